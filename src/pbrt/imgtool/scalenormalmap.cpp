#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::string file, outfile;
    float scale = 1;
};

constexpr char kDescription[] =
    "Makes the relief of a normal map steeper or flatter: x and y of each normal are multiplied, "
    "and the normal gets length 1 again. Values v mean 2 v - 1.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "picture", &o->file, "normal map of three channels");
    AddOutfile(app, &o->outfile);
    cli::AddNumber(app, "--scale", &o->scale, {}, "factor of x and y (default 1)");
}

Outcome WithOptions(Options &o) {
    // Normals are numbers, not colors: 8-bit files hold them as they are.
    std::string remarks;
    OrError<Image> read = Read(o.file, &remarks, ColorEncoding{});
    if (!read) return Failure(read.error);
    Image &image = *read.value;
    if (image.NChannels() < 3)
        return Failure(fmt::format("{}: has {} channel{}, not three", o.file, image.NChannels(),
                                   image.NChannels() == 1 ? "" : "s"));
    for (size_t i = 0; i < image.Data().size(); i += size_t(image.NChannels())) {
        float *const p = &image.Data()[i];
        const Vector3f n{o.scale * (2 * p[0] - 1), o.scale * (2 * p[1] - 1), 2 * p[2] - 1};
        const float length = Length(n);
        if (length == 0) continue;
        for (int c = 0; c < 3; ++c)
            p[c] = (n[c] / length + 1) / 2;
    }
    if (o.outfile.ends_with(".png"))  // whose writer turns linear light into sRGB
        for (float &v : image.Data())
            v = ColorEncoding{ColorEncoding::Kind::sRGB}.ToLinear(v);
    return Remarking(remarks, Write(image, o.outfile, ExrPixels::Float));
}

}  // namespace

Outcome ScaleNormalMap(Args args) {
    return cli::RunWithOptions(args, "imgtool scalenormalmap", kDescription, DefineOptions,
                               WithOptions);
}

}  // namespace pbrt::imgtool
