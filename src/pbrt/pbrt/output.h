#pragma once

#include <string>

#include "pbrt/render/identity.h"
#include "pbrt/render/render.h"

namespace pbrt::program {

/// NAME.partial.exr and NAME-stats.exr beside NAME.<extension>.
std::string PartialName(const std::string &picture);
std::string CostName(const std::string &picture);

/// Metadata of a picture with `samples` of each pixel, the first that are rendered: camera, number
/// of samples, origin. No times, so that equal pictures are equal files.
void AddMetadata(const RenderTask &task, const RenderIdentity &identity, int samples,
                 ImageMetadata *metadata);

/// Writes the picture of a finished render; of a part, with its sums.
std::optional<std::string> WritePicture(const RenderTask &task, const RenderIdentity &identity,
                                        const RenderState &state, const Image &image);

/// Writes PartialName of a render that was stopped.
std::optional<std::string> WritePartial(const RenderTask &task, const RenderIdentity &identity,
                                        const RenderState &state);

/// "wrote x.exr (1.2 MB, 64 spp, 13 s)".
std::string WroteText(const std::string &file, double samplesPerPixel, double seconds);

}  // namespace pbrt::program
