#include "pbrt/imgtool/pictures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "pbrt/image/primaries.h"

namespace pbrt::imgtool {

OrError<Image> Crop(const Image &image, const std::vector<int> &crop) {
    const int x0 = crop[0], x1 = crop[1] < 0 ? crop[0] - crop[1] : crop[1];
    const int y0 = crop[2], y1 = crop[3] < 0 ? crop[2] - crop[3] : crop[3];
    const auto [width, height] = image.Resolution();
    if (x0 < 0 || y0 < 0 || x1 <= x0 || y1 <= y0 || x1 > width || y1 > height)
        return {{},
                fmt::format("has {} x {} pixels: the crop [{}, {}) x [{}, {}) is empty or "
                            "reaches beyond",
                            width, height, x0, x1, y0, y1)};
    Image part({x1 - x0, y1 - y0}, image.ChannelNames());
    part.metadata = image.metadata;
    auto &bounds = part.metadata.pixelBounds;
    bounds = {bounds[0] + x0, bounds[0] + x1, bounds[2] + y0, bounds[2] + y1};
    if (part.metadata.fullResolution == Point2i{}) part.metadata.fullResolution = {width, height};
    for (int y = y0; y < y1; ++y)
        std::copy_n(image.Pixel({x0, y}), size_t(x1 - x0) * image.NChannels(),
                    &part.Data()[size_t(y - y0) * (x1 - x0) * image.NChannels()]);
    return {std::move(part), {}};
}

OrError<Image> Read(const std::string &fileName, std::string *remarks,
                    std::optional<ColorEncoding> encoding) {
    OrError<Image> image = ReadImage(fileName, encoding, Pipes::Taken);
    if (image && !image.value->metadata.unread.empty())
        *remarks += fmt::format("imgtool: {}: {}\n", fileName, image.value->metadata.unread);
    return image;
}

OrError<Image> ReadPart(const std::string &fileName, const std::vector<std::string> &channels,
                        const std::vector<int> &crop, std::string *remarks) {
    OrError<Image> image = Read(fileName, remarks);
    if (!image) return image;
    if (!channels.empty()) image = SelectChannels(*image.value, channels);
    if (image && !crop.empty()) image = Crop(*image.value, crop);
    if (!image) image.error = fmt::format("{}: {}", fileName, image.error);
    return image;
}

const RGBColorSpace *ColorSpaceOf(const Image &image) {
    const auto &xy = image.metadata.chromaticities;
    if (!xy) return &RGBColorSpace::sRGB();
    for (const std::string_view name : RGBColorSpace::Names())
        if (SamePrimaries(RGBColorSpace::Named(name)->Chromaticities(), *xy))
            return RGBColorSpace::Named(name);
    return nullptr;
}

std::optional<std::string> Mismatch(const Image &a, const Image &b) {
    if (a.Resolution() != b.Resolution())
        return fmt::format("the pictures differ in size: {} x {} and {} x {} pixels",
                           a.Resolution().x, a.Resolution().y, b.Resolution().x, b.Resolution().y);
    if (a.ChannelNames() != b.ChannelNames())
        return fmt::format("the pictures differ in channels: {} and {}",
                           fmt::join(a.ChannelNames(), ", "), fmt::join(b.ChannelNames(), ", "));
    const auto primaries = [](const Image &image) {
        return image.metadata.chromaticities.value_or(kSRGBChromaticities);
    };
    if (!SamePrimaries(primaries(a), primaries(b)))
        return "the pictures differ in color space; \"imgtool convert --colorspace\" helps";
    return {};
}

std::vector<std::string> FilesOf(const std::string &nameOrPrefix) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path path(nameOrPrefix);
    if (fs::exists(path, error) && !fs::is_directory(path, error)) return {nameOrPrefix};
    std::vector<std::string> files;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    for (auto entry = fs::directory_iterator(folder, error);
         !error && entry != fs::directory_iterator(); entry.increment(error)) {
        std::error_code unknown;
        if (entry->path().filename().string().starts_with(path.filename().string()) &&
            entry->is_regular_file(unknown))
            files.push_back(path.has_parent_path() ? entry->path().string()
                                                   : entry->path().filename().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

OrError<std::vector<std::string>> FilesOf(const std::vector<std::string> &namesOrPrefixes) {
    std::vector<std::string> files;
    for (const std::string &argument : namesOrPrefixes) {
        const std::vector<std::string> found = FilesOf(argument);
        if (found.empty())
            return {{}, fmt::format("{}: no such file, and none whose name begins so", argument)};
        files.insert(files.end(), found.begin(), found.end());
    }
    return {std::move(files), {}};
}

}  // namespace pbrt::imgtool
