#pragma once

#include <bit>
#include <cstdint>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

#include "pbrt/util/hash.h"

namespace pbrt {

// Sixteen numbers side by side, one for each ray of a packet; arithmetic and comparison are lane by
// lane, and the compiler splits what its registers cannot hold. Formulas that are written for a
// type T with the functions below hold for one float and for sixteen. Where the compiler does not
// find an instruction by itself, it is named.

inline constexpr int kPacketSize = 16;
using FloatX16 = float __attribute__((vector_size(64)));
using IntX16 = int32_t __attribute__((vector_size(64)));
using UintX16 = uint32_t __attribute__((vector_size(64)));
using DoubleX16 = double __attribute__((vector_size(128)));
using Uint64X16 = uint64_t __attribute__((vector_size(128)));
/// What comparing gives: in each lane all bits or none.
using MaskX16 = IntX16;
/// One bit per lane, lane 0 lowest.
using LaneBits = uint32_t;
inline constexpr LaneBits kAllLanes = 0xffff;

using Vector3fX16 = Vec3<FloatX16>;
using Point3fX16 = Vec3<FloatX16>;
using Normal3fX16 = Vec3<FloatX16>;
using Point2fX16 = Vec2<FloatX16>;
using FrameX16 = FrameT<FloatX16>;

/// The lanes 0 to n - 1.
constexpr LaneBits FirstLanes(int n) {
    return n >= kPacketSize ? kAllLanes : (LaneBits(1) << n) - 1;
}
/// Calls f(lane) for each bit that is set, from the lowest.
template <typename F>
inline void ForEachLane(LaneBits lanes, F f) {
    for (; lanes != 0; lanes &= lanes - 1)
        f(std::countr_zero(lanes));
}

template <typename T>
struct IsWideTrait : std::false_type {};
template <>
struct IsWideTrait<FloatX16> : std::true_type {};
/// What comparing two T gives.
template <typename T>
using MaskFor = std::conditional_t<IsWideTrait<T>::value, MaskX16, bool>;
template <typename T>
using IntOf = std::conditional_t<IsWideTrait<T>::value, IntX16, int>;
/// float or FloatX16.
template <typename T>
concept AnyFloat = std::is_same_v<T, float> || std::is_same_v<T, FloatX16>;

// The same names for one float, so that templates can use them.
inline float Select(bool condition, float a, float b) {
    return condition ? a : b;
}
inline uint32_t Select(bool condition, uint32_t a, uint32_t b) {
    return condition ? a : b;
}
inline float Sqrt(float a) {
    return std::sqrt(a);
}
inline double Sqrt(double a) {
    return std::sqrt(a);
}
inline float Abs(float a) {
    return std::abs(a);
}
inline float Min(float a, float b) {
    return std::min(a, b);
}
inline float Max(float a, float b) {
    return std::max(a, b);
}
inline float Floor(float a) {
    return std::floor(a);
}
inline float CopySign(float size, float sign) {
    return std::copysign(size, sign);
}
inline float FastInverseRoot(float a) {
    return 1 / std::sqrt(a);
}
/// Towards 0; 0 <= a < 2^31.
inline uint32_t Truncate(float a) {
    return uint32_t(int32_t(a));
}
inline int ToInt(float a) {
    return int(a);
}
inline bool Any(bool condition) {
    return condition;
}
inline bool All(bool condition) {
    return condition;
}

inline FloatX16 Broadcast16(float x) {
    return FloatX16{} + x;
}
inline Vec3<FloatX16> Broadcast16(Vector3f v) {
    return {Broadcast16(v.x), Broadcast16(v.y), Broadcast16(v.z)};
}
inline UintX16 Broadcast16(uint32_t x) {
    return UintX16{} + x;
}
/// 0, 1, 2, ... 15.
inline constexpr UintX16 kLaneNumbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
/// a where the mask holds, else b.
inline FloatX16 Select(MaskX16 mask, FloatX16 a, FloatX16 b) {
    return mask ? a : b;
}
inline FloatX16 Select(MaskX16 mask, float a, FloatX16 b) {
    return mask ? Broadcast16(a) : b;
}
inline FloatX16 Select(MaskX16 mask, FloatX16 a, float b) {
    return mask ? a : Broadcast16(b);
}
inline FloatX16 Select(MaskX16 mask, float a, float b) {
    return mask ? Broadcast16(a) : Broadcast16(b);
}
inline UintX16 Select(MaskX16 mask, UintX16 a, UintX16 b) {
    return mask ? a : b;
}
template <typename M, typename T>
inline Vec3<T> Select(M mask, Vec3<T> a, Vec3<T> b) {
    return {Select(mask, a.x, b.x), Select(mask, a.y, b.y), Select(mask, a.z, b.z)};
}
template <typename M, typename T>
inline Vec2<T> Select(M mask, Vec2<T> a, Vec2<T> b) {
    return {Select(mask, a.x, b.x), Select(mask, a.y, b.y)};
}
inline FloatX16 Sqrt(FloatX16 a) {
    for (int i = 0; i < kPacketSize; ++i)  // one instruction
        a[i] = std::sqrt(a[i]);
    return a;
}
inline DoubleX16 Sqrt(const DoubleX16 &a) {
    DoubleX16 root;
    for (int i = 0; i < kPacketSize; ++i)
        root[i] = std::sqrt(a[i]);
    return root;
}
inline FloatX16 Floor(FloatX16 a) {
    for (int i = 0; i < kPacketSize; ++i)  // one instruction
        a[i] = std::floor(a[i]);
    return a;
}
inline FloatX16 Abs(FloatX16 a) {
    return std::bit_cast<FloatX16>(std::bit_cast<IntX16>(a) & 0x7fffffff);
}
inline FloatX16 CopySign(FloatX16 size, FloatX16 sign) {
    return std::bit_cast<FloatX16>((std::bit_cast<IntX16>(size) & 0x7fffffff) |
                                   (std::bit_cast<IntX16>(sign) & ~0x7fffffff));
}
inline FloatX16 CopySign(float size, FloatX16 sign) {
    return CopySign(Broadcast16(size), sign);
}
// Where one of the two is a constant, g++ 12 compares and blends.
inline FloatX16 Min(FloatX16 a, FloatX16 b) {
#if defined(__AVX512F__)
    return std::bit_cast<FloatX16>(
        _mm512_maskz_min_ps(0xffff, std::bit_cast<__m512>(a), std::bit_cast<__m512>(b)));
#else
    return a < b ? a : b;
#endif
}
inline FloatX16 Min(FloatX16 a, float b) {
    return Min(a, Broadcast16(b));
}
inline FloatX16 Max(FloatX16 a, FloatX16 b) {
#if defined(__AVX512F__)
    return std::bit_cast<FloatX16>(
        _mm512_maskz_max_ps(0xffff, std::bit_cast<__m512>(a), std::bit_cast<__m512>(b)));
#else
    return a > b ? a : b;
#endif
}
inline FloatX16 Max(FloatX16 a, float b) {
    return Max(a, Broadcast16(b));
}
inline IntX16 ToInt(FloatX16 a) {
    return __builtin_convertvector(a, IntX16);
}
inline UintX16 Truncate(FloatX16 a) {
    return std::bit_cast<UintX16>(__builtin_convertvector(a, IntX16));
}
/// 64 bits from two halves, and back.
inline Uint64X16 Join(UintX16 low, UintX16 high) {
    return __builtin_convertvector(low, Uint64X16) |
           (__builtin_convertvector(high, Uint64X16) << 32);
}
inline UintX16 LowHalf(const Uint64X16 &a) {
    return __builtin_convertvector(a, UintX16);
}
inline UintX16 HighHalf(const Uint64X16 &a) {
    return __builtin_convertvector(a >> 32, UintX16);
}
/// Of numbers below 2^31.
inline FloatX16 ToFloat(UintX16 a) {
    return __builtin_convertvector(std::bit_cast<IntX16>(a), FloatX16);
}
/// As that of one number: the 24 upper bits as a number in [0, 1).
inline FloatX16 ToUnitFloat(UintX16 bits) {
    return ToFloat(bits >> 8) * 0x1p-24f;
}
inline FloatX16 Clamp(FloatX16 a, float low, float high) {
    return Min(Max(a, low), high);
}
inline float Clamp(float a, float low, float high) {
    return std::clamp(a, low, high);
}
inline FloatX16 SafeSqrt(FloatX16 a) {
    return Sqrt(Max(a, 0.f));
}
/// 1 / sqrt(a) to within 2^-14 of itself; 1e-37 < a < infinity. A tenth of a division's time.
inline FloatX16 FastInverseRoot(FloatX16 a) {
#if defined(__AVX512F__)
    return std::bit_cast<FloatX16>(_mm512_maskz_rsqrt14_ps(0xffff, std::bit_cast<__m512>(a)));
#else
    return 1 / Sqrt(a);
#endif
}
/// Sums of the lanes up to and with each.
inline FloatX16 InclusiveScan(FloatX16 a) {
    constexpr FloatX16 zero{};
    a += __builtin_shufflevector(zero, a, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,
                                 30);
    a += __builtin_shufflevector(zero, a, 0, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28,
                                 29);
    a += __builtin_shufflevector(zero, a, 0, 0, 0, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26,
                                 27);
    return a +
           __builtin_shufflevector(zero, a, 0, 0, 0, 0, 0, 0, 0, 0, 16, 17, 18, 19, 20, 21, 22, 23);
}
inline Vec3<FloatX16> operator*(float s, Vec3<FloatX16> a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline Vec3<FloatX16> Max(Vec3<FloatX16> a, Vec3<FloatX16> b) {
    return {Max(a.x, b.x), Max(a.y, b.y), Max(a.z, b.z)};
}
inline FloatX16 AbsDot(Vec3<FloatX16> a, Vec3<FloatX16> b) {
    return Abs(Dot(a, b));
}
inline Vec3<FloatX16> FaceForward(Vec3<FloatX16> n, Vec3<FloatX16> v) {
    return Select(Dot(n, v) < 0, -n, n);
}
inline Vec3<FloatX16> Abs(Vec3<FloatX16> a) {
    return {Abs(a.x), Abs(a.y), Abs(a.z)};
}
inline FloatX16 Length(Vec3<FloatX16> a) {
    return Sqrt(Dot(a, a));
}
inline Vec3<FloatX16> Normalize(Vec3<FloatX16> a) {
    return a * (1 / Length(a));
}

inline LaneBits BitsOf(MaskX16 mask) {
#if defined(__AVX512F__)
    const __m512i v = std::bit_cast<__m512i>(mask);
    return _mm512_test_epi32_mask(v, v);
#else
    LaneBits bits = 0;
    for (int i = 0; i < kPacketSize; ++i)
        bits |= LaneBits(mask[i] < 0) << i;
    return bits;
#endif
}
inline MaskX16 MaskOf(LaneBits bits) {
    constexpr IntX16 kBit{1 << 0, 1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                          1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
    return (kBit & int32_t(bits)) != 0;
}
inline bool Any(MaskX16 mask) {
    return BitsOf(mask) != 0;
}
inline bool All(MaskX16 mask) {
    return BitsOf(mask) == kAllLanes;
}

/// 16 successive numbers; any alignment.
inline FloatX16 LoadWide(const float *from) {
    FloatX16 v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
inline UintX16 LoadWide(const uint32_t *from) {
    UintX16 v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
inline void StoreWide(FloatX16 v, float *to) {
    __builtin_memcpy(to, &v, sizeof v);
}
inline void StoreWide(UintX16 v, uint32_t *to) {
    __builtin_memcpy(to, &v, sizeof v);
}

/// Sixteen T: of float or uint32_t.
template <typename T>
using WideOf = std::conditional_t<std::is_same_v<T, float>, FloatX16, UintX16>;

// With masks that hold, for g++ 12 takes the unmasked forms for uses of uninitialised values.

/// from[index[lane]] in each lane; every index must be readable. T: float or uint32_t.
template <typename T>
inline WideOf<T> Gather(const T *from, UintX16 index) {
#if defined(__AVX512F__)
    return std::bit_cast<WideOf<T>>(_mm512_mask_i32gather_epi32(
        _mm512_setzero_si512(), 0xffff, std::bit_cast<__m512i>(index), from, 4));
#else
    WideOf<T> v;
    for (int i = 0; i < kPacketSize; ++i)
        v[i] = from[index[i]];
    return v;
#endif
}
/// table[index[lane] % 16] in each lane; a tenth of a Gather's time.
inline UintX16 Permute(UintX16 table, UintX16 index) {
#if defined(__AVX512F__)
    return std::bit_cast<UintX16>(_mm512_maskz_permutexvar_epi32(
        0xffff, std::bit_cast<__m512i>(index), std::bit_cast<__m512i>(table)));
#else
    UintX16 v;
    for (int i = 0; i < kPacketSize; ++i)
        v[i] = table[index[i] % kPacketSize];
    return v;
#endif
}
/// to[index[lane]] = v[lane] in the given lanes; of equal indices the last lane's counts.
template <typename T>
inline void Scatter(T *to, UintX16 index, WideOf<T> v, LaneBits lanes) {
#if defined(__AVX512F__)
    _mm512_mask_i32scatter_epi32(to, __mmask16(lanes), std::bit_cast<__m512i>(index),
                                 std::bit_cast<__m512i>(v), 4);
#else
    ForEachLane(lanes, [&](int i) { to[index[i]] = v[i]; });
#endif
}

/// The given lanes of v, one after another; writes up to sixteen numbers.
template <typename T>
inline void StoreLanes(T *to, WideOf<T> v, LaneBits lanes) {
#if defined(__AVX512F__)
    _mm512_storeu_si512(to,
                        _mm512_maskz_compress_epi32(__mmask16(lanes), std::bit_cast<__m512i>(v)));
#else
    ForEachLane(lanes, [&](int i) { *to++ = v[i]; });
#endif
}

/// Lane i of a point or vector.
inline Vector3f Lane(const Vec3<FloatX16> &v, int i) {
    return {v.x[i], v.y[i], v.z[i]};
}
inline Point2f Lane(const Vec2<FloatX16> &v, int i) {
    return {v.x[i], v.y[i]};
}
inline void SetLane(Vec3<FloatX16> *v, int i, Vector3f value) {
    v->x[i] = value.x, v->y[i] = value.y, v->z[i] = value.z;
}
inline void SetLane(FrameX16 *frame, int i, const Frame &value) {
    SetLane(&frame->x, i, value.x);
    SetLane(&frame->y, i, value.y);
    SetLane(&frame->z, i, value.z);
}
inline void SetLane(FloatX16 *v, int i, float value) {
    (*v)[i] = value;
}
inline void SetLane(Vec2<FloatX16> *v, int i, Point2f value) {
    v->x[i] = value.x, v->y[i] = value.y;
}

}  // namespace pbrt
