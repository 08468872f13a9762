#pragma once

#include "pbrt/shapes/surface_point.h"
#include "pbrt/util/wide.h"

namespace pbrt {

/// Sixteen rays side by side. What lanes hold that are not asked for does not matter.
struct alignas(64) RayPacket {
    WidePoint3f o;
    WideVector3f d;
    WideFloat tMax, time;

    Ray At(int lane) const { return {Lane(o, lane), Lane(d, lane), tMax[lane], time[lane]}; }
    void Set(int lane, const Ray &ray) {
        SetLane(&o, lane, ray.o);
        SetLane(&d, lane, ray.d);
        tMax[lane] = ray.tMax;
        time[lane] = ray.time;
    }
};

/// Whether a packet's rays start side by side in nearly one direction, as a pixel's camera rays do.
/// Of such the nearest hits are found in a third of the time, of others in twice the time; hits are
/// the same. (Shadow rays gain nothing even from one pixel's points to one light.)
enum class Coherence { Scattered, Alike };

/// Sixteen of Hit.
struct alignas(64) HitPacket {
    WideFloat t, u, v;
    WideUint geometry, primitive, instance;

    Hit At(int lane) const {
        return {t[lane], u[lane], v[lane], geometry[lane], primitive[lane], instance[lane]};
    }
};

}  // namespace pbrt
