#pragma once

#include "pbrt/base/film.h"

namespace pbrt {

/// Film `rgb`: nothing besides R, G and B.
class RGBFilm {
  public:
    static constexpr std::string_view kName = "rgb";
    static constexpr FilmTraits kTraits{};
    struct Sums {
        template <typename F>
        void ForEach(const F &) {}
    };

    static RGBFilm Create(ParamDict &) { return {}; }
    void SetSpaces(const Transform &, const Transform &) {}
    SampledWavelengths SampleWavelengths(float u) const {
        return SampledWavelengths::SampleVisible(u);
    }
    Sums NewSums() const { return {}; }
    void Add(Sums *, const FilmSample &) const {}
    std::vector<std::string> ChannelNames() const { return {}; }
    void Write(const Sums &, float *) const {}
    void WriteMetadata(std::map<std::string, std::string> *) const {}
};

}  // namespace pbrt
