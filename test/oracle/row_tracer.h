#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "oracle/bent_row.h"
#include "oracle/complex_airy.h"
#include "oracle/direction_bins.h"
#include "oracle/statistics.h"

namespace pbrt::oracle {

/// Mirrors all light: what R leaves is lost by shadowing alone.
struct PerfectMirror {
    double Reflectance(double) const { return 1; }
    double Pigment(double, double) const { return 0; }
};

/// S-eq.1 to S-eq.3 over melanin that reflects `melanin` of the light diffusely.
struct FilmOverMelanin {
    AiryFilm film;
    double melanin;
    double Reflectance(double cosine) const { return Unpolarised<AirySum>(film, cosine).r; }
    double Pigment(double cosineIn, double cosineOut) const {
        return PigmentIntensity(film, cosineIn, cosineOut, std::sqrt(melanin));
    }
};

/// Shares of the light that falls on the vane from one direction.
struct RowLight {
    Estimate gap;                      ///< passes between the barbules without touching one
    Estimate single;                   ///< reflected by a film once, and away
    Estimate second;                   ///< away after the second reflection
    Estimate later;                    ///< still on its way after two, or lost behind the cup
    Estimate pigment;                  ///< TRT, away from the first barbule without meeting another
    std::vector<Estimate> facets;      ///< first reflection by direction, before it can be hindered
    std::vector<Estimate> singleBins;  ///< `single` by direction
    std::vector<Estimate> pigmentBins;  ///< `pigment` by direction
};

struct TraceOptions {
    std::uint64_t seed;
    int samples = 1024;  ///< per replicate
    bool secondBounce = false;
};

/// Follows light that arrives from w (pointing away) through the row, kReplicates * samples rays.
/// `facets` counts light, not power: every surface reflects all of it.
template <class Optics>
class RowTracer {
  public:
    RowTracer(const BentRow &row, const Optics &optics, const DirectionBins &reflected,
              const DirectionBins &scattered)
        : row(row), optics(optics), reflected(reflected), scattered(scattered) {}

    RowLight Trace(Vec3 w, const TraceOptions &options) const {
        const std::size_t nr = reflected.Size(), np = scattered.Size();
        std::mt19937_64 random(options.seed);
        Replicates tally(kBins + 2 * nr + np);
        for (int replicate = 0; replicate < kReplicates; ++replicate) {
            EvenPoints<4> points(random);
            for (int i = 0; i < options.samples; ++i) {
                const auto [u0, u1, u2, u3] = points.Next();
                const auto hit = row.Enter(w, u0, u1);
                if (!hit) {
                    tally.Add(kGap, 1);
                    continue;
                }
                Reflect(*hit, w, options.secondBounce ? &random : nullptr, tally);
                Scatter(*hit, w, u2, u3, tally);
            }
            tally.Close(options.samples);
        }
        return {tally[kGap],
                tally[kSingle],
                tally[kSecond],
                tally[kLater],
                tally[kPigment],
                tally.Part(kBins, nr),
                tally.Part(kBins + nr, nr),
                tally.Part(kBins + 2 * nr, np)};
    }

  private:
    enum Quantity : std::size_t { kGap, kSingle, kSecond, kLater, kPigment, kBins };

    /// Off the film; if it cannot leave and `random` is given, off the next film too.
    void Reflect(const BentRow::Hit &hit, Vec3 w, std::mt19937_64 *random,
                 Replicates &tally) const {
        const Vec3 d = Mirrored(-w, hit.normal);
        const double power = optics.Reflectance(Dot(w, hit.normal));
        const std::size_t bin = kBins + reflected(d);
        tally.Add(bin, 1);
        if (row.Leaves(hit, d)) {
            tally.Add(kSingle, power);
            tally.Add(bin + reflected.Size(), power);
        } else if (random) {
            const auto next = row.Next(hit, d, std::generate_canonical<double, 53>(*random));
            const double kept = next ? optics.Reflectance(-Dot(d, next->normal)) : 1;
            const bool away = next && row.Leaves(*next, Mirrored(d, next->normal));
            tally.Add(away ? kSecond : kLater, power * kept);
        }
    }

    /// Through the film, off the melanin, and out in two directions opposite each other about the
    /// normal.
    void Scatter(const BentRow::Hit &hit, Vec3 w, double u, double v, Replicates &tally) const {
        for (const double turn : {0.0, 0.5}) {
            const Vec3 out = Lambertian(hit.normal, u + turn, v);
            if (!row.Leaves(hit, out)) continue;
            const double power = optics.Pigment(Dot(w, hit.normal), Dot(out, hit.normal)) / 2;
            tally.Add(kPigment, power);
            tally.Add(kBins + 2 * reflected.Size() + scattered(out), power);
        }
    }

    /// Cosine-weighted about the unit normal m.
    static Vec3 Lambertian(Vec3 m, double u, double v) {
        const double angle = 2 * std::numbers::pi * u, r = std::sqrt(v);
        const double a = r * std::cos(angle), b = r * std::sin(angle);
        const double yz = std::hypot(m.y, m.z);  // > 0 but at the pole along x
        const Vec3 s = yz > 0 ? Vec3{0, m.z / yz, -m.y / yz} : Vec3{0, 1, 0};
        const Vec3 t{m.y * s.z - m.z * s.y, m.z * s.x - m.x * s.z, m.x * s.y - m.y * s.x};
        return a * s + b * t + std::sqrt(1 - v) * m;
    }

    const BentRow &row;
    const Optics &optics;
    const DirectionBins &reflected, &scattered;
};

}  // namespace pbrt::oracle
