#include "pbrt/denoise/oidn_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace pbrt {
namespace {

namespace fs = std::filesystem;

/// The folder that scripts/denoiser.sh makes.
fs::path OwnFolder() {
    const char *const data = std::getenv("XDG_DATA_HOME"), *const home = std::getenv("HOME");
    const fs::path base = data && *data   ? fs::path(data)
                          : home && *home ? fs::path(home) / ".local" / "share"
                                          : fs::path();
    return base.empty() ? base : base / "pbrt-feather" / "denoiser";
}

/// Libraries in the Python packages of that folder, of whatever Python.
std::vector<std::string> OwnLibraries() {
    std::vector<std::string> found;
    std::error_code none;
    for (const auto &python : fs::directory_iterator(OwnFolder() / "lib", none)) {
        const fs::path library = python.path() / "site-packages" / "pyoidn" / "oidn" / "lib" /
                                 "libOpenImageDenoise.so.2";
        if (fs::exists(library, none)) found.push_back(library.string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

void *Open(const std::string &name) {
    return dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
}

/// Takes the function of the first name that the library has; false where it has none.
template <typename F>
bool Take(void *library, F *function, std::initializer_list<const char *> names) {
    void *symbol = nullptr;
    for (const char *const name : names)
        if (!symbol) symbol = dlsym(library, name);
    *function = reinterpret_cast<F>(symbol);
    return symbol != nullptr;
}

std::optional<OidnLibrary> Functions(void *library) {
    OidnLibrary l;
    const bool all = Take(library, &l.newDevice, {"oidnNewDevice"}) &&
                     Take(library, &l.commitDevice, {"oidnCommitDevice"}) &&
                     Take(library, &l.getDeviceError, {"oidnGetDeviceError"}) &&
                     Take(library, &l.releaseDevice, {"oidnReleaseDevice"}) &&
                     Take(library, &l.newFilter, {"oidnNewFilter"}) &&
                     Take(library, &l.setSharedFilterImage, {"oidnSetSharedFilterImage"}) &&
                     Take(library, &l.setFilterBool, {"oidnSetFilterBool", "oidnSetFilter1b"}) &&
                     Take(library, &l.commitFilter, {"oidnCommitFilter"}) &&
                     Take(library, &l.executeFilter, {"oidnExecuteFilter"}) &&
                     Take(library, &l.releaseFilter, {"oidnReleaseFilter"});
    if (!all) return {};
    return l;
}

}  // namespace

OrError<OidnLibrary> LoadOidn() {
    std::vector<std::string> names{"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1",
                                   "libOpenImageDenoise.so.0"};
    const std::vector<std::string> own = OwnLibraries();
    names.insert(names.end(), own.begin(), own.end());
    if (const char *const asked = std::getenv("OIDN_LIBRARY"); asked && *asked) names = {asked};
    std::string lastError;
    for (const std::string &name : names) {
        void *const library = Open(name);
        if (!library) {
            const char *const why = dlerror();
            if (why) lastError = why;
            continue;
        }
        if (const auto functions = Functions(library)) return {*functions, {}};
        lastError = fmt::format("{}: lacks functions of Open Image Denoise", name);
    }
    return {{},
            fmt::format("Open Image Denoise was not found ({}). scripts/denoiser.sh installs it "
                        "(88 MB); or let OIDN_LIBRARY name its libOpenImageDenoise.so",
                        lastError)};
}

}  // namespace pbrt
