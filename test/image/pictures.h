#pragma once

#include <cmath>
#include <random>

#include "pbrt/image/image.h"

namespace pbrt {

/// Values spread over 24 stops about 1, some negative, some 0.
inline Image RandomPicture(Point2i size, std::vector<std::string> channels, unsigned seed = 1) {
    Image image(size, std::move(channels));
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-12, 12);
    for (float &v : image.Data()) {
        v = std::exp2(uniform(random));
        if (random() % 10 == 0) v = random() % 2 ? 0 : -v;
    }
    return image;
}

/// Values in [0, 1].
inline Image RandomDisplayPicture(Point2i size, std::vector<std::string> channels) {
    Image image(size, std::move(channels));
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (float &v : image.Data())
        v = uniform(random);
    return image;
}

}  // namespace pbrt
