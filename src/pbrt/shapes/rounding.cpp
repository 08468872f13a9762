#include "pbrt/shapes/rounding.h"

namespace pbrt {

CrossDirection CrossDirectionInDouble(Vector3f a, Vector3f b) {
    const Vector3d d = Cross(ToDouble(a), ToDouble(b));
    const double length2 = LengthSquared(d);
    if (length2 == 0) return {{0, 0, 1}, 0};
    const double inverse = 1 / std::sqrt(length2);
    return {ToFloat(d * inverse), float(std::min(inverse, 1e30))};
}

CrossDirectionT<FloatX16> CrossDirectionInDouble(Vector3fX16 a, Vector3fX16 b) {
    CrossDirectionT<FloatX16> c;
    for (int i = 0; i < kPacketSize; ++i) {
        const CrossDirection lane = DirectionOfCross(Lane(a, i), Lane(b, i));
        SetLane(&c.n, i, lane.n);
        c.inverseLength.Set(i, lane.inverseLength);
    }
    return c;
}

}  // namespace pbrt
