#pragma once

#include "feather/model.h"

namespace pbrt::feather {

/// Sixteen barbules, one by one and side by side.
template <std::floating_point T>
class Sixteen {
  public:
    using V = SimdX16<T>;
    using Wide = Barbule<V, 4>;

    void Set(int k, const Shape &shape, const Optics<T, 4> &at = Feather<T>()) {
        one.resize(kPacketSize, BarbuleOf<T>({}));
        one[k] = BarbuleOf<T>(shape, at);
        vane.Set(k, Vane<T>(ParamsOf<T>(shape)));
        thickness.Set(k, T(shape.thickness));
        roughness.Set(k, T(shape.roughness));
        for (int i = 0; i < 4; ++i) {
            optics.lambda[i].Set(k, at.lambda[i]);
            optics.eta[i].Set(k, at.eta[i]);
            optics.melanin[i].Set(k, at.melanin[i]);
        }
    }
    const Barbule<T, 4> &One(int k) const { return one[k]; }
    Wide SideBySide() const { return Wide(vane, {thickness}, optics, {roughness}); }

  private:
    std::vector<Barbule<T, 4>> one;
    Vane<V> vane;
    V thickness, roughness;
    Optics<V, 4> optics;
};

template <std::floating_point T>
void SetLane(Direction<SimdX16<T>> *to, int k, const Direction<T> &w) {
    to->x.Set(k, w.x), to->y.Set(k, w.y), to->z.Set(k, w.z);
}
template <std::floating_point T>
Direction<T> Lane(const Direction<SimdX16<T>> &w, int k) {
    return {w.x[k], w.y[k], w.z[k]};
}

}  // namespace pbrt::feather
