// The reader of Ptex files, by hand because no package of Debian 12 carries a library for them.

#include <fmt/format.h>

#include <cstring>

#include "pbrt/ptex/native/decode.h"
#include "pbrt/ptex/native/metadata.h"
#include "pbrt/ptex/texture.h"
#include "pbrt/util/memory.h"
#include "pbrt/util/read_file.h"

namespace pbrt {
namespace {

/// Texels that take no room in the file (constant tiles) may take this much memory.
constexpr uint64_t kMostConstantBytes = uint64_t(256) << 20;

/// One level's blocks and whose they are: entry i belongs to face faces[i].
struct Level {
    std::vector<PtexBlockHeader> headers;
    std::string_view blocks;
};

class Reader {
  public:
    explicit Reader(std::string_view file) : rest(file) {}

    std::optional<PtexData> Read() {
        if (!Header() || !FaceInfos() || !Constants() || !Levels() || !MetadataSection()) return {};
        if (!HasRoom(data.texels.BytesNeeded(), "its texels")) return {};
        data.texels.Allocate();
        for (int f = 0; f < NFaces(); ++f)
            if (data.texels.IsConstant(f))
                std::memcpy(data.texels.Level(f, 0), Color(f), data.texels.PixelSize());
        std::vector<int> stored(size_t(NFaces()), 0);  // the coarsest level each face has
        // Stored reductions are multiplied by alpha, the finest texels are not.
        const size_t nUsed = data.alphaChannel < 0 ? levels.size() : 1;
        for (size_t l = 0; l < nUsed; ++l)
            if (!ForEachBlock(int(l), [&](int face, const PtexBlock &block) {
                    stored[size_t(face)] = int(l);
                    return DecodePtexBlock(block, data.texels, Color(face),
                                           data.texels.Level(face, int(l)));
                }))
                return {};
        for (int f = 0; f < NFaces(); ++f)
            for (int l = stored[size_t(f)] + 1; l < data.texels.NLevels(f); ++l)
                data.texels.Reduce(f, l);
        return std::move(data);
    }
    const std::string &Problem() const { return problem; }

  private:
    int NFaces() const { return int(header.nFaces); }
    const std::byte *Color(int face) const {
        return reinterpret_cast<const std::byte *>(constants.data()) +
               size_t(face) * data.texels.PixelSize();
    }
    template <typename... Args>
    bool Fail(fmt::format_string<Args...> text, Args &&...args) {
        problem = fmt::format(text, std::forward<Args>(args)...);
        return false;
    }
    /// Moves the next `size` bytes of the file into `section`.
    bool Take(uint64_t size, std::string_view what, std::string_view *section) {
        if (size > rest.size())
            return Fail("is too short: {} need {} bytes, {} are left", what, size, rest.size());
        *section = rest.substr(0, size);
        rest.remove_prefix(size);
        return true;
    }
    /// False where there is no memory for so many bytes.
    bool HasRoom(uint64_t size, std::string_view what) {
        constexpr uint64_t kSmall = 1 << 24;  // asking takes longer than unpacking
        const auto why = size > kSmall ? WhyTooLarge(size) : std::nullopt;
        return !why || Fail("is too large: for {} it {}", what, *why);
    }
    /// Fills `to` with the `size` bytes that `zipped` holds.
    template <typename Container>
    bool InflateTo(std::string_view zipped, uint64_t size, std::string_view what, Container *to) {
        if (!CanInflate(zipped.size(), size))
            return Fail("is damaged: {} cannot be {} bytes large", what, size);
        if (!HasRoom(size, what)) return false;
        to->resize(size / sizeof(*to->data()));
        return Inflate(zipped, to->data(), size) || Fail("is damaged: {} cannot be inflated", what);
    }

    bool Header() {
        std::string_view section;
        if (!Take(sizeof header, "the header's fields", &section)) return false;
        std::memcpy(&header, section.data(), sizeof header);
        if (std::string_view(header.magic, 4) != "Ptex") return Fail("is no Ptex file");
        if (header.version != 1)
            return Fail("is of version {}.{}, only 1 is known", header.version,
                        header.minorVersion);
        if (header.mesh > 1) return Fail("is damaged: kind of mesh {}", header.mesh);
        if (header.type > 3) return Fail("is damaged: type of texels {}", header.type);
        if (header.nChannels < 1 || header.nChannels > kPtexMaxChannels)
            return Fail("has {} channels, must be 1 to {}", header.nChannels, kPtexMaxChannels);
        if (header.alphaChannel < -1 || header.alphaChannel >= header.nChannels)
            return Fail("is damaged: alpha channel {} of {}", header.alphaChannel,
                        header.nChannels);
        if (header.nFaces < 1 || header.nFaces > INT32_MAX)
            return Fail("has {} faces", header.nFaces);
        if (header.nLevels < 1 || header.nLevels > kPtexMaxLog2 + 1 ||
            header.levelInfoSize != header.nLevels * sizeof(PtexLevelInfo))
            return Fail("is damaged: {} levels in {} bytes", header.nLevels, header.levelInfoSize);
        PtexExtHeader ext;
        if (!Take(header.extHeaderSize, "the header's extension", &section)) return false;
        std::memcpy(&ext, section.data(), std::min(section.size(), sizeof ext));
        if (ext.editSize > 0) return Fail("has edits, which are not read; write it anew");
        data.texels =
            PtexTexels(PtexMesh(header.mesh), PtexType(header.type), int(header.nChannels));
        data.alphaChannel = header.alphaChannel;
        return true;
    }

    bool FaceInfos() {
        std::string_view section;
        std::vector<PtexFaceInfo> infos;
        if (!Take(header.faceInfoSize, "the faces", &section) ||
            !InflateTo(section, uint64_t(header.nFaces) * sizeof(PtexFaceInfo), "the faces",
                       &infos))
            return false;
        bool anyNeighbour = false;
        data.texels.ReserveFaces(infos.size());
        for (size_t f = 0; f < infos.size(); ++f) {
            if (!CheckFace(f, infos[f])) return false;
            data.texels.AddFace(infos[f].log2U, infos[f].log2V,
                                infos[f].flags & PtexFaceInfo::kConstant);
            for (int e = 0; e < NEdges(); ++e)
                anyNeighbour |= infos[f].neighbours[e] >= 0;
        }
        if (!anyNeighbour) return true;
        data.neighbours.reserve(infos.size());
        for (const PtexFaceInfo &info : infos)
            data.neighbours.push_back(NeighboursOf(info));
        return true;
    }
    int NEdges() const { return data.texels.Mesh() == PtexMesh::Quad ? 4 : 3; }
    bool CheckFace(size_t f, const PtexFaceInfo &info) {
        const auto outside = [](int log2) { return log2 < 0 || log2 > kPtexMaxLog2; };
        const bool triangle = data.texels.Mesh() == PtexMesh::Triangle;
        if (outside(info.log2U) || outside(info.log2V) || (triangle && info.log2U != info.log2V))
            return Fail("is damaged: face {} of 2^{} x 2^{} texels", f, info.log2U, info.log2V);
        if (info.flags & PtexFaceInfo::kHasEdits)
            return Fail("has edits, which are not read; write it anew");
        for (int e = 0; e < NEdges(); ++e)
            if (info.neighbours[e] < -1 || info.neighbours[e] >= NFaces() ||
                (triangle && (info.neighbourEdges >> 2 * e & 3) == 3))
                return Fail("is damaged: face {}'s neighbour {} is {}", f, e, info.neighbours[e]);
        return true;
    }
    static PtexNeighbours NeighboursOf(const PtexFaceInfo &info) {
        PtexNeighbours n;
        std::copy(info.neighbours, info.neighbours + 4, n.faces.begin());
        n.edges = info.neighbourEdges;
        n.subface = info.flags & PtexFaceInfo::kSubface;
        n.uniform = (info.flags & PtexFaceInfo::kConstant) &&
                    (info.flags & PtexFaceInfo::kNeighboursConstant);
        return n;
    }

    bool Constants() {
        std::string_view section;
        return Take(header.constantSize, "the faces' colors", &section) &&
               InflateTo(section, uint64_t(header.nFaces) * data.texels.PixelSize(),
                         "the faces' colors", &constants);
    }

    bool Levels() {
        std::string_view section;
        if (!Take(header.levelInfoSize, "the levels", &section)) return false;
        std::vector<PtexLevelInfo> infos(header.nLevels);
        std::memcpy(infos.data(), section.data(), section.size());
        order = PtexReductionOrder(data.texels);
        uint64_t constantBytes = 0;
        for (int l = 0; l < int(infos.size()); ++l) {
            if (!CheckLevel(l, infos) || !Take(infos[size_t(l)].dataSize, "texels", &section))
                return false;
            const PtexLevelInfo &info = infos[size_t(l)];
            if (info.headerSize > section.size())
                return Fail("is damaged: level {} has {} bytes, its sizes {}", l, section.size(),
                            info.headerSize);
            Level level;
            if (!InflateTo(section.substr(0, info.headerSize),
                           uint64_t(info.nFaces) * sizeof(PtexBlockHeader), "a level's sizes",
                           &level.headers))
                return false;
            level.blocks = section.substr(info.headerSize);
            levels.push_back(std::move(level));
            if (!ForEachBlock(l, [&](int, const PtexBlock &block) {
                    return CheckPtexBlock(block, data.texels, &constantBytes);
                }))
                return false;
        }
        return constantBytes <= kMostConstantBytes ||
               Fail("has constant tiles of {} bytes, at most {} are read", constantBytes,
                    kMostConstantBytes);
    }
    /// The faces that level l lists must exist and have that level.
    bool CheckLevel(int l, const std::vector<PtexLevelInfo> &infos) {
        const uint32_t n = infos[size_t(l)].nFaces;
        const uint32_t most = l == 0 ? header.nFaces : infos[size_t(l) - 1].nFaces;
        if (n > most || (l == 0 && n < most))
            return Fail("is damaged: level {} has {} faces, {} are possible", l, n, most);
        for (size_t i = 0; l > 0 && i < n; ++i) {
            const int f = order[i];
            if (data.texels.IsConstant(f) ||
                std::min(data.texels.Log2U(f), data.texels.Log2V(f)) < l)
                return Fail("is damaged: level {} lists face {}, which has none", l, f);
        }
        return true;
    }

    /// Calls f(face, block) for each block of a level until one fails; constant faces' are left
    /// out.
    template <typename F>
    bool ForEachBlock(int l, F f) {
        const Level &level = levels[size_t(l)];
        std::string_view blocks = level.blocks;
        for (size_t i = 0; i < level.headers.size(); ++i) {
            const PtexBlockHeader blockHeader = level.headers[i];
            const int face = l == 0 ? int(i) : order[i];
            if (blockHeader.Size() > blocks.size())
                return Fail("is damaged: face {} on level {} reaches beyond the level", face, l);
            const PtexBlock block{blockHeader, blocks.substr(0, blockHeader.Size()),
                                  data.texels.Log2U(face) - l, data.texels.Log2V(face) - l};
            blocks.remove_prefix(blockHeader.Size());
            if (data.texels.IsConstant(face)) continue;
            const std::string why = f(face, block);
            if (!why.empty()) return Fail("is damaged: face {} on level {}: {}", face, l, why);
        }
        return true;
    }

    bool MetadataSection() {
        std::string_view section;
        std::string bytes;
        if (header.metadataZipSize == 0) return true;
        if (!Take(header.metadataZipSize, "the metadata", &section) ||
            !InflateTo(section, header.metadataSize, "the metadata", &bytes))
            return false;
        return ParsePtexMetadata(bytes, &data.metadata) || Fail("is damaged: its metadata");
    }

    std::string_view rest;
    std::string problem;
    PtexHeader header;
    PtexData data;
    std::string constants;
    std::vector<int> order;
    std::vector<Level> levels;
};

}  // namespace

OrError<PtexData> ReadPtex(const std::string &fileName) {
    const FileContents file = ReadWholeFile(fileName);
    if (!file.bytes) return {{}, file.error};
    Reader reader(*file.bytes);
    std::optional<PtexData> data = reader.Read();
    if (!data) return {{}, fmt::format("{}: {}", fileName, reader.Problem())};
    return {std::move(data), {}};
}

}  // namespace pbrt
