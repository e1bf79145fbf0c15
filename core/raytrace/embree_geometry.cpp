#include "core/raytrace/embree_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/mesh/vertex_normals.h"
#include "core/raytrace/edge_lines.h"
#include "core/raytrace/embree_api.h"

namespace seesaw {

namespace {

// Single precision is good to 1e-7 of the unit size; rays start this far from where they left, in units.
constexpr double facet_clearance = 2e-5;

void throw_on_error(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw Error("not enough memory to trace rays through this scene");
  if (error != RTC_ERROR_NONE) throw Error("Embree failed with error " + std::to_string(error));
}

const char* device_settings() {
#if defined(__x86_64__) || defined(__i386__)
  return "isa=sse4.2";  // the same instructions, so the same pixels, on every processor
#else
  return nullptr;
#endif
}

// A mesh as it is shaded.
struct ShadedMesh {
  const MeshObject* object;
  Points<3> normals;  // 3 x V, or 3 x 0 for flat
  std::vector<std::uint8_t> drawn_edges;
};

struct Rounded {
  const Material* material;
  const Points<3>* centers;
  const Points<3>* normals;  // null for spheres
};

}  // namespace

struct EmbreeGeometry::Parts {
  enum class Kind { mesh, discs, spheres };
  struct Geometry {
    Kind kind;
    std::size_t index;
  };

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  Point<3> center = Point<3>::Zero();
  double scale = 1;  // scene units per Embree unit
  double pixel_angle = 0;
  std::vector<ShadedMesh> meshes;
  std::vector<Rounded> rounded;
  std::vector<Geometry> geometries;  // by Embree's geometry number

  ~Parts() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void attach(RTCGeometry geometry, Geometry what) {
    rtcCommitGeometry(geometry);
    const unsigned number = rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    throw_on_error(device);
    if (geometries.size() <= number) geometries.resize(number + 1);
    geometries[number] = what;
  }

  void* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t stride, Index count) {
    void* memory =
        rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, static_cast<std::size_t>(count));
    throw_on_error(device);
    return memory;
  }

  std::array<float, 3> unit(const Point<3>& p) const {
    const Point<3> q = (p - center) / scale;
    return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())};
  }

  void add_mesh(const MeshObject& object) {
    const TriangleMesh& mesh = object.mesh;
    if (mesh.faces.cols() == 0) return;
    SEESAW_CHECK_GE(mesh.faces.minCoeff(), 0);
    SEESAW_CHECK_LT(mesh.faces.maxCoeff(), mesh.vertices.cols());
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.cols()));
    for (Index i = 0; i < mesh.vertices.cols(); ++i) {
      const auto p = unit(mesh.vertices.col(i));
      std::copy(p.begin(), p.end(), vertices + 3 * i);
    }
    auto* faces = static_cast<unsigned*>(
        buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.faces.cols()));
    for (Index i = 0; i < mesh.faces.size(); ++i) faces[i] = static_cast<unsigned>(mesh.faces.data()[i]);
    attach(geometry, {Kind::mesh, meshes.size()});
    meshes.push_back({&object,
                      object.flat          ? Points<3>(3, 0)
                      : mesh.has_normals() ? mesh.normals
                                           : vertex_normals(mesh),
                      object.edges.width > 0 ? edges_to_draw(mesh, object.edges.least_angle)
                                             : std::vector<std::uint8_t>()});
  }

  void add_rounded(const Points<3>& centers, const Points<3>* normals, const Values& radii,
                   const Material& material) {
    SEESAW_CHECK_EQ(centers.cols(), radii.size());
    if (centers.cols() == 0) return;
    RTCGeometry geometry = rtcNewGeometry(
        device, normals ? RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT : RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* vertices = static_cast<float*>(
        buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4 * sizeof(float), centers.cols()));
    for (Index i = 0; i < centers.cols(); ++i) {
      const auto p = unit(centers.col(i));
      std::copy(p.begin(), p.end(), vertices + 4 * i);
      vertices[4 * i + 3] = static_cast<float>(radii[i] / scale);
    }
    if (normals) {
      SEESAW_CHECK_EQ(normals->cols(), centers.cols());
      auto* directions = static_cast<float*>(
          buffer(geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, 3 * sizeof(float), centers.cols()));
      for (Index i = 0; i < centers.cols(); ++i)
        for (int d = 0; d < 3; ++d)
          directions[3 * i + d] = static_cast<float>(normals->col(i).normalized()[d]);
    }
    attach(geometry, {normals ? Kind::discs : Kind::spheres, rounded.size()});
    rounded.push_back({&material, &centers, normals});
  }

  RTCRay query_of(const Ray& ray) const {
    RTCRay query{};
    const auto origin = unit(ray.origin);
    query.org_x = origin[0];
    query.org_y = origin[1];
    query.org_z = origin[2];
    query.dir_x = static_cast<float>(ray.direction.x());
    query.dir_y = static_cast<float>(ray.direction.y());
    query.dir_z = static_cast<float>(ray.direction.z());
    query.tnear = static_cast<float>(ray.begin / scale);
    query.tfar = static_cast<float>(ray.end / scale);
    query.mask = ~0u;
    return query;
  }

  // Turns the hit's normals toward the ray and says where rays leave from.
  void finish(const Ray& ray, const Point<3>& outward, Hit& hit) const {
    hit.back = outward.dot(ray.direction) > 0;
    hit.facet = hit.back ? Point<3>(-outward) : outward;
    if (hit.normal.dot(hit.facet) < 0) hit.normal = -hit.normal;
    // A smooth normal may look away where its facet does not.
    const double away = hit.normal.dot(ray.direction);
    if (away > -0.02) hit.normal = (hit.normal - (away + 0.02) * ray.direction).normalized();
  }

  void hit_mesh(const Ray& ray, const ShadedMesh& mesh, Index face, double u, double v, Hit& hit) const {
    const auto corner = mesh.object->mesh.faces.col(face);
    const Points<3>& vertices = mesh.object->mesh.vertices;
    const Point<3> a = vertices.col(corner[0]), b = vertices.col(corner[1]), c = vertices.col(corner[2]);
    const Point<3> cross = (b - a).cross(c - a);
    if (cross.squaredNorm() > 0) {
      const Point<3> outward = cross.normalized();
      // The plane's own place for the hit, in double precision, unless the ray only grazes it.
      const double slope = outward.dot(ray.direction);
      if (std::abs(slope) > 1e-3) {
        const double exact = outward.dot(a - ray.origin) / slope;
        if (std::abs(exact - hit.t) < 1e-3 * scale) hit.t = exact;
      }
    }
    hit.place = ray.at(hit.t);
    const Point<3> outward =
        cross.squaredNorm() > 0 ? Point<3>(cross.normalized()) : Point<3>(-ray.direction);
    hit.normal = outward;
    hit.start = hit.place;
    const double w = 1 - u - v;
    if (mesh.normals.cols() > 0) {
      const Point<3> na = mesh.normals.col(corner[0]), nb = mesh.normals.col(corner[1]),
                     nc = mesh.normals.col(corner[2]);
      const Point<3> smooth = w * na + u * nb + v * nc;
      if (smooth.squaredNorm() > 1e-12) hit.normal = smooth.normalized();
      // Shadow rays leave from the smooth surface that the facet stands for: otherwise the facets' own
      // shadows show where light grazes them (Hanika 2021, "Hacking the shadow terminator").
      const double side = outward.dot(ray.direction) > 0 ? -1 : 1;
      Point<3> lifted = Point<3>::Zero();
      const Point<3>* corners[3] = {&a, &b, &c};
      const Point<3>* normals[3] = {&na, &nb, &nc};
      const double weights[3] = {w, u, v};
      for (int k = 0; k < 3; ++k) {
        const double below = side * normals[k]->dot(hit.place - *corners[k]);
        lifted += weights[k] * (hit.place - std::min(0.0, below) * side * *normals[k]);
      }
      hit.start = lifted;
    }
    hit.material = &mesh.object->material;
    hit.line_cover = 0;
    if (!mesh.drawn_edges.empty()) {
      const double reach = 0.5 * mesh.object->edges.width * pixel_angle * hit.t;
      if (on_drawn_edge(ray, hit.place, a, b, c, mesh.drawn_edges[static_cast<std::size_t>(face)], reach)) {
        hit.line = mesh.object->edges.color;
        hit.line_cover = 1;
      }
    }
    finish(ray, outward, hit);
    hit.start += facet_clearance * scale * hit.facet;
  }

  void hit_rounded(const Ray& ray, const Rounded& object, Index index, Hit& hit) const {
    hit.place = ray.at(hit.t);
    const Point<3> outward = object.normals ? object.normals->col(index).normalized().eval()
                                            : (hit.place - object.centers->col(index)).normalized().eval();
    hit.normal = outward;
    hit.material = object.material;
    hit.line_cover = 0;
    finish(ray, outward, hit);
    hit.start = hit.place + facet_clearance * scale * hit.facet;
    if (object.normals) hit.back = false;  // a disc has two good sides
  }
};

EmbreeGeometry::EmbreeGeometry(const Scene& scene, const Box<3>& box, double pixel_angle)
    : parts_(std::make_unique<Parts>()) {
  Parts& parts = *parts_;
  if (!box.isEmpty()) {
    parts.center = box.center();
    const double half = 0.5 * box.sizes().maxCoeff();
    parts.scale = half > 0 ? half : 1.0;
  }
  parts.pixel_angle = pixel_angle;
  parts.device = rtcNewDevice(device_settings());
  if (!parts.device) throw Error("Embree does not run on this processor");
  parts.scene = rtcNewScene(parts.device);
  rtcSetSceneFlags(parts.scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
  for (const MeshObject& each : scene.meshes) parts.add_mesh(each);
  for (const DiscsObject& each : scene.discs)
    parts.add_rounded(each.centers, &each.normals, each.radii, each.material);
  for (const SpheresObject& each : scene.spheres)
    parts.add_rounded(each.centers, nullptr, each.radii, each.material);
  rtcCommitScene(parts.scene);
  throw_on_error(parts.device);
}

EmbreeGeometry::~EmbreeGeometry() = default;

bool EmbreeGeometry::empty() const { return parts_->geometries.empty(); }

void EmbreeGeometry::nearest(std::span<const Ray> rays, std::span<Hit> hits) const {
  SEESAW_CHECK_EQ(rays.size(), hits.size());
  if (empty()) return;
  const Parts& parts = *parts_;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRayHit query;
    query.ray = parts.query_of(rays[i]);
    query.ray.tfar = std::min(query.ray.tfar, static_cast<float>(hits[i].t / parts.scale));
    query.hit = RTCHit{};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree_nearest(parts.scene, query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    const Parts::Geometry& what = parts.geometries[query.hit.geomID];
    const Index primitive = query.hit.primID;
    hits[i].t = static_cast<double>(query.ray.tfar) * parts.scale;
    if (what.kind == Parts::Kind::mesh)
      parts.hit_mesh(rays[i], parts.meshes[what.index], primitive, static_cast<double>(query.hit.u),
                     static_cast<double>(query.hit.v), hits[i]);
    else
      parts.hit_rounded(rays[i], parts.rounded[what.index], primitive, hits[i]);
  }
}

void EmbreeGeometry::occlude(std::span<const Ray> rays, std::span<char> blocked) const {
  SEESAW_CHECK_EQ(rays.size(), blocked.size());
  if (empty()) return;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (blocked[i]) continue;
    RTCRay query = parts_->query_of(rays[i]);
    if (embree_occluded(parts_->scene, query)) blocked[i] = 1;
  }
}

}  // namespace seesaw
