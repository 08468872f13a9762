#include "pbrt/bxdfs/feather_barbule_packet.h"

namespace pbrt {
namespace {

using V = FloatX16;
using ModelSpectrum = feather::Barbule<V, NSpectrumSamples>::Spectrum;

/// Directions for the model; in inactive lanes one from which nothing is seen.
feather::Direction<V> Local(const Vector3fX16 &w, LaneBits active) {
    return {w.x, w.y, Select(MaskOf(active), w.z, 0)};
}
FeatherBarbulePacket::Spectra SpectraOf(const ModelSpectrum &values) {
    FeatherBarbulePacket::Spectra spectra;
    for (int i = 0; i < kPacketSize; ++i) {
        std::array<float, NSpectrumSamples> one;
        for (size_t k = 0; k < NSpectrumSamples; ++k)
            one[k] = values[k][i];
        spectra[size_t(i)] = SampledSpectrum(one);
    }
    return spectra;
}

}  // namespace

void FeatherBarbulePacket::Set(int i, const FeatherSurface &surface) {
    vane.Set(i, surface.vane);
    const LaneBits lane = LaneBits(1) << i;
    tilted = surface.tilt ? tilted | lane : tilted & ~lane;
    if (surface.tilt) tilt.Set(i, *surface.tilt);
    thickness.Set(i, surface.thickness);
    roughness.Set(i, surface.roughness);
    for (size_t k = 0; k < NSpectrumSamples; ++k) {
        optics.lambda[k].Set(i, surface.optics.lambda[k]);
        optics.eta[k].Set(i, surface.optics.eta[k]);
        optics.melanin[k].Set(i, surface.optics.melanin[k]);
    }
    barbules.reset();
}

const FeatherBarbulePacket::Model &FeatherBarbulePacket::Barbules() {
    if (!barbules)
        barbules.emplace(vane, feather::Nm<V>{thickness}, optics, feather::Nm<V>{roughness});
    return *barbules;
}

FeatherBarbulePacket::Spectra FeatherBarbulePacket::f(const Vector3fX16 &wo, const Vector3fX16 &wi,
                                                      LaneBits active) {
    return SpectraOf(Barbules().f(Local(wo, active), Local(wi, active)));
}

FeatherBarbulePacket::LobeValues FeatherBarbulePacket::Lobes(const Vector3fX16 &wo,
                                                             const Vector3fX16 &wi,
                                                             LaneBits active) {
    const Model &model = Barbules();
    const feather::View<V> view = model.SeenFrom(Local(wo, active));
    const feather::Direction<V> in = Local(wi, active);
    return {SpectraOf(model.R(view, in)), SpectraOf(model.TRT(view, in))};
}

FloatX16 FeatherBarbulePacket::PDF(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active) {
    const Model &model = Barbules();
    return model.PDF(model.SeenFrom(Local(wo, active)), Local(wi, active));
}

BxDFValues FeatherBarbulePacket::Evaluate(const Vector3fX16 &wo, const Vector3fX16 &wi,
                                          LaneBits active) {
    const Model &model = Barbules();
    const feather::Direction<V> in = Local(wi, active);
    const feather::View<V> view = model.SeenFrom(Local(wo, active));
    return {SpectraOf(model.f(view, in)), model.PDF(view, in)};
}

BxDFSamples FeatherBarbulePacket::Draw(const Vector3fX16 &wo, const FloatX16 &uc,
                                       const Point2fX16 &u, LaneBits active) {
    const feather::View<V> view = Barbules().SeenFrom(Local(wo, active));
    return Draw(view, wo, uc, u, active);
}

BxDFSamples FeatherBarbulePacket::Sample(const Vector3fX16 &wo, const FloatX16 &uc,
                                         const Point2fX16 &u, LaneBits active) {
    const Model &model = Barbules();
    const feather::View<V> view = model.SeenFrom(Local(wo, active));
    BxDFSamples samples = Draw(view, wo, uc, u, active);
    const LaneBits others = samples.valid & ~samples.nullTransmission;
    const Spectra f = SpectraOf(model.f(view, Local(samples.wi, others)));
    ForEachLane(others, [&](int i) { samples.f[size_t(i)] = f[size_t(i)]; });
    return samples;
}

BxDFSamples FeatherBarbulePacket::Draw(const feather::View<V> &view, const Vector3fX16 &wo,
                                       const FloatX16 &uc, const Point2fX16 &u, LaneBits active) {
    const Model &model = *barbules;
    const auto [wi, isGap] = model.Draw(view, uc, u.x, u.y);
    BxDFSamples samples;
    samples.wi = {wi.x, wi.y, wi.z};
    samples.nullTransmission = samples.specular = BitsOf(isGap) & active;
    samples.pdf =
        Select(MaskOf(samples.nullTransmission), 1 - view.pigmentChance, model.PDF(view, wi));
    samples.valid = active & BitsOf(samples.pdf > 0.f) & ~BitsOf(view.grazing);
    samples.transmission = samples.nullTransmission | BitsOf((samples.wi.z < 0.f) != (wo.z < 0.f));
    ForEachLane(samples.nullTransmission,
                [&](int i) { samples.f[size_t(i)] = SampledSpectrum(1 / std::abs(wo.z[i])); });
    return samples;
}

}  // namespace pbrt
