// Inside core/raytrace: Embree's two versions as one. Only this floor includes it, and only in .cpp files.
#pragma once

#if SEESAW_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace seesaw {

/// The nearest hit of the ray in `query`.
inline void embree_nearest(RTCScene scene, RTCRayHit& query) {
#if SEESAW_EMBREE_VERSION >= 4
  rtcIntersect1(scene, &query, nullptr);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#endif
}

/// Whether anything lies on the ray.
inline bool embree_occluded(RTCScene scene, RTCRay& ray) {
#if SEESAW_EMBREE_VERSION >= 4
  rtcOccluded1(scene, &ray, nullptr);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
#endif
  return ray.tfar < 0;  // Embree's way to say yes
}

}  // namespace seesaw
