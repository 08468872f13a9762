#include "pbrt/spectra/spectrum_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "pbrt/spectra/sampled_spectrum.h"

namespace pbrt {
namespace {

/// The number that `word` spells, whole; nothing where it spells none.
std::optional<float> ParseFinite(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    float value;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

struct Reader {
    const std::string &fileName;
    SpectrumPoints points;
    std::string error;

    void Fail(int line, const std::string &what) {
        error = fileName + ":" + std::to_string(line) + ": " + what;
    }
    void Take(const std::string &word, int line) {
        const std::optional<float> number = ParseFinite(word);
        if (!number) return Fail(line, "\"" + word + "\" is not a number");
        if (points.lambda.size() > points.values.size()) {
            points.values.push_back(*number);
        } else if (!points.lambda.empty() && *number <= points.lambda.back()) {
            Fail(line, "wavelength " + word + " is not greater than the one before it");
        } else {
            points.lambda.push_back(*number);
        }
    }
};

/// Why these say nothing about visible light; empty where they do.
std::string Invisible(const std::vector<float> &lambda) {
    if (lambda.front() <= LambdaMax && lambda.back() >= LambdaMin) return {};
    constexpr float kMostMicrometres = 100;
    return fmt::format("covers {} to {} nm, nothing of {} to {}{}", lambda.front(), lambda.back(),
                       LambdaMin, LambdaMax,
                       lambda.back() < kMostMicrometres ? "; are these micrometres?" : "");
}

}  // namespace

SpectrumPoints HoldingEnds(SpectrumPoints points) {
    if (points.lambda.front() > LambdaMin) {
        points.lambda.insert(points.lambda.begin(), LambdaMin);
        points.values.insert(points.values.begin(), points.values.front());
    }
    if (points.lambda.back() < LambdaMax) {
        points.lambda.push_back(LambdaMax);
        points.values.push_back(points.values.back());
    }
    return points;
}

OrError<SpectrumPoints> ReadSpectrumFile(const std::string &fileName) {
    std::ifstream file(fileName);
    if (!file) return {std::nullopt, fileName + ": cannot be opened"};
    Reader reader{fileName, {}, {}};
    std::string line, word;
    for (int number = 1; std::getline(file, line) && reader.error.empty(); ++number) {
        std::istringstream words(line.substr(0, line.find('#')));
        while (reader.error.empty() && words >> word)
            reader.Take(word, number);
    }
    if (file.bad()) reader.error = fileName + ": cannot be read";
    if (!reader.error.empty()) return {std::nullopt, reader.error};
    if (reader.points.lambda.empty()) return {std::nullopt, fileName + ": holds no spectrum"};
    if (reader.points.lambda.size() != reader.points.values.size())
        return {std::nullopt, fileName + ": ends with a wavelength that has no value"};
    if (const std::string reason = Invisible(reader.points.lambda); !reason.empty())
        return {std::nullopt, fileName + ": " + reason};
    return {std::move(reader.points), {}};
}

}  // namespace pbrt
