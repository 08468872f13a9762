#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include "pbrt/image/codecs.h"
#include "pbrt/util/atomic_file.h"
#include "pbrt/util/memory.h"
#include "pbrt/util/read_file.h"

namespace pbrt {
namespace {

namespace fs = std::filesystem;

constexpr ColorEncoding kSRGB{ColorEncoding::Kind::sRGB, 1};

OrError<Image> Decode(std::string_view bytes, const ColorEncoding &encoding) {
    if (bytes.empty()) return {{}, "is empty"};
    if (bytes.starts_with("\x76\x2f\x31\x01")) return DecodeExr(bytes);
    if (bytes.starts_with("\x89PNG")) return DecodePng(bytes, encoding);
    if (bytes.starts_with("\xff\xd8\xff")) return DecodeJpeg(bytes, encoding);
    if (bytes.starts_with("PF") || bytes.starts_with("Pf")) return DecodePfm(bytes);
    if (bytes.starts_with("#?")) return DecodeHdr(bytes);
    if (bytes.starts_with("qoif")) return DecodeQoi(bytes, encoding);
    if (IsTga(bytes)) return DecodeTga(bytes, encoding);
    return {{}, "is no EXR, PNG, JPEG, PFM, Radiance HDR, QOI or TGA picture"};
}

/// The extension in lower case, without the dot.
std::string Extension(std::string_view fileName) {
    const size_t dot = fileName.find_last_of("./");
    if (dot == std::string_view::npos || fileName[dot] == '/') return {};
    std::string extension(fileName.substr(dot + 1));
    for (char &c : extension)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

OrError<std::string> Encode(const Image &image, const std::string &extension, ExrPixels pixels) {
    if (image.Resolution().x <= 0 || image.Resolution().y <= 0 || image.NChannels() == 0)
        return {{}, "would be an empty picture"};
    if (extension == "exr") return EncodeExr(image, pixels);
    if (extension == "png") return EncodePng(image);
    if (extension == "pfm") return EncodePfm(image);
    return {{}, "has none of the extensions that can be written: .exr, .png, .pfm"};
}

}  // namespace

std::optional<std::string> Implausible(double width, double height, double channels,
                                       double bitsPerPixel, double maxRatio, size_t bytesInFile) {
    if (!(width >= 1) || !(height >= 1) || !(channels >= 1)) return "holds no pixels";
    if (width * height * channels > 0x1p31)
        return fmt::format("has {} x {} pixels of {} channels, more than fit here", width, height,
                           channels);
    if (width * height * bitsPerPixel / 8 > maxRatio * double(bytesInFile))
        return fmt::format("is damaged: {} x {} pixels cannot come from {} bytes", width, height,
                           bytesInFile);
    const double bytes = width * height * (channels * sizeof(float) + bitsPerPixel / 8);
    if (const auto why = WhyTooLarge(uint64_t(bytes)))
        return fmt::format("has {} x {} pixels of {} channels: it {}", width, height, channels,
                           *why);
    return {};
}

OrError<Image> ReadImage(const std::string &fileName, std::optional<ColorEncoding> encoding,
                         Pipes pipes) {
    const FileContents file = ReadWholeFile(fileName, pipes);
    if (!file.bytes) return {{}, file.error};
    OrError<Image> image;
    try {
        image = Decode(*file.bytes, encoding.value_or(kSRGB));
    } catch (const std::exception &e) {  // OpenEXR's, or out of memory
        image.error = fmt::format("cannot be read: {}", e.what());
    }
    if (!image) return {{}, fmt::format("{}: {}", fileName, image.error)};
    ImageMetadata &metadata = image.value->metadata;
    if (metadata.fullResolution == Point2i{}) {
        const Point2i size = image.value->Resolution();
        metadata.fullResolution = size;
        metadata.pixelBounds = {0, size.x, 0, size.y};
    }
    return image;
}

std::optional<std::string> WriteImage(const Image &image, const std::string &fileName,
                                      ExrPixels pixels) {
    OrError<std::string> bytes;
    try {
        bytes = Encode(image, Extension(fileName), pixels);
    } catch (const std::exception &e) {
        bytes.error = fmt::format("cannot be written: {}", e.what());
    }
    if (!bytes) return fmt::format("{}: {}", fileName, bytes.error);
    return WriteFileAtomically(fileName, *bytes.value);
}

std::optional<std::string> WriteImageWithWords(const Image &image, const std::string &fileName,
                                               ExrPixels pixels, const ExrWords &words) {
    OrError<std::string> bytes;
    try {
        bytes = EncodeExr(image, pixels, &words);
    } catch (const std::exception &e) {
        bytes.error = fmt::format("cannot be written: {}", e.what());
    }
    if (!bytes) return fmt::format("{}: {}", fileName, bytes.error);
    return WriteFileAtomically(fileName, *bytes.value);
}

OrError<ExrWords> ReadWords(const std::string &fileName, const std::string &name) {
    const FileContents file = ReadWholeFile(fileName, Pipes::Refused);
    if (!file.bytes) return {{}, file.error};
    OrError<ExrWords> words;
    try {
        words = DecodeExrWords(*file.bytes, name);
    } catch (const std::exception &e) {
        words.error = fmt::format("cannot be read: {}", e.what());
    }
    if (!words) words.error = fmt::format("{}: {}", fileName, words.error);
    return words;
}

std::optional<std::string> WriteImageSomewhere(const Image &image, const std::string &fileName,
                                               ExrPixels pixels) {
    const auto why = WriteImage(image, fileName, pixels);
    if (!why) return {};
    std::error_code unknown;
    std::string folder = (fs::temp_directory_path(unknown) / "pbrt-XXXXXX").string();
    if (!mkdtemp(folder.data())) return why;
    constexpr size_t kLongest = 200;  // bytes of a name, which others limit to 255
    const std::string name = fs::path(fileName).stem().string().substr(0, kLongest);
    const std::string kept = fmt::format("{}/{}.exr", folder, name);
    if (!WriteImage(image, kept, pixels)) return fmt::format("{}; the picture is {}", *why, kept);
    fs::remove(folder, unknown);
    return fmt::format("{}; neither could it be kept in {}", *why, folder);
}

bool CanWriteImage(std::string_view fileName) {
    const std::string extension = Extension(fileName);
    return extension == "exr" || extension == "png" || extension == "pfm";
}

}  // namespace pbrt
