#pragma once

#include "pbrt/image/image.h"
#include "pbrt/util/result.h"

namespace pbrt {

/// Takes the noise of few samples out of the channels R, G and B, by Open Image Denoise, and leaves
/// all others as they are. Albedo.R, .G, .B and Ns.X, .Y, .Z (else N.X, .Y, .Z) of film "gbuffer"
/// keep edges and textures sharp where the image has them; both are denoised first. Values are
/// linear light of any size; what is not finite counts as 0.
///
/// The library is looked for when this is called, so that nobody needs it who does not denoise: the
/// file that the environment variable OIDN_LIBRARY names, else where the system's loader looks,
/// else what scripts/denoiser.sh installs. The error says what to do where there is none.
OrError<Image> Denoised(const Image &image);
/// Why Denoised would find no library, or nothing: to be asked before hours of rendering.
std::optional<std::string> WhyNoDenoiser();

}  // namespace pbrt
