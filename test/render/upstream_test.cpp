// What the table of pbrt-v4's names says is not built here is not: a scene that names it is told
// so.

#include "pbrt/util/upstream.h"

#include <fmt/format.h>

#include <map>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// `{}` stands for the plug-in and its parameters.
const std::map<std::string_view, const char *> kScenes{
    {"camera", "Camera {} WorldBegin"},
    {"sampler", "Sampler {} WorldBegin"},
    {"integrator", "Integrator {} WorldBegin"},
    {"accelerator", "Accelerator {} WorldBegin"},
    {"medium", "MakeNamedMedium \"m\" \"string type\" {} WorldBegin MediumInterface \"m\" \"\""},
    {"shape", "WorldBegin Shape {}"},
    {"material", "WorldBegin Material {}"},
    {"texture class", "WorldBegin Texture \"a\" \"float\" {}"},
    {"light", "WorldBegin LightSource {}"},
    {"area light", "WorldBegin AreaLightSource {} Shape \"sphere\""}};

TEST(Upstream, NamesAreToldToBeNotBuiltHere) {
    int told = 0;
    for (const UpstreamName &row : NotBuiltHere()) {
        const size_t quote = row.kind.find(" \"");
        const auto scene = kScenes.find(row.kind.substr(0, quote));
        if (scene == kScenes.end()) {
            EXPECT_TRUE(row.kind == "option of pbrt" || row.kind == "command of imgtool");
            continue;
        }
        const std::string plugIn =
            quote == row.kind.npos
                ? fmt::format("\"{}\" \"float a\" 1", row.name)
                : fmt::format("{} \"float {}\" 1", row.kind.substr(quote), row.name);
        Diagnostics log;
        SceneDescription description;
        ParseString(fmt::format(fmt::runtime(scene->second), plugIn), "test.pbrt", ".", description,
                    log);
        EXPECT_FALSE(MakeRenderTask(std::move(description), {}, log));
        std::string said;
        for (const Message &m : log.Messages())
            said += m.text + '\n';
        const bool isPlugIn = quote == row.kind.npos;
        if (isPlugIn && said.find("unknown parameter") != said.npos) continue;  // built since
        // Read by the plug-in, which refuses values of it by itself, as CoatParams does.
        if (!isPlugIn && said.find(": expected \"texture ") != said.npos) continue;
        EXPECT_NE(said.find(": pbrt-v4 has it; not built here. "), std::string::npos) << said;
        // Of an unknown plug-in no parameter is reported, too.
        if (isPlugIn) {
            EXPECT_EQ(log.ErrorCount(), 1) << said;
        }
        ++told;
    }
    EXPECT_GT(told, 10);
}

}  // namespace
}  // namespace pbrt::test
