#pragma once

#include "pbrt/textures/checkerboard.h"
#include "pbrt/textures/constant.h"
#include "pbrt/textures/imagemap.h"
#include "pbrt/textures/mix.h"
#include "pbrt/textures/per_face.h"
#include "pbrt/textures/scale.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of textures. Parser, messages and tests follow from it.
using TextureTypes = TypeList<CheckerboardTexture, ConstantTexture, ImageTexture, MixTexture,
                              PerFaceTexture, ScaleTexture>;

template <TextureType T>
inline constexpr bool kIsTexture = true;
static_assert(TextureTypes::All([]<typename T>() { return kIsTexture<T>; }));

}  // namespace pbrt
