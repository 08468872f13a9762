#include "pbrt/pbrt/output.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "pbrt/pbrt/messages.h"
#include "pbrt/render/part.h"
#include "pbrt/util/memory.h"

namespace pbrt::program {
namespace {

std::string Beside(const std::string &picture, std::string_view ending) {
    std::filesystem::path path(picture);
    path.replace_extension();
    return path.string().append(ending);
}

}  // namespace

std::string PartialName(const std::string &picture) {
    return Beside(picture, ".partial.exr");
}

std::string CostName(const std::string &picture) {
    return Beside(picture, "-stats.exr");
}

void AddMetadata(const RenderTask &task, const RenderIdentity &identity, int samples,
                 ImageMetadata *metadata) {
    const RenderScene &scene = *task.scene;
    metadata->samplesPerPixel = samples;
    metadata->cameraFromWorld = Placement(scene.camera).cameraFromWorld.Matrix();
    metadata->ndcFromWorld = NDCFromWorld(scene.camera).Matrix();
    SetOrigin(OriginOf(identity), metadata);
}

std::optional<std::string> WritePicture(const RenderTask &task, const RenderIdentity &identity,
                                        const RenderState &state, const Image &image) {
    const Film &film = task.scene->film;
    if (!OriginOf(identity).IsWhole())
        return WriteImageWithWords(image, film.FileName(), film.Format(), SumsForFile(film, state));
    return WriteImageSomewhere(image, film.FileName(), film.Format());
}

std::optional<std::string> WritePartial(const RenderTask &task, const RenderIdentity &identity,
                                        const RenderState &state) {
    const Film &film = task.scene->film;
    Image image = WithSampleCounts(film, state);
    const SampleRange spread = state.Spread();
    AddMetadata(task, identity, int(state.Stats().samplesPerPixel), &image.metadata);
    // Some pixels have more, which no range says: those that all have.
    Origin origin = OriginOf(identity);
    origin.last = origin.first + std::max(spread.last, 1);
    SetOrigin(origin, &image.metadata);
    return WriteImage(image, PartialName(film.FileName()), ExrPixels::Float);
}

std::string WroteText(const std::string &file, double samplesPerPixel, double seconds) {
    std::error_code unknown;
    const uint64_t bytes = std::filesystem::file_size(file, unknown);
    const std::string size = unknown ? std::string() : ByteText(bytes) + ", ";
    const bool whole = samplesPerPixel == std::floor(samplesPerPixel);
    return fmt::format("wrote {} ({}{:.{}f} spp, {})", file, size, samplesPerPixel, whole ? 0 : 1,
                       DurationText(seconds));
}

}  // namespace pbrt::program
