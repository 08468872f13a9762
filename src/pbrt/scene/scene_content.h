#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace pbrt {

/// 128 bits of text or bytes; different ones share them with a probability of 3e-39.
using Digest = std::array<uint64_t, 2>;
Digest DigestOf(std::string_view bytes);
/// The digest of both, in this order.
Digest Joined(const Digest &a, const Digest &b);
/// 32 hexadecimal digits.
std::string ToText(const Digest &digest);

/// The content of a scene: the text of its files, and the files that quoted words in it name.
class SceneContent {
  public:
    /// The text of one more file; relative names in it start from the folder `dir`.
    void AddText(std::string_view text, std::string_view dir);

    /// The digest of all text, layout and comments included.
    const Digest &Text() const { return text; }
    /// The digest of all files that were there when AddText saw their names, but for those with
    /// these names, which the scene writes. Reads them.
    Digest Assets(std::span<const std::string> written) const;

  private:
    Digest text{};
    std::unordered_set<std::string> seen;  ///< words, so that each is looked for once
    struct File {
        std::string word, path;
    };
    std::vector<File> files;  ///< in the order of their names in the text
};

}  // namespace pbrt
