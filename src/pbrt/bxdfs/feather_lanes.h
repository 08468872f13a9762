#pragma once

#include "pbrt/bxdfs/bxdf_lanes.h"
#include "pbrt/bxdfs/feather_barbule.h"

namespace pbrt {

/// Feathers side by side: FeatherBarbuleBxDF of each surface, in half of the time or less.
template <>
class BxDFLanes<FeatherSurface> {
  public:
    void Set(int i, const FeatherSurface &surface) {
        vane.Set(i, surface.vane);
        thickness.Set(i, surface.thickness);
        for (size_t k = 0; k < NSpectrumSamples; ++k) {
            optics.lambda[k].Set(i, surface.optics.lambda[k]);
            optics.eta[k].Set(i, surface.optics.eta[k]);
            optics.melanin[k].Set(i, surface.optics.melanin[k]);
        }
        barbules.reset();
    }
    void Regularize(int) {}
    BxDFFlags Flags(int) const { return FeatherBarbuleBxDF::kFlags; }

    std::array<SampledSpectrum, kWide> f(const WideVector3f &wo, const WideVector3f &wi,
                                         LaneBits active) {
        const Model &model = Barbules();
        return Spectra(model.f(model.SeenFrom(Local(wo, active)), Local(wi, active)));
    }
    WideFloat PDF(const WideVector3f &wo, const WideVector3f &wi, LaneBits active) {
        const Model &model = Barbules();
        return ToWide(model.Pdf(model.SeenFrom(Local(wo, active)), Local(wi, active)));
    }
    BxDFValues Evaluate(const WideVector3f &wo, const WideVector3f &wi, LaneBits active) {
        const Model &model = Barbules();
        const feather::Direction<V> in = Local(wi, active);
        const feather::View<V> view = model.SeenFrom(Local(wo, active));
        return {Spectra(model.f(view, in)), ToWide(model.Pdf(view, in))};
    }

    BxDFSamples Sample(const WideVector3f &wo, const WideFloat &uc, const WidePoint2f &u,
                       LaneBits active) {
        const Model &model = Barbules();
        const feather::View<V> view = model.SeenFrom(Local(wo, active));
        const auto [wi, isGap] = model.Draw(view, ToLanes(uc), ToLanes(u.x), ToLanes(u.y));
        BxDFSamples samples;
        samples.wi = {ToWide(wi.x), ToWide(wi.y), ToWide(wi.z)};
        samples.gap = samples.specular = feather::BitsOf(isGap) & active;
        // Of gaps f is known, and nothing else need be found.
        const LaneBits others = active & ~samples.gap;
        const feather::Direction<V> in = Local(samples.wi, others);
        samples.f = Spectra(model.f(view, in));
        const WideFloat chance = ToWide(1 - view.pigmentChance);
        samples.pdf = Select(MaskOf(samples.gap), chance, ToWide(model.Pdf(view, in)));
        ForEachLane(samples.gap,
                    [&](int i) { samples.f[size_t(i)] = SampledSpectrum(1 / std::abs(wo.z[i])); });
        samples.valid = active & BitsOf(samples.pdf > 0.f) & ~feather::BitsOf(view.grazing);
        samples.transmission = samples.gap | BitsOf((samples.wi.z < 0.f) != (wo.z < 0.f));
        return samples;
    }

  private:
    using V = feather::Lanes<float>;
    using Model = feather::Barbule<V, NSpectrumSamples>;

    static V ToLanes(const WideFloat &x) { return V::At(reinterpret_cast<const float *>(&x)); }
    static WideFloat ToWide(const V &x) {
        WideFloat wide;
        x.Store(reinterpret_cast<float *>(&wide));
        return wide;
    }
    /// Where a lane is not active, a direction from which nothing is seen.
    static feather::Direction<V> Local(const WideVector3f &w, LaneBits active) {
        return {ToLanes(w.x), ToLanes(w.y), ToLanes(Select(MaskOf(active), w.z, 0.f))};
    }
    static std::array<SampledSpectrum, kWide> Spectra(const Model::Spectrum &values) {
        std::array<SampledSpectrum, kWide> spectra;
        for (int i = 0; i < kWide; ++i) {
            std::array<float, NSpectrumSamples> one;
            for (size_t k = 0; k < NSpectrumSamples; ++k)
                one[k] = values[k][i];
            spectra[size_t(i)] = SampledSpectrum(one);
        }
        return spectra;
    }
    const Model &Barbules() {
        if (!barbules) barbules.emplace(vane, feather::Nm<V>{thickness}, optics);
        return *barbules;
    }

    // Lanes that are never set stay 0: what comes of them is not used.
    feather::Vane<V> vane{};
    V thickness{};
    feather::Optics<V, NSpectrumSamples> optics{};
    std::optional<Model> barbules;
};

}  // namespace pbrt
