#pragma once

#include "pbrt/build/build_scene.h"
#include "pbrt/feathergen/commands.h"
#include "support/temp_folder.h"

namespace pbrt::feathergen {

/// Runs feathergen in a folder of its own.
class Grown : public TempFolder {
  protected:
    static std::string Succeed(const std::vector<std::string> &args) {
        const cli::Outcome outcome = feathergen::Run(args);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    }
    static std::string Fail(const std::vector<std::string> &args) {
        const cli::Outcome outcome = feathergen::Run(args);
        EXPECT_EQ(outcome.exitCode, 1) << outcome.out;
        return outcome.err;
    }
    std::string Bytes(const std::string &name) const {
        std::ifstream file(Path(name), std::ios::binary);
        EXPECT_TRUE(file) << name;
        return {std::istreambuf_iterator<char>(file), {}};
    }
    /// The scene that includes `name` of the folder after `before`, ready to be traced.
    std::unique_ptr<RenderScene> Scene(const std::string &name,
                                       const std::string &before = "") const {
        Diagnostics log;
        SceneDescription scene;
        ParseString(
            "WorldBegin\nLightSource \"infinite\"\n" + before + "Include \"" + Path(name) + "\"\n",
            "test.pbrt", folder.string(), scene, log);
        std::unique_ptr<RenderScene> world = BuildScene(std::move(scene), {}, log);
        for (const Message &m : log.Messages())
            ADD_FAILURE() << m.text;
        return world;
    }
};

}  // namespace pbrt::feathergen
