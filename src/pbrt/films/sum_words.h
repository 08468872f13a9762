#pragma once

#include <span>
#include <string_view>

#include "pbrt/films/exact_sum.h"

namespace pbrt {

// Files with some of a picture's samples hold its exact sums, too, so that they can be joined:
// image/exr_words.h, of the name kSumsPart, with an attribute kFilmAttribute, the film's type.

inline constexpr std::string_view kSumsPart = "sums", kFilmAttribute = "film";
inline constexpr size_t kWordsPerSum = 4;

/// sums.size() * kWordsPerSum words, and back.
inline void PutWords(std::span<const ExactSum> sums, uint32_t *words) {
    for (const ExactSum &sum : sums)
        for (const uint32_t word : sum.Words())
            *words++ = word;
}
inline void TakeWords(const uint32_t *words, std::span<ExactSum> sums) {
    for (ExactSum &sum : sums) {
        sum = ExactSum::FromWords(words);
        words += kWordsPerSum;
    }
}

}  // namespace pbrt
