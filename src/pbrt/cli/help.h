#pragma once

#include <string>

namespace CLI {
class App;
}

namespace pbrt::cli {

/// The text that --help prints for a program or command: usage, description, arguments, options,
/// footer. The same for every version of CLI11.
std::string Help(const CLI::App &app);

}  // namespace pbrt::cli
