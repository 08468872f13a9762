#pragma once

#include "pbrt/image/image.h"

namespace pbrt::imgtool {

/// The FLIP error of each pixel, in [0, 1], as one sees it when two pictures take turns on a screen
/// (Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild: FLIP: A Difference Evaluator
/// for Alternating Images, 2020), at 67 pixels per degree of sight: a screen of 0.7 m and 3840
/// pixels seen from 0.7 m. Both have the channels R, G and B of linear light and one size; values
/// are clamped to [0, 1] first (the low dynamic range form). The result has one channel, Y.
/// Within 2e-6 of the authors' program.
Image Flip(const Image &image, const Image &reference);

}  // namespace pbrt::imgtool
