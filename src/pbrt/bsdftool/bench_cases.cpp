#include "pbrt/bsdftool/bench_cases.h"

#include <cmath>

#include "pbrt/bsdftool/bench_model.h"
#include "pbrt/bsdftool/spectral_bsdf.h"
#include "pbrt/bxdfs/feather_packet.h"
#include "pbrt/bxdfs/hair.h"

namespace pbrt::bsdftool {
namespace {

constexpr auto kMode = TransportMode::Radiance;

/// Of each lane, as in AddTimers.
FloatX16 AverageOf(const std::array<SampledSpectrum, kPacketSize> &spectra) {
    FloatX16 average;
    for (int i = 0; i < kPacketSize; ++i)
        average.Set(i, spectra[size_t(i)].Average());
    return average;
}

BxDFPacket<FeatherSurface> SixteenAlike(const FeatherBarbuleMaterial &material) {
    BxDFPacket<FeatherSurface> lanes;
    const SampledWavelengths lambda = SampledWavelengths::Of(kBenchLambda);
    for (int i = 0; i < kPacketSize; ++i)
        lanes.Set(i, material.GetSurface(MiddleOfTexture(), lambda));
    return lanes;
}

template <typename B>
void AddTimers(const B &bsdf, BenchCase *c) {
    c->timers.push_back({&BenchRow::f, Pass([bsdf](const BenchInput &in) {
                             return bsdf.f(in.wo, in.wi, kMode).Average();
                         })});
    c->timers.push_back({&BenchRow::pdf, Pass([bsdf](const BenchInput &in) {
                             return bsdf.PDF(in.wo, in.wi, kMode);
                         })});
    c->timers.push_back({&BenchRow::sample, Pass([bsdf](const BenchInput &in) {
                             const auto s = bsdf.Sample_f(in.wo, in.uc, in.u, kMode);
                             return s ? s->f.Average() + s->pdf + s->wi.x : 0;
                         })});
}

}  // namespace

BenchCase CaseOf(const std::string &name, const Material &material) {
    BenchCase c;
    c.row.name = name;
    WithSpectralBSDF(material, {kBenchLambda.begin(), kBenchLambda.end()},
                     [&](auto spectral) { AddTimers(spectral.parts[0].bsdf, &c); });
    if (const auto *barbule = std::get_if<FeatherBarbuleMaterial>(&material)) {
        const auto model = BenchModel<FeatherBarbuleBxDF::Model>(*barbule);
        c.timers.push_back({&BenchRow::draw, Pass([model](const BenchInput &in) {
                                const auto view = model.SeenFrom(Local<float>(in.wo));
                                const auto s = model.SampleDirection(view, in.uc, in.u.x, in.u.y);
                                return s ? s->pdf + s->wi.x : 0;
                            })});
    }
    return c;
}

EvaluatedLobes EvaluatePacket(const FeatherBarbuleMaterial &material,
                              const std::vector<BenchInput> &pairs) {
    BxDFPacket<FeatherSurface> lanes = SixteenAlike(material);
    EvaluatedLobes parts;
    size_t left = pairs.size();
    for (const WideBenchInput &in : PackInputs(pairs)) {
        const size_t count = std::min(left, size_t(kPacketSize));
        const LaneBits active = FirstLanes(int(count));
        const auto [R, TRT] = lanes.Lobes(in.wo, in.wi, active);
        const FloatX16 pdf = lanes.PDF(in.wo, in.wi, active);
        for (size_t i = 0; i < count; ++i) {
            parts.R.push_back(R[i]);
            parts.TRT.push_back(TRT[i]);
            parts.pdf.push_back(pdf[i]);
        }
        left -= count;
    }
    return parts;
}

BenchCase SideBySideCase(const FeatherBarbuleMaterial &material) {
    BxDFPacket<FeatherSurface> lanes = SixteenAlike(material);
    BenchCase c;
    c.row.name = "featherbarbule, by 16";
    c.timers.push_back({&BenchRow::f, WidePass([lanes](const WideBenchInput &in) mutable {
                            return AverageOf(lanes.f(in.wo, in.wi, kAllLanes));
                        })});
    c.timers.push_back({&BenchRow::pdf, WidePass([lanes](const WideBenchInput &in) mutable {
                            return lanes.PDF(in.wo, in.wi, kAllLanes);
                        })});
    c.timers.push_back({&BenchRow::sample, WidePass([lanes](const WideBenchInput &in) mutable {
                            const BxDFSamples s = lanes.Sample(in.wo, in.uc, in.u, kAllLanes);
                            return AverageOf(s.f) + s.pdf + s.wi.x;
                        })});
    c.timers.push_back({&BenchRow::draw, WidePass([lanes](const WideBenchInput &in) mutable {
                            const BxDFSamples s = lanes.Draw(in.wo, in.uc, in.u, kAllLanes);
                            return s.pdf + s.wi.x;
                        })});
    return c;
}

BenchCase HairCase() {
    BenchCase c;
    c.row.name = "hair";
    AddTimers(HairBxDF(0.3f, 1.55f, SampledSpectrum(0.5f), 0.3f, 0.3f, 2), &c);
    return c;
}

BenchCase SineCase() {
    BenchCase c;
    c.row.name = "sinf";
    c.timers.push_back(
        {&BenchRow::f, Pass([](const BenchInput &in) { return std::sin(2 * Pi * in.uc); })});
    return c;
}

}  // namespace pbrt::bsdftool
