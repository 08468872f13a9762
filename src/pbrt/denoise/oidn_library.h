#pragma once

#include <cstddef>
#include <string>

#include "pbrt/util/result.h"

namespace pbrt {

/// Open Image Denoise's C interface, versions 1.4 and 2, loaded when it is needed: the functions
/// used here, by their names and with their types of the library's manual.
struct OidnLibrary {
    using Device = struct OidnDevice *;
    using Filter = struct OidnFilter *;
    static constexpr int kDefaultDevice = 0, kFloat3 = 3;

    Device (*newDevice)(int type);
    void (*commitDevice)(Device);
    int (*getDeviceError)(Device, const char **message);
    void (*releaseDevice)(Device);
    Filter (*newFilter)(Device, const char *type);
    void (*setSharedFilterImage)(Filter, const char *name, void *pixels, int format, size_t width,
                                 size_t height, size_t byteOffset, size_t bytePixelStride,
                                 size_t byteRowStride);
    void (*setFilterBool)(Filter, const char *name, bool value);
    void (*commitFilter)(Filter);
    void (*executeFilter)(Filter);
    void (*releaseFilter)(Filter);
};

/// The library, which stays loaded; or why there is none, and what to do.
OrError<OidnLibrary> LoadOidn();

}  // namespace pbrt
