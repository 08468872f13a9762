#include "pbrt/imgtool/metric.h"

#include <fmt/format.h>

#include <limits>
#include <vector>

#include "pbrt/util/diagnostics.h"

namespace pbrt::imgtool {

namespace {

/// `name` in any case is `capitals`.
bool Means(std::string_view name, std::string_view capitals) {
    const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; };
    return std::equal(name.begin(), name.end(), capitals.begin(), capitals.end(),
                      [&](char a, char b) { return upper(a) == b; });
}

}  // namespace

const Metric *MetricNamed(std::string_view name) {
    for (const Metric &metric : kMetrics)
        if (Means(name, metric.name)) return &metric;
    return nullptr;
}

bool IsFlip(std::string_view name) {
    return Means(name, "FLIP");
}

std::string UnknownMetric(std::string_view name, std::vector<std::string_view> more) {
    std::vector<std::string_view> names;
    for (const Metric &metric : kMetrics)
        names.push_back(metric.name);
    names.insert(names.end(), more.begin(), more.end());
    return fmt::format("unknown metric \"{}\"; there are {}", name, QuotedList(names));
}

double MeanError(const Metric &metric, const Image &image, const Image &reference, Image *picture) {
    if (picture) {
        *picture = Image(image.Resolution(), image.ChannelNames());
        picture->metadata = image.metadata;
    }
    double sum = 0;
    const size_t n = image.Data().size();
    for (size_t i = 0; i < n; ++i) {
        double error = metric.error(image.Data()[i], reference.Data()[i]);
        if (!std::isfinite(error)) error = std::numeric_limits<double>::infinity();
        if (picture) picture->Data()[i] = float(error);
        sum += error;
    }
    return sum / double(n);
}

double AverageValue(const Image &image) {
    double sum = 0;
    for (const float v : image.Data())
        sum += v;
    return sum / double(image.Data().size());
}

}  // namespace pbrt::imgtool
