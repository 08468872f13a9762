// The writer of Ptex files, by hand because no package of Debian 12 carries a library for them.

#include <fmt/format.h>

#include "pbrt/ptex/check.h"
#include "pbrt/ptex/native/encode.h"
#include "pbrt/ptex/native/metadata.h"
#include "pbrt/ptex/texture.h"
#include "pbrt/util/atomic_file.h"

namespace pbrt {
namespace {

PtexFaceInfo InfoOf(const PtexData &data, int face) {
    const PtexTexels &texels = data.texels;
    PtexFaceInfo info{int8_t(texels.Log2U(face)), int8_t(texels.Log2V(face)), 0, 0, {}};
    const PtexNeighbours around =
        data.neighbours.empty() ? PtexNeighbours{} : data.neighbours[size_t(face)];
    if (texels.IsConstant(face)) info.flags |= PtexFaceInfo::kConstant;
    if (texels.IsConstant(face) && (around.uniform || data.neighbours.empty()))
        info.flags |= PtexFaceInfo::kNeighboursConstant;
    std::copy(around.faces.begin(), around.faces.end(), info.neighbours);
    info.neighbourEdges = around.edges;
    return info;
}

/// Each face's color: its last reduction.
std::string Constants(const PtexTexels &texels) {
    std::string bytes;
    for (int f = 0; f < texels.NFaces(); ++f)
        bytes.append(reinterpret_cast<const char *>(texels.Level(f, texels.NLevels(f) - 1)),
                     texels.PixelSize());
    return Zip(bytes.data(), bytes.size());
}

std::string FileBytes(const PtexData &data) {
    const PtexTexels &texels = data.texels;
    std::vector<PtexFaceInfo> infos;
    for (int f = 0; f < texels.NFaces(); ++f)
        infos.push_back(InfoOf(data, f));
    const std::string faceInfo = Zip(infos), constants = Constants(texels);
    // Files' reductions are multiplied by alpha; without them readers make their own.
    const std::vector<PtexLevel> levels = EncodeLevels(texels, data.alphaChannel < 0);
    std::string levelInfo, levelData;
    for (const PtexLevel &level : levels) {
        const std::string headers = Zip(level.headers);
        AppendBytes(&levelInfo,
                    PtexLevelInfo{headers.size() + level.blocks.size(), uint32_t(headers.size()),
                                  uint32_t(level.headers.size())});
        levelData += headers + level.blocks;
    }
    const std::string metadata = PtexMetadataBytes(data.metadata);
    const std::string zipped = metadata.empty() ? "" : Zip(metadata.data(), metadata.size());

    PtexHeader header;
    header.mesh = uint32_t(texels.Mesh());
    header.type = uint32_t(texels.Type());
    header.alphaChannel = data.alphaChannel;
    header.nChannels = uint16_t(texels.NChannels());
    header.nLevels = uint16_t(levels.size());
    header.nFaces = uint32_t(texels.NFaces());
    header.extHeaderSize = sizeof(PtexExtHeader);
    header.faceInfoSize = uint32_t(faceInfo.size());
    header.constantSize = uint32_t(constants.size());
    header.levelInfoSize = uint32_t(levelInfo.size());
    header.levelDataSize = levelData.size();
    header.metadataZipSize = uint32_t(zipped.size());
    header.metadataSize = uint32_t(metadata.size());
    const std::string body = faceInfo + constants + levelInfo + levelData + zipped;
    PtexExtHeader ext;
    ext.editPosition = sizeof header + sizeof ext + body.size();
    std::string bytes;
    AppendBytes(&bytes, header);
    AppendBytes(&bytes, ext);
    return bytes + body;
}

}  // namespace

std::optional<std::string> WritePtex(const std::string &fileName, const PtexContent &content) {
    if (const std::string wrong = WhatIsWrong(content); !wrong.empty())
        return fmt::format("{}: cannot be written: {}", fileName, wrong);
    return WriteFileAtomically(fileName, FileBytes(PackPtex(content)));
}

}  // namespace pbrt
