#include "bench/feather/cases.h"

#include <cmath>

#include "bench/feather/model.h"
#include "bench/stopwatch.h"
#include "pbrt/bsdftool/spectral_bsdf.h"
#include "pbrt/bxdfs/feather_barbule_packet.h"
#include "pbrt/bxdfs/hair_bxdf.h"

namespace pbrt::bench {
namespace {

using bsdftool::MiddleOfTexture;

constexpr auto kMode = TransportMode::Radiance;

/// Of each lane, as in AddTimers.
FloatX16 AverageOf(const std::array<SampledSpectrum, kPacketSize> &spectra) {
    FloatX16 average;
    for (int i = 0; i < kPacketSize; ++i)
        average.Set(i, spectra[size_t(i)].Average());
    return average;
}

FeatherBarbulePacket SixteenAlike(const FeatherBarbuleMaterial &material) {
    FeatherBarbulePacket lanes;
    const SampledWavelengths lambda = SampledWavelengths::Of(kLambda);
    for (int i = 0; i < kPacketSize; ++i)
        lanes.Set(i, material.GetPacketInput(MiddleOfTexture(), lambda));
    return lanes;
}

template <typename B>
void AddTimers(const B &bsdf, Case *c) {
    c->timers.push_back(
        {&Row::f, Pass([bsdf](const Input &in) { return bsdf.f(in.wo, in.wi, kMode).Average(); })});
    c->timers.push_back(
        {&Row::pdf, Pass([bsdf](const Input &in) { return bsdf.PDF(in.wo, in.wi, kMode); })});
    c->timers.push_back({&Row::sample, Pass([bsdf](const Input &in) {
                             const auto s = bsdf.Sample_f(in.wo, in.uc, in.u, kMode);
                             return s ? s->f.Average() + s->pdf + s->wi.x : 0;
                         })});
}

}  // namespace

void RunTimers(std::vector<Case> &cases, int rounds) {
    Stopwatch watch;
    for (Case &c : cases)
        for (const Timer &timer : c.timers)
            watch.Add(c.row.name, int(TimedInputs().size()), timer.pass);
    constexpr int kPasses = 3;
    watch.Run(rounds, kPasses);
    const auto times = watch.All();
    auto time = times.begin();
    for (Case &c : cases)
        for (const Timer &timer : c.timers)
            c.row.*timer.cell = (time++)->second;
}

Case CaseOf(const std::string &name, const Material &material) {
    Case c;
    c.row.name = name;
    bsdftool::WithSpectralBSDF(material, {kLambda.begin(), kLambda.end()},
                               [&](auto spectral) { AddTimers(spectral.parts[0].bsdf, &c); });
    if (const auto *barbule = std::get_if<FeatherBarbuleMaterial>(&material)) {
        const auto model = ModelOf<FeatherBarbuleBxDF::Model>(*barbule);
        c.timers.push_back({&Row::draw, Pass([model](const Input &in) {
                                const auto view = model.SeenFrom(Local<float>(in.wo));
                                const auto s = model.SampleDirection(view, in.uc, in.u.x, in.u.y);
                                return s ? s->pdf + s->wi.x : 0;
                            })});
    }
    return c;
}

EvaluatedLobes EvaluatePacket(const FeatherBarbuleMaterial &material,
                              const std::vector<Input> &pairs) {
    FeatherBarbulePacket lanes = SixteenAlike(material);
    EvaluatedLobes parts;
    size_t left = pairs.size();
    for (const PacketInput &in : PackInputs(pairs)) {
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

Case PacketCase(const FeatherBarbuleMaterial &material) {
    FeatherBarbulePacket lanes = SixteenAlike(material);
    Case c;
    c.row.name = "featherbarbule, by 16";
    c.timers.push_back({&Row::f, PacketPass([lanes](const PacketInput &in) mutable {
                            return AverageOf(lanes.f(in.wo, in.wi, kAllLanes));
                        })});
    c.timers.push_back({&Row::pdf, PacketPass([lanes](const PacketInput &in) mutable {
                            return lanes.PDF(in.wo, in.wi, kAllLanes);
                        })});
    c.timers.push_back({&Row::sample, PacketPass([lanes](const PacketInput &in) mutable {
                            const BxDFSamples s = lanes.Sample(in.wo, in.uc, in.u, kAllLanes);
                            return AverageOf(s.f) + s.pdf + s.wi.x;
                        })});
    c.timers.push_back({&Row::draw, PacketPass([lanes](const PacketInput &in) mutable {
                            const BxDFSamples s = lanes.Draw(in.wo, in.uc, in.u, kAllLanes);
                            return s.pdf + s.wi.x;
                        })});
    return c;
}

std::vector<Case> PartCases(const FeatherBarbuleMaterial &material) {
    const auto model = ModelOf<FeatherBarbuleBxDF::Model>(material);
    const auto known = model.SeenFrom(Local<float>(TimedInputs().front().wo));
    const auto timed = [](const char *name, std::function<double()> pass) {
        Case c;
        c.row.name = name;
        c.timers.push_back({&Row::f, std::move(pass)});
        return c;
    };
    return {timed("R", Pass([model](const Input &in) {
                      const auto view = model.SeenFrom(Local<float>(in.wo));
                      return model.R(view, Local<float>(in.wi))[0];
                  })),
            timed("PDF, view given", Pass([model, known](const Input &in) {
                      return model.PDF(known, Local<float>(in.wi));
                  })),
            timed("gap fraction", Pass([model](const Input &in) {
                      return model.GapFraction(Local<float>(in.wo));
                  })),
            timed("make a model", Pass([material](const Input &in) {
                      const auto made = ModelOf<FeatherBarbuleBxDF::Model>(material);
                      return made.GapFraction(Local<float>(in.wo));
                  })),
            timed("vertex's input", Pass([material](const Input &in) {
                      TextureEvalContext ctx;
                      ctx.uv = in.u;
                      const Frame straight{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
                      const Frame frame =
                          material.TurnsFrame() ? material.TurnFrame(straight, ctx) : straight;
                      const FeatherSurface surface =
                          material.GetPacketInput(ctx, SampledWavelengths::Of(kLambda));
                      return frame.z.x + surface.thickness + surface.vane.row.Spacing();
                  }))};
}

Case HairCase() {
    Case c;
    c.row.name = "hair";
    AddTimers(HairBxDF(0.3f, 1.55f, SampledSpectrum(0.5f), 0.3f, 0.3f, 2), &c);
    return c;
}

Case SineCase() {
    Case c;
    c.row.name = "sinf";
    c.timers.push_back({&Row::f, Pass([](const Input &in) { return std::sin(2 * Pi * in.uc); })});
    return c;
}

}  // namespace pbrt::bench
