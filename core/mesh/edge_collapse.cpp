#include "core/mesh/edge_collapse.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "core/mesh/compact.h"
#include "core/mesh/edge_table.h"

namespace seesaw {

namespace {

// The weighted sum of squared distances to planes, as a quadratic polynomial p' A p + 2 b' p + c.
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Point<3> b = Point<3>::Zero();
  double c = 0;

  void add_plane(const Point<3>& normal, const Point<3>& on_it, double weight) {
    const double d = -normal.dot(on_it);
    a += weight * normal * normal.transpose();
    b += weight * d * normal;
    c += weight * d * d;
  }
  void add(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
  }
  double at(const Point<3>& p) const { return p.dot(a * p) + 2 * b.dot(p) + c; }
};

class Collapser {
 public:
  Collapser(const TriangleMesh& mesh, const Progress& progress)
      : progress_(progress),
        points_(mesh.vertices),
        faces_(mesh.faces),
        faces_at_(slot(mesh.vertices.cols())),
        quadrics_(slot(mesh.vertices.cols())),
        on_boundary_(slot(mesh.vertices.cols()), 0),
        version_(slot(mesh.vertices.cols()), 0),
        dead_(slot(mesh.faces.cols()), 0) {
    // Around the middle and in units of the size, so that the quadrics keep their digits.
    const Box<3> box = bounding_box_of<3>(points_);
    if (!box.isEmpty()) points_.colwise() -= Point<3>(box.center());
    const double size = points_.size() > 0 ? points_.cwiseAbs().maxCoeff() : 1.0;
    if (size > 0) points_ /= size;
    const EdgeTable table(faces_, points_.cols());
    for (Index f = 0; f < faces_.cols(); ++f) {
      if (table.skipped(f)) {
        dead_[slot(f)] = 1;
        continue;
      }
      const Point<3> normal = normal_of(faces_.col(f));
      const double twice_area = normal.norm();
      for (int k = 0; k < 3; ++k) {
        faces_at_[slot(faces_(k, f))].push_back(static_cast<int>(f));
        if (twice_area > 0)
          quadrics_[slot(faces_(k, f))].add_plane(normal / twice_area, points_.col(faces_(k, f)),
                                                  twice_area / 6);
      }
    }
    for (Index e = 0; e < table.edges(); ++e)
      if (table.halves(e).size() == 1)
        hold_boundary(table.ends(e).a, table.ends(e).b, table.halves(e)[0] / 3);
    for (Index v = 0; v < points_.cols(); ++v) alive_ += !faces_at_[slot(v)].empty();
  }

  void run(Index vertices) {
    const Index start = alive_;
    // What was refused may be allowed after others have gone: once more from the start, as long as that
    // helps.
    for (Index before = alive_ + 1; alive_ > vertices && alive_ < before;) {
      before = alive_;
      const Faces left = faces();
      const EdgeTable table(left, points_.cols());
      queue_ = {};
      for (Index e = 0; e < table.edges(); ++e) offer(table.ends(e).a, table.ends(e).b);
      drain(start, vertices);
    }
  }

  Faces faces() const {
    Faces left(3, faces_.cols());
    Index n = 0;
    for (Index f = 0; f < faces_.cols(); ++f)
      if (!dead_[slot(f)]) left.col(n++) = faces_.col(f);
    return left.leftCols(n);
  }

 private:
  struct Candidate {
    double price;
    int u, v;
    int u_version, v_version;
    // The cheapest comes out first; equal prices by number, so that the result is always the same.
    bool operator<(const Candidate& other) const {
      return std::tie(other.price, other.u, other.v) < std::tie(price, u, v);
    }
  };

  void drain(Index start, Index vertices) {
    for (Index step = 0; alive_ > vertices && !queue_.empty(); ++step) {
      if (step % 1024 == 0)
        report(progress_, static_cast<double>(start - alive_) / static_cast<double>(start - vertices));
      const Candidate best = queue_.top();
      queue_.pop();
      if (best.u_version != version_[slot(best.u)] || best.v_version != version_[slot(best.v)]) continue;
      if (allowed(best.u, best.v)) collapse(best.u, best.v);
    }
  }

  Point<3> normal_of(const Eigen::Vector3i& face) const {
    const Point<3> a = points_.col(face[0]);
    return (points_.col(face[1]) - a).cross(points_.col(face[2]) - a);
  }

  // A rim is held by planes that stand upright on its faces.
  void hold_boundary(int a, int b, Index face) {
    on_boundary_[slot(a)] = on_boundary_[slot(b)] = 1;
    const Point<3> along = points_.col(b) - points_.col(a);
    const Point<3> upright = along.cross(normal_of(faces_.col(face))).stableNormalized();
    for (const int v : {a, b}) quadrics_[slot(v)].add_plane(upright, points_.col(a), along.squaredNorm());
  }

  void offer(int a, int b) {
    Quadric both = quadrics_[slot(a)];
    both.add(quadrics_[slot(b)]);
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, a)})
      queue_.push({both.at(points_.col(v)), u, v, version_[slot(u)], version_[slot(v)]});
  }

  bool has(int face, int vertex) const {
    return faces_(0, face) == vertex || faces_(1, face) == vertex || faces_(2, face) == vertex;
  }

  void neighbors(int vertex, std::vector<int>& result) const {
    result.clear();
    for (const int f : faces_at_[slot(vertex)])
      for (int k = 0; k < 3; ++k)
        if (faces_(k, f) != vertex) result.push_back(faces_(k, f));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
  }

  bool allowed(int u, int v) {
    std::array<int, 2> tips{};
    std::size_t shared = 0;
    for (const int f : faces_at_[slot(u)])
      if (has(f, v)) {
        if (shared == 2) return false;
        tips[shared++] = faces_(0, f) + faces_(1, f) + faces_(2, f) - u - v;
      }
    if (shared == 0) return false;
    const bool rim = shared == 1;
    // Between two rims, or from a rim inward, no edge collapses but along the rim itself.
    if (on_boundary_[slot(u)] && !rim) return false;
    neighbors(u, around_u_);
    neighbors(v, around_v_);
    common_.clear();
    std::set_intersection(around_u_.begin(), around_u_.end(), around_v_.begin(), around_v_.end(),
                          std::back_inserter(common_));
    if (common_.size() != shared) return false;
    // A tetrahedron's edge: both ends have a face with both tips, and would leave the same face twice.
    for (const int f : faces_at_[slot(u)])
      if (shared == 2 && has(f, tips[0]) && has(f, tips[1])) return false;
    // A lone triangle, or the last but one of a rim.
    if (rim && around_u_.size() == 2 && around_v_.size() == 2) return false;
    for (const int f : faces_at_[slot(u)]) {
      if (has(f, v)) continue;
      Eigen::Vector3i face = faces_.col(f);
      const Point<3> before = normal_of(face);
      for (int k = 0; k < 3; ++k)
        if (face[k] == u) face[k] = v;
      const Point<3> after = normal_of(face);
      if (!(before.dot(after) > 0.2 * before.norm() * after.norm()) || !(after.norm() > 0)) return false;
    }
    return true;
  }

  void collapse(int u, int v) {
    for (const int f : faces_at_[slot(u)]) {
      if (has(f, v)) {
        dead_[slot(f)] = 1;
        for (int k = 0; k < 3; ++k)
          if (faces_(k, f) != u) std::erase(faces_at_[slot(faces_(k, f))], f);
      } else {
        for (int k = 0; k < 3; ++k)
          if (faces_(k, f) == u) faces_(k, f) = v;
        faces_at_[slot(v)].push_back(f);
      }
    }
    faces_at_[slot(u)].clear();
    quadrics_[slot(v)].add(quadrics_[slot(u)]);
    ++version_[slot(u)];
    ++version_[slot(v)];
    --alive_;
    neighbors(v, around_v_);
    for (const int w : around_v_) offer(v, w);
  }

  const Progress& progress_;
  Points<3> points_;
  Faces faces_;
  std::vector<std::vector<int>> faces_at_;
  std::vector<Quadric> quadrics_;
  std::vector<char> on_boundary_;
  std::vector<int> version_;
  std::vector<char> dead_;
  Index alive_ = 0;
  std::priority_queue<Candidate> queue_;
  std::vector<int> around_u_, around_v_, common_;
};

}  // namespace

TriangleMesh collapse_edges(const TriangleMesh& mesh, Index vertices, const Progress& progress) {
  Collapser collapser(mesh, progress);
  collapser.run(vertices);
  return with_faces(mesh, collapser.faces());
}

}  // namespace seesaw
