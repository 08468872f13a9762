#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "pbrt/util/diagnostics.h"

namespace pbrt {

/// Places in scene files, in half the memory of FileLoc.
class Places {
  public:
    void Reserve(size_t count) { places.reserve(count); }
    void Append(const FileLoc &loc) {
        if (files.empty() || files.back() != loc.file) files.push_back(loc.file);
        places.push_back({uint32_t(files.size() - 1), loc.line, loc.column});
    }
    FileLoc operator[](size_t i) const {
        return {files[places[i].file], places[i].line, places[i].column};
    }

  private:
    struct Place {
        uint32_t file;  ///< index into `files`
        int line, column;
    };
    std::vector<std::string_view> files;  ///< again wherever it changes from one place to the next
    std::vector<Place> places;
};

}  // namespace pbrt
