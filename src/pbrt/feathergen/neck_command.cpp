#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/feathergen/covering.h"
#include "pbrt/feathergen/feather_options.h"
#include "pbrt/feathergen/vane_grid.h"
#include "pbrt/util/hash.h"

namespace pbrt::feathergen {
namespace {

struct NeckOptions {
    FeatherOptions feather;
    std::string surface;
    std::vector<double> flow{0, 0, -1};
};

constexpr char kDescription[] =
    "Covers a neck with overlapping feathers: a few distinct ones, many times. Writes "
    "meshes, textures and neck.pbrt, to be included in a scene.";

void DefineOptions(CLI::App *app, NeckOptions *o) {
    o->feather.AddTo(app);
    cli::AddText(app, "--surface", &o->surface,
                 "PLY file to cover, millimetres (default: a dove's neck)");
    cli::AddNumbers(app, "--flow", &o->flow, "x,y,z", {},
                    "where feathers' tips point (default 0,0,-1)");
}

/// The kinds of feather: their parameters, files and forms.
struct Kinds {
    std::vector<FeatherNames> names;
    std::vector<Parameters> parameters;
    std::vector<Sheet> sheets;
    size_t quads = 0;  ///< of the vane of one

    Kinds(const Parameters &base, const NeckOptions &o, FileSet *files) {
        const int shapes = int(base.neckShapes);
        for (int i = 0; i < kNeckColors * shapes; ++i) {
            const double color = double(i / shapes) / (kNeckColors - 1);
            Parameters p = base;
            p.thickness = Lerp(color, base.neckGreen, base.neckPurple);
            p.thicknessGradient = 0.15 * base.thicknessGradient;
            const Feather feather(p, Hash(o.feather.seed, i));
            names.push_back(
                {o.feather.Folder(), fmt::format("feather{}-", i), o.feather.Textures()});
            AddFeatherFiles(feather, names.back(), files);
            parameters.push_back(p);
            sheets.emplace_back(feather);
        }
        const VaneGrid grid(Feather(base, 0));
        quads = size_t(grid.NFaces());
    }
};

std::string InstanceDirective(const Placed &f) {
    const Vec3d x = f.scale * f.x, y = f.scale * f.y, z = f.scale * f.z;
    return fmt::format(
        "AttributeBegin ConcatTransform [ {:.7g} {:.7g} {:.7g} 0 {:.7g} {:.7g} {:.7g} 0 {:.7g} "
        "{:.7g} {:.7g} 0 {:.7g} {:.7g} {:.7g} 1 ] ObjectInstance \"feather{}\" AttributeEnd\n",
        x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z, f.root.x, f.root.y, f.root.z, f.kind);
}

std::string NeckDirectives(const Kinds &kinds, const std::vector<Placed> &feathers,
                           const std::string &skin) {
    std::string text;
    for (size_t i = 0; i < kinds.names.size(); ++i)
        text += TextureDirectives(kinds.names[i]);
    for (size_t i = 0; i < kinds.names.size(); ++i)
        text += fmt::format("ObjectBegin \"feather{}\"\n{}ObjectEnd\n", i,
                            ShapeDirectives(kinds.parameters[i], kinds.names[i]));
    text += fmt::format(
        "AttributeBegin\nMaterial \"diffuse\" \"rgb reflectance\" [ 0.03 0.03 0.035 ]\n"
        "Shape \"plymesh\" \"string filename\" \"{}\"\nAttributeEnd\n",
        skin);
    for (const Placed &f : feathers)
        text += InstanceDirective(f);
    return text;
}

/// Covers the surface and writes everything.
Outcome Grow(const NeckOptions &o, const Parameters &p, Vec3d flow, const Mesh &surface) {
    constexpr size_t kSamples = 60000;
    const std::vector<SurfaceSample> samples =
        SampleSurface(surface, flow, kSamples, Hash(o.feather.seed));
    if (samples.empty())
        return Failure(fmt::format("--surface: {}: has no area to cover", o.surface));
    FileSet files;
    const Kinds kinds(p, o, &files);
    const auto feathers = Cover(samples, flow, p, kinds.sheets, Hash(o.feather.seed, 1));
    if (!feathers)
        return Failure(
            fmt::format("\"neck_spacing\" is {} mm: more than {} feathers on this surface",
                        p.neckSpacing, kMostFeathers));

    const std::string folder = o.feather.Folder(), skin = folder + "skin.ply";
    const std::string contents =
        fmt::format("{} feathers of {} kinds, {} quads of vane", feathers->size(),
                    kinds.names.size(), feathers->size() * kinds.quads);
    files.Add(skin, TextWriter(ToPly(surface)));
    files.Add(folder + "neck.pbrt",
              TextWriter(fmt::format(
                  "# feathergen neck --preset {} --seed {}: {}, millimetres.\n{}", o.feather.preset,
                  o.feather.seed, contents, NeckDirectives(kinds, *feathers, skin))));
    if (const auto wrong = files.Write(folder)) return Failure(*wrong);
    return {0, contents + "\n", {}};
}

Outcome WithOptions(NeckOptions &o) {
    Parameters p;
    std::string problem = o.feather.Read(&p);
    if (!problem.empty()) return Failure(problem);
    if (o.feather.printPreset) return {0, ToJson(p), {}};
    const double quads = kNeckColors * p.neckShapes * p.VaneQuads();
    if (quads > 2 * kMostVaneQuads)
        return Failure(
            fmt::format("neck_shapes and the numbers of barbs and quads make {:.0f} quads, "
                        "above {:.0f}",
                        quads, 2 * kMostVaneQuads));
    const Vec3d flow{o.flow[0], o.flow[1], o.flow[2]};
    if (!(LengthSquared(flow) > 0 && LengthSquared(flow) < Infinity))
        return Failure(fmt::format("--flow: ({}, {}, {}) is no direction", flow.x, flow.y, flow.z));
    std::optional<Mesh> surface = BuiltInNeck();
    if (!o.surface.empty()) surface = ReadSurface(o.surface, &problem);
    if (!surface) return Failure("--surface: " + problem);
    return Grow(o, p, Normalize(flow), *surface);
}

}  // namespace

Outcome NeckCommand(Args args) {
    return cli::RunWithOptions(args, "feathergen neck", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::feathergen
