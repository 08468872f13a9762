#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// 2^64 over the golden ratio, odd: steps of it fill the integers evenly (Weyl sequence).
inline constexpr uint64_t kGolden64 = 0x9e3779b97f4a7c15;

/// Bijection of 64 bits in which each input bit flips each output bit about half the time:
/// x ^= x >> a, x *= b, ... as MurmurHash3's finaliser (Appleby), with Stafford's constants
/// ("Mix13", 2011). Mix64(0) = 0. U: uint64_t, or several of them side by side.
template <typename U>
requires(!std::is_arithmetic_v<U> || std::is_same_v<U, uint64_t>) constexpr U Mix64(const U &bits) {
    U x = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

/// The same for 32 bits (constants: Wellons 2018, bias 0.17). Mix32(0) = 0. U: uint32_t, or several
/// of them side by side.
template <typename U>
requires(!std::is_arithmetic_v<U> || std::is_same_v<U, uint32_t>) constexpr U Mix32(U x) {
    x = (x ^ (x >> 16)) * 0x7feb352d;
    x = (x ^ (x >> 15)) * 0x846ca68b;
    return x ^ (x >> 16);
}

/// The 24 upper bits as a number in [0, 1).
constexpr float ToUnitFloat(uint32_t bits) {
    return float(int32_t(bits >> 8)) * 0x1p-24f;
}

namespace detail {
template <typename T>
requires(std::is_integral_v<T> || std::is_enum_v<T>) constexpr uint64_t Absorb(uint64_t h, T x) {
    return Mix64((h + kGolden64) ^ uint64_t(x));
}
constexpr uint64_t Absorb(uint64_t h, float x) {
    return Absorb(h, std::bit_cast<uint32_t>(x == 0 ? 0.f : x));
}
template <typename T>
constexpr uint64_t Absorb(uint64_t h, Vec2<T> v) {
    return Absorb(Absorb(h, v.x), v.y);
}
template <typename T>
constexpr uint64_t Absorb(uint64_t h, Vec3<T> v) {
    return Absorb(Absorb(Absorb(h, v.x), v.y), v.z);
}
}  // namespace detail

/// 64 well-mixed bits of integers, enumerations, floats (0 and -0 count as equal), points and
/// vectors, in order; the same on every machine.
template <typename... Ts>
constexpr uint64_t Hash(const Ts &...values) {
    uint64_t h = 0;
    ((h = detail::Absorb(h, values)), ...);
    return h;
}

/// Hash as a number in [0, 1).
template <typename... Ts>
constexpr float HashFloat(const Ts &...values) {
    return ToUnitFloat(uint32_t(Hash(values...) >> 32));
}

}  // namespace pbrt
