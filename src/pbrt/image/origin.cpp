#include "pbrt/image/origin.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "pbrt/util/parse_number.h"

namespace pbrt {
namespace {

constexpr const char *kScene = "sceneHash", *kSeed = "seed", *kRange = "sampleRange";

const std::string *Find(const ImageMetadata &metadata, const char *name) {
    const auto found = metadata.strings.find(name);
    return found == metadata.strings.end() ? nullptr : &found->second;
}

/// The numbers between the separators.
std::optional<std::vector<int>> Numbers(std::string_view text, std::string_view separator) {
    std::vector<int> numbers;
    for (;;) {
        const size_t end = text.find(separator);
        const std::optional<int> number = ParseWhole<int>(text.substr(0, end));
        if (!number) return {};
        numbers.push_back(*number);
        if (end == text.npos) return numbers;
        text.remove_prefix(end + separator.size());
    }
}

bool Overlap(int a0, int a1, int b0, int b1) {
    return std::max(a0, b0) < std::min(a1, b1);
}

}  // namespace

std::optional<Origin> OriginOf(const ImageMetadata &metadata) {
    const std::string *const scene = Find(metadata, kScene), *const seed = Find(metadata, kSeed),
                             *const range = Find(metadata, kRange);
    if (!scene || !seed || !range) return {};
    constexpr std::string_view kOf = " of ";
    const size_t of = range->find(kOf);
    if (of == range->npos) return {};
    const auto seeds = Numbers(*seed, ",");
    const auto ends = Numbers(std::string_view(*range).substr(0, of), ":");
    const auto whole = ParseWhole<int>(std::string_view(*range).substr(of + kOf.size()));
    if (!seeds || !ends || ends->size() != 2 || !whole) return {};
    const Origin origin{*scene, *seeds, ends->at(0), ends->at(1), *whole};
    const bool sound = 0 <= origin.first && origin.first < origin.last && origin.last <= *whole;
    return sound ? std::optional(origin) : std::nullopt;
}

void SetOrigin(const Origin &origin, ImageMetadata *metadata) {
    metadata->strings[kScene] = origin.scene;
    metadata->strings[kSeed] = fmt::format("{}", fmt::join(origin.seeds, ","));
    metadata->strings[kRange] = fmt::format("{}:{} of {}", origin.first, origin.last, origin.whole);
}

void ClearOrigin(ImageMetadata *metadata) {
    for (const char *const name : {kScene, kSeed, kRange})
        metadata->strings.erase(name);
}

bool ShareSamples(const ImageMetadata &a, const ImageMetadata &b) {
    const std::optional<Origin> originA = OriginOf(a), originB = OriginOf(b);
    if (!originA || !originB || originA->scene != originB->scene) return false;
    const bool sameSeed = std::any_of(originA->seeds.begin(), originA->seeds.end(), [&](int seed) {
        return std::count(originB->seeds.begin(), originB->seeds.end(), seed) > 0;
    });
    const auto &p = a.pixelBounds, &q = b.pixelBounds;
    return sameSeed && Overlap(originA->first, originA->last, originB->first, originB->last) &&
           Overlap(p[0], p[1], q[0], q[1]) && Overlap(p[2], p[3], q[2], q[3]);
}

}  // namespace pbrt
