#pragma once

#include "pbrt/util/wide.h"

namespace pbrt {

/// Sixteen rays side by side. Embree's layout: it traces them where they stand.
struct alignas(64) RayPacket {
    WidePoint3f o;
    WideVector3f d;
    WideFloat tMax, time;
};

/// Sixteen of Hit. Lanes that met nothing are undefined.
struct alignas(64) HitPacket {
    WideFloat t, u, v;
    WideUint geometry, primitive, instance;
};

}  // namespace pbrt
