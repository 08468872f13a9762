#include "pbrt/spectra/spectrum_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "pbrt/spectra/sampled_spectrum.h"
#include "pbrt/util/diagnostics.h"
#include "pbrt/util/parse_number.h"
#include "pbrt/util/read_file.h"

namespace pbrt {
namespace {

struct Reader {
    const std::string &fileName;
    SpectrumPoints points;
    std::string error;

    void Fail(int line, const std::string &what) {
        error = fileName + ":" + std::to_string(line) + ": " + what;
    }
    void Take(std::string_view word, int line) {
        const std::optional<float> number = ParseNumber<float>(word);
        if (!number) return Fail(line, fmt::format("\"{}\" is not a number", Shortened(word)));
        if (points.lambda.size() > points.values.size()) {
            points.values.push_back(*number);
        } else if (!points.lambda.empty() && *number <= points.lambda.back()) {
            Fail(line, "wavelength " + Shortened(word) + " is not greater than the one before it");
        } else {
            points.lambda.push_back(*number);
        }
    }
    /// The numbers before a `#`.
    void TakeLine(std::string_view line, int number) {
        constexpr std::string_view kSpace = " \t\r\v\f";
        line = line.substr(0, line.find('#'));
        for (size_t at = line.find_first_not_of(kSpace); at < line.size() && error.empty();) {
            const size_t end = std::min(line.find_first_of(kSpace, at), line.size());
            Take(line.substr(at, end - at), number);
            at = line.find_first_not_of(kSpace, end);
        }
    }
    void TakeAll(std::string_view text) {
        for (int number = 1; !text.empty() && error.empty(); ++number) {
            const size_t end = std::min(text.find('\n'), text.size());
            TakeLine(text.substr(0, end), number);
            text.remove_prefix(std::min(end + 1, text.size()));
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
    const FileContents file = ReadWholeFile(fileName);
    if (!file.bytes) return {std::nullopt, file.error};
    Reader reader{fileName, {}, {}};
    reader.TakeAll(*file.bytes);
    if (!reader.error.empty()) return {std::nullopt, reader.error};
    if (reader.points.lambda.empty()) return {std::nullopt, fileName + ": holds no spectrum"};
    if (reader.points.lambda.size() != reader.points.values.size())
        return {std::nullopt, fileName + ": ends with a wavelength that has no value"};
    if (const std::string reason = Invisible(reader.points.lambda); !reason.empty())
        return {std::nullopt, fileName + ": " + reason};
    return {std::move(reader.points), {}};
}

}  // namespace pbrt
