#include "pbrt/feathergen/feather_files.h"

#include <fmt/format.h>

#include "pbrt/feathergen/vane_mesh.h"
#include "pbrt/feathergen/vane_textures.h"
#include "pbrt/util/atomic_file.h"

namespace pbrt::feathergen {
namespace {

constexpr const char *kTextures[] = {"thickness", "spacing", "tilt"};

/// Atlases are much higher than wide, so that pbrt-v4's rule for other filters takes far too coarse
/// levels, and means of tilt or thickness are not means of color.
constexpr const char *kAtlasLookup = " \"string wrap\" \"clamp\" \"string filter\" \"ewa\"";

std::string TextureFile(const FeatherNames &names, std::string_view which) {
    return names.Path(which) + (names.textures == TextureFiles::Ptex ? ".ptx" : ".exr");
}

std::string ShapeLine(const FeatherNames &names, std::string_view mesh) {
    return fmt::format("Shape \"plymesh\" \"string filename\" \"{}\"\n", names.Path(mesh));
}

}  // namespace

FileSet::Writer TextWriter(std::string text) {
    return [text = std::move(text)](const std::string &name) {
        return WriteFileAtomically(name, text);
    };
}

void AddFeatherFiles(const Feather &feather, const FeatherNames &names, FileSet *files) {
    const bool isPtex = names.textures == TextureFiles::Ptex;
    const VaneUV uv = isPtex ? VaneUV::Faces : VaneUV::Atlas;
    files->Add(names.Path("left.ply"), TextWriter(ToPly(VaneMesh(feather, Bank::Left, uv))));
    files->Add(names.Path("right.ply"), TextWriter(ToPly(VaneMesh(feather, Bank::Right, uv))));
    files->Add(names.Path("rami.ply"), TextWriter(ToPly(RamusMesh(feather))));
    files->Add(names.Path("rachis.ply"), TextWriter(ToPly(RachisMesh(feather))));
    VaneTextures textures(feather);
    std::vector<float> *const values[] = {&textures.thickness, &textures.spacing, &textures.tilt};
    for (int i = 0; i < 3; ++i)
        if (isPtex)
            files->Add(TextureFile(names, kTextures[i]),
                       [content = Faces(feather, *values[i])](const std::string &name) {
                           return WritePtex(name, content);
                       });
        else
            files->Add(TextureFile(names, kTextures[i]),
                       [image = Atlas(feather, *values[i])](const std::string &name) {
                           return WriteImage(image, name, ExrPixels::Float);
                       });
}

std::string TextureDirectives(const FeatherNames &names) {
    std::string text;
    for (const char *which : kTextures)
        text += fmt::format(
            "Texture \"{}{}\" \"float\" {} \"string filename\" \"{}\"{}\n", names.prefix, which,
            names.textures == TextureFiles::Ptex ? "\"ptex\" \"string encoding\" \"linear\""
                                                 : "\"imagemap\"",
            TextureFile(names, which), names.textures == TextureFiles::Ptex ? "" : kAtlasLookup);
    return text + fmt::format(
                      "Texture \"{0}tilt angle\" \"float\" \"mix\" \"float tex1\" {1} "
                      "\"float tex2\" {2} \"texture amount\" \"{0}tilt\"\n",
                      names.prefix, -1.5707963, 1.5707963);
}

std::string ShapeDirectives(const Parameters &p, const FeatherNames &names) {
    std::string text;
    for (const Bank bank : {Bank::Left, Bank::Right}) {
        text += fmt::format(
            "Material \"featherbarbule\" \"texture thickness\" \"{0}thickness\" "
            "\"texture spacing\" \"{0}spacing\"\n  \"texture tilt\" \"{0}tilt angle\" "
            "\"float aspect\" {1} \"float opening\" {2} \"float rotation\" {3:.6f}\n",
            names.prefix, p.aspect, p.opening, Rotation(p, bank));
        text += ShapeLine(names, bank == Bank::Left ? "left.ply" : "right.ply");
    }
    text += fmt::format(
        "Material \"coateddiffuse\" \"rgb reflectance\" [ {} {} {} ] \"float eta\" 1.55 \"float "
        "roughness\" 0.2\n",
        p.keratinRed, p.keratinGreen, p.keratinBlue);
    return text + ShapeLine(names, "rami.ply") + ShapeLine(names, "rachis.ply");
}

}  // namespace pbrt::feathergen
