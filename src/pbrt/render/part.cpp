#include "pbrt/render/part.h"

#include <fmt/format.h>

#include "pbrt/films/sum_words.h"

namespace pbrt {
namespace {

/// Calls f(place in the tile, pixel) for the pixels of a tile inside the film's bounds.
template <typename F>
void ForEachPixel(const Film &film, const PixelBounds &tile, const F &f) {
    const std::vector<Point2i> pixels = PixelsAlongCurve(tile);
    for (size_t i = 0; i < pixels.size(); ++i)
        if (film.Bounds().Contains(pixels[i])) f(i, pixels[i]);
}

/// The borders of blocks next to `sample`, at most and at least.
SampleRange BordersAround(int sample, int spp) {
    SampleRange block = BlockAt(0, spp);
    while (block.last < sample && block.last < spp)
        block = BlockAt(block.last, spp);
    return block.last == sample ? SampleRange{sample, sample} : block;
}

}  // namespace

ExrWords SumsForFile(const Film &film, const RenderState &state) {
    const size_t perPixel = film.SumsPerPixel();
    const PixelBounds &b = film.Bounds();
    ExrWords words{std::string(kSumsPart),
                   {{std::string(kFilmAttribute), std::string(film.TypeName())}},
                   perPixel * kWordsPerSum,
                   std::vector<uint32_t>(size_t(b.Area()) * perPixel * kWordsPerSum)};
    state.Look([&](const TileSums &sums, const auto &) {
        for (size_t tile = 0; tile < sums.Tiles().size(); ++tile) {
            const std::span<const ExactSum> flat = sums.Flat(tile);
            if (flat.empty()) continue;
            ForEachPixel(film, sums.Tiles()[tile], [&](size_t i, Point2i p) {
                const size_t at = size_t(p.y - b.y0) * size_t(b.Width()) + size_t(p.x - b.x0);
                PutWords(flat.subspan(i * perPixel, perPixel), &words.values[at * words.perPixel]);
            });
        }
    });
    return words;
}

Image WithSampleCounts(const Film &film, const RenderState &state) {
    const Image plain = state.Develop();
    std::vector<std::string> channels = plain.ChannelNames();
    channels.push_back("samples");
    Image image(plain.Resolution(), channels);
    image.metadata = plain.metadata;
    const PixelBounds &b = film.Bounds();
    state.Look([&](const TileSums &sums, const auto &tiles) {
        for (size_t tile = 0; tile < tiles.size(); ++tile)
            ForEachPixel(film, sums.Tiles()[tile], [&](size_t, Point2i p) {
                const Point2i q{p.x - b.x0, p.y - b.y0};
                std::copy_n(plain.Pixel(q), plain.NChannels(), image.Pixel(q));
                image.Set(q, plain.NChannels(), float(tiles[tile].next - state.Samples().first));
            });
    });
    return image;
}

Image CostImage(const Film &film, const RenderState &state) {
    const PixelBounds &b = film.Bounds();
    Image image({b.Width(), b.Height()}, {"samples", "seconds", "rays"});
    image.metadata.pixelBounds = {b.x0, b.x1, b.y0, b.y1};
    image.metadata.fullResolution = film.FullResolution();
    state.Look([&](const TileSums &sums, const auto &tiles) {
        for (size_t i = 0; i < tiles.size(); ++i) {
            const RenderState::Tile &tile = tiles[i];
            const double area = double(sums.Tiles()[i].Area());
            ForEachPixel(film, sums.Tiles()[i], [&](size_t, Point2i p) {
                float *const values = image.Pixel({p.x - b.x0, p.y - b.y0});
                values[0] = float(tile.next - state.Samples().first);
                values[1] = float(tile.seconds / area);
                values[2] = float(double(tile.rays) / area);
            });
        }
    });
    return image;
}

std::optional<std::string> WhyNoPart(SampleRange range, int spp) {
    if (range.last > spp)
        return fmt::format("the picture has {} samples per pixel, 0:{} at most", spp, spp);
    const SampleRange a = BordersAround(range.first, spp), b = BordersAround(range.last, spp);
    if (range.first == 0 ? b.Size() == 0 : a.Size() == 0 && b.Size() == 0) return {};
    const int first = range.first == 0 ? 0 : a.first;
    return fmt::format(
        "parts begin and end at 0, 1, 4, 16, 32, 64, 128, from there on every {} samples, and at "
        "the last, {}; so they have the bits of the whole when they are joined. Around these: "
        "{}:{}",
        kLargestBlock, spp, first, b.last);
}

}  // namespace pbrt
