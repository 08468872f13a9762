#include <zlib.h>

#include <cstring>

#include "pbrt/util/read_file.h"
#include "ptex/samples.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

template <typename T>
void Poke(std::string *bytes, size_t at, T value) {
    std::memcpy(bytes->data() + at, &value, sizeof value);
}
template <typename T>
T Peek(const std::string &bytes, size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}
std::string Inflated(const std::string &zipped) {
    std::string out(1 << 20, '\0');
    uLongf size = uLongf(out.size());
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef *>(out.data()), &size,
                         reinterpret_cast<const Bytef *>(zipped.data()), uLong(zipped.size())),
              Z_OK);
    out.resize(size);
    return out;
}
std::string Deflated(const std::string &bytes) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::string out(size, '\0');
    compress(reinterpret_cast<Bytef *>(out.data()), &size,
             reinterpret_cast<const Bytef *>(bytes.data()), uLong(bytes.size()));
    out.resize(size);
    return out;
}

/// A file taken apart, the zipped sections inflated; put together again with true sizes.
struct Parts {
    std::string header, ext, faces, constants, levelInfo;
    struct Level {
        std::string sizes, blocks;
    };
    std::vector<Level> levels;
    std::string metadata;

    explicit Parts(const std::string &file) {
        size_t at = 0;
        const auto take = [&](size_t size) { return at += size, file.substr(at - size, size); };
        header = take(64);
        ext = take(Peek<uint32_t>(header, 28));
        faces = Inflated(take(Peek<uint32_t>(header, 32)));
        constants = Inflated(take(Peek<uint32_t>(header, 36)));
        levelInfo = take(Peek<uint32_t>(header, 40));
        for (size_t l = 0; l < levelInfo.size() / 16; ++l) {
            const auto size = Peek<uint64_t>(levelInfo, 16 * l);
            const auto sizes = Peek<uint32_t>(levelInfo, 16 * l + 8);
            const std::string zipped = take(sizes);
            levels.push_back({Inflated(zipped), take(size - sizes)});
        }
        metadata = Inflated(take(Peek<uint32_t>(header, 56)));
    }
    std::string File() const {
        std::string h = header, info = levelInfo, data;
        for (size_t l = 0; l < levels.size(); ++l) {
            const std::string sizes = Deflated(levels[l].sizes);
            Poke(&info, 16 * l, uint64_t(sizes.size() + levels[l].blocks.size()));
            Poke(&info, 16 * l + 8, uint32_t(sizes.size()));
            data += sizes + levels[l].blocks;
        }
        const std::string f = Deflated(faces), c = Deflated(constants), m = Deflated(metadata);
        Poke(&h, 28, uint32_t(ext.size()));
        Poke(&h, 32, uint32_t(f.size()));
        Poke(&h, 36, uint32_t(c.size()));
        Poke(&h, 40, uint32_t(info.size()));
        Poke(&h, 48, uint64_t(data.size()));
        Poke(&h, 56, uint32_t(m.size()));
        return h + ext + f + c + info + data + m;
    }
};

std::string Sample(const std::string &name) {
    const FileContents file = ReadWholeFile(kPtexData + name);
    EXPECT_TRUE(file.bytes) << file.error;
    return file.bytes.value_or("");
}

class PtexDamaged : public TempFolder {
  protected:
    OrError<PtexData> Read(const std::string &bytes) const {
        Put("a.ptx", bytes);
        return ReadPtex(Path("a.ptx"));
    }
    void ExpectError(const std::string &bytes, const std::string &part) const {
        const OrError<PtexData> data = Read(bytes);
        EXPECT_FALSE(data) << "expected: " << part;
        EXPECT_TRUE(data.error.starts_with(Path("a.ptx") + ": ")) << data.error;
        EXPECT_NE(data.error.find(part), std::string::npos) << data.error;
    }
    /// `change` takes the parts of a good file.
    template <typename F>
    void ExpectErrorAfter(F change, const std::string &part,
                          const std::string &name = "quad_u8.ptx") const {
        Parts parts(Sample(name));
        change(parts);
        ExpectError(parts.File(), part);
    }
    template <typename T>
    void ExpectHeaderError(size_t at, T value, const std::string &part) const {
        std::string file = Sample("quad_u8.ptx");
        Poke(&file, at, value);
        ExpectError(file, part);
    }
};

TEST_F(PtexDamaged, TakenApartAndPutTogetherTheyAreGood) {
    for (const char *name : {"quad_u8.ptx", "quad_float.ptx", "tiled_u8.ptx", "tri_u8.ptx"})
        EXPECT_TRUE(Read(Parts(Sample(name)).File())) << name;
}

TEST_F(PtexDamaged, HeaderFields) {
    ExpectError("", "too short");
    ExpectError("Ptex", "too short");
    ExpectError(std::string(5000, 'x'), "no Ptex file");
    ExpectHeaderError(4, uint32_t(2), "version 2.4");
    ExpectHeaderError(8, uint32_t(2), "kind of mesh 2");
    ExpectHeaderError(12, uint32_t(4), "type of texels 4");
    ExpectHeaderError(16, int32_t(3), "alpha channel 3 of 3");
    ExpectHeaderError(16, int32_t(-2), "alpha channel -2");
    ExpectHeaderError(20, uint16_t(0), "0 channels");
    ExpectHeaderError(20, uint16_t(65535), "65535 channels");
    ExpectHeaderError(20, uint16_t(1000), "faces' colors");
    ExpectHeaderError(22, uint16_t(0), "0 levels");
    ExpectHeaderError(22, uint16_t(4), "4 levels in 48 bytes");
    ExpectHeaderError(24, uint32_t(0), "0 faces");
    ExpectHeaderError(24, uint32_t(5), "the faces cannot be inflated");
    ExpectHeaderError(24, uint32_t(0x7fffffff), "the faces cannot be 42949672940 bytes");
    ExpectHeaderError(24, uint32_t(0xffffffff), "4294967295 faces");
    ExpectHeaderError(28, uint32_t(0xffffffff), "too short");
    ExpectHeaderError(32, uint32_t(0xffffffff), "too short");
    ExpectHeaderError(36, uint32_t(0x80000000), "too short");
    ExpectHeaderError(40, uint32_t(32), "levels in 32 bytes");
    ExpectHeaderError(56, uint32_t(1 << 20), "too short");
    ExpectHeaderError(60, uint32_t(0xffffffff), "the metadata cannot be 4294967295 bytes");
    ExpectHeaderError(64 + 24, uint64_t(8), "has edits");
}

TEST_F(PtexDamaged, Faces) {
    const auto face = [](size_t at, auto value) {
        return [=](Parts &p) { Poke(&p.faces, at, value); };
    };
    ExpectErrorAfter(face(0, int8_t(-1)), "face 0 of 2^-1");
    ExpectErrorAfter(face(20, int8_t(16)), "face 1 of 2^16");
    ExpectErrorAfter(face(21, int8_t(127)), "2^127 texels");
    // Room for 2^30 texels in a block of some bytes.
    ExpectErrorAfter([](Parts &p) { p.faces[0] = p.faces[1] = 15; },
                     "face 0 on level 0: 139 bytes cannot hold 32768 x 32768 texels");
    ExpectErrorAfter(face(1, int8_t(5)), "cannot be inflated");
    ExpectErrorAfter(face(3, uint8_t(2)), "has edits");
    ExpectErrorAfter(face(4, int32_t(4)), "face 0's neighbour 0 is 4");
    ExpectErrorAfter(face(16, int32_t(-2)), "neighbour 3 is -2");
    ExpectErrorAfter([](Parts &p) { p.faces.pop_back(); }, "the faces cannot be inflated");
    ExpectErrorAfter(face(0, int8_t(3)), "face 0 of 2^3 x 2^4", "tri_u8.ptx");
    ExpectErrorAfter(face(2, uint8_t(3)), "neighbour 0", "tri_u8.ptx");
    ExpectErrorAfter([](Parts &p) { p.constants += "x"; }, "colors cannot be inflated");
}

TEST_F(PtexDamaged, Levels) {
    const auto info = [](size_t at, auto value) {
        return [=](Parts &p) { Poke(&p.levelInfo, at, value); };
    };
    ExpectErrorAfter(info(12, uint32_t(3)), "level 0 has 3 faces, 4 are possible");
    ExpectErrorAfter(info(16 + 12, uint32_t(5)), "level 1 has 5 faces");
    ExpectErrorAfter(info(32 + 12, uint32_t(2)), "level's sizes cannot be inflated");
    ExpectErrorAfter([](Parts &p) { p.levels[2].sizes += p.levels[2].sizes; },
                     "level's sizes cannot be inflated");
    // Where the parts are put together the sizes become true; these stay false.
    const size_t levelInfo = Sample("quad_u8.ptx").size() - 8 - 26 - 960 - 48;
    const auto file = [&](size_t at, auto value) {
        std::string bytes = Sample("quad_u8.ptx");
        EXPECT_EQ(Peek<uint64_t>(bytes, levelInfo), 584u);
        Poke(&bytes, levelInfo + at, value);
        return bytes;
    };
    ExpectError(file(0, uint64_t(1) << 60), "too short: texels need");
    ExpectError(file(0, uint64_t(10)), "level 0 has 10 bytes, its sizes 19");
    ExpectError(file(8, uint32_t(0xffffffff)), "its sizes 4294967295");
    const auto block = [](int level, size_t face, uint32_t size, uint32_t encoding) {
        return [=](Parts &p) {
            Poke(&p.levels[size_t(level)].sizes, 4 * face, size | encoding << 30);
        };
    };
    ExpectErrorAfter(block(0, 0, 0x3fffffff, 2), "face 0 on level 0 reaches beyond the level");
    ExpectErrorAfter(block(0, 3, 139, 2), "face 3 on level 0 reaches beyond");
    ExpectErrorAfter(block(0, 0, 139, 0), "a constant of 139 bytes, pixels have 3");
    ExpectErrorAfter(block(0, 0, 139, 3), "list of tiles");
    ExpectErrorAfter(block(1, 0, 50, 2), "face 1 on level 1: its texels cannot be inflated");
    ExpectErrorAfter(block(0, 0, 503, 2), "not whole", "quad_float.ptx");
    ExpectErrorAfter([](Parts &p) { p.levels[0].blocks[60] ^= 0x55; }, "cannot be inflated");
    ExpectErrorAfter([](Parts &p) { p.metadata[0] = 100; }, "its metadata");
    ExpectErrorAfter([](Parts &p) { Poke(&p.metadata, 7, uint32_t(0xfffffff0)); }, "its metadata");
}

TEST_F(PtexDamaged, Tiles) {
    const auto tile = [this](size_t at, auto value, const std::string &part) {
        ExpectErrorAfter([=](Parts &p) { Poke(&p.levels[0].blocks, at, value); }, part,
                         "tiled_u8.ptx");
    };
    tile(0, int8_t(10), "list of tiles");
    tile(0, int8_t(-1), "list of tiles");
    tile(1, int8_t(9), "list of tiles");
    tile(0, int8_t(0), "list of tiles");  // 512 tiles instead of 2
    tile(2, uint32_t(0xffffffff), "list of tiles");
    tile(2, uint32_t(15), "list of tiles");
    tile(10, uint8_t(0xff), "list of tiles");
    tile(6672 - 100, uint64_t(0), "tile 1: its texels cannot be inflated");
    // The list of tiles itself, of two, behind 6 bytes.
    const auto list = [this](uint32_t first, uint32_t second, const std::string &part) {
        ExpectErrorAfter(
            [=](Parts &p) {
                std::string headers(8, '\0');
                Poke(&headers, 0, first);
                Poke(&headers, 4, second);
                headers = Deflated(headers);
                std::string &blocks = p.levels[0].blocks;
                const std::string tiles = blocks.substr(6 + Peek<uint32_t>(blocks, 2));
                Poke(&blocks, 2, uint32_t(headers.size()));
                blocks = blocks.substr(0, 6) + headers + tiles;
                Poke(&p.levels[0].sizes, 0, uint32_t(blocks.size()) | 3u << 30);
            },
            part, "tiled_u8.ptx");
    };
    list(3523 | 3u << 30, 3127 | 2u << 30, "tile 0: tiles inside a tile");
    list(3523 | 2u << 30, 3128 | 2u << 30, "tile 1 reaches beyond its face");
    list(3523 | 0u << 30, 3127 | 2u << 30, "tile 0: a constant of 3523 bytes");
    list(60 | 2u << 30, 3127 | 2u << 30, "cannot hold 256 x 256 texels");
}

TEST_F(PtexDamaged, ConstantTilesCannotFillTheMemory) {
    // One face of 2^15 x 2^15 float texels in two tiles of one texel each: 4 GiB from 200 bytes.
    Parts p(Sample("tiled_half.ptx"));
    p.faces[0] = p.faces[1] = 15;
    std::string headers(8, '\0');
    Poke(&headers, 0, uint32_t(6));
    Poke(&headers, 4, uint32_t(6));
    headers = Deflated(headers);
    std::string block(6, '\0');
    block[0] = 15;
    block[1] = 14;
    Poke(&block, 2, uint32_t(headers.size()));
    p.levels[0].blocks = block + headers + std::string(12, '\1');
    Poke(&p.levels[0].sizes, 0, uint32_t(p.levels[0].blocks.size()) | 3u << 30);
    ExpectError(p.File(), "constant tiles of 6442450944 bytes");
    // With fewer texels they are no damage.
    p.faces[0] = p.faces[1] = 5;
    Poke(&p.levels[0].blocks, 0, uint16_t(0x0405));
    const OrError<PtexData> data = Read(p.File());
    EXPECT_TRUE(data) << data.error;
}

TEST_F(PtexDamaged, TruncatedFilesAreErrors) {
    // Eight bytes of the library's follow the last section.
    for (const char *name : {"quad_u8.ptx", "const_float.ptx", "tiled_u8.ptx", "tri_u8.ptx"}) {
        const std::string good = Sample(name);
        for (size_t size = 0; size + 8 < good.size(); size += 1 + size / 20)
            EXPECT_FALSE(Read(good.substr(0, size))) << name << " " << size;
        EXPECT_TRUE(Read(good.substr(0, good.size() - 8))) << name;
    }
}

TEST_F(PtexDamaged, FlippedBytesNeverCrash) {
    std::mt19937 random(1);
    int errors = 0, good = 0;
    for (const char *name :
         {"quad_u8.ptx", "quad_half.ptx", "const_u8_rgba.ptx", "tiled_u8.ptx", "tri_u8.ptx"}) {
        const std::string file = Sample(name);
        for (int i = 0; i < 400; ++i) {
            std::string bad = file;
            const size_t range = i % 2 ? bad.size() : std::min<size_t>(bad.size(), 400);
            for (int k = 0; k <= i % 3; ++k)
                bad[random() % range] = char(random());
            if (OrError<PtexData> data = Read(bad)) {
                // Where the damage passes unseen (a color) all look-ups still work.
                ++good;
                const PtexTexture texture(std::move(*data.value));
                for (int face = 0; face < std::min(texture.NFaces(), 100); ++face)
                    LookupAll(texture, face, {0.01f, 0.98f}, {0.03f, 0.5f});
            } else {
                ++errors;
                EXPECT_TRUE(data.error.starts_with(Path("a.ptx") + ": ")) << data.error;
            }
        }
    }
    EXPECT_GT(errors, 500);
    EXPECT_GT(good, 50);
}

}  // namespace
}  // namespace pbrt
