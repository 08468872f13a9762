#include "pbrt/ptex/native/metadata.h"

#include <cstdint>
#include <cstring>

#include "pbrt/ptex/native/encode.h"

namespace pbrt {
namespace {

constexpr uint8_t kText = 0;

}  // namespace

std::string PtexMetadataBytes(const std::map<std::string, std::string> &metadata) {
    std::string bytes;
    for (const auto &[key, value] : metadata) {
        AppendBytes(&bytes, uint8_t(key.size() + 1));
        bytes.append(key.c_str(), key.size() + 1);
        AppendBytes(&bytes, kText);
        AppendBytes(&bytes, uint32_t(value.size() + 1));
        bytes.append(value.c_str(), value.size() + 1);
    }
    return bytes;
}

bool ParsePtexMetadata(std::string_view bytes, std::map<std::string, std::string> *metadata) {
    while (!bytes.empty()) {
        const size_t keySize = uint8_t(bytes[0]);
        const size_t head = 1 + keySize + 1 + sizeof(uint32_t);
        if (keySize == 0 || bytes.size() < head) return false;
        uint32_t size;
        std::memcpy(&size, bytes.data() + 1 + keySize + 1, sizeof size);
        if (size > bytes.size() - head) return false;
        const std::string_view key = bytes.substr(1, keySize - 1), value = bytes.substr(head, size);
        if (uint8_t(bytes[1 + keySize]) == kText)
            (*metadata)[std::string(key)] = value.substr(0, value.find('\0'));
        bytes.remove_prefix(head + size);
    }
    return true;
}

}  // namespace pbrt
