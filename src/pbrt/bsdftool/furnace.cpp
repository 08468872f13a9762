#include <fmt/format.h>

#include "pbrt/bsdftool/commands.h"
#include "pbrt/util/rng.h"

namespace pbrt::bsdftool {
namespace {

/// Running mean and its standard error.
struct Mean {
    double sum = 0, sumSqr = 0;
    void Add(double v) { sum += v, sumSqr += v * v; }
    double Value(int n) const { return sum / n; }
    double Error(int n) const {
        return std::sqrt(std::max(0.0, sumSqr / n - Value(n) * Value(n)) / (n - 1));
    }
};

struct Sums {
    Mean reflected, transmitted, R, TRT, gap;
};

template <typename B>
void AddSample(const B &bsdf, Vector3f wo, float uc, Point2f u, Sums &sums) {
    const auto s = bsdf.Sample_f(wo, uc, u, TransportMode::Radiance);
    const bool gap = s && Has(s->flags, BxDFFlags::Gap);
    const double weight = s ? s->f.Average() * std::abs(s->wi.z) / s->pdf : 0;
    const bool back = s && SameHemisphere(wo, s->wi);
    sums.reflected.Add(back ? weight : 0);
    sums.transmitted.Add(s && !back && !gap ? weight : 0);
    sums.gap.Add(gap ? weight : 0);
    if constexpr (requires { bsdf.Parts(wo, wo); }) {
        double r = 0, trt = 0;
        if (s && !gap) {
            const auto parts = bsdf.Parts(wo, s->wi);
            for (int i = 0; i < NSpectrumSamples; ++i) {
                const double scale = std::abs(s->wi.z) / s->pdf / NSpectrumSamples;
                r += parts.R[i] * scale;
                trt += parts.TRT[i] * scale;
            }
        }
        sums.R.Add(r);
        sums.TRT.Add(trt);
    }
}

FurnaceRow RowFor(const Material &material, float theta, float phi, int samples) {
    const float t = Radians(theta), p = Radians(phi);
    const Vector3f wo{std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
    TextureEvalContext ctx;
    ctx.uv = {0.5f, 0.5f};
    Rng rng(1);
    Sums sums;
    std::visit(
        [&](const auto &m) {
            for (int i = 0; i < samples; ++i) {
                SampledWavelengths lambda =
                    SampledWavelengths::SampleUniform((i + rng.Uniform()) / samples);
                const auto bsdf = m.GetBxDF(ctx, lambda);
                const float uc = rng.Uniform();
                const Point2f u = rng.Uniform2D();
                AddSample(bsdf, wo, uc, u, sums);
            }
        },
        material);
    FurnaceRow row{theta, phi};
    row.reflected = sums.reflected.Value(samples);
    row.transmitted = sums.transmitted.Value(samples);
    row.R = sums.R.Value(samples);
    row.TRT = sums.TRT.Value(samples);
    row.gap = sums.gap.Value(samples);
    row.absorbed = 1 - row.reflected - row.transmitted - row.gap;
    for (const Mean *m : {&sums.reflected, &sums.transmitted, &sums.gap})
        row.error = std::max(row.error, m->Error(samples));
    return row;
}

}  // namespace

std::vector<FurnaceRow> Furnace(const Material &material, const std::vector<float> &thetas,
                                const std::vector<float> &phis, int samples) {
    std::vector<FurnaceRow> rows;
    for (float theta : thetas)
        for (float phi : phis) rows.push_back(RowFor(material, theta, phi, samples));
    return rows;
}

std::string FurnaceTable(const Material &material, const std::vector<FurnaceRow> &rows) {
    const bool feather = std::holds_alternative<FeatherBarbuleMaterial>(material);
    std::string table = fmt::format("{:>6} {:>6} {:>10} {:>11}", "theta", "phi", "reflected",
                                    "transmitted");
    if (feather) table += fmt::format(" {:>8} {:>8} {:>8}", "R", "TRT", "T");
    table += fmt::format(" {:>9} {:>9}\n", "absorbed", "+-");
    for (const FurnaceRow &r : rows) {
        table += fmt::format("{:6g} {:6g} {:10.5f} {:11.5f}", r.theta, r.phi, r.reflected,
                             r.transmitted);
        if (feather) table += fmt::format(" {:8.5f} {:8.5f} {:8.5f}", r.R, r.TRT, r.gap);
        table += fmt::format(" {:9.5f} {:9.5f}\n", r.absorbed, r.error);
    }
    return table;
}

}  // namespace pbrt::bsdftool
