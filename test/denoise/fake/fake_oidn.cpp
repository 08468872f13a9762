// Stands in for Open Image Denoise: a filter of it halves its first image. It fails where the
// environment variable FAKE_OIDN_FAILS is set, and where it is not used as the manual says.

#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

namespace {

struct Image {
    float *pixels;
    size_t count;
};
struct Filter {
    std::map<std::string, Image> images;
    bool hdr = false, cleanAux = false, committed = false;
};
const char *problem = nullptr;
/// The uses of a device's filters, as in "albedo normal color+albedo+normal".
std::string *const log = new std::string;

}  // namespace

extern "C" {
void *oidnNewDevice(int) {
    return &problem;
}
void oidnCommitDevice(void *) {
    if (std::getenv("FAKE_OIDN_FAILS")) problem = "out of cheese";
}
int oidnGetDeviceError(void *, const char **message) {
    *message = problem;
    return problem ? 1 : 0;
}
void oidnReleaseDevice(void *) {
    setenv("FAKE_OIDN_LOG", log->c_str(), 1);
    log->clear();
    problem = nullptr;
}
void *oidnNewFilter(void *, const char *type) {
    if (std::strcmp(type, "RT") != 0) problem = "unknown filter";
    return new Filter;
}
void oidnSetSharedFilterImage(void *filter, const char *name, void *pixels, int format,
                              size_t width, size_t height, size_t, size_t, size_t) {
    if (format != 3) problem = "not three floats";
    static_cast<Filter *>(filter)->images[name] = {static_cast<float *>(pixels),
                                                   3 * width * height};
}
void oidnSetFilterBool(void *filter, const char *name, bool value) {
    Filter &f = *static_cast<Filter *>(filter);
    (std::strcmp(name, "hdr") == 0 ? f.hdr : f.cleanAux) = value;
}
void oidnCommitFilter(void *filter) {
    static_cast<Filter *>(filter)->committed = true;
}
void oidnExecuteFilter(void *filter) {
    Filter &f = *static_cast<Filter *>(filter);
    if (!f.committed) problem = "not committed";
    const bool color = f.images.contains("color");
    if (color != f.hdr) problem = "colors are linear light, and nothing else is";
    if (f.cleanAux != (color && f.images.contains("albedo")))
        problem = "aux is clean, or not there";
    *log += log->empty() ? "" : " ";
    std::string inputs;
    for (const char *const name : {"color", "albedo", "normal"})
        if (f.images.contains(name)) inputs += (inputs.empty() ? "" : "+") + std::string(name);
    *log += inputs;
    const Image in = f.images.at(inputs.substr(0, inputs.find('+'))), out = f.images.at("output");
    for (size_t i = 0; i < out.count; ++i)
        out.pixels[i] = in.pixels[i] / 2;
}
void oidnReleaseFilter(void *filter) {
    delete static_cast<Filter *>(filter);
}
}
