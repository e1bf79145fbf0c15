// Inside core/raytrace: what each ray of a wave sees.
//
// Before it: traced_scene.h, which finds surfaces. After it: render.cpp, which makes pixels of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/raytrace/linear_light.h"
#include "core/raytrace/render.h"
#include "core/raytrace/traced_scene.h"

namespace seesaw {

/// Light times alpha, so that samples can be averaged, and alpha.
struct Sample {
  Light3 light = Light3::Zero();
  double alpha = 1;
};

/// Which of a pixel's samples a ray belongs to: what shifts its patterns.
struct SampleId {
  std::uint64_t pixel = 0;   ///< a hash of the pixel's place
  std::uint64_t number = 0;  ///< of the sample within the pixel
};

class Shader {
 public:
  /// Reads all three while it lives; `lights` are the scene's or those of the studio, `up` a unit vector.
  Shader(const Scene& scene, const TracedScene& traced, const std::vector<Light>& lights, const Point<3>& up,
         const RenderOptions& options);

  /// What rays[i], of sample ids[i], sees. Called from many threads.
  std::vector<Sample> look(std::span<const Ray> rays, std::span<const SampleId> ids) const;

 private:
  struct Spot;
  struct Wave;
  std::vector<Sample> look(std::span<const Ray> rays, std::span<const SampleId> ids, int depth) const;
  bool meets_floor(const Ray& ray, const Hit& hit, Spot& spot) const;
  void ask_lights(const std::vector<Spot>& spots, std::span<const SampleId> ids, Wave& wave) const;
  Sample lit(const Spot& spot, const Ray& ray, const Wave& wave, std::size_t index) const;
  Sample lit_floor(const Spot& spot, const Wave& wave, std::size_t index) const;

  const Scene& scene_;
  const TracedScene& traced_;
  const std::vector<Light>& lights_;
  const RenderOptions& options_;
  Point<3> up_, floor_up_, floor_u_, floor_v_;
  Light3 background_, floor_light_, floor_dark_;
  std::vector<Light3> light_colors_;
};

}  // namespace seesaw
