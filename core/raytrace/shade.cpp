#include "core/raytrace/shade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/raytrace/sampling.h"

namespace seesaw {

namespace {

// Light from below is light that a bright room's floor sent up: a little less.
constexpr double ambient_from_below = 0.74;

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / std::max(to - from, 1e-300), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Color back_of(const Material& material) {
  return material.back_color ? *material.back_color : mix(material.color, hex("#8A5A3C"), 0.55);
}

}  // namespace

// A place that light falls on.
struct Shader::Spot {
  std::size_t ray = 0;  // of the wave
  bool floor = false;
  Point<3> place, start, facet, normal;
  const Material* material = nullptr;
  bool back = false;
  Color line;
  double line_cover = 0;
};

// What the lights answered: for spot i and light k, the direction toward the light and whether it is seen.
struct Shader::Wave {
  std::vector<Point<3>> toward;
  std::vector<char> seen;
  std::vector<double> open;  // of spot i, 0 .. 1
};

Shader::Shader(const Scene& scene, const TracedScene& traced, const std::vector<Light>& lights,
               const Point<3>& up, const RenderOptions& options)
    : scene_(scene),
      traced_(traced),
      lights_(lights),
      options_(options),
      up_(up),
      floor_up_(scene.floor.up.normalized()),
      background_(light_of(scene.background)),
      floor_light_(light_of(scene.floor.light)),
      floor_dark_(light_of(scene.floor.dark)) {
  across(floor_up_, floor_u_, floor_v_);
  for (const Light& light : lights) light_colors_.push_back(light.intensity * light_of(light.color));
}

bool Shader::meets_floor(const Ray& ray, const Hit& hit, Spot& spot) const {
  if (scene_.floor.look == Floor::Look::none) return false;
  const double slope = ray.direction.dot(floor_up_);
  if (!(slope < 0)) return false;  // from below it is not there, so that a subject can be seen from all sides
  const double t = (scene_.floor.point - ray.origin).dot(floor_up_) / slope;
  if (!(t >= ray.begin && t <= ray.end && t < hit.t)) return false;
  spot.floor = true;
  spot.place = ray.at(t);
  spot.start = spot.place + 1e-6 * traced_.size() * floor_up_;
  spot.facet = spot.normal = floor_up_;
  return true;
}

void Shader::ask_lights(const std::vector<Spot>& spots, std::span<const SampleId> ids, Wave& wave) const {
  const std::size_t lights = lights_.size();
  wave.toward.resize(spots.size() * lights);
  wave.seen.assign(spots.size() * lights, 0);
  wave.open.assign(spots.size(), 1.0);
  std::vector<Ray> rays;
  std::vector<std::size_t> asked;  // the entry of wave.seen, or beyond those, the spot whose sky it is
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot& spot = spots[i];
    const SampleId& id = ids[spot.ray];
    for (std::size_t k = 0; k < lights; ++k) {
      const Light& light = lights_[k];
      Point<3> toward = light.kind == Light::Kind::point ? Point<3>(light.at - spot.place) : light.at;
      double distance = toward.norm();
      if (!(distance > 0)) continue;
      toward /= distance;
      if (light.softness > 0) {
        Point<3> u, v;
        across(toward, u, v);
        const Point<2> d = disc_point(pattern_point(id.number, mixed_bits(id.pixel + 2 * k + 1)));
        const double radius = light.kind == Light::Kind::point
                                  ? light.softness / distance
                                  : std::tan(std::min(light.softness, 80.0) * std::numbers::pi / 180);
        toward += radius * (d.x() * u + d.y() * v);
        distance *= toward.norm();
        toward.normalize();
      }
      wave.toward[i * lights + k] = toward;
      if (!(spot.normal.dot(toward) > 0)) continue;
      wave.seen[i * lights + k] = 1;
      if (!light.shadows) continue;
      Ray ray;
      ray.origin = spot.start;
      ray.direction = toward;
      if (light.kind == Light::Kind::point) ray.end = distance;
      rays.push_back(ray);
      asked.push_back(i * lights + k);
    }
    if (scene_.ambient > 0)
      for (int k = 0; k < options_.ambient_rays; ++k) {
        const auto number =
            id.number * static_cast<std::uint64_t>(options_.ambient_rays) + static_cast<std::uint64_t>(k);
        Ray ray;
        ray.origin = spot.start;
        ray.direction = cosine_direction(spot.normal, pattern_point(number, mixed_bits(id.pixel)));
        if (!(ray.direction.dot(spot.facet) > 0)) continue;  // below its own facet: no occluder of its own
        ray.end = options_.ambient_reach * traced_.size();
        rays.push_back(ray);
        asked.push_back(wave.seen.size() + i);
      }
  }
  std::vector<char> blocked(rays.size());
  traced_.occlude(rays, blocked);
  for (std::size_t r = 0; r < rays.size(); ++r) {
    if (!blocked[r]) continue;
    if (asked[r] < wave.seen.size())
      wave.seen[asked[r]] = 0;
    else
      wave.open[asked[r] - wave.seen.size()] -= 1.0 / options_.ambient_rays;
  }
}

Sample Shader::lit(const Spot& spot, const Ray& ray, const Wave& wave, std::size_t index) const {
  const Material& material = *spot.material;
  if (spot.line_cover > 0) return {light_of(spot.line), 1};
  const Light3 color = light_of(spot.back ? back_of(material) : material.color);
  const double from_above = 0.5 * (1 + spot.normal.dot(up_));
  Light3 arriving = Light3::Constant(scene_.ambient * wave.open[index] *
                                     (ambient_from_below + (1 - ambient_from_below) * from_above));
  Light3 shine = Light3::Zero();
  for (std::size_t k = 0; k < lights_.size(); ++k) {
    if (!wave.seen[index * lights_.size() + k]) continue;
    const Point<3>& toward = wave.toward[index * lights_.size() + k];
    arriving += light_colors_[k] * std::max(0.0, spot.normal.dot(toward));
    // Blinn's halfway vector.
    const double facing = spot.normal.dot((toward - ray.direction).normalized());
    if (material.highlight > 0 && facing > 0)
      shine += light_colors_[k] * material.highlight * std::pow(facing, material.gloss);
  }
  return {softened(color * arriving + shine), 1};
}

Sample Shader::lit_floor(const Spot& spot, const Wave& wave, std::size_t index) const {
  // Where nothing is in the way the floor has its own color: what it shows is how much light is missing.
  Light3 arriving = Light3::Constant(scene_.ambient * wave.open[index]);
  Light3 full = Light3::Constant(scene_.ambient);
  for (std::size_t k = 0; k < lights_.size(); ++k) {
    const Light3 part =
        light_colors_[k] * std::max(0.0, spot.normal.dot(wave.toward[index * lights_.size() + k]));
    full += part;
    if (wave.seen[index * lights_.size() + k]) arriving += part;
  }
  const Floor& floor = scene_.floor;
  const Point<3> from = spot.place - floor.point;
  const double gone = smooth_step(floor.fade_begin, floor.fade_end, from.norm());
  const Light3 left = (full > 0).select(arriving / full.max(1e-300), Light3::Ones());
  const Light3 shade = left + gone * (1 - left);
  if (floor.look == Floor::Look::plain) {
    const double alpha = scene_.background.a;
    return {alpha * background_ * shade, alpha + (1 - alpha) * (1 - shade.mean())};
  }
  const double x = std::floor(from.dot(floor_u_) / floor.tile),
               y = std::floor(from.dot(floor_v_) / floor.tile);
  const Light3& tile = std::fmod(std::abs(x + y), 2.0) < 0.5 ? floor_light_ : floor_dark_;
  const double alpha = 1 - gone * (1 - scene_.background.a);
  return {(1 - gone) * tile * shade + gone * scene_.background.a * background_, alpha};
}

std::vector<Sample> Shader::look(std::span<const Ray> rays, std::span<const SampleId> ids) const {
  return look(rays, ids, 0);
}

std::vector<Sample> Shader::look(std::span<const Ray> rays, std::span<const SampleId> ids, int depth) const {
  const Sample nothing{scene_.background.a * background_, scene_.background.a};
  std::vector<Sample> seen(rays.size(), nothing);
  std::vector<Hit> hits(rays.size());
  traced_.nearest(rays, hits);

  std::vector<Spot> spots;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Spot spot;
    spot.ray = i;
    if (!meets_floor(rays[i], hits[i], spot)) {
      const Hit& hit = hits[i];
      if (!hit.found()) continue;
      spot = {i,          false,        hit.place, hit.start, hit.facet,
              hit.normal, hit.material, hit.back,  hit.line,  hit.line_cover};
    }
    spots.push_back(spot);
  }
  Wave wave;
  ask_lights(spots, ids, wave);

  std::vector<Ray> mirrored;
  std::vector<SampleId> mirrored_ids;
  std::vector<std::size_t> from;
  std::vector<double> share;
  for (std::size_t s = 0; s < spots.size(); ++s) {
    const Spot& spot = spots[s];
    const Ray& ray = rays[spot.ray];
    seen[spot.ray] = spot.floor ? lit_floor(spot, wave, s) : lit(spot, ray, wave, s);
    double mirror = spot.floor ? scene_.floor.mirror : spot.line_cover > 0 ? 0 : spot.material->mirror;
    if (spot.floor)
      mirror *= 1 - smooth_step(scene_.floor.fade_begin, scene_.floor.fade_end,
                                (spot.place - scene_.floor.point).norm());
    if (!(mirror > 0) || depth >= options_.max_depth) continue;
    Ray reflected;
    reflected.origin = spot.start;
    reflected.direction = (ray.direction - 2 * ray.direction.dot(spot.normal) * spot.normal).normalized();
    // A smooth normal can send it into its own facet.
    const double below = reflected.direction.dot(spot.facet);
    if (below < 0.01) reflected.direction = (reflected.direction + (0.01 - below) * spot.facet).normalized();
    mirrored.push_back(reflected);
    mirrored_ids.push_back({mixed_bits(ids[spot.ray].pixel), ids[spot.ray].number});
    from.push_back(spot.ray);
    share.push_back(std::min(mirror, 1.0));
  }
  if (!mirrored.empty()) {
    const std::vector<Sample> images = look(mirrored, mirrored_ids, depth + 1);
    for (std::size_t m = 0; m < images.size(); ++m) {
      Sample& sample = seen[from[m]];
      sample.light = (1 - share[m]) * sample.light + share[m] * images[m].light;
      sample.alpha = (1 - share[m]) * sample.alpha + share[m] * images[m].alpha;
    }
  }
  return seen;
}

}  // namespace seesaw
