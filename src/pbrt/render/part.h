#pragma once

#include <optional>
#include <string>

#include "pbrt/image/exr_words.h"
#include "pbrt/render/render_state.h"

namespace pbrt {

/// The sums of the pixels inside the film's bounds, row by row, as files of parts hold them
/// (films/sum_words.h).
ExrWords SumsForFile(const Film &film, const RenderState &state);

/// The image of the samples so far, with one more channel, "samples": how many a pixel has.
Image WithSampleCounts(const Film &film, const RenderState &state);

/// The cost of rendering: channels "samples" of a pixel, "seconds" of a thread and "rays", the last
/// two as means over the tile of the pixel, for its pixels are traced together.
Image CostImage(const Film &film, const RenderState &state);

/// Why blocks of samples do not begin at range.first and end at range.last, where they do not: the
/// parts of a picture of `spp` samples are made of whole blocks (render/pieces.h).
std::optional<std::string> WhyNoPart(SampleRange range, int spp);

}  // namespace pbrt
