#pragma once

// What differs between Embree 3 and 4, under one name each. CMake prefers 4, and so does this.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace pbrt {

#if RTC_VERSION_MAJOR >= 4

using EmbreeContext = RTCRayQueryContext;

inline void InitContext(EmbreeContext *context) {
    rtcInitRayQueryContext(context);
}
inline void Intersect1(RTCScene scene, EmbreeContext *context, RTCRayHit *rayHit) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = context;
    rtcIntersect1(scene, rayHit, &arguments);
}
inline void Occluded1(RTCScene scene, EmbreeContext *context, RTCRay *ray) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = context;
    rtcOccluded1(scene, ray, &arguments);
}

#else

using EmbreeContext = RTCIntersectContext;

inline void InitContext(EmbreeContext *context) {
    rtcInitIntersectContext(context);
}
inline void Intersect1(RTCScene scene, EmbreeContext *context, RTCRayHit *rayHit) {
    rtcIntersect1(scene, context, rayHit);
}
inline void Occluded1(RTCScene scene, EmbreeContext *context, RTCRay *ray) {
    rtcOccluded1(scene, context, ray);
}

#endif

}  // namespace pbrt
