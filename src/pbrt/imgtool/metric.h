#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/image/image.h"

namespace pbrt::imgtool {

/// Error of a value against its reference, before the mean over pixels and channels is taken.
struct Metric {
    std::string_view name;
    double (*error)(double value, double reference);
};

inline constexpr std::array kMetrics{
    Metric{"MSE", [](double v, double r) { return (v - r) * (v - r); }},
    Metric{"MAE", [](double v, double r) { return std::abs(v - r); }},
    // Relative to the reference; 0.01 keeps dark pixels from ruling the mean.
    Metric{"MRSE",
           [](double v, double r) { return (v - r) * (v - r) / ((r + 0.01) * (r + 0.01)); }},
};

/// Metric of that name, case ignored; nullptr where unknown.
const Metric *MetricNamed(std::string_view name);
/// True for FLIP (flip.h), which judges pixels by their neighbours.
bool IsFlip(std::string_view name);
/// `unknown metric "X"; ...` with what is allowed; `more`: beside kMetrics.
std::string UnknownMetric(std::string_view name, std::vector<std::string_view> more = {});

/// Mean over pixels and channels, infinite where a value is not finite. `picture`, if given, gets
/// the error of each value. The images must match.
double MeanError(const Metric &metric, const Image &image, const Image &reference,
                 Image *picture = nullptr);

/// Mean over pixels and channels.
double AverageValue(const Image &image);

}  // namespace pbrt::imgtool
