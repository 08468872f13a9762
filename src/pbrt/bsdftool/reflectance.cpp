#include "pbrt/bsdftool/reflectance.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace pbrt::bsdftool {

ReflectanceTable TabulateReflectance(const Material &material, const ReflectanceOptions &options,
                                     const Spectrum &illuminant) {
    ReflectanceTable table;
    const int steps = int((LambdaMax - LambdaMin) / options.step + 1e-3f);
    for (int i = 0; i <= steps; ++i)
        table.lambda.push_back(LambdaMin + float(i) * options.step);
    table.phi = options.phi;
    table.hasParts = std::holds_alternative<FeatherBarbuleMaterial>(material);
    const Observer observer(table.lambda, illuminant);
    table.angles.resize(options.thetas.size());
    tbb::parallel_for(size_t(0), table.angles.size(), [&](size_t i) {
        ReflectanceTable::Angle &angle = table.angles[i];
        angle.theta = options.thetas[i];
        angle.energy = AlbedoFrom(material, Spherical(angle.theta, options.phi), table.lambda,
                                  options.samples);
        const auto &reflected = angle.energy.reflected;
        angle.color = observer.ToXYZ(std::vector<float>(reflected.begin(), reflected.end()));
    });
    return table;
}

std::string ReflectanceCsv(const ReflectanceTable &table) {
    std::string csv =
        fmt::format("theta,phi,lambda,reflectance{}\n", table.hasParts ? ",R,TRT" : "");
    for (const auto &angle : table.angles)
        for (size_t i = 0; i < table.lambda.size(); ++i) {
            csv += fmt::format("{:g},{:g},{:g},{:.9g}", angle.theta, table.phi, table.lambda[i],
                               angle.energy.reflected[i]);
            if (table.hasParts)
                csv += fmt::format(",{:.9g},{:.9g}", angle.energy.R[i], angle.energy.TRT[i]);
            csv += '\n';
        }
    return csv;
}

std::string ColorTable(const ReflectanceTable &table) {
    std::string text =
        fmt::format("{:>6} {:>7} {:>7} {:>8}   {}\n", "theta", "x", "y", "Y", "linear sRGB");
    for (const auto &angle : table.angles) {
        const XYZ &c = angle.color;
        const float sum = c.X + c.Y + c.Z;
        const RGB rgb = RGBColorSpace::sRGB().ToRGB(c);
        text +=
            fmt::format("{:6g} {:7.4f} {:7.4f} {:8.5f}   {:.4f} {:.4f} {:.4f}\n", angle.theta,
                        sum > 0 ? c.X / sum : 0, sum > 0 ? c.Y / sum : 0, c.Y, rgb.r, rgb.g, rgb.b);
    }
    return text;
}

}  // namespace pbrt::bsdftool
