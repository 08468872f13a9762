#include <cmath>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::string file, outfile;
    float level = Infinity, scale = 0.3f;
    int iterations = 5, width = 15;
};

constexpr char kDescription[] =
    "Lets bright pixels bleed into their neighbours, as lenses and film do: what is at --level or "
    "above is blurred again and again, and the mean of all the blurred pictures is added.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "picture", &o->file, "picture to read");
    AddOutfile(app, &o->outfile);
    cli::AddNumber(app, "--level", &o->level, cli::kFromZero,
                   "values from here on bleed (default: none do)");
    cli::AddNumber(app, "--scale", &o->scale, cli::kFromZero, "share that bleeds (default 0.3)");
    cli::AddNumber(app, "--iterations", &o->iterations, {.lo = 1, .hi = 1000},
                   "how often to blur (default 5)");
    cli::AddNumber(app, "--width", &o->width, {.lo = 1, .hi = 4096},
                   "pixels across the blur (default 15)");
}

/// Weights of a Gaussian that ends at three standard deviations, of sum 1.
std::vector<float> Gaussian(int width) {
    const int radius = std::max(1, width / 2);
    std::vector<float> weights(size_t(2 * radius + 1));
    float sum = 0;
    for (int i = -radius; i <= radius; ++i) {
        const float w = std::exp(-4.5f * Sqr(float(i) / float(radius)));
        weights[size_t(i + radius)] = w;
        sum += w;
    }
    for (float &w : weights)
        w /= sum;
    return weights;
}

/// Along one axis; pixels outside repeat those of the border.
Image BlurAlong(const Image &image, const std::vector<float> &weights, Point2i step) {
    const int radius = int(weights.size()) / 2, n = image.NChannels();
    const auto [width, height] = image.Resolution();
    Image out(image.Resolution(), image.ChannelNames());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int k = -radius; k <= radius; ++k) {
                const float *const from = image.Pixel({std::clamp(x + k * step.x, 0, width - 1),
                                                       std::clamp(y + k * step.y, 0, height - 1)});
                float *const to = out.Pixel({x, y});
                for (int c = 0; c < n; ++c)
                    to[c] += weights[size_t(k + radius)] * from[c];
            }
    return out;
}

Outcome WithOptions(Options &o) {
    std::string remarks;
    OrError<Image> read = Read(o.file, &remarks);
    if (!read) return Failure(read.error);
    Image &image = *read.value;
    const int alpha = image.ChannelIndex("A"), n = image.NChannels();
    Image bright(image.Resolution(), image.ChannelNames());
    for (size_t i = 0; i < image.Data().size(); ++i)
        if (int(i % size_t(n)) != alpha && image.Data()[i] >= o.level &&
            std::isfinite(image.Data()[i]))
            bright.Data()[i] = image.Data()[i];
    const std::vector<float> weights = Gaussian(o.width);
    std::vector<float> sum(image.Data().size());
    for (int k = 0; k < o.iterations; ++k) {
        bright = BlurAlong(BlurAlong(bright, weights, {1, 0}), weights, {0, 1});
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += bright.Data()[i];
    }
    for (size_t i = 0; i < sum.size(); ++i)
        image.Data()[i] += o.scale / float(o.iterations) * sum[i];
    return Remarking(remarks, Write(image, o.outfile, ExrPixels::Float));
}

}  // namespace

Outcome Bloom(Args args) {
    return cli::RunWithOptions(args, "imgtool bloom", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
