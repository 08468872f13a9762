#pragma once

#include <optional>
#include <string>

#include "pbrt/films/film.h"

namespace pbrt {

/// Log of an image's error while it is rendered: Option "msereferenceimage" and
/// "msereferenceout".
class MseLog {
  public:
    /// nullopt where no reference is named, and where a mistake is reported: one of the two names
    /// is missing, the reference cannot be read, has no R, G and B, another color space, or not all
    /// of the film's pixels, or the other file cannot be written.
    static std::optional<MseLog> Create(const Options &options, const Film &film, Diagnostics &log);

    /// Writes a line `spp, error` and all before it: the mean over pixels, R, G and B of the
    /// squared difference.
    void Add(const Image &image, int samplesPerPixel);
    /// Error of the last image added.
    double Error() const { return error; }
    /// Why the file could not be written, if so.
    const std::optional<std::string> &Problem() const { return problem; }

  private:
    Image reference;
    std::string outfile, lines;
    std::optional<std::string> problem;
    double error = 0;
};

}  // namespace pbrt
