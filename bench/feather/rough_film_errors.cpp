#include "bench/feather/rough_film_errors.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "oracle/rough_film.h"
#include "pbrt/feather/dispersion.h"
#include "pbrt/feather/thin_film.h"
#include "pbrt/util/rng.h"

namespace pbrt::bench {
namespace {

using oracle::Polarisation;
using oracle::RoughFilm;
constexpr int kCases = 2000;

/// A value that should be `exact`.
struct Found {
    double value, exact;
};
struct Errors {
    double mean = 0, bias = 0, rms = 0, most = 0;
};
/// Errors over kCases random cases.
Errors Measure(const std::function<Found(Rng &)> &one) {
    std::vector<Found> found(kCases);
    tbb::parallel_for(0, kCases, [&](int i) {
        Rng rng(uint64_t(i) + 1);
        found[size_t(i)] = one(rng);
    });
    Errors e;
    for (const auto &[value, exact] : found) {
        const double off = value - exact;
        e.mean += exact / kCases;
        e.bias += off / kCases;
        e.rms += off * off / kCases;
        e.most = std::max(e.most, std::abs(off));
    }
    e.rms = std::sqrt(e.rms);
    return e;
}

double Between(Rng &rng, double lo, double hi) {
    return lo + (hi - lo) * double(rng.Uniform());
}
RoughFilm AnyKeratin(Rng &rng, double thinnest, double thickest, double deviation) {
    const double lambda = Between(rng, 380, 780);
    const double eta = feather::KeratinIndex(feather::Nm<double>{lambda});
    return {{lambda, Between(rng, thinnest, thickest), eta}, deviation};
}
feather::Film<double> ModelOf(const RoughFilm &f) {
    return {{f.film.lambda}, {f.film.thickness}, f.film.index, {f.deviation}};
}

Errors OfReflectance(double from, double to, double deviation) {
    return Measure([=](Rng &rng) {
        const RoughFilm f = AnyKeratin(rng, 100, 2000, Between(rng, 1e-3, deviation));
        const double c = std::cos(Between(rng, from, to) * std::numbers::pi / 180);
        return Found{ModelOf(f).Reflectance(c), MeanReflectance(f, c)};
    });
}

enum class Way { Rendered, Reference };
Errors OfReturn(Way way, double deviation) {
    return Measure([=](Rng &rng) {
        const RoughFilm f = AnyKeratin(rng, 400, 800, deviation);
        const double in = std::sqrt(Between(rng, 1e-6, 1)), out = std::sqrt(Between(rng, 1e-6, 1));
        const auto exact = [&](Polarisation p) {
            return MeanTransmittance(f, in, p) * MeanTransmittance(f, out, p);
        };
        const feather::Film<double> film = ModelOf(f);
        const auto i = film.Transmittance(in), o = film.Transmittance(out);
        return Found{way == Way::Rendered ? film.twice.Weighted(1., in * in, out * out)
                                          : i.s * o.s + i.p * o.p,
                     exact(Polarisation::S) + exact(Polarisation::P)};
    });
}

}  // namespace

std::string RoughFilmCsv() {
    std::string csv = "kind,from,to,deviation,mean,bias,rms,most\n";
    const auto add = [&](const char *kind, double from, double to, double deviation,
                         const Errors &e) {
        csv += fmt::format("\"{}\",{},{},{},{:.4g},{:.4g},{:.4g},{:.4g}\n", kind, from, to,
                           deviation, e.mean, e.bias, e.rms, e.most);
    };
    constexpr double edges[] = {0, 45, 60, 75, 85, 89.9};
    for (int i = 0; i < 5; ++i)
        for (const double deviation : {10, 40, 200})
            add("reflectance", edges[i], edges[i + 1], deviation,
                OfReflectance(edges[i], edges[i + 1], deviation));
    for (const double deviation : {5, 10, 20, 40, 100}) {
        add("return, as rendered", 0, 90, deviation, OfReturn(Way::Rendered, deviation));
        add("return, reference", 0, 90, deviation, OfReturn(Way::Reference, deviation));
    }
    return csv;
}

}  // namespace pbrt::bench
