#pragma once

#include <string>
#include <vector>

#include "pbrt/scene/params.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// What a camera ray met first, in rendering space.
struct VisibleSurface {
    Point3f p;
    Normal3f n, ns;
    Point2f uv;
    Vector3f dpdx, dpdy;     ///< per pixel step
    SampledSpectrum albedo;  ///< share of even light that is scattered towards the camera
};

/// What film `gbuffer` keeps beside R, G and B: means over what is seen of position, depth slopes,
/// normals, uv and albedo (each weighted by the pixel filter; 0 where nothing is seen), and the
/// variance of the samples' R, G, B, also relative to the squared mean.
class GBuffer {
  public:
    static constexpr std::string_view kName = "gbuffer";
    static GBuffer Create(ParamDict &params);
    /// From rendering space; the film's `coordinatesystem` chooses.
    void SetSpaces(const Transform &camera, const Transform &world) {
        outputFromRender = inWorld ? world : camera;
    }

    static constexpr size_t kSurfaceChannels = 16;
    /// Of one pixel.
    struct Sums {
        double weight = 0;
        std::array<double, kSurfaceChannels> surface{};
        int64_t n = 0;
        std::array<double, 3> mean{}, squares{};  ///< of rgb; squares of differences from the mean
    };
    Sums NewSums() const { return {}; }
    /// rgb: the sample's; albedo: the surface's, in the film's RGB.
    void Add(Sums *sums, const RGB &rgb, float weight, const VisibleSurface *surface,
             const RGB &albedo) const;

    std::vector<std::string> ChannelNames() const;
    /// One value per channel.
    void Write(const Sums &sums, float *channels) const;

  private:
    bool inWorld = false;
    Transform outputFromRender;
};

}  // namespace pbrt
