#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "pbrt/bsdftool/bench_cases.h"
#include "pbrt/bsdftool/bench_model.h"

namespace pbrt::bsdftool {
namespace {

/// Pairs of directions, and the oracle's TRT of each.
struct Reference {
    const FeatherBarbuleMaterial &material;
    std::vector<BenchInput> pairs;
    std::vector<Oracle::Spectrum> exact;

    Reference(const FeatherBarbuleMaterial &material, int count)
        : material(material), pairs(BenchInputs(count, 2)), exact(pairs.size()) {
        const auto oracle = BenchModel<Oracle>(material);
        tbb::parallel_for(size_t(0), pairs.size(), [&](size_t i) {
            const auto view = oracle.SeenFrom(Local<double>(pairs[i].wo));
            exact[i] = oracle.TRT(view, Local<double>(pairs[i].wi));
        });
    }
};

/// trt(i): TRT of pair i.
template <typename TRT>
void MeasureTRT(const Reference &reference, const TRT &trt, BenchRow &row) {
    double light = 0, f = 0, meanLight = 0, meanF = 0;
    for (size_t i = 0; i < reference.pairs.size(); ++i) {
        const BenchInput &in = reference.pairs[i];
        const auto found = trt(i);
        const double cosines = double(in.wo.z) * in.wi.z;
        for (int k = 0; k < NSpectrumSamples; ++k) {
            const double exact = reference.exact[i][size_t(k)], off = found[k] - exact;
            f += off * off;
            light += off * off * cosines * cosines;
            meanF += exact;
            meanLight += exact * cosines;
        }
    }
    const double n = double(NSpectrumSamples * reference.pairs.size());
    if (meanF == 0) return;  // no melanin
    row.lightError = std::sqrt(light / n) / (meanLight / n);
    row.fError = std::sqrt(f / n) / (meanF / n);
}

template <class Quadrature>
BenchCase With(const Reference &reference, const std::string &name) {
    const auto model =
        BenchModel<feather::Barbule<float, NSpectrumSamples, Quadrature>>(reference.material);
    BenchCase c;
    c.row.name = name;
    MeasureTRT(
        reference,
        [&](size_t i) {
            const BenchInput &in = reference.pairs[i];
            return SampledSpectrum(
                model.TRT(model.SeenFrom(Local<float>(in.wo)), Local<float>(in.wi)));
        },
        c.row);
    c.timers.push_back({&BenchRow::f, Pass([model](const BenchInput &in) {
                            const auto view = model.SeenFrom(Local<float>(in.wo));
                            const auto f = model.f(view, Local<float>(in.wi));
                            return f[0] + f[1] + f[2] + f[3];
                        })});
    return c;
}

/// Plain Gauss-Legendre in both angles; the number along the arc follows its opening.
template <int Points>
BenchCase WithGauss(const Reference &reference) {
    return With<feather::GaussPanel<Points>>(reference, fmt::format("Gauss, {} in e", Points));
}
template <int Segments, int Points, bool Interleaved>
BenchCase WithFixed(const Reference &reference) {
    const char *const kind = !Interleaved ? "" : Points == 4 ? ", fitted" : ", interleaved";
    return With<feather::FixedRule<Segments, Points, Interleaved>>(
        reference, fmt::format("{} segments x {}{}", Segments, Points, kind));
}

}  // namespace

std::vector<BenchCase> QuadratureCases(const FeatherBarbuleMaterial &material, int pairs) {
    const Reference r(material, pairs);
    BenchCase sideBySide = SideBySideCase(material);
    const EvaluatedLobes rendered = EvaluatePacket(material, r.pairs);
    MeasureTRT(
        r, [&](size_t i) { return rendered.TRT[i]; }, sideBySide.row);
    return {std::move(sideBySide),
            With<feather::AdaptiveRule>(r, "adaptive"),
            WithFixed<2, 4, true>(r),
            WithFixed<2, 8, true>(r),
            WithFixed<2, 16, true>(r),
            WithFixed<2, 4, false>(r),
            WithFixed<2, 8, false>(r),
            WithFixed<4, 8, false>(r),
            WithFixed<4, 16, false>(r),
            WithFixed<8, 8, false>(r),
            WithFixed<8, 16, false>(r),
            WithGauss<4>(r),
            WithGauss<8>(r),
            WithGauss<16>(r)};
}

}  // namespace pbrt::bsdftool
