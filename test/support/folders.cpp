#include "support/folders.h"

namespace pbrt {

std::string SourceDir() {
    return PBRT_SOURCE_DIR;
}

std::string ProgramDir() {
    return PBRT_PROGRAM_DIR;
}

}  // namespace pbrt
