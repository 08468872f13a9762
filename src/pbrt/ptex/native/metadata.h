#pragma once

#include <map>
#include <string>
#include <string_view>

namespace pbrt {

/// Metadata as a Ptex file holds it inflated: size of the key with its zero, key, type (0: text),
/// size, value.
std::string PtexMetadataBytes(const std::map<std::string, std::string> &metadata);
/// Takes what is text; false where the bytes are damaged.
bool ParsePtexMetadata(std::string_view bytes, std::map<std::string, std::string> *metadata);

}  // namespace pbrt
