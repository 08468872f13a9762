#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "support/folders.h"

namespace pbrt::test {

/// The text of a scene of cases/, whose first line says what is right.
inline std::string Case(const std::string &name) {
    std::stringstream text;
    text << std::ifstream(SourceDir() + "/test/render/cases/" + name).rdbuf();
    EXPECT_FALSE(text.str().empty()) << name;
    return text.str();
}

}  // namespace pbrt::test
