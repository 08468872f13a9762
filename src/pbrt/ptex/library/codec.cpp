// Ptex files through the Ptex library. Written from its documented interface; where this was
// written there was no library to link or test it with.

#include <Ptexture.h>
#include <fmt/format.h>

#include <cstring>

#include "pbrt/ptex/check.h"
#include "pbrt/ptex/texture.h"
#include "pbrt/util/memory.h"
#include "pbrt/util/read_file.h"

namespace pbrt {
namespace {

PtexNeighbours NeighboursOf(const Ptex::FaceInfo &info) {
    PtexNeighbours n;
    for (int e = 0; e < 4; ++e) {
        n.faces[size_t(e)] = info.adjface(e);
        n.edges |= uint8_t(int(info.adjedge(e)) << 2 * e);
    }
    n.subface = info.isSubface();
    n.uniform = info.isConstant() && info.isNeighborhoodConstant();
    return n;
}

std::map<std::string, std::string> MetadataOf(Ptex::PtexTexture &file) {
    std::map<std::string, std::string> metadata;
    const Ptex::PtexPtr<Ptex::PtexMetaData> entries(file.getMetaData());
    for (int i = 0; i < entries->numKeys(); ++i) {
        const char *key = nullptr, *text = nullptr;
        Ptex::MetaDataType type;
        entries->getKey(i, key, type);
        if (type != Ptex::mdt_string) continue;
        entries->getValue(key, text);
        if (text) metadata[key] = text;
    }
    return metadata;
}

/// The full resolution; reductions are made here, as the file's are multiplied by alpha.
void ReadTexels(Ptex::PtexTexture &file, PtexTexels *texels) {
    texels->Allocate();
    for (int f = 0; f < texels->NFaces(); ++f) {
        if (texels->IsConstant(f)) {
            const Ptex::PtexPtr<Ptex::PtexFaceData> pixel(file.getData(f));
            std::memcpy(texels->Level(f, 0), pixel->getData(), texels->PixelSize());
            continue;
        }
        file.getData(f, texels->Level(f, 0), 0);
        for (int level = 1; level < texels->NLevels(f); ++level)
            texels->Reduce(f, level);
    }
}

}  // namespace

OrError<PtexData> ReadPtex(const std::string &fileName) {
    if (const auto why = WhyNoFile(fileName))
        return {{}, fmt::format("{}: cannot be opened: {}", fileName, *why)};
    Ptex::String problem;
    const Ptex::PtexPtr<Ptex::PtexTexture> file(
        Ptex::PtexTexture::open(fileName.c_str(), problem, false));
    if (!file) return {{}, fmt::format("{}: {}", fileName, problem.c_str())};
    PtexData data;
    data.texels =
        PtexTexels(PtexMesh(file->meshType()), PtexType(file->dataType()), file->numChannels());
    data.alphaChannel = file->alphaChannel();
    data.metadata = MetadataOf(*file);
    bool anyNeighbour = false;
    for (int f = 0; f < file->numFaces(); ++f) {
        const Ptex::FaceInfo &info = file->getFaceInfo(f);
        const int log2U = info.res.ulog2, log2V = info.res.vlog2;
        if (std::min(log2U, log2V) < 0 || std::max(log2U, log2V) > kPtexMaxLog2)
            return {{},
                    fmt::format("{}: face {} has 2^{} x 2^{} texels", fileName, f, log2U, log2V)};
        data.texels.AddFace(log2U, log2V, info.isConstant());
        data.neighbours.push_back(NeighboursOf(info));
        anyNeighbour |= data.neighbours.back().faces != PtexNeighbours{}.faces;
    }
    if (!anyNeighbour) data.neighbours = {};
    if (const auto why = WhyTooLarge(data.texels.BytesNeeded()))
        return {{}, fmt::format("{}: is too large: for its texels it {}", fileName, *why)};
    ReadTexels(*file, &data.texels);
    return {std::move(data), {}};
}

/// The library, too, writes to another name and renames at the end.
std::optional<std::string> WritePtex(const std::string &fileName, const PtexContent &content) {
    if (const std::string wrong = WhatIsWrong(content); !wrong.empty())
        return fmt::format("{}: cannot be written: {}", fileName, wrong);
    const PtexData data = PackPtex(content);
    const PtexTexels &texels = data.texels;
    Ptex::String problem;
    const auto failed = [&] { return fmt::format("{}: {}", fileName, problem.c_str()); };
    const Ptex::PtexPtr<Ptex::PtexWriter> file(Ptex::PtexWriter::open(
        fileName.c_str(), Ptex::MeshType(content.mesh), Ptex::DataType(content.type),
        content.nChannels, content.alphaChannel, texels.NFaces(), problem, true));
    if (!file) return failed();
    for (const auto &[key, value] : content.metadata)
        file->writeMeta(key.c_str(), value.c_str());
    for (int f = 0; f < texels.NFaces(); ++f) {
        PtexFace face = content.faces[size_t(f)];
        const Ptex::FaceInfo info(Ptex::Res(int8_t(face.log2U), int8_t(face.log2V)),
                                  face.neighbours.data(), face.neighbourEdges.data());
        const bool written = texels.IsConstant(f)
                                 ? file->writeConstantFace(f, info, texels.Level(f, 0))
                                 : file->writeFace(f, info, texels.Level(f, 0), 0);
        if (!written) break;
    }
    if (!file->close(problem)) return failed();
    return {};
}

}  // namespace pbrt
