// Time of the feather model and error of its TRT quadratures, on one thread, 4 wavelengths, float,
// both directions uniform on the upper hemisphere. Prints nanoseconds and multiples of sinf's time.
//   bench_feather [rounds, default 200]

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "bench/stopwatch.h"
#include "feather/model.h"

namespace pbrt::bench {
namespace {

using namespace feather;

constexpr int kCalls = 2000;

struct Pairs {
    std::vector<Direction<float>> wo, wi;
    std::vector<float> number;
    explicit Pairs(int n) {
        Dice dice(1);
        for (int i = 0; i < n; ++i) {
            wo.push_back(Rounded<float>(dice.OnUpperHemisphere()));
            wi.push_back(Rounded<float>(dice.OnUpperHemisphere()));
            number.push_back(float(dice.Uniform(0, 0.999999)));
        }
    }
};

template <class Each>
std::function<double()> Over(const Pairs &pairs, Each each) {
    return [&pairs, each] {
        double sum = 0;
        for (int i = 0; i < kCalls; ++i)
            sum += each(pairs, i);
        return sum;
    };
}

void AddFilm(Stopwatch &watch, const Pairs &pairs) {
    watch.Add("sinf", kCalls,
              Over(pairs, [](const Pairs &p, int i) { return std::sin(6 * p.number[i] - 3); }));
    const Film<float> film({550}, {590}, 1.55f);
    watch.Add("film", kCalls,
              Over(pairs, [film](const Pairs &p, int i) { return film.Reflectance(p.number[i]); }));
}

void AddModel(Stopwatch &watch, const Pairs &pairs) {
    static const auto barbule = BarbuleOf<float>({});
    static const auto sparse = BarbuleOf<float>({.spacing = 2.5});
    static const auto optics = Feather<float>();
    watch.Add("f", kCalls, Over(pairs, [](const Pairs &p, int i) {
                  return barbule.f(barbule.SeenFrom(p.wo[i]), p.wi[i])[0];
              }));
    watch.Add("R", kCalls, Over(pairs, [](const Pairs &p, int i) {
                  return barbule.R(barbule.SeenFrom(p.wo[i]), p.wi[i])[0];
              }));
    watch.Add("PDF", kCalls, Over(pairs, [](const Pairs &p, int i) {
                  return barbule.PDF(barbule.SeenFrom(p.wo[i]), p.wi[i]);
              }));
    watch.Add("PDF, view given", kCalls, [&pairs] {
        double sum = 0;
        const auto view = barbule.SeenFrom(pairs.wo[0]);
        for (int i = 0; i < kCalls; ++i)
            sum += barbule.PDF(view, pairs.wi[i]);
        return sum;
    });
    watch.Add("Sample without f", kCalls, Over(pairs, [](const Pairs &p, int i) {
                  const auto s = barbule.SampleDirection(barbule.SeenFrom(p.wo[i]), p.number[i],
                                                         p.number[(i + 1) % kCalls],
                                                         p.number[(i + 2) % kCalls]);
                  return s ? s->pdf : 0;
              }));
    watch.Add("gap, spacing 2.5", kCalls,
              Over(pairs, [](const Pairs &p, int i) { return sparse.GapFraction(p.wo[i]); }));
    watch.Add("make a Barbule", kCalls, Over(pairs, [](const Pairs &p, int i) {
                  BarbuleParams<float> params;
                  params.tilt = {p.number[i]};
                  return Barbule<float, 4>(params, optics).GapFraction({0, 0, 1});
              }));
}

template <class Quadrature>
void AddRule(Stopwatch &watch, const Pairs &pairs, const std::string &name) {
    static const auto barbule = BarbuleOf<float, Quadrature>({});
    watch.Add(name, kCalls, Over(pairs, [](const Pairs &p, int i) {
                  return barbule.TRT(barbule.SeenFrom(p.wo[i]), p.wi[i])[0];
              }));
}

/// Error of TRT rms relative to its mean, against the oracle: of f cos cos and of f.
struct Error {
    double light, f;
};

template <class Quadrature>
Error Measure(const Shape &shape, int pairs) {
    const auto fast = BarbuleOf<float, Quadrature>(shape);
    const auto exact = BarbuleOf<double, Converged<4, 6>>(shape);
    Dice dice(2);
    Error off{}, mean{};
    for (int k = 0; k < pairs; ++k) {
        const Direction<double> wo = dice.OnUpperHemisphere(), wi = dice.OnUpperHemisphere();
        const auto a = fast.TRT(fast.SeenFrom(Rounded<float>(wo)), Rounded<float>(wi));
        const auto b = exact.TRT(exact.SeenFrom(wo), wi);
        for (int i = 0; i < 4; ++i) {
            const double d = a[i] - b[i], cosines = wo.z * wi.z;
            off.f += d * d;
            off.light += d * d * cosines * cosines;
            mean.f += b[i];
            mean.light += b[i] * cosines;
        }
    }
    const double n = 4.0 * pairs;
    return {std::sqrt(off.light / n) / (mean.light / n), std::sqrt(off.f / n) / (mean.f / n)};
}

template <class Quadrature>
void PrintRule(const Stopwatch &watch, const std::string &name) {
    const Error usual = Measure<Quadrature>({}, 3000);
    const Error thick = Measure<Quadrature>({.thickness = 2000}, 1000);
    const Error bent = Measure<Quadrature>({.opening = 0.6}, 1000);
    const double ns = watch.Nanoseconds(name);
    std::printf("%-26s %7.1f %6.1f   %6.3f %6.3f   %6.3f   %6.3f\n", name.c_str(), ns,
                ns / watch.Nanoseconds("sinf"), 100 * usual.light, 100 * usual.f, 100 * thick.light,
                100 * bent.light);
}

/// Calls visit.operator()<Quadrature>(name) for every quadrature of the curve.
template <class Visit>
void ForEachRule(Visit visit) {
    visit.template operator()<GaussPanel<8>>("plain 8 x 2, in e");
    visit.template operator()<FixedRule<2, 2, true>>("4 interleaved to 2");
    visit.template operator()<FixedRule<2, 4, true>>("8 interleaved to 2");
    visit.template operator()<FixedRule<2, 4, false>>("4 x 2");
    visit.template operator()<FixedRule<2, 6, true>>("12 interleaved to 2");
    visit.template operator()<FixedRule<2, 8, true>>("16 interleaved to 2");
    visit.template operator()<FixedRule<2, 8, false>>("8 x 2");
    visit.template operator()<FixedRule<2, 16, true>>("32 interleaved to 2");
    visit.template operator()<FixedRule<4, 8, false>>("8 x 4");
    visit.template operator()<FixedRule<8, 8, false>>("8 x 8");
    visit.template operator()<AdaptiveRule>("adaptive (default)");
}

void Run(int rounds) {
    const Pairs pairs(kCalls);
    Stopwatch watch;
    AddFilm(watch, pairs);
    AddModel(watch, pairs);
    ForEachRule([&]<class Q>(const char *name) { AddRule<Q>(watch, pairs, name); });
    watch.Run(rounds);

    const double sinf = watch.Nanoseconds("sinf");
    std::printf("%-26s %7s %6s\n", "", "ns", "/ sinf");
    for (const char *name : {"sinf", "film", "f", "R", "PDF", "PDF, view given", "Sample without f",
                             "gap, spacing 2.5", "make a Barbule"})
        std::printf("%-26s %7.1f %6.1f\n", name, watch.Nanoseconds(name),
                    watch.Nanoseconds(name) / sinf);
    std::printf("\nTRT by quadrature (points x segments); error rms / mean in %%\n");
    std::printf("%-26s %7s %6s   %6s %6s   %6s   %6s\n", "", "ns", "/ sinf", "light", "f", "d 2 um",
                "opening .6");
    ForEachRule([&]<class Q>(const char *name) { PrintRule<Q>(watch, name); });
}

}  // namespace
}  // namespace pbrt::bench

int main(int argc, char **argv) {
    pbrt::bench::Run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 200);
}
