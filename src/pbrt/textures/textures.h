#pragma once

#include <string_view>
#include <vector>

#include "pbrt/textures/checkerboard.h"
#include "pbrt/textures/constant.h"
#include "pbrt/textures/direction_mix.h"
#include "pbrt/textures/dots.h"
#include "pbrt/textures/fbm.h"
#include "pbrt/textures/imagemap.h"
#include "pbrt/textures/mix.h"
#include "pbrt/textures/per_face.h"
#include "pbrt/textures/scale.h"
#include "pbrt/textures/wrinkled.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of textures. Parser, messages and tests follow from it.
using TextureTypes =
    TypeList<CheckerboardTexture, ConstantTexture, DirectionMixTexture, DotsTexture, FBmTexture,
             ImageTexture, MixTexture, PerFaceTexture, ScaleTexture, WrinkledTexture>;

template <TextureType T>
inline constexpr bool kIsTexture = true;
static_assert(TextureTypes::All([]<typename T>() { return kIsTexture<T>; }));

/// Names of the types that make spectra.
std::vector<std::string_view> SpectrumTextureNames();

}  // namespace pbrt
