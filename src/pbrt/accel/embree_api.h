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
inline void Intersect16(RTCScene scene, EmbreeContext *context, const int *valid,
                        RTCRayHit16 *rayHits, bool coherent) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = context;
    if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect16(valid, scene, rayHits, &arguments);
}
inline void Occluded16(RTCScene scene, EmbreeContext *context, const int *valid, RTCRay16 *rays) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = context;
    rtcOccluded16(valid, scene, rays, &arguments);
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
inline void Intersect16(RTCScene scene, EmbreeContext *context, const int *valid,
                        RTCRayHit16 *rayHits, bool coherent) {
    if (coherent) context->flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, scene, context, rayHits);
}
inline void Occluded16(RTCScene scene, EmbreeContext *context, const int *valid, RTCRay16 *rays) {
    rtcOccluded16(valid, scene, context, rays);
}

#endif

}  // namespace pbrt
