#include "pbrt/scene/scene_content.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "pbrt/scene/quoted_words.h"
#include "pbrt/scene/scene_file.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

Digest ToDigest(XXH128_hash_t hash) {
    return {hash.low64, hash.high64};
}

/// The digest of a file's bytes; that of nothing where it cannot be read. A file that memory could
/// not hold, so that no plug-in reads it, counts by its size.
Digest DigestOfFile(const std::string &name) {
    std::error_code unknown;
    const uint64_t size = std::filesystem::file_size(name, unknown);
    if (unknown) return DigestOf({});
    if (size > AvailableMemory()) return DigestOf(fmt::format("{} bytes", size));
    const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                         XXH3_freeState);
    XXH3_128bits_reset(state.get());
    std::ifstream file(name, std::ios::binary);
    std::vector<char> buffer(size_t(1) << 20);
    while (file.read(buffer.data(), std::streamsize(buffer.size())), file.gcount() > 0)
        XXH3_128bits_update(state.get(), buffer.data(), size_t(file.gcount()));
    return ToDigest(XXH3_128bits_digest(state.get()));
}

}  // namespace

Digest DigestOf(std::string_view bytes) {
    return ToDigest(XXH3_128bits(bytes.data(), bytes.size()));
}

Digest Joined(const Digest &a, const Digest &b) {
    const std::array<Digest, 2> both{a, b};
    return ToDigest(XXH3_128bits(both.data(), sizeof both));
}

std::string ToText(const Digest &digest) {
    return fmt::format("{:016x}{:016x}", digest[1], digest[0]);
}

void SceneContent::AddText(std::string_view more, std::string_view dir) {
    text = Joined(text, DigestOf(more));
    ForEachQuotedWord(more, [&](const std::string &word) {
        constexpr size_t kLongest = 4096;  // of a path
        if (word.empty() || word.size() > kLongest || !seen.insert(word).second) return;
        std::string file = ResolvePath(word, dir);
        std::error_code none;
        if (std::filesystem::is_regular_file(file, none)) files.push_back({word, std::move(file)});
    });
}

Digest SceneContent::Assets(std::span<const std::string> written) const {
    Digest all{};
    for (const File &file : files)
        if (std::find(written.begin(), written.end(), file.word) == written.end())
            all = Joined(all, DigestOfFile(file.path));
    return all;
}

}  // namespace pbrt
