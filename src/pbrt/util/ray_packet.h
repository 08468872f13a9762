#pragma once

#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// Sixteen rays side by side. What lanes hold that are not asked for does not matter.
struct alignas(64) RayPacket {
    Point3fX16 o;
    Vector3fX16 d;
    FloatX16 tMax, time;

    Ray At(int lane) const { return {Lane(o, lane), Lane(d, lane), tMax[lane], time[lane]}; }
    void Set(int lane, const Ray &ray) {
        SetLane(&o, lane, ray.o);
        SetLane(&d, lane, ray.d);
        tMax.Set(lane, ray.tMax);
        time.Set(lane, ray.time);
    }
};

}  // namespace pbrt
