#include "pbrt/lights/goniometric.h"

#include <numeric>

#include "pbrt/lights/light_picture.h"

namespace pbrt {
namespace {

constexpr StringParam kFileName{"filename", "",
                                "square picture of all directions, equal-area octahedral"};

}  // namespace

std::optional<GoniometricLight> GoniometricLight::Create(ParamDict &params,
                                                         const Transform &renderFromLight) {
    const Emission emission = GetEmission(params, kLightIntensity);
    const EmissionScale scale = GetScale(params, kLightPower);
    const std::optional<Image> image = ReadLightPicture(
        params, kFileName, {.what = "a goniometric light", .square = true, .mayBeGray = true});
    if (!image) return std::nullopt;
    auto diagram = std::make_shared<Diagram>();
    diagram->intensity = emission.spectrum;
    diagram->luminance = emission.luminance;
    diagram->lightFromRender = renderFromLight.Inverse();
    diagram->resolution = image->Resolution().x;
    const int gray = image->ChannelIndex("Y");
    for (int y = 0; y < diagram->resolution; ++y)
        for (int x = 0; x < diagram->resolution; ++x)
            diagram->factors.push_back(gray >= 0 ? std::max(0.f, image->Get({x, y}, gray))
                                                 : TexelRGB(*image, x, y).Average());
    const double sum = std::accumulate(diagram->factors.begin(), diagram->factors.end(), 0.0);
    diagram->mean = float(sum / double(diagram->factors.size()));
    if (scale.target > 0 && !(diagram->mean > 0)) {
        params.Error(kLightPower.name, "the picture is black: no scale can give it a power");
        return std::nullopt;
    }
    GoniometricLight light;
    light.scale = scale.For(4 * Pi * diagram->mean);
    light.diagram = std::move(diagram);
    light.p = renderFromLight.Point({0, 0, 0});
    return light;
}

}  // namespace pbrt
