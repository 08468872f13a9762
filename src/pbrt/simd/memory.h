#pragma once

#include <cstdint>
#include <type_traits>

#include "simd.h"

namespace pbrt {

/// 16 successive numbers; any alignment.
template <class T>
[[gnu::always_inline]] inline SimdX16<T> LoadX16(const T *from) {
    return SimdX16<T>::Load(from);
}
template <class T, int N>
[[gnu::always_inline]] inline void Store(const Simd<T, N> &v, std::type_identity_t<T> *to) {
    v.Store(to);
}

// Of numbers of four bytes.

/// from[index[k]] as element k; every index must be readable, and below 2^31.
template <class T>
[[gnu::always_inline]] inline SimdX16<T> Gather(const T *from, const UintX16 &index) {
#if defined(__AVX512F__)
    static_assert(sizeof(T) == 4);
    SimdX16<T> v;
    v.part[0] = typename SimdX16<T>::Register(_mm512_mask_i32gather_epi32(
        _mm512_setzero_si512(), 0xffff, __m512i(index.part[0]), from, 4));
    return v;
#else
    return SimdX16<T>::Generate([&](int k)
                                    __attribute__((always_inline)) { return from[index[k]]; });
#endif
}

/// to[index[k]] = v[k] for the given elements; of equal indices the last element's counts.
template <class T>
[[gnu::always_inline]] inline void Scatter(T *to, const UintX16 &index, const SimdX16<T> &v,
                                           LaneBits lanes) {
#if defined(__AVX512F__)
    static_assert(sizeof(T) == 4);
    _mm512_mask_i32scatter_epi32(to, __mmask16(lanes), __m512i(index.part[0]), __m512i(v.part[0]),
                                 4);
#else
    T values[kPacketSize];
    uint32_t places[kPacketSize];
    v.Store(values);
    index.Store(places);
    ForEachLane(lanes, [&](int k) { to[places[k]] = values[k]; });
#endif
}

/// The given elements of v, one after another; writes up to sixteen numbers.
template <class T>
[[gnu::always_inline]] inline void Compress(T *to, const SimdX16<T> &v, LaneBits lanes) {
#if defined(__AVX512F__)
    static_assert(sizeof(T) == 4);
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(__mmask16(lanes), __m512i(v.part[0])));
#else
    T values[kPacketSize];
    v.Store(values);
    ForEachLane(lanes, [&](int k) { *to++ = values[k]; });
#endif
}

}  // namespace pbrt
