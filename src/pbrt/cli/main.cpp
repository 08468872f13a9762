#include "pbrt/cli/main.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <vector>

#include "pbrt/util/args.h"
#include "pbrt/util/memory.h"

namespace pbrt::cli {
namespace {

constexpr int kFailure = 1;

/// Takes the option out of `words`; the user's mistake as a sentence.
std::optional<std::string> TakeMemoryLimit(std::vector<std::string> *words) {
    const ArgOption option{"memory-limit", true};
    const auto end = std::find(words->begin(), words->end(), "--");
    for (auto word = words->begin(); word != end; ++word) {
        const std::string::size_type equals = word->find('=');
        if (!IsSpellingOf(std::string_view(*word).substr(0, equals), option.name)) continue;
        const auto value = equals == std::string::npos ? word + 1 : word;
        const std::string text = value == end                  ? ""
                                 : equals == std::string::npos ? *value
                                                               : value->substr(equals + 1);
        words->erase(word, value == end ? value : value + 1);
        const std::optional<uint64_t> bytes = ParseBytes(text);
        if (!bytes) return fmt::format("--memory-limit: \"{}\" is no size, as in 4G or 500M", text);
        return LimitMemory(*bytes);
    }
    return {};
}

/// Without allocation.
int Fail(std::string_view program, const char *why) {
    std::fprintf(stderr, "%.*s: %s\n", int(program.size()), program.data(), why);
    return kFailure;
}

}  // namespace

int Main(std::string_view program, int argc, char **argv, const std::function<int(Args)> &run) {
    try {
        std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
        if (const auto mistake = TakeMemoryLimit(&words)) return Fail(program, mistake->c_str());
        return run(words);
    } catch (const std::bad_alloc &) {
        return Fail(program, "memory has run out");
    } catch (const std::exception &e) {
        return Fail(program, e.what());
    }
}

}  // namespace pbrt::cli
