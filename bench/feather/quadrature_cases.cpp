#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "bench/feather/cases.h"
#include "bench/feather/model.h"
#include "feather/trt_error.h"

namespace pbrt::bench {
namespace {

/// Pairs of directions, and the oracle's TRT of each.
struct Reference {
    const FeatherBarbuleMaterial &material;
    std::vector<Input> pairs;
    std::vector<Oracle::Spectrum> exact;

    Reference(const FeatherBarbuleMaterial &material, int count)
        : material(material), pairs(MakeInputs(count, 2)), exact(pairs.size()) {
        const auto oracle = ModelOf<Oracle>(material);
        tbb::parallel_for(size_t(0), pairs.size(), [&](size_t i) {
            const auto view = oracle.SeenFrom(Local<double>(pairs[i].wo));
            exact[i] = oracle.TRT(view, Local<double>(pairs[i].wi));
        });
    }
};

/// Enters the errors of trt(i), TRT of pair i.
template <typename TRT>
void MeasureTRT(const Reference &reference, const TRT &trt, Row &row) {
    feather::TRTErrorSum sum;
    for (size_t i = 0; i < reference.pairs.size(); ++i)
        sum.Add(Local<double>(reference.pairs[i].wo), Local<double>(reference.pairs[i].wi), trt(i),
                reference.exact[i]);
    const std::optional<feather::TRTError> error = sum.Relative();
    if (!error) return;  // no melanin
    row.lightError = error->light;
    row.fError = error->f;
}

template <class Quadrature>
Case With(const Reference &reference, const std::string &name) {
    const auto model =
        ModelOf<feather::Barbule<float, NSpectrumSamples, Quadrature>>(reference.material);
    Case c;
    c.row.name = name;
    MeasureTRT(
        reference,
        [&](size_t i) {
            const Input &in = reference.pairs[i];
            return model.TRT(model.SeenFrom(Local<float>(in.wo)), Local<float>(in.wi));
        },
        c.row);
    c.timers.push_back({&Row::f, Pass([model](const Input &in) {
                            const auto view = model.SeenFrom(Local<float>(in.wo));
                            const auto f = model.f(view, Local<float>(in.wi));
                            return f[0] + f[1] + f[2] + f[3];
                        })});
    return c;
}

/// Plain Gauss-Legendre in both angles; the number along the arc follows its opening.
template <int Points>
Case WithGauss(const Reference &reference) {
    return With<feather::GaussPanel<Points>>(reference, fmt::format("Gauss, {} in e", Points));
}
template <int Segments, int Points, bool Interleaved>
Case WithFixed(const Reference &reference) {
    const char *const kind = !Interleaved ? "" : Points == 4 ? ", fitted" : ", interleaved";
    return With<feather::FixedRule<Segments, Points, Interleaved>>(
        reference, fmt::format("{} segments x {}{}", Segments, Points, kind));
}

}  // namespace

std::vector<Case> QuadratureCases(const FeatherBarbuleMaterial &material, int pairs) {
    const Reference r(material, pairs);
    Case packet = PacketCase(material);
    const EvaluatedLobes rendered = EvaluatePacket(material, r.pairs);
    MeasureTRT(
        r, [&](size_t i) { return rendered.TRT[i]; }, packet.row);
    return {std::move(packet),
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

}  // namespace pbrt::bench
