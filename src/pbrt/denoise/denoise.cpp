#include "pbrt/denoise/denoise.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>

#include "pbrt/denoise/oidn_library.h"

namespace pbrt {
namespace {

/// Three floats a pixel.
using Plane = std::vector<float>;
using Names = std::array<std::string_view, 3>;

/// The channels of these names, empty where one is missing.
Plane Channels(const Image &image, const Names &names) {
    std::array<int, 3> index;
    for (size_t c = 0; c < 3; ++c) {
        index[c] = image.ChannelIndex(names[c]);
        if (index[c] < 0) return {};
    }
    const size_t n = size_t(image.NChannels());
    Plane plane;
    plane.reserve(image.Data().size() / n * 3);
    for (size_t i = 0; i < image.Data().size(); i += n)
        for (const int c : index) {
            const float v = image.Data()[i + size_t(c)];
            plane.push_back(std::isfinite(v) ? v : 0);
        }
    return plane;
}

/// A device of the library, and filters on it.
class Oidn {
  public:
    Oidn(const OidnLibrary &library, Point2i resolution)
        : library(library),
          resolution(resolution),
          device(library.newDevice(OidnLibrary::kDefaultDevice)) {
        if (device) library.commitDevice(device);
    }
    ~Oidn() {
        if (device) library.releaseDevice(device);
    }
    Oidn(const Oidn &) = delete;
    Oidn &operator=(const Oidn &) = delete;

    /// An auxiliary image on its own, in place.
    void Prefilter(const char *name, Plane *plane) {
        if (!device || plane->empty()) return;
        const OidnLibrary::Filter filter = library.newFilter(device, "RT");
        Set(filter, name, plane);
        Set(filter, "output", plane);
        Run(filter);
    }
    void Color(Plane *color, Plane *albedo, Plane *normal) {
        if (!device) return;
        const OidnLibrary::Filter filter = library.newFilter(device, "RT");
        Set(filter, "color", color);
        if (!albedo->empty()) Set(filter, "albedo", albedo);
        // The library takes normals only beside an albedo.
        const bool both = !albedo->empty() && !normal->empty();
        if (both) Set(filter, "normal", normal);
        Set(filter, "output", color);
        library.setFilterBool(filter, "hdr", true);
        if (!albedo->empty()) library.setFilterBool(filter, "cleanAux", true);
        Run(filter);
    }
    /// The library's complaint, or nothing.
    std::optional<std::string> Problem() const {
        const char *why = nullptr;
        if (library.getDeviceError(device, &why) == 0 && device) return {};
        return fmt::format("Open Image Denoise: {}", why && *why ? why : "it does not start");
    }

  private:
    void Set(OidnLibrary::Filter filter, const char *name, Plane *plane) {
        library.setSharedFilterImage(filter, name, plane->data(), OidnLibrary::kFloat3,
                                     size_t(resolution.x), size_t(resolution.y), 0, 0, 0);
    }
    void Run(OidnLibrary::Filter filter) {
        library.commitFilter(filter);
        library.executeFilter(filter);
        library.releaseFilter(filter);
    }

    const OidnLibrary &library;
    Point2i resolution;
    OidnLibrary::Device device;
};

}  // namespace

std::optional<std::string> WhyNoDenoiser() {
    const OrError<OidnLibrary> library = LoadOidn();
    if (library) return {};
    return library.error;
}

OrError<Image> Denoised(const Image &image) {
    constexpr Names kColor{"R", "G", "B"};
    Plane color = Channels(image, kColor);
    if (color.empty()) return {{}, "has not the channels R, G and B"};
    const OrError<OidnLibrary> library = LoadOidn();
    if (!library) return {{}, library.error};
    Plane albedo = Channels(image, {"Albedo.R", "Albedo.G", "Albedo.B"});
    Plane normal = Channels(image, {"Ns.X", "Ns.Y", "Ns.Z"});
    if (normal.empty()) normal = Channels(image, {"N.X", "N.Y", "N.Z"});

    Oidn oidn(*library.value, image.Resolution());
    oidn.Prefilter("albedo", &albedo);
    oidn.Prefilter("normal", &normal);
    oidn.Color(&color, &albedo, &normal);
    if (const auto why = oidn.Problem()) return {{}, *why};

    Image denoised = image;
    for (size_t c = 0; c < 3; ++c) {
        const size_t at = size_t(image.ChannelIndex(kColor[c])), n = size_t(image.NChannels());
        for (size_t i = 0; i < color.size() / 3; ++i)
            denoised.Data()[i * n + at] = color[3 * i + c];
    }
    return {std::move(denoised), {}};
}

}  // namespace pbrt
