#include "pbrt/feathergen/feather.h"

#include <algorithm>
#include <numbers>

#include "pbrt/util/rng.h"

namespace pbrt::feathergen {
namespace {

/// The root's part of a barb, where its barbules are short.
constexpr double kRootPart = 0.2, kRootWidth = 0.45;

double SmoothStep(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

/// Normal variates by the polar form of Box and Muller's transform, cut at 3 so that no barb stands
/// out wildly.
class Variates {
  public:
    explicit Variates(uint64_t seed) : rng(seed) {}
    double operator()() {
        const double r = std::sqrt(-2 * std::log(1 - double(rng.Uniform())));
        return std::clamp(r * std::cos(2 * std::numbers::pi * double(rng.Uniform())), -3.0, 3.0);
    }

  private:
    Rng rng;
};

/// Length of the barb at `place`, of the longest.
double LengthProfile(const Parameters &p, double place) {
    const double peak = p.barbLengthPeak, half = std::numbers::pi / 2;
    if (place < peak)
        return p.barbLengthBase + (1 - p.barbLengthBase) * std::sin(half * place / peak);
    return p.barbLengthTip + (1 - p.barbLengthTip) * std::cos(half * (place - peak) / (1 - peak));
}

BentAxis GrowRachis(const Parameters &p) {
    BentAxis axis;
    axis.base = {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
    axis.length = p.rachisLength;
    axis.turn = -p.rachisSweep;
    axis.droop = p.rachisBend;
    return axis;
}

Barb GrowBarb(const Feather &feather, double place, int side, Variates &random) {
    const Parameters &p = feather.parameters;
    Barb barb;
    barb.place = place;
    const double crowded = place + p.barbCrowding * place * (1 - place);
    const double at = p.barbStart + (0.995 - p.barbStart) * crowded;
    barb.axis.base = feather.rachis.At(at);
    barb.axis.root =
        feather.rachis.Point(at) + 0.7 * side * feather.RachisRadius(at) * barb.axis.base.left;
    const double angle = Lerp(crowded, p.barbAngleBase, p.barbAngleTip);
    barb.axis.azimuth = side * (angle + p.jitter * random());
    barb.axis.turn =
        -side * (p.barbCurl * angle / std::max(p.barbAngleBase, 0.01) + p.jitter * random());
    // Barbs along the rachis lie in its plane, those across it bend most.
    barb.axis.rise = (p.barbLift + p.jitter * random()) * std::sin(angle);
    barb.axis.droop = (p.barbDroop + p.jitter * random()) * std::sin(angle);
    barb.axis.length = p.barbLength * LengthProfile(p, place) * (1 + p.jitter * random());
    barb.width = p.barbWidth * (1 + p.jitter * random());
    // The side towards the feather's tip is the left one of barbs on the right.
    barb.roll = side * (p.barbRoll + p.jitter * random());
    barb.extra = {p.thicknessSpread * random(), p.spacingSpread * random(),
                  p.tiltSpread * random()};
    return barb;
}

}  // namespace

double Barb::Profile(const Parameters &p, double u) const {
    const double root = kRootWidth + (1 - kRootWidth) * SmoothStep(u / kRootPart);
    const double gone = std::max(0.0, (u - (1 - p.barbTaper)) / p.barbTaper);
    return root * (1 - (1 - p.barbTipWidth) * gone * gone);
}

VanePoint Barb::Surface(const Parameters &p, double u, double v) const {
    const AxisFrame f = axis.At(u);
    const double cr = std::cos(roll), sr = std::sin(roll);
    const Vec3d left = cr * f.left + sr * f.up, up = cr * f.up - sr * f.left;
    // Derivatives of the frame: the azimuth turns it about the base's up, the elevation about left.
    const double a = axis.turn, e = -axis.droop, elevation = axis.Elevation(u);
    const Vec3d level = std::cos(elevation) * f.forward - std::sin(elevation) * f.up;
    const Vec3d dLeft = -a * level;
    const Vec3d dUp = -e * f.forward - (a * std::sin(elevation)) * f.left;
    const Vec3d dRolledLeft = cr * dLeft + sr * dUp, dRolledUp = cr * dUp - sr * dLeft;

    const auto radiusAt = [&](double t) { return width / (2 * std::sin(p.cover)) * Profile(p, t); };
    constexpr double kStep = 1e-5;
    const double radius = radiusAt(u);
    const double dRadius = (radiusAt(u + kStep) - radiusAt(u - kStep)) / (2 * kStep);
    const double angle = v * p.cover, s = std::sin(angle), drop = 1 - std::cos(angle);
    return {axis.Point(u) + radius * (s * left - drop * up),
            axis.length * f.forward + dRadius * (s * left - drop * up) +
                radius * (s * dRolledLeft - drop * dRolledUp),
            (radius * p.cover) * (std::cos(angle) * left - s * up)};
}

VaneValues Barb::Values(const Parameters &p, double u, double v) const {
    const auto along = [&](double mean, double gradient, double rootToTip) {
        return mean + gradient * (place - 0.5) + rootToTip * (u - 0.5);
    };
    const double nearRamus = 1 - SmoothStep(std::abs(v) / p.tiltRiseWidth);
    return {
        std::max(0.0, along(p.thickness, p.thicknessGradient, p.thicknessAlong) + extra.thickness),
        std::max(0.01, along(p.spacing, p.spacingGradient, p.spacingAlong) + extra.spacing),
        std::clamp(along(p.tilt, p.tiltGradient, p.tiltAlong) + extra.tilt + p.tiltRise * nearRamus,
                   -std::numbers::pi / 2, std::numbers::pi / 2)};
}

Feather::Feather(const Parameters &p, uint64_t seed) : parameters(p), rachis(GrowRachis(p)) {
    const int count = int(p.barbCount);
    Variates random(seed);
    for (int i = 0; i < count; ++i)
        for (const int side : {-1, 1})
            barbs.push_back(GrowBarb(*this, (i + (side < 0 ? 0.5 : 0.1)) / count, side, random));
}

double Feather::RachisRadius(double u) const {
    return Lerp(u, parameters.rachisRadius, parameters.rachisTipRadius);
}

double Rotation(const Parameters &p, Bank bank) {
    const double turn = (std::numbers::pi / 2 - p.span) * (180 / std::numbers::pi);
    return bank == Bank::Left ? -turn : turn;
}

}  // namespace pbrt::feathergen
