#include "pbrt/textures/encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "pbrt/util/parse_number.h"

namespace pbrt {
namespace {

constexpr StringParam kEncoding{"encoding", "",
                                "sRGB, linear or \"gamma x\"; not given: as the file's kind is"};

}  // namespace

std::optional<ColorEncoding> GetEncoding(ParamDict &params) {
    const std::string text = params.GetOneString(kEncoding);
    if (text.empty()) return std::nullopt;
    if (text == "sRGB") return ColorEncoding{ColorEncoding::Kind::sRGB, 1};
    if (text == "linear") return ColorEncoding{ColorEncoding::Kind::Linear, 1};
    if (text.starts_with("gamma ")) {
        const size_t begin = std::min(text.find_first_not_of(' ', 5), text.size());
        const auto gamma = ParseWhole<float>(std::string_view(text).substr(begin));
        if (gamma && *gamma > 0 && *gamma < 100)
            return ColorEncoding{ColorEncoding::Kind::Gamma, *gamma};
    }
    params.Error(kEncoding.name,
                 fmt::format("unknown encoding \"{}\"; expected \"sRGB\", \"linear\" or "
                             "\"gamma x\" with a number x above 0 and below 100",
                             text));
    return std::nullopt;
}

}  // namespace pbrt
