#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "pbrt/ptex/texture.h"
#include "support/folders.h"

namespace pbrt {

inline const std::string kPtexData = SourceDir() + "/test/ptex/data/";

/// What the real library read at one place.
struct PtexProbe {
    int face;
    float x, y;  ///< texel, or (u, v)
    std::vector<float> channels;
};
struct PtexSample {
    std::string file, mesh, type;
    int nChannels, nFaces;
    std::vector<PtexProbe> texels, lookups;
};

inline std::vector<PtexSample> ExpectedSamples() {
    std::vector<PtexSample> samples;
    std::ifstream in(kPtexData + "expected.txt");
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "file") {
            PtexSample s;
            words >> s.file >> s.mesh >> s.type >> s.nChannels >> s.nFaces;
            samples.push_back(s);
            continue;
        }
        PtexProbe p;
        words >> p.face >> p.x >> p.y;
        for (float v; words >> v;)
            p.channels.push_back(v);
        (kind == "texel" ? samples.back().texels : samples.back().lookups).push_back(p);
    }
    return samples;
}

inline PtexTexture ReadPtexOrFail(const std::string &path) {
    OrError<PtexData> data = ReadPtex(path);
    if (!data) ADD_FAILURE() << data.error;
    return PtexTexture(data ? std::move(*data.value) : PackPtex(ConstantPtex(1, {0})));
}

inline std::vector<float> LookupAll(const PtexTexture &texture, int face, Point2f uv,
                                    Vector2f width = {0, 0}) {
    std::vector<float> out(size_t(texture.NChannels()));
    texture.Lookup(face, uv, width, out);
    return out;
}

/// Random texels of what the type can hold exactly.
inline PtexContent RandomPtex(PtexMesh mesh, PtexType type, int nChannels,
                              std::vector<PtexFace> faces, uint32_t seed) {
    std::mt19937 random(seed);
    PtexContent content{mesh, type, nChannels, -1, std::move(faces), {}, {}};
    size_t nTexels = 0;
    for (const PtexFace &face : content.faces)
        nTexels += face.NTexels();
    for (size_t i = 0; i < nTexels * size_t(nChannels); ++i) {
        const uint32_t bits = uint32_t(random());
        content.texels.push_back(type == PtexType::UInt8    ? float(bits % 256) * (1 / 255.f)
                                 : type == PtexType::UInt16 ? float(bits % 65536) * (1 / 65535.f)
                                 : type == PtexType::Half   ? float(int(bits % 4096) - 2048) / 64
                                                            : float(bits) * 1e-3f - 1e5f);
    }
    return content;
}

}  // namespace pbrt
