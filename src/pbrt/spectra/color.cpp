#include "pbrt/spectra/color.h"

#include <tbb/collaborative_call_once.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "pbrt/spectra/sigmoid_fit.h"
#include "pbrt/spectra/sigmoid_table.h"

namespace pbrt {
namespace {

/// XYZ of a chromaticity at Y = 1.
Triple XYZOfChromaticity(const std::array<float, 2> &xy) {
    return {double(xy[0]) / xy[1], 1, (1 - double(xy[0]) - xy[1]) / xy[1]};
}

/// Columns: XYZ of the primaries, scaled so that they add up to the white.
Matrix3d MatrixOfPrimaries(const std::array<std::array<float, 2>, 4> &xy, const Triple &white) {
    Matrix3d columns;
    for (int c = 0; c < 3; ++c) {
        // At X + Y + Z = 1, since a primary's y may be 0.
        const double x = xy[c][0], y = xy[c][1];
        columns[0][c] = x, columns[1][c] = y, columns[2][c] = 1 - x - y;
    }
    const Triple scale = Mul(Inverse(columns), white);
    for (auto &row : columns)
        for (int c = 0; c < 3; ++c)
            row[c] *= scale[c];
    return columns;
}

float InUnitRange(float v) {
    return v > 0 ? std::min(v, 1.f) : 0;  // and 0 for no number
}
RGB InUnitRange(const RGB &c) {
    return {InUnitRange(c.r), InUnitRange(c.g), InUnitRange(c.b)};
}
bool IsGrey(const RGB &c) {
    return c.r == c.g && c.g == c.b;
}
/// The constant `value` as a sigmoid; infinite c2 for 0 and 1.
RGBSigmoid GreySigmoid(float value) {
    return {0, 0, (value - 0.5f) / std::sqrt(value * (1 - value))};
}

/// Colour = scale * albedo with the greatest albedo 1/2, where sigmoids are smoothest.
struct ScaledAlbedo {
    RGB albedo;
    float scale;
    explicit ScaledAlbedo(const RGB &c) : scale(2 * std::max(0.f, c.Max())) {
        if (scale > 0) albedo = c * (1 / scale);
    }
};

}  // namespace

struct RGBColorSpace::Tables {
    Tables(std::shared_ptr<const DenseTable> illuminant, const Matrix3d &rgbFromXYZ)
        : illuminant(illuminant), fit(Spectrum::Dense(illuminant), rgbFromXYZ) {}
    const SigmoidTable &LookUpTable() {
        tbb::collaborative_call_once(once, [this] { table.emplace(fit); });
        return *table;
    }

    std::shared_ptr<const DenseTable> illuminant;
    SigmoidFit fit;

  private:
    // A cache: filled at the first look-up, by all threads that wait for it.
    tbb::collaborative_once_flag once;
    std::optional<SigmoidTable> table;
};

RGBColorSpace::RGBColorSpace(std::string_view name,
                             const std::array<std::array<float, 2>, 4> &chromaticities,
                             const Spectrum &illuminant)
    : name(name), xy(chromaticities), illuminant(illuminant) {
    const auto [X, Y, Z] = SpectrumToXYZ(illuminant);
    xy[3] = {X / (X + Y + Z), Y / (X + Y + Z)};
    const Matrix3d matrix = MatrixOfPrimaries(xy, {double(X) / Y, 1, double(Z) / Y});
    xyzFromRGB = ToFloat(matrix);
    rgbFromXYZ = ToFloat(Inverse(matrix));
    auto dense = std::make_shared<DenseTable>();
    for (int i = 0; i < DenseTable::Size; ++i)
        dense->values.push_back(illuminant(LambdaMin + i));
    tables = std::make_unique<Tables>(std::move(dense), Inverse(matrix));
}

RGBColorSpace::~RGBColorSpace() = default;

namespace {

constexpr std::array<std::string_view, 4> spaceNames{"srgb", "rec2020", "dci-p3", "aces2065-1"};

/// Spaces in the order of their names.
const std::array<RGBColorSpace, 4> &Spaces() {
    const auto space = [](int i, const std::array<std::array<float, 2>, 4> &xy,
                          std::string_view illuminant) {
        return RGBColorSpace(spaceNames[size_t(i)], xy, *GetNamedSpectrum(illuminant));
    };
    // Whites as standardised; the spaces take that of the illuminant's spectrum, equal to 1e-4.
    static const std::array<RGBColorSpace, 4> spaces{
        // IEC 61966-2-1
        space(0, {{{.64f, .33f}, {.3f, .6f}, {.15f, .06f}, {.3127f, .329f}}}, "stdillum-D65"),
        // ITU-R BT.2020
        space(1, {{{.708f, .292f}, {.17f, .797f}, {.131f, .046f}, {.3127f, .329f}}},
              "stdillum-D65"),
        // SMPTE RP 431-2 with the white of displays
        space(2, {{{.68f, .32f}, {.265f, .69f}, {.15f, .06f}, {.3127f, .329f}}}, "stdillum-D65"),
        // SMPTE ST 2065-1
        space(3, {{{.7347f, .2653f}, {0, 1}, {.0001f, -.077f}, {.32168f, .33767f}}},
              "illum-acesD60"),
    };
    return spaces;
}

}  // namespace

const RGBColorSpace *RGBColorSpace::Named(std::string_view name) {
    const auto same = [](unsigned char a, unsigned char b) {
        return std::tolower(a) == std::tolower(b);
    };
    for (const RGBColorSpace &space : Spaces())
        if (std::equal(name.begin(), name.end(), space.name.begin(), space.name.end(), same))
            return &space;
    return nullptr;
}

const RGBColorSpace &RGBColorSpace::sRGB() {
    return Spaces()[0];
}

std::span<const std::string_view> RGBColorSpace::Names() {
    return spaceNames;
}

RGB RGBColorSpace::ToRGB(const XYZ &c) const {
    const auto [r, g, b] = Mul(rgbFromXYZ, {c.X, c.Y, c.Z});
    return {r, g, b};
}

XYZ RGBColorSpace::ToXYZ(const RGB &c) const {
    const auto [x, y, z] = Mul(xyzFromRGB, {c.r, c.g, c.b});
    return {x, y, z};
}

RGBSigmoid RGBColorSpace::FitSigmoid(const RGB &rgb) const {
    const RGB c = InUnitRange(rgb);
    if (IsGrey(c)) return GreySigmoid(c.r);
    return ToSigmoid(tables->fit.Fit({c.r, c.g, c.b}).parameters);
}

RGBSigmoid RGBColorSpace::LookUpSigmoid(const RGB &rgb) const {
    const RGB c = InUnitRange(rgb);
    if (IsGrey(c)) return GreySigmoid(c.r);
    return tables->LookUpTable().LookUp({c.r, c.g, c.b});
}

Spectrum RGBColorSpace::AlbedoSpectrum(const RGB &rgb) const {
    const RGB c = InUnitRange(rgb);
    return IsGrey(c) ? Spectrum(c.r) : Spectrum(FitSigmoid(c));
}

Spectrum RGBColorSpace::UnboundedSpectrum(const RGB &rgb) const {
    if (IsGrey(rgb)) return Spectrum(rgb.r);
    const ScaledAlbedo c(rgb);
    return Spectrum(FitSigmoid(c.albedo), c.scale);
}

Spectrum RGBColorSpace::IlluminantSpectrum(const RGB &rgb) const {
    if (IsGrey(rgb)) return Spectrum::Dense(tables->illuminant, rgb.r);
    const ScaledAlbedo c(rgb);
    return Spectrum(FitSigmoid(c.albedo), c.scale, tables->illuminant);
}

SampledSpectrum RGBColorSpace::SampleAlbedo(const RGB &rgb,
                                            const SampledWavelengths &lambda) const {
    const RGB c = InUnitRange(rgb);
    if (IsGrey(c)) return SampledSpectrum(c.r);
    return LookUpSigmoid(c).Sample(lambda);
}

SampledSpectrum RGBColorSpace::SampleUnbounded(const RGB &rgb,
                                               const SampledWavelengths &lambda) const {
    if (IsGrey(rgb)) return SampledSpectrum(rgb.r);
    const ScaledAlbedo c(rgb);
    return LookUpSigmoid(c.albedo).Sample(lambda) * c.scale;
}

SampledSpectrum RGBColorSpace::SampleIlluminant(const RGB &rgb,
                                                const SampledWavelengths &lambda) const {
    return SampleUnbounded(rgb, lambda) * tables->illuminant->Sample(lambda.Lambda());
}

Matrix3 WhiteBalance(const std::array<float, 2> &fromXY, const std::array<float, 2> &toXY) {
    // Bradford's cone responses (Lam 1985), as in ICC.1:2022 annex E.
    const Matrix3d bradford{
        {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
    const Triple from = Mul(bradford, XYZOfChromaticity(fromXY));
    const Triple to = Mul(bradford, XYZOfChromaticity(toXY));
    Matrix3d scale{};
    for (int i = 0; i < 3; ++i)
        scale[i][i] = to[i] / from[i];
    return ToFloat(Product(Product(Inverse(bradford), scale), bradford));
}

}  // namespace pbrt
