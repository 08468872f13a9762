#include "pbrt/bsdftool/observer.h"

namespace pbrt::bsdftool {

Observer::Observer(const std::vector<float> &lambda, const Spectrum &illuminant) {
    float sum = 0;
    for (float l : lambda) {
        const float light = illuminant(l);
        weights.push_back(
            {spectra::X()(l) * light, spectra::Y()(l) * light, spectra::Z()(l) * light});
        sum += weights.back().Y;
    }
    if (sum == 0) return;
    for (XYZ &w : weights)
        w = {w.X / sum, w.Y / sum, w.Z / sum};
}

XYZ Observer::ToXYZ(std::span<const float> values) const {
    DCHECK(values.size() == weights.size());
    XYZ c;
    for (size_t i = 0; i < values.size(); ++i) {
        c.X += values[i] * weights[i].X;
        c.Y += values[i] * weights[i].Y;
        c.Z += values[i] * weights[i].Z;
    }
    return c;
}

}  // namespace pbrt::bsdftool
