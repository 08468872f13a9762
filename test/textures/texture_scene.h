#pragma once

#include <gtest/gtest.h>

#include <string>

#include "pbrt/textures/texture.h"
#include "pbrt/util/transform.h"

namespace pbrt::test {

/// The textures of a scene whose world block is `world`.
struct TextureScene {
    explicit TextureScene(const std::string &world, const std::string &dir = "") {
        ParseString("WorldBegin\n" + world, "t.pbrt", dir, scene, log);
        named = BuildTextures(scene, Transform(), log);
    }
    std::string Messages() const {
        std::string all;
        for (const Message &m : log.Messages())
            all += m.text + "\n";
        return all;
    }
    const FloatTexture &Float(const std::string &name) const {
        EXPECT_EQ(Messages(), "");
        return named.floats.at(name);
    }
    const SpectrumTexture &Spectrum(const std::string &name, SpectrumType role) const {
        EXPECT_EQ(Messages(), "");
        return named.Spectra(role).at(name);
    }

    SceneDescription scene;
    Diagnostics log;
    NamedTextures named;
};

inline TextureEvalContext AtUV(float u, float v) {
    TextureEvalContext ctx;
    ctx.uv = {u, v};
    return ctx;
}
inline TextureEvalContext AtPoint(Point3f p) {
    TextureEvalContext ctx;
    ctx.p = p;
    return ctx;
}

}  // namespace pbrt::test
