#include <algorithm>

#include "oracle/curved_film.h"

#include <gtest/gtest.h>

namespace pbrt::oracle {
namespace {

const AiryFilm kFilm{520, 650, 1.532 + 5890.0 / (520 * 520)};  // nm; S-sec.1's, of keratin
const CurvedFilm kPacketSize{kFilm, 40e3}, kNarrow{kFilm, 4e3};

/// Greatest difference from the flat film at angles of incidence between two bounds, degrees.
double WorstDifference(const CurvedFilm &tube, double from, double to) {
    double worst = 0;
    for (double degrees = from; degrees <= to; degrees += 0.25) {
        const double incidence = degrees * std::numbers::pi / 180;
        const double flat = Unpolarised<AirySum>(tube.film, std::cos(incidence)).r;
        worst = std::max(worst, std::abs(Reflectance(tube, 2 * incidence) - flat));
    }
    return worst;
}

// S-sec.1: "almost no difference [...] except at near-grazing angles, where total internal
// reflection happens", in figures. The flat film reflects 0.0254 to 0.1908 up to 75 degrees.
TEST(CurvedFilm, FortyMicronsAreAsGoodAsFlat) {
    EXPECT_LT(WorstDifference(kPacketSize, 0, 55), 0.002);
    EXPECT_LT(WorstDifference(kPacketSize, 55, 75), 0.015);
}

TEST(CurvedFilm, FourMicronsDifferNearGrazingOnly) {
    EXPECT_LT(WorstDifference(kNarrow, 0, 55), 0.02);
    EXPECT_GT(WorstDifference(kNarrow, 64, 70), 0.3);
}

/// Angle of incidence on the flat film, degrees, from which on a tube's first-order ray of the same
/// outgoing direction is totally reflected inside: sin(inner) = 1/index, sin(incidence) = 1 - d/r.
double OnsetOfTotalReflection(const CurvedFilm &tube) {
    const TubeRay ray(tube, std::asin(1 - tube.film.thickness / tube.radius), 1);
    return ray.Axis() * 180 / std::numbers::pi;
}

TEST(CurvedFilm, DifferenceBeginsWithTotalReflection) {
    EXPECT_NEAR(OnsetOfTotalReflection(kNarrow), 64.3, 0.05);
    EXPECT_NEAR(OnsetOfTotalReflection(kPacketSize), 80.4, 0.05);
    for (const CurvedFilm &tube : {kPacketSize, kNarrow}) {
        const double onset = OnsetOfTotalReflection(tube);
        EXPECT_GT(WorstDifference(tube, onset + 1, onset + 2),
                  3 * WorstDifference(tube, 0, onset - 1));
    }
}

// The difference is of first order in thickness over radius.
TEST(CurvedFilm, WideTubesAreFlat) {
    const double one = WorstDifference({kFilm, 4e5}, 0, 75),
                 two = WorstDifference({kFilm, 8e5}, 0, 75);
    EXPECT_LT(one, 2e-3);
    EXPECT_NEAR(one / two, 2, 0.1);
}

struct Plane {
    double x, y;
    friend Plane operator+(Plane a, Plane b) { return {a.x + b.x, a.y + b.y}; }
    friend Plane operator*(double s, Plane a) { return {s * a.x, s * a.y}; }
};
double Dot(Plane a, Plane b) {
    return a.x * b.x + a.y * b.y;
}

/// Follows the first-order ray step by step with Snell's law in vectors; light falls along -y.
struct FollowedRay {
    Plane out;    ///< its direction when it has left
    double path;  ///< optical, from the line y = 0 to the front through the axis across `out`
    FollowedRay(const CurvedFilm &tube, double incidence) {
        const double r = tube.radius, n = tube.film.index;
        const auto hit = [](Plane o, Plane d, double radius, double sign) {
            const double b = Dot(o, d);
            return -b + sign * std::sqrt(b * b - Dot(o, o) + radius * radius);
        };
        const auto refract = [](Plane d, Plane normal, double ratio) {  // normal against d
            const double c = -Dot(d, normal);
            return ratio * d + (ratio * c - std::sqrt(1 - ratio * ratio * (1 - c * c))) * normal;
        };
        const Plane enter{r * std::sin(incidence), r * std::cos(incidence)};
        Plane d = refract({0, -1}, (1 / r) * enter, 1 / n);
        const double first = hit(enter, d, r - tube.film.thickness, -1);
        const Plane turn = enter + first * d;
        const Plane normal = (1 / std::sqrt(Dot(turn, turn))) * turn;
        d = d + -2 * Dot(d, normal) * normal;
        const double second = hit(turn, d, r, 1);
        const Plane leave = turn + second * d;
        out = refract(d, (-1 / r) * leave, n);
        path = -enter.y + n * (first + second) - Dot(leave, out);
    }
};

TEST(CurvedFilm, RaysLeaveInParallelAfterTheStatedPath) {
    for (const CurvedFilm &tube : {kPacketSize, kNarrow})
        for (double axis = 0.05; axis < 1.55; axis += 0.1) {
            const TubeRay ray = RayWithAxis(tube, axis, 1);
            const FollowedRay followed(tube, ray.incidence);
            EXPECT_NEAR(followed.out.x, std::sin(2 * axis), 1e-9);
            EXPECT_NEAR(followed.out.y, std::cos(2 * axis), 1e-9);
            EXPECT_NEAR(followed.path, ray.Path(tube), 1e-9 * tube.radius);
        }
}

}  // namespace
}  // namespace pbrt::oracle
