#include "pbrt/feathergen/file_set.h"

#include <fmt/format.h>

#include <filesystem>

#include "pbrt/util/atomic_file.h"

namespace pbrt::feathergen {
namespace fs = std::filesystem;

namespace {

/// New files and folders, which are removed again unless they are kept.
class Created {
  public:
    Created() = default;
    Created(const Created &) = delete;
    Created &operator=(const Created &) = delete;
    ~Created() {
        std::error_code failure;
        for (auto path = paths.rbegin(); path != paths.rend(); ++path)
            fs::remove(*path, failure);
    }
    void Add(const std::string &path) { paths.push_back(path); }
    void Keep() { paths.clear(); }

  private:
    std::vector<std::string> paths;
};

}  // namespace

std::optional<std::string> FileSet::Write(const std::string &folder) const {
    std::error_code failure;
    Created created;
    if (!folder.empty() && !fs::exists(folder, failure)) {
        created.Add(folder);
        if (fs::create_directories(folder, failure), failure)
            return fmt::format("{}: the folder cannot be made: {}", folder, failure.message());
    }
    for (const File &file : files)
        if (auto problem = WhyNotWritable(file.name)) return problem;
    for (const File &file : files) {
        if (!fs::exists(file.name, failure)) created.Add(file.name);
        if (auto problem = file.write(file.name)) return problem;
    }
    created.Keep();
    return {};
}

}  // namespace pbrt::feathergen
