#include "pbrt/scene/content_hash.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

#include "pbrt/util/hash.h"

namespace pbrt {
namespace {

/// Two streams of 64 bits over the same words, each multiplied by an odd number of its own.
class ContentHasher {
  public:
    void Add(uint64_t word) {
        hash[0] = Hash(hash[0], word);
        hash[1] = Hash(hash[1], word * 0xd6e8feb86659fd93);
    }
    /// The number of bytes and the bytes, eight at a time.
    void Add(std::string_view bytes) {
        Add(bytes.size());
        for (size_t at = 0; at < bytes.size(); at += sizeof(uint64_t)) {
            uint64_t word = 0;
            std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
            Add(word);
        }
    }
    template <typename T>
    void Add(const std::vector<T> &values) {
        Add(std::string_view(reinterpret_cast<const char *>(values.data()),
                             values.size() * sizeof(T)));
    }
    void Add(const std::vector<std::string> &values) {
        Add(values.size());
        for (const std::string &s : values)
            Add(std::string_view(s));
    }
    void Add(const RGBColorSpace *space) { Add(uint64_t(reinterpret_cast<uintptr_t>(space))); }
    const ContentHash &Result() const { return hash; }

  private:
    ContentHash hash{};
};

}  // namespace

ContentHash HashContent(const Entity &entity) {
    ContentHasher hasher;
    hasher.Add(std::string_view(entity.type));
    hasher.Add(entity.colorSpace);
    for (const ParsedParameter &p : entity.params) {
        hasher.Add(p.type);
        hasher.Add(std::string_view(p.name));
        hasher.Add(p.floats);
        hasher.Add(p.ints);
        hasher.Add(p.strings);
        hasher.Add(p.bools);
        hasher.Add(uint64_t(p.mayBeUnused));
        hasher.Add(p.colorSpace);
    }
    return hasher.Result();
}

}  // namespace pbrt
