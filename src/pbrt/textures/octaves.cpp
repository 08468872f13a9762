#include "pbrt/textures/octaves.h"

namespace pbrt {
namespace {

// Up to where the sums stay far from float's ends.
constexpr IntParam kOctaves{"octaves", 8, 0, 64, "most octaves that are summed"};
constexpr FloatParam kRoughness{"roughness", "", 0.5f,
                                0,           2,  "height of an octave over that of the one before"};

struct Octaves : FloatNode {
    Octaves(const Transform &textureFromRender, decltype(FBm) *sum, float roughness, int octaves)
        : textureFromRender(textureFromRender), sum(sum), roughness(roughness), octaves(octaves) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        return sum(textureFromRender.Point(ctx.p), textureFromRender.Vector(ctx.dpdx),
                   textureFromRender.Vector(ctx.dpdy), roughness, octaves);
    }
    Transform textureFromRender;
    decltype(FBm) *sum;
    float roughness;
    int octaves;
};

}  // namespace

FloatTexture OctavesOfNoise(TextureBuilder &builder, decltype(FBm) *sum) {
    builder.named.readFootprints = true;
    const int octaves = builder.params.GetOneInt(kOctaves);
    const float roughness = builder.params.GetOneFloat(kRoughness);
    return FloatTexture(
        std::make_shared<Octaves>(builder.textureFromRender, sum, roughness, octaves));
}

}  // namespace pbrt
