#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/util/matrix.h"
#include "pbrt/util/read_file.h"
#include "pbrt/util/result.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Metadata of an image. Empty optionals are not written.
struct ImageMetadata {
    /// Data window in full-image pixels, [x0, x1) x [y0, y1), and the full size. ReadImage sets
    /// both; WriteImage reads "all 0" as the whole image.
    std::array<int, 4> pixelBounds{};  ///< x0 x1 y0 y1
    Point2i fullResolution{};
    std::optional<std::array<std::array<float, 2>, 4>> chromaticities;  ///< xy: R G B white
    std::optional<float> renderTimeSeconds;
    std::optional<int> samplesPerPixel;
    std::optional<float> mse;
    /// Row-major as pbrt writes them.
    std::optional<std::array<std::array<float, 4>, 4>> cameraFromWorld, ndcFromWorld;
    std::map<std::string, std::string> strings;
    /// Number format of the file that was read: "half", "float", "uint", "8-bit", "16-bit" or
    /// "rgbe"; empty for images made in memory. Not written.
    std::string storedAs;
    /// Parts of a file that were not read, as the rest of a sentence; else empty. Not written.
    std::string unread;
};

/// Pixels in float, interleaved channels, rows top to bottom; values are linear light.
class Image {
  public:
    Image() = default;
    Image(Point2i resolution, std::vector<std::string> channels);

    Point2i Resolution() const { return resolution; }
    int NChannels() const { return int(channels.size()); }
    const std::vector<std::string> &ChannelNames() const { return channels; }
    /// Index of the named channel; -1 where there is none.
    int ChannelIndex(std::string_view name) const;
    float Get(Point2i p, int c) const { return pixels[Offset(p) + c]; }
    void Set(Point2i p, int c, float v) { pixels[Offset(p) + c] = v; }
    const float *Pixel(Point2i p) const { return &pixels[Offset(p)]; }
    float *Pixel(Point2i p) { return &pixels[Offset(p)]; }
    const std::vector<float> &Data() const { return pixels; }
    std::vector<float> &Data() { return pixels; }

    ImageMetadata metadata;

  private:
    size_t Offset(Point2i p) const { return (size_t(p.y) * resolution.x + p.x) * channels.size(); }
    Point2i resolution;
    std::vector<std::string> channels;
    std::vector<float> pixels;
};

/// The named channels in this order. The error lists those that the image has.
OrError<Image> SelectChannels(const Image &image, const std::vector<std::string> &names);
/// Applies m to the channels R, G and B; false, and nothing done, where one of them is missing.
bool TransformRGB(const Matrix3 &m, Image *image);

/// Relation between stored and linear values.
struct ColorEncoding {
    enum class Kind { Linear, sRGB, Gamma } kind = Kind::Linear;
    float gamma = 1;
    float ToLinear(float encoded) const;
    float FromLinear(float linear) const;
};

/// Reads EXR, PNG, JPEG, PFM, Radiance HDR, QOI and TGA, told apart by their first bytes. PNG,
/// JPEG, QOI and TGA are decoded by `encoding` (default sRGB, alpha always linear), but for QOI
/// files that say of themselves that they are linear; the others hold linear values. Channels: R G
/// B, then A, or Y, as the file has them; those of EXR sorted by layer, in a layer R G B A or X Y Z
/// first, the rest by name. Of an EXR file of several parts the first is read, and metadata.unread
/// says so. An image that would need more memory than there is, is refused before any is taken.
OrError<Image> ReadImage(const std::string &fileName,
                         std::optional<ColorEncoding> encoding = std::nullopt,
                         Pipes pipes = Pipes::Refused);

enum class ExrPixels { Half, Float };
/// Writes .exr (ZIP), .png (8 bit sRGB) or .pfm by extension, by WriteFileAtomically. Returns the
/// reason on failure; then nothing is left behind and an old file is untouched. Half: values beyond
/// +-65504 become +-65504, NaN stays. PNG and PFM keep R G B, else Y, else the one or three
/// channels beside alpha; PNG alpha, too. Channels R, G, B of any layer are turned into sRGB
/// primaries where chromaticities are given; PNG clamps to [0, 1] and writes NaN as 0.
std::optional<std::string> WriteImage(const Image &image, const std::string &fileName,
                                      ExrPixels pixels = ExrPixels::Half);
/// WriteImage; where it fails, the image is kept as an EXR file in a new folder among those for
/// temporary files. The reason says where it is, too.
std::optional<std::string> WriteImageSomewhere(const Image &image, const std::string &fileName,
                                               ExrPixels pixels);
/// True where WriteImage knows the extension.
bool CanWriteImage(std::string_view fileName);

}  // namespace pbrt
