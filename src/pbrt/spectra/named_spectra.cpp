#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "pbrt/spectra/spectrum.h"
#include "pbrt/spectra/tables.h"

namespace pbrt {
namespace {

namespace t = spectra::tables;

/// Index of a glass: n^2 = 1 + sum of b_i l^2 / (l^2 - c_i), l in um.
struct Sellmeier {
    double b1, c1, b2, c2, b3, c3;
    double operator()(float lambda) const {
        const double l2 = Sqr(lambda * 1e-3);
        return std::sqrt(1 + b1 * l2 / (l2 - c1) + b2 * l2 / (l2 - c2) + b3 * l2 / (l2 - c3));
    }
};

// SCHOTT's data sheets: N-BK7, N-BAF10, N-FK51A, N-LASF9, SF5, SF10, SF11.
constexpr Sellmeier bk7{1.03961212,   0.00600069867, 0.231792344,
                        0.0200179144, 1.01046945,    103.560653};
constexpr Sellmeier baf10{1.5851495,    0.00926681282, 0.143559385,
                          0.0424489805, 1.08521269,    105.613573};
constexpr Sellmeier fk51a{0.971247817,  0.00472301995, 0.216901417,
                          0.0153575612, 0.904651666,   168.68133};
constexpr Sellmeier lasf9{2.00029547,   0.0121426017, 0.298926886,
                          0.0538736236, 1.80691843,   156.530829};
constexpr Sellmeier sf5{1.46141885,   0.0111826126, 0.247713019,
                        0.0508594669, 0.949995832,  112.041888};
constexpr Sellmeier sf10{1.61625977,   0.0127534559, 0.259229334,
                         0.0581983954, 1.07762317,   116.60768};
constexpr Sellmeier sf11{1.73848403,   0.0136068604, 0.311168974,
                         0.0615960463, 1.17490871,   121.922711};

/// Magnesium oxide: Stephens and Malitson 1952, doi 10.6028/jres.049.025, l in um. It is
/// transparent: Palik gives k < 2e-6.
double MagnesiaIndex(float lambda) {
    const double l2 = Sqr(lambda * 1e-3);
    return std::sqrt(2.956362 - 0.01062387 * l2 - 2.04968e-5 * l2 * l2 +
                     0.02195770 / (l2 - 0.01428322));
}

/// Feather keratin: Leertouwer, Wilts, Stavenga 2011, doi 10.1364/oe.19.024061. The feather model,
/// which stands on the standard library alone, has this formula and the next, too; a test compares.
double KeratinIndex(double lambda) {
    return 1.532 + 5890 / (lambda * lambda);
}

/// Power that melanin reflects in air at normal incidence, of the index n + ik by Stavenga et al.
/// 2015, doi 10.1038/lsa.2015.16.
double MelaninReflectance(double lambda) {
    const double n = 1.648 + 23700 / (lambda * lambda), k = 0.56 * std::exp(-lambda / 270);
    return (Sqr(n - 1) + Sqr(k)) / (Sqr(n + 1) + Sqr(k));
}

/// CIE standard illuminant A by its definition (CIE S 014-2): c2 = 1.435e7, T = 2848 K.
double IlluminantA(float lambda) {
    const double c2OverT = 1.435e7 / 2848;
    return 100 * std::pow(560.0 / lambda, 5) * std::expm1(c2OverT / 560) /
           std::expm1(c2OverT / lambda);
}

template <size_t N>
Spectrum Densely(const std::array<float, N> &lambda, const std::array<float, N> &values) {
    return Spectrum::PiecewiseLinear(lambda, values).Densely();
}

Spectrum Fluorescent(int number) {
    const auto &values = t::fluorescent[size_t(number - 1)];
    std::array<float, 81> lambda;
    for (size_t i = 0; i < lambda.size(); ++i)
        lambda[i] = 380 + 5 * float(i);
    return Densely(lambda, values);
}

/// The D illuminants were defined with another second radiation constant, 1.4380e-2 m K.
Spectrum StandardDaylight(double nominalKelvin) {
    return Spectrum::Daylight(nominalKelvin * (1.4388 / 1.4380));
}

using Entries = std::vector<std::pair<std::string, Spectrum>>;

void AddMetals(Entries &all) {
    const auto add = [&](const std::string &name, const auto &lambda, const auto &eta,
                         const auto &k) {
        all.emplace_back("metal-" + name + "-eta", Densely(lambda, eta));
        all.emplace_back("metal-" + name + "-k", Densely(lambda, k));
    };
    add("Ag", t::metalAgLambda, t::metalAgEta, t::metalAgK);
    add("Al", t::metalAlLambda, t::metalAlEta, t::metalAlK);
    add("Au", t::metalAuLambda, t::metalAuEta, t::metalAuK);
    add("Cu", t::metalCuLambda, t::metalCuEta, t::metalCuK);
    add("CuZn", t::metalCuZnLambda, t::metalCuZnEta, t::metalCuZnK);
    add("TiO2", t::metalTiO2Lambda, t::metalTiO2Eta, t::metalTiO2K);
    all.emplace_back("metal-MgO-eta", Spectrum::DenselySampled(MagnesiaIndex));
    all.emplace_back("metal-MgO-k", Spectrum(0.f));
}

void AddGlasses(Entries &all) {
    const std::pair<const char *, const Sellmeier &> glasses[] = {
        {"BK7", bk7}, {"BAF10", baf10}, {"FK51A", fk51a}, {"LASF9", lasf9},
        {"F5", sf5},  {"F10", sf10},    {"F11", sf11}};
    for (const auto &[name, index] : glasses)
        all.emplace_back(std::string("glass-") + name, Spectrum::DenselySampled(index));
}

void AddIlluminants(Entries &all) {
    all.emplace_back("stdillum-A", Spectrum::DenselySampled(IlluminantA));
    all.emplace_back("stdillum-D50", StandardDaylight(5000));
    all.emplace_back("stdillum-D65", StandardDaylight(6500));
    for (int i = 1; i <= 12; ++i)
        all.emplace_back("stdillum-F" + std::to_string(i), Fluorescent(i));
    // The spectrum whose chromaticity, x 0.32168, y 0.33767, is the white of ACES.
    all.emplace_back("illum-acesD60", Spectrum::Daylight(6000));
}

void AddFeather(Entries &all) {
    all.emplace_back("keratin", Spectrum::DenselySampled(KeratinIndex));
    all.emplace_back("melanin", Spectrum::DenselySampled(MelaninReflectance));
}

/// Entries sorted by name.
struct Library {
    Entries entries;
    std::vector<std::string_view> names;

    Library() {
        AddMetals(entries);
        AddGlasses(entries);
        AddIlluminants(entries);
        AddFeather(entries);
        std::sort(entries.begin(), entries.end(),
                  [](const auto &a, const auto &b) { return a.first < b.first; });
        for (const auto &[name, spectrum] : entries)
            names.push_back(name);
    }
};

const Library &NamedSpectra() {
    static const Library library;
    return library;
}

}  // namespace

const Spectrum *GetNamedSpectrum(std::string_view name) {
    const Library &l = NamedSpectra();
    const auto found = std::lower_bound(l.names.begin(), l.names.end(), name);
    if (found == l.names.end() || *found != name) return nullptr;
    return &l.entries[size_t(found - l.names.begin())].second;
}

std::span<const std::string_view> NamedSpectrumNames() {
    return NamedSpectra().names;
}

}  // namespace pbrt
