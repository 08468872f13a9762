#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pbrt::feathergen {

/// Files that belong together: all are written, or none is left that was not there before.
class FileSet {
  public:
    /// `write` returns the reason why it fails.
    using Writer = std::function<std::optional<std::string>(const std::string &fileName)>;

    void Add(std::string fileName, Writer write) {
        files.push_back({std::move(fileName), std::move(write)});
    }
    /// Makes the folder (and those above it) and writes in the order of Add.
    std::optional<std::string> Write(const std::string &folder) const;
    size_t Size() const { return files.size(); }

  private:
    struct File {
        std::string name;
        Writer write;
    };
    std::vector<File> files;
};

}  // namespace pbrt::feathergen
