#include <cmath>

#include "bench/feather/cases.h"
#include "bench/feather/model.h"

namespace pbrt::bench {
namespace {

/// Closer to the horizon float leaves the gap fraction fewer digits: 5e-3 at 1e-5.
constexpr float kNotGrazing = 0.01f;

/// Whether small turns of wi leave all or nothing of R.
bool AwayFromEdges(const Oracle &oracle, const feather::View<double> &view,
                   const feather::Direction<double> &wi) {
    constexpr double turn = 1e-4;
    const bool lit = oracle.R(view, wi)[0] > 0;
    for (int i = 0; i < 8; ++i) {
        const double x = wi.x + ((i & 1) ? turn : -turn), y = wi.y + ((i & 2) ? turn : -turn),
                     z = wi.z + ((i & 4) ? turn : -turn), length = std::hypot(x, y, z);
        if ((oracle.R(view, {x / length, y / length, z / length})[0] > 0) != lit) return false;
    }
    return true;
}

}  // namespace

PartErrors MeasureParts(const FeatherBarbuleMaterial &material, int pairs) {
    const auto model = ModelOf<FeatherBarbuleBxDF::Model>(material);
    const auto oracle = ModelOf<Oracle>(material);
    PartErrors errors;
    const auto raise = [](double &most, double error) { most = std::max(most, std::abs(error)); };
    const std::vector<Input> inputs = MakeInputs(pairs, 3);
    const EvaluatedLobes rendered = EvaluatePacket(material, inputs);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const Input &in = inputs[i];
        const auto wo = Local<double>(in.wo), wi = Local<double>(in.wi);
        const auto exactView = oracle.SeenFrom(wo);
        if (in.wo.z >= kNotGrazing)
            raise(errors.gap, model.GapFraction(Local<float>(in.wo)) - oracle.GapFraction(wo));
        if (!AwayFromEdges(oracle, exactView, wi)) continue;
        const double pdf = oracle.PDF(exactView, wi);
        if (pdf > 0) raise(errors.pdf, rendered.pdf[i] / pdf - 1);
        const auto exact = oracle.R(exactView, wi);
        const double most = *std::max_element(exact.begin(), exact.end());
        if (most == 0) continue;
        ++errors.lit;
        for (int k = 0; k < NSpectrumSamples; ++k)
            raise(errors.R, (rendered.R[i][k] - exact[size_t(k)]) / most);
    }
    return errors;
}

}  // namespace pbrt::bench
