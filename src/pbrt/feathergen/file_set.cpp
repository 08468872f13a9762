#include "pbrt/feathergen/file_set.h"

#include <fmt/format.h>

#include <filesystem>

#include "pbrt/util/atomic_file.h"

namespace pbrt::feathergen {
namespace fs = std::filesystem;

std::optional<std::string> FileSet::Write(const std::string &folder) const {
    std::error_code failure;
    const bool isNewFolder = !folder.empty() && !fs::exists(folder, failure);
    if (isNewFolder && (fs::create_directories(folder, failure), failure))
        return fmt::format("{}: the folder cannot be made: {}", folder, failure.message());

    std::vector<std::string> created;
    std::optional<std::string> problem;
    for (const File &file : files)
        if (!problem) problem = WhyNotWritable(file.name);
    for (const File &file : files) {
        if (problem) break;
        if (!fs::exists(file.name, failure)) created.push_back(file.name);
        problem = file.write(file.name);
    }
    if (!problem) return {};
    for (const std::string &name : created)
        fs::remove(name, failure);
    if (isNewFolder) fs::remove(folder, failure);
    return problem;
}

}  // namespace pbrt::feathergen
