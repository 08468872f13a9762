#pragma once

#include "pbrt/base/film.h"
#include "pbrt/films/exact_sum.h"

namespace pbrt {

/// Film `gbuffer`: means over what camera rays see first of position, depth slopes, normals and uv
/// (weighted by the pixel filter; 0 where nothing is seen), the mean albedo over all camera rays,
/// and the variance of R, G, B over those that see something, also relative to their mean.
class GBufferFilm {
  public:
    static constexpr std::string_view kName = "gbuffer";
    static constexpr FilmTraits kTraits{.surface = true, .exrOnly = true};
    static constexpr size_t kSurfaceChannels = 16;
    /// On the heap, so that pixels of other films stay small.
    struct Sums {
        ExactSum n;                                ///< samples that see something
        ExactSum weight, weightOfAll;              ///< of these, and of all
        std::vector<ExactSum> surface;             ///< kSurfaceChannels, weighted
        std::vector<std::array<ExactSum, 2>> rgb;  ///< R, G, B and their squares, not weighted

        template <typename F>
        void ForEach(const F &f) {
            f(n), f(weight), f(weightOfAll);
            for (ExactSum &s : surface)
                f(s);
            for (std::array<ExactSum, 2> &s : rgb)
                f(s[0]), f(s[1]);
        }
    };

    static GBufferFilm Create(ParamDict &params);
    /// The film's `coordinatesystem` chooses.
    void SetSpaces(const Transform &camera, const Transform &world) {
        outputFromRender = inWorld ? world : camera;
    }
    SampledWavelengths SampleWavelengths(float u) const {
        return SampledWavelengths::SampleVisible(u);
    }
    Sums NewSums() const {
        return {{},
                {},
                {},
                std::vector<ExactSum>(kSurfaceChannels),
                std::vector<std::array<ExactSum, 2>>(3)};
    }
    void Add(Sums *sums, const FilmSample &sample) const;
    std::vector<std::string> ChannelNames() const;
    void Write(const Sums &sums, float *channels) const;
    void WriteMetadata(std::map<std::string, std::string> *) const {}

  private:
    bool inWorld = false;
    Transform outputFromRender;
};

}  // namespace pbrt
