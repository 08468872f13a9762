#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "pbrt/util/diagnostics.h"
#include "support/folders.h"

namespace pbrt {

/// A folder of broken scenes below test/: NN-name.pbrt beside NN-name.expected, which holds a line
/// for each message as the program prints it: `Error: file:line:column: message` or `Warning: ...`,
/// `file` relative to the folder. A program is checked in the same way by running it in the folder.
inline std::filesystem::path CorpusFolder(const std::string &folder) {
    return std::filesystem::path(SourceDir()) / "test" / folder;
}

/// Names of the scenes, without folder and extension, sorted.
inline std::vector<std::string> CorpusScenes(const std::string &folder) {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(CorpusFolder(folder)))
        if (entry.path().extension() == ".pbrt") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

inline std::string CorpusTestName(const testing::TestParamInfo<std::string> &info) {
    std::string name = info.param;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
}

/// Texts that stand for others in expected messages: `{all materials}` for their quoted names.
using Placeholders = std::vector<std::pair<std::string, std::string>>;

/// Runs `pipeline` on the scene inside the folder; its messages must be those expected, in order.
inline void ExpectMessages(
    const std::string &folder, const std::string &scene,
    const std::function<void(const std::string &file, Diagnostics &log)> &pipeline,
    const Placeholders &placeholders = {}) {
    std::ifstream expectedFile(CorpusFolder(folder) / (scene + ".expected"));
    ASSERT_TRUE(expectedFile) << scene << ".expected is missing";
    std::stringstream expected;
    expected << expectedFile.rdbuf();
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(CorpusFolder(folder));
    Diagnostics log;
    pipeline(scene + ".pbrt", log);
    std::filesystem::current_path(before);
    std::string said;
    for (const Message &m : log.Messages())
        said += (m.severity == Severity::Error ? "Error: " : "Warning: ") + m.text + "\n";
    std::string text = expected.str();
    for (const auto &[placeholder, meaning] : placeholders)
        for (size_t at; (at = text.find(placeholder)) != text.npos;)
            text.replace(at, placeholder.size(), meaning);
    EXPECT_EQ(said, text);
    EXPECT_TRUE(log.HasErrors()) << "a broken scene must not render";
}

}  // namespace pbrt
