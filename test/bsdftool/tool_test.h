#pragma once

#include <sstream>

#include "pbrt/bsdftool/commands.h"
#include "pbrt/bsdftool/material_source.h"
#include "support/tool_test.h"

namespace pbrt::bsdftool {

class BsdfTool : public ToolFolder<kTool> {
  protected:
    /// A material that is known to be right.
    static Material Read(const std::string &text) {
        Diagnostics log;
        const auto source = ReadMaterial(text, "", log);
        for (const Message &m : log.Messages())
            ADD_FAILURE() << m.text;
        return source ? source->material : Material();
    }
    static std::vector<std::string> Lines(const std::string &text) {
        std::vector<std::string> lines;
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);)
            lines.push_back(line);
        return lines;
    }
    static inline const std::string kFeather = "Material \"featherbarbule\"";
};

}  // namespace pbrt::bsdftool
