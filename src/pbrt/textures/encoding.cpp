#include "pbrt/textures/encoding.h"

#include <fmt/format.h>

#include <charconv>

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
        float gamma = 0;
        const char *begin = text.data() + text.find_first_not_of(' ', 5);
        const char *end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(begin, end, gamma);
        if (error == std::errc() && stop == end && gamma > 0 && gamma < 100)
            return ColorEncoding{ColorEncoding::Kind::Gamma, gamma};
    }
    params.Error(kEncoding.name,
                 fmt::format("unknown encoding \"{}\"; expected \"sRGB\", \"linear\" or "
                             "\"gamma x\" with a number x above 0 and below 100",
                             text));
    return std::nullopt;
}

}  // namespace pbrt
