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

inline constexpr int kWide = 16;
using WideFloat = float __attribute__((vector_size(64)));
using WideInt = int32_t __attribute__((vector_size(64)));
using WideUint = uint32_t __attribute__((vector_size(64)));
using WideDouble = double __attribute__((vector_size(128)));
using WideUint64 = uint64_t __attribute__((vector_size(128)));
/// What comparing gives: in each lane all bits or none.
using WideMask = WideInt;
/// One bit per lane, lane 0 lowest.
using LaneBits = uint32_t;
inline constexpr LaneBits kAllLanes = 0xffff;

using WideVector3f = Vec3<WideFloat>;
using WidePoint3f = Vec3<WideFloat>;
using WideNormal3f = Vec3<WideFloat>;
using WidePoint2f = Vec2<WideFloat>;
using WideFrame = FrameT<WideFloat>;

/// The lanes 0 to n - 1.
constexpr LaneBits FirstLanes(int n) {
    return n >= kWide ? kAllLanes : (LaneBits(1) << n) - 1;
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
struct IsWideTrait<WideFloat> : std::true_type {};
/// What comparing two T gives.
template <typename T>
using MaskFor = std::conditional_t<IsWideTrait<T>::value, WideMask, bool>;
template <typename T>
using IntOf = std::conditional_t<IsWideTrait<T>::value, WideInt, int>;
/// float or WideFloat.
template <typename T>
concept AnyFloat = std::is_same_v<T, float> || std::is_same_v<T, WideFloat>;

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

inline WideFloat Broadcast16(float x) {
    return WideFloat{} + x;
}
inline Vec3<WideFloat> Broadcast16(Vector3f v) {
    return {Broadcast16(v.x), Broadcast16(v.y), Broadcast16(v.z)};
}
inline WideUint Broadcast16(uint32_t x) {
    return WideUint{} + x;
}
/// 0, 1, 2, ... 15.
inline constexpr WideUint kLaneNumbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
/// a where the mask holds, else b.
inline WideFloat Select(WideMask mask, WideFloat a, WideFloat b) {
    return mask ? a : b;
}
inline WideFloat Select(WideMask mask, float a, WideFloat b) {
    return mask ? Broadcast16(a) : b;
}
inline WideFloat Select(WideMask mask, WideFloat a, float b) {
    return mask ? a : Broadcast16(b);
}
inline WideFloat Select(WideMask mask, float a, float b) {
    return mask ? Broadcast16(a) : Broadcast16(b);
}
inline WideUint Select(WideMask mask, WideUint a, WideUint b) {
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
inline WideFloat Sqrt(WideFloat a) {
    for (int i = 0; i < kWide; ++i)  // one instruction
        a[i] = std::sqrt(a[i]);
    return a;
}
inline WideDouble Sqrt(const WideDouble &a) {
    WideDouble root;
    for (int i = 0; i < kWide; ++i)
        root[i] = std::sqrt(a[i]);
    return root;
}
inline WideFloat Floor(WideFloat a) {
    for (int i = 0; i < kWide; ++i)  // one instruction
        a[i] = std::floor(a[i]);
    return a;
}
inline WideFloat Abs(WideFloat a) {
    return std::bit_cast<WideFloat>(std::bit_cast<WideInt>(a) & 0x7fffffff);
}
inline WideFloat CopySign(WideFloat size, WideFloat sign) {
    return std::bit_cast<WideFloat>((std::bit_cast<WideInt>(size) & 0x7fffffff) |
                                    (std::bit_cast<WideInt>(sign) & ~0x7fffffff));
}
inline WideFloat CopySign(float size, WideFloat sign) {
    return CopySign(Broadcast16(size), sign);
}
// Where one of the two is a constant, g++ 12 compares and blends.
inline WideFloat Min(WideFloat a, WideFloat b) {
#if defined(__AVX512F__)
    return std::bit_cast<WideFloat>(
        _mm512_maskz_min_ps(0xffff, std::bit_cast<__m512>(a), std::bit_cast<__m512>(b)));
#else
    return a < b ? a : b;
#endif
}
inline WideFloat Min(WideFloat a, float b) {
    return Min(a, Broadcast16(b));
}
inline WideFloat Max(WideFloat a, WideFloat b) {
#if defined(__AVX512F__)
    return std::bit_cast<WideFloat>(
        _mm512_maskz_max_ps(0xffff, std::bit_cast<__m512>(a), std::bit_cast<__m512>(b)));
#else
    return a > b ? a : b;
#endif
}
inline WideFloat Max(WideFloat a, float b) {
    return Max(a, Broadcast16(b));
}
inline WideInt ToInt(WideFloat a) {
    return __builtin_convertvector(a, WideInt);
}
inline WideUint Truncate(WideFloat a) {
    return std::bit_cast<WideUint>(__builtin_convertvector(a, WideInt));
}
/// 64 bits from two halves, and back.
inline WideUint64 Join(WideUint low, WideUint high) {
    return __builtin_convertvector(low, WideUint64) |
           (__builtin_convertvector(high, WideUint64) << 32);
}
inline WideUint LowHalf(const WideUint64 &a) {
    return __builtin_convertvector(a, WideUint);
}
inline WideUint HighHalf(const WideUint64 &a) {
    return __builtin_convertvector(a >> 32, WideUint);
}
/// Of numbers below 2^31.
inline WideFloat ToFloat(WideUint a) {
    return __builtin_convertvector(std::bit_cast<WideInt>(a), WideFloat);
}
/// As that of one number: the 24 upper bits as a number in [0, 1).
inline WideFloat ToUnitFloat(WideUint bits) {
    return ToFloat(bits >> 8) * 0x1p-24f;
}
inline WideFloat Clamp(WideFloat a, float low, float high) {
    return Min(Max(a, low), high);
}
inline float Clamp(float a, float low, float high) {
    return std::clamp(a, low, high);
}
inline WideFloat SafeSqrt(WideFloat a) {
    return Sqrt(Max(a, 0.f));
}
/// 1 / sqrt(a) to within 2^-14 of itself; 1e-37 < a < infinity. A tenth of a division's time.
inline WideFloat FastInverseRoot(WideFloat a) {
#if defined(__AVX512F__)
    return std::bit_cast<WideFloat>(_mm512_maskz_rsqrt14_ps(0xffff, std::bit_cast<__m512>(a)));
#else
    return 1 / Sqrt(a);
#endif
}
/// Sums of the lanes up to and with each.
inline WideFloat SumsUpTo(WideFloat a) {
    constexpr WideFloat zero{};
    a += __builtin_shufflevector(zero, a, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,
                                 30);
    a += __builtin_shufflevector(zero, a, 0, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28,
                                 29);
    a += __builtin_shufflevector(zero, a, 0, 0, 0, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26,
                                 27);
    return a +
           __builtin_shufflevector(zero, a, 0, 0, 0, 0, 0, 0, 0, 0, 16, 17, 18, 19, 20, 21, 22, 23);
}
inline Vec3<WideFloat> operator*(float s, Vec3<WideFloat> a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline Vec3<WideFloat> Max(Vec3<WideFloat> a, Vec3<WideFloat> b) {
    return {Max(a.x, b.x), Max(a.y, b.y), Max(a.z, b.z)};
}
inline WideFloat AbsDot(Vec3<WideFloat> a, Vec3<WideFloat> b) {
    return Abs(Dot(a, b));
}
inline Vec3<WideFloat> FaceForward(Vec3<WideFloat> n, Vec3<WideFloat> v) {
    return Select(Dot(n, v) < 0, -n, n);
}
inline Vec3<WideFloat> Abs(Vec3<WideFloat> a) {
    return {Abs(a.x), Abs(a.y), Abs(a.z)};
}
inline WideFloat Length(Vec3<WideFloat> a) {
    return Sqrt(Dot(a, a));
}
inline Vec3<WideFloat> Normalize(Vec3<WideFloat> a) {
    return a * (1 / Length(a));
}

inline LaneBits BitsOf(WideMask mask) {
#if defined(__AVX512F__)
    const __m512i v = std::bit_cast<__m512i>(mask);
    return _mm512_test_epi32_mask(v, v);
#else
    LaneBits bits = 0;
    for (int i = 0; i < kWide; ++i)
        bits |= LaneBits(mask[i] < 0) << i;
    return bits;
#endif
}
inline WideMask MaskOf(LaneBits bits) {
    constexpr WideInt kBit{1 << 0, 1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                           1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
    return (kBit & int32_t(bits)) != 0;
}
inline bool Any(WideMask mask) {
    return BitsOf(mask) != 0;
}
inline bool All(WideMask mask) {
    return BitsOf(mask) == kAllLanes;
}

/// 16 successive numbers; any alignment.
inline WideFloat LoadWide(const float *from) {
    WideFloat v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
inline WideUint LoadWide(const uint32_t *from) {
    WideUint v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
inline void StoreWide(WideFloat v, float *to) {
    __builtin_memcpy(to, &v, sizeof v);
}
inline void StoreWide(WideUint v, uint32_t *to) {
    __builtin_memcpy(to, &v, sizeof v);
}

/// Sixteen T: of float or uint32_t.
template <typename T>
using WideOf = std::conditional_t<std::is_same_v<T, float>, WideFloat, WideUint>;

// With masks that hold, for g++ 12 takes the unmasked forms for uses of uninitialised values.

/// from[index[lane]] in each lane; every index must be readable. T: float or uint32_t.
template <typename T>
inline WideOf<T> Gather(const T *from, WideUint index) {
#if defined(__AVX512F__)
    return std::bit_cast<WideOf<T>>(_mm512_mask_i32gather_epi32(
        _mm512_setzero_si512(), 0xffff, std::bit_cast<__m512i>(index), from, 4));
#else
    WideOf<T> v;
    for (int i = 0; i < kWide; ++i)
        v[i] = from[index[i]];
    return v;
#endif
}
/// table[index[lane] % 16] in each lane; a tenth of a Gather's time.
inline WideUint Permute(WideUint table, WideUint index) {
#if defined(__AVX512F__)
    return std::bit_cast<WideUint>(_mm512_maskz_permutexvar_epi32(
        0xffff, std::bit_cast<__m512i>(index), std::bit_cast<__m512i>(table)));
#else
    WideUint v;
    for (int i = 0; i < kWide; ++i)
        v[i] = table[index[i] % kWide];
    return v;
#endif
}
/// to[index[lane]] = v[lane] in the given lanes; of equal indices the last lane's counts.
template <typename T>
inline void Scatter(T *to, WideUint index, WideOf<T> v, LaneBits lanes) {
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
inline Vector3f Lane(const Vec3<WideFloat> &v, int i) {
    return {v.x[i], v.y[i], v.z[i]};
}
inline Point2f Lane(const Vec2<WideFloat> &v, int i) {
    return {v.x[i], v.y[i]};
}
inline void SetLane(Vec3<WideFloat> *v, int i, Vector3f value) {
    v->x[i] = value.x, v->y[i] = value.y, v->z[i] = value.z;
}
inline void SetLane(WideFrame *frame, int i, const Frame &value) {
    SetLane(&frame->x, i, value.x);
    SetLane(&frame->y, i, value.y);
    SetLane(&frame->z, i, value.z);
}
inline void SetLane(WideFloat *v, int i, float value) {
    (*v)[i] = value;
}
inline void SetLane(Vec2<WideFloat> *v, int i, Point2f value) {
    v->x[i] = value.x, v->y[i] = value.y;
}

}  // namespace pbrt
