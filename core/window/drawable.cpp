#include "core/window/drawable.h"

#include <epoxy/gl.h>

#include <numeric>

#include "core/base/check.h"

namespace seesaw {

namespace {

constexpr std::size_t floats_a_vertex = 10;  // position 3, normal 3, color 4

std::vector<unsigned> counted(Index n) {
  std::vector<unsigned> indices(slot(n));
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

void attribute(unsigned index, int size, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, floats_a_vertex * sizeof(float),
                        reinterpret_cast<const void*>(offset * sizeof(float)));
}

}  // namespace

Drawable::~Drawable() {
  if (array_ == 0) return;
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &indices_);
}

void Drawable::set(Kind kind, const PointsRef<3>& points, const PointsRef<3>& normals,
                   const std::vector<Color>& colors, const std::vector<unsigned>& indices) {
  if (!colors.empty()) SEESAW_CHECK_EQ(colors.size(), slot(points.cols()));
  kind_ = kind;
  count_ = static_cast<int>(indices.size());
  has_colors_ = !colors.empty();
  if (count_ == 0) return;
  std::vector<float> data(floats_a_vertex * slot(points.cols()), 0.0f);
  for (Index i = 0; i < points.cols(); ++i) {
    float* v = data.data() + floats_a_vertex * slot(i);
    for (int k = 0; k < 3; ++k) v[k] = static_cast<float>(points(k, i));
    if (normals.cols() > 0)
      for (int k = 0; k < 3; ++k) v[3 + k] = static_cast<float>(normals(k, i));
    if (!has_colors_) continue;
    const Color& c = colors[slot(i)];
    const double parts[4] = {c.r, c.g, c.b, c.a};
    for (int k = 0; k < 4; ++k) v[6 + k] = static_cast<float>(parts[k]);
  }
  if (array_ == 0) {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &vertices_);
    glGenBuffers(1, &indices_);
  }
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(),
               GL_DYNAMIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(unsigned)),
               indices.data(), GL_DYNAMIC_DRAW);
  attribute(0, 3, 0);
  attribute(1, 3, 3);
  attribute(2, 4, 6);
  glBindVertexArray(0);
}

void Drawable::set_triangles(const TriangleMesh& mesh, const std::vector<Color>& colors) {
  std::vector<unsigned> indices;
  indices.reserve(slot(mesh.faces.size()));
  for (const int i : mesh.faces.reshaped()) {
    SEESAW_CHECK_LT(static_cast<Index>(i), mesh.vertices.cols());
    indices.push_back(static_cast<unsigned>(i));
  }
  set(Kind::triangles, mesh.vertices, mesh.has_normals() ? mesh.normals : Points<3>(3, 0), colors, indices);
}

void Drawable::set_segments(const PointsRef<3>& ends, const std::vector<Color>& colors) {
  SEESAW_CHECK_EQ(ends.cols() % 2, 0);
  set(Kind::segments, ends, Points<3>(3, 0), colors, counted(ends.cols()));
}

void Drawable::set_polyline(const PointsRef<3>& points, bool closed, const std::vector<Color>& colors) {
  std::vector<unsigned> indices;
  const Index n = points.cols();
  for (Index i = 0; i + 1 < n; ++i)
    indices.insert(indices.end(), {static_cast<unsigned>(i), static_cast<unsigned>(i + 1)});
  if (closed && n > 2) indices.insert(indices.end(), {static_cast<unsigned>(n - 1), 0u});
  set(Kind::segments, points, Points<3>(3, 0), colors, indices);
}

void Drawable::set_points(const PointsRef<3>& points, const std::vector<Color>& colors) {
  set(Kind::points, points, Points<3>(3, 0), colors, counted(points.cols()));
}

void Drawable::draw() const {
  if (empty()) return;
  const GLenum mode = kind_ == Kind::triangles  ? GL_TRIANGLES
                      : kind_ == Kind::segments ? GL_LINES
                                                : GL_POINTS;
  glBindVertexArray(array_);
  glDrawElements(mode, count_, GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
}

}  // namespace seesaw
