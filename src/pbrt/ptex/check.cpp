#include "pbrt/ptex/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pbrt {
namespace {

constexpr size_t kMostValues = size_t(1) << 27;

std::string WhatIsWrongWithFace(const PtexContent &content, const PtexFace &face) {
    const auto inside = [](int log2) { return log2 >= 0 && log2 <= kPtexMaxLog2; };
    if (!inside(face.log2U) || !inside(face.log2V))
        return fmt::format("resolution 2^{} x 2^{}, exponents must lie in 0 to {}", face.log2U,
                           face.log2V, kPtexMaxLog2);
    if (content.mesh == PtexMesh::Triangle && face.log2U != face.log2V)
        return "a triangle's resolution must be the same along u and v";
    for (size_t e = 0; e < 4; ++e) {
        if (face.neighbours[e] < -1 || face.neighbours[e] >= int64_t(content.faces.size()))
            return fmt::format("neighbour {} of {} faces", face.neighbours[e],
                               content.faces.size());
        if (face.neighbourEdges[e] < 0 || face.neighbourEdges[e] > 3)
            return fmt::format("edge {} of a neighbour", face.neighbourEdges[e]);
    }
    return {};
}

}  // namespace

std::string WhatIsWrong(const PtexContent &content) {
    if (content.nChannels < 1 || content.nChannels > kPtexMaxChannels)
        return fmt::format("{} channels, must be 1 to {}", content.nChannels, kPtexMaxChannels);
    if (content.alphaChannel < -1 || content.alphaChannel >= content.nChannels)
        return fmt::format("alpha channel {} of {}", content.alphaChannel, content.nChannels);
    if (content.faces.empty() || content.faces.size() > INT32_MAX)
        return fmt::format("{} faces", content.faces.size());
    size_t nTexels = 0;
    for (size_t f = 0; f < content.faces.size(); ++f) {
        const std::string wrong = WhatIsWrongWithFace(content, content.faces[f]);
        if (!wrong.empty()) return fmt::format("face {}: {}", f, wrong);
        nTexels += content.faces[f].NTexels();
        // The file's counts of bytes have 30 bits a face and 32 bits for the constants.
        if (nTexels * size_t(content.nChannels) > kMostValues)
            return fmt::format("more than {} values", kMostValues);
    }
    if (content.texels.size() != nTexels * size_t(content.nChannels))
        return fmt::format("{} texels of {} channels need {} values, {} are given", nTexels,
                           content.nChannels, nTexels * size_t(content.nChannels),
                           content.texels.size());
    if (!std::all_of(content.texels.begin(), content.texels.end(),
                     [](float v) { return std::isfinite(v); }))
        return "a texel is not finite";
    for (const auto &[key, value] : content.metadata)
        if (key.empty() || key.size() > 254)
            return fmt::format("key \"{}\" of metadata, must have 1 to 254 bytes", key);
    return {};
}

PtexContent ConstantPtex(int nChannels, std::vector<float> values) {
    PtexContent content;
    content.nChannels = nChannels;
    content.faces.resize(values.size() / size_t(nChannels));
    content.texels = std::move(values);
    return content;
}

}  // namespace pbrt
