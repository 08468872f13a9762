#include "pbrt/imgtool/parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "pbrt/films/film.h"
#include "pbrt/films/sum_words.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/util/hash.h"

namespace pbrt::imgtool {
namespace {

using Bounds = std::array<int, 4>;  ///< x0 x1 y0 y1, as in ImageMetadata

bool Overlap(const Bounds &a, const Bounds &b) {
    return std::max(a[0], b[0]) < std::min(a[1], b[1]) &&
           std::max(a[2], b[2]) < std::min(a[3], b[3]);
}

Bounds Around(std::span<const Part> parts) {
    Bounds all = parts[0].image.metadata.pixelBounds;
    for (const Part &part : parts) {
        const Bounds &b = part.image.metadata.pixelBounds;
        all = {std::min(all[0], b[0]), std::max(all[1], b[1]), std::min(all[2], b[2]),
               std::max(all[3], b[3])};
    }
    return all;
}

std::string SeedText(const Origin &origin) {
    return fmt::format("{}", fmt::join(origin.seeds, ","));
}

/// How the second differs from the first, as the rest of a sentence.
std::optional<std::string> Difference(const Part &a, const Part &b) {
    const ImageMetadata &m = a.image.metadata, &n = b.image.metadata;
    if (a.image.ChannelNames() != b.image.ChannelNames()) return "have other channels";
    if (m.storedAs != n.storedAs)
        return fmt::format("hold {} and {} numbers", m.storedAs, n.storedAs);
    if (m.fullResolution != n.fullResolution)
        return fmt::format("are of pictures of {} x {} and {} x {} pixels", m.fullResolution.x,
                           m.fullResolution.y, n.fullResolution.x, n.fullResolution.y);
    if (a.origin.has_value() != b.origin.has_value())
        return "are from different programs: one says which samples it holds, one does not";
    if (!a.origin) return {};
    if (a.origin->scene != b.origin->scene) return "are of different scenes, or other options";
    if (a.origin->seeds != b.origin->seeds)
        return fmt::format("have the seeds {} and {}; imgtool average joins such pictures",
                           SeedText(*a.origin), SeedText(*b.origin));
    if (a.origin->whole != b.origin->whole)
        return fmt::format("are parts of {} and of {} samples per pixel", a.origin->whole,
                           b.origin->whole);
    return {};
}

std::string RangeText(const Part &part) {
    const Bounds &b = part.image.metadata.pixelBounds;
    const std::string pixels =
        fmt::format("the pixels [{}, {}) x [{}, {})", b[0], b[1], b[2], b[3]);
    if (!part.origin) return pixels;
    return fmt::format("the samples {}:{} of {}", part.origin->first, part.origin->last, pixels);
}

std::optional<std::string> Clash(const Part &a, const Part &b) {
    const bool same = a.origin
                          ? ShareSamples(a.image.metadata, b.image.metadata)
                          : Overlap(a.image.metadata.pixelBounds, b.image.metadata.pixelBounds);
    if (!same) return {};
    return fmt::format("overlap: they hold {} and {}", RangeText(a), RangeText(b));
}

/// True where the part has all samples of its pixels, so that they are developed.
bool IsWhole(const Part &part) {
    return !part.origin || part.origin->IsWhole();
}

/// A picture on its way: what of each pixel is there.
class Canvas {
  public:
    Canvas(std::span<const Part> parts, const Bounds &bounds)
        : bounds(bounds), image({Width(), bounds[3] - bounds[2]}, parts[0].image.ChannelNames()) {
        image.metadata = parts[0].image.metadata;
        image.metadata.pixelBounds = bounds;
        image.metadata.mse.reset();
        const size_t pixels = size_t(image.Resolution().x) * size_t(image.Resolution().y);
        coverage.resize(pixels);
        for (const Part &part : parts) {
            perPixel = std::max(perPixel, part.sums.perPixel / kWordsPerSum);
            ends.insert(
                {part.origin ? part.origin->first : 0, part.origin ? part.origin->last : 1});
        }
        sums.resize(pixels * perPixel);
    }

    void Add(const Part &part) {
        const Bounds &b = part.image.metadata.pixelBounds;
        std::vector<ExactSum> more(perPixel);
        const uint64_t covers = CoverageOf(part);
        for (int y = b[2]; y < b[3]; ++y)
            for (int x = b[0]; x < b[1]; ++x) {
                const size_t to = At(x, y);
                const Point2i from{x - b[0], y - b[2]};
                coverage[to] += covers;
                if (IsWhole(part)) {
                    std::copy_n(part.image.Pixel(from), image.NChannels(),
                                image.Data().begin() + ptrdiff_t(to * image.NChannels()));
                    continue;
                }
                const size_t place = size_t(from.y) * size_t(b[1] - b[0]) + size_t(from.x);
                TakeWords(&part.sums.values[place * part.sums.perPixel], more);
                for (size_t i = 0; i < perPixel; ++i)
                    sums[to * perPixel + i] += more[i];
            }
    }

    /// Develops the pixels that have this coverage; none, or the bits of one part, are as they are.
    void Develop(const Film &film, uint64_t whole, bool all) {
        // The film has its channels in another order than a file that was read.
        const Image inFilm = film.NewImage();
        std::vector<int> places;
        for (const std::string &name : inFilm.ChannelNames())
            places.push_back(image.ChannelIndex(name));
        std::vector<float> values(places.size());
        for (size_t i = 0; i < coverage.size(); ++i) {
            const std::span<const ExactSum> pixel(&sums[i * perPixel], perPixel);
            const bool summed = std::any_of(pixel.begin(), pixel.end(),
                                            [](const ExactSum &s) { return s != ExactSum(); });
            if (coverage[i] != whole || !(summed || all)) continue;
            film.Develop(film.Unflatten(pixel.data()), values.data());
            for (size_t c = 0; c < places.size(); ++c)
                if (places[c] >= 0)
                    image.Data()[i * size_t(image.NChannels()) + size_t(places[c])] = values[c];
        }
    }

    /// A number for a set of samples; of sets without a common sample they add up.
    uint64_t CoverageOf(int first, int last) const {
        uint64_t covers = 0;
        int before = -1;
        for (const int end : ends) {
            if (before >= first && end <= last) covers += Hash(before, end);
            before = end;
        }
        return covers;
    }
    uint64_t CoverageOf(const Part &part) const {
        return part.origin ? CoverageOf(part.origin->first, part.origin->last) : CoverageOf(0, 1);
    }

    const std::vector<uint64_t> &Coverage() const { return coverage; }
    const std::set<int> &Ends() const { return ends; }
    Image &Picture() { return image; }
    size_t SumsPerPixel() const { return perPixel; }
    std::vector<uint32_t> Words() const {
        std::vector<uint32_t> words(sums.size() * kWordsPerSum);
        PutWords(sums, words.data());
        return words;
    }
    std::string PixelText(size_t i) const {
        return fmt::format("({}, {})", int(i % size_t(Width())) + bounds[0],
                           int(i / size_t(Width())) + bounds[2]);
    }

  private:
    int Width() const { return bounds[1] - bounds[0]; }
    size_t At(int x, int y) const {
        return size_t(y - bounds[2]) * size_t(Width()) + size_t(x - bounds[0]);
    }

    Bounds bounds;
    Image image;
    std::vector<uint64_t> coverage;
    std::set<int> ends;  ///< where ranges of samples begin or end
    size_t perPixel = 0;
    std::vector<ExactSum> sums;
};

/// Why a pixel differs from another in which samples it has; nullopt where none does.
std::optional<std::string> Unevenness(const Canvas &canvas, uint64_t expected, Gaps gaps) {
    for (size_t i = 0; i < canvas.Coverage().size(); ++i) {
        const uint64_t covered = canvas.Coverage()[i];
        if (covered == expected || (covered == 0 && gaps == Gaps::Black)) continue;
        return covered == 0
                   ? fmt::format("no file has the pixel {}; imgtool assemble leaves such black",
                                 canvas.PixelText(i))
                   : fmt::format("the pixel {} has other samples than others: a part is missing",
                                 canvas.PixelText(i));
    }
    return {};
}

/// Samples that lie between those of the parts and are in none.
std::optional<std::string> Hole(const Canvas &canvas, std::span<const Part> parts) {
    int before = *canvas.Ends().begin();
    for (const int end : canvas.Ends()) {
        const bool there =
            end == before || std::any_of(parts.begin(), parts.end(), [&](const Part &part) {
                return !part.origin || (part.origin->first <= before && end <= part.origin->last);
            });
        if (!there) return fmt::format("no file has the samples {}:{}", before, end);
        before = end;
    }
    return {};
}

/// How many samples a pixel of the result has; the mean of what the parts say, weighted by pixels,
/// where each has all of its pixels.
std::optional<int> SamplesOf(std::span<const Part> parts, const std::optional<Origin> &origin) {
    if (origin && !std::all_of(parts.begin(), parts.end(), IsWhole))
        return origin->last - origin->first;
    double sum = 0, pixels = 0;
    for (const Part &part : parts) {
        if (!part.image.metadata.samplesPerPixel) return {};
        const double area = double(part.image.Resolution().x) * part.image.Resolution().y;
        sum += area * *part.image.metadata.samplesPerPixel;
        pixels += area;
    }
    return int(sum / pixels);
}

}  // namespace

OrError<Part> ReadPart(const std::string &file, bool needsOrigin, std::string *remarks) {
    OrError<Image> image = ReadImage(file);
    if (!image) return {{}, image.error};
    Part part{file, std::move(*image.value), {}, {}};
    part.origin = OriginOf(part.image.metadata);
    if (!part.origin && needsOrigin)
        return {{},
                fmt::format("{} does not say which samples of which scene it holds, as pictures of "
                            "pbrt-feather do",
                            file)};
    if (!part.origin || part.origin->IsWhole()) {
        if (!part.image.metadata.unread.empty())
            *remarks += fmt::format("imgtool: {}: {}\n", file, part.image.metadata.unread);
        return {std::move(part), {}};
    }
    OrError<ExrWords> sums = ReadWords(file, std::string(kSumsPart));
    if (!sums) return {{}, sums.error};
    if (sums.value->perPixel == 0)
        return {{},
                fmt::format("{} holds the samples {}:{} of {} without their sums: it is no picture "
                            "of pbrt --sample-range",
                            file, part.origin->first, part.origin->last, part.origin->whole)};
    part.sums = std::move(*sums.value);
    const auto size = part.image.Resolution();
    const auto film = part.sums.strings.find(std::string(kFilmAttribute));
    if (film == part.sums.strings.end() ||
        !Film::ForSums(film->second, part.sums.perPixel / kWordsPerSum) ||
        part.sums.values.size() != size_t(size.x) * size_t(size.y) * part.sums.perPixel)
        return {{}, fmt::format("{}: its sums are not those of its picture", file)};
    return {std::move(part), {}};
}

std::optional<std::string> WhyNotOne(std::span<const Part> parts) {
    for (size_t i = 0; i < parts.size(); ++i)
        for (size_t j = 0; j < i; ++j) {
            auto why = Difference(parts[j], parts[i]);
            if (!why) why = Clash(parts[j], parts[i]);
            if (why) return fmt::format("{} and {} {}", parts[j].file, parts[i].file, *why);
        }
    return {};
}

OrError<Merged> Merge(std::span<const Part> parts, Gaps gaps) {
    const Point2i full = parts[0].image.metadata.fullResolution;
    Canvas canvas(parts, gaps == Gaps::Black ? Bounds{0, full.x, 0, full.y} : Around(parts));
    for (const Part &part : parts)
        canvas.Add(part);
    const int first = *canvas.Ends().begin(), last = *canvas.Ends().rbegin();
    const uint64_t expected = canvas.CoverageOf(first, last);
    if (const auto why = Hole(canvas, parts)) return {{}, *why};
    if (const auto why = Unevenness(canvas, expected, gaps)) return {{}, *why};

    std::optional<Origin> origin = parts[0].origin;
    if (origin) origin->first = first, origin->last = last;
    const bool whole = !origin || origin->IsWhole();
    Merged merged;
    const auto summed = std::find_if(parts.begin(), parts.end(),
                                     [](const Part &part) { return part.sums.perPixel > 0; });
    if (summed != parts.end()) {
        const auto film = Film::ForSums(summed->sums.strings.at(std::string(kFilmAttribute)),
                                        canvas.SumsPerPixel());
        canvas.Develop(*film, expected, !whole);
        if (!whole) {
            merged.sums = summed->sums;
            merged.sums.values = canvas.Words();
        }
    }
    merged.image = std::move(canvas.Picture());
    merged.missing = std::count(canvas.Coverage().begin(), canvas.Coverage().end(), uint64_t(0));
    merged.image.metadata.samplesPerPixel = SamplesOf(parts, origin);
    if (origin) SetOrigin(*origin, &merged.image.metadata);
    return {std::move(merged), {}};
}

}  // namespace pbrt::imgtool
