#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "pbrt/image/codecs.h"
#include "pbrt/image/exr_stream.h"

namespace pbrt {
namespace {

/// Beyond deflate's 1032:1, for the wavelet and block coders on flat images.
constexpr double kMaxRatio = 4096;

template <typename Attribute, typename T>
void ReadAttribute(const Imf::Header &header, const char *name, std::optional<T> *value) {
    if (const auto *attribute = header.findTypedAttribute<Attribute>(name))
        *value = attribute->value();
}

std::optional<std::array<std::array<float, 4>, 4>> ReadMatrix(const Imf::Header &header,
                                                              const char *name) {
    const auto *attribute = header.findTypedAttribute<Imf::M44fAttribute>(name);
    if (!attribute) return {};
    std::array<std::array<float, 4>, 4> m;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            m[i][j] = attribute->value()[i][j];
    return m;
}

ImageMetadata ReadMetadata(const Imf::Header &header) {
    ImageMetadata metadata;
    const Imath::Box2i data = header.dataWindow(), display = header.displayWindow();
    metadata.pixelBounds = {data.min.x - display.min.x, data.max.x + 1 - display.min.x,
                            data.min.y - display.min.y, data.max.y + 1 - display.min.y};
    metadata.fullResolution = {display.max.x + 1 - display.min.x,
                               display.max.y + 1 - display.min.y};
    if (const auto *xy =
            header.findTypedAttribute<Imf::ChromaticitiesAttribute>("chromaticities")) {
        const Imf::Chromaticities &c = xy->value();
        metadata.chromaticities = {{{c.red.x, c.red.y},
                                    {c.green.x, c.green.y},
                                    {c.blue.x, c.blue.y},
                                    {c.white.x, c.white.y}}};
    }
    ReadAttribute<Imf::FloatAttribute>(header, "renderTimeSeconds", &metadata.renderTimeSeconds);
    ReadAttribute<Imf::IntAttribute>(header, "samplesPerPixel", &metadata.samplesPerPixel);
    ReadAttribute<Imf::FloatAttribute>(header, "MSE", &metadata.mse);
    metadata.cameraFromWorld = ReadMatrix(header, "worldToCamera");
    metadata.ndcFromWorld = ReadMatrix(header, "worldToNDC");
    for (auto a = header.begin(); a != header.end(); ++a)
        if (const auto *text = dynamic_cast<const Imf::StringAttribute *>(&a.attribute()))
            metadata.strings[a.name()] = text->value();
    // What the file format itself says with strings.
    metadata.strings.erase("name");
    metadata.strings.erase("type");
    return metadata;
}

struct Channels {
    std::vector<std::string> names;
    Imf::PixelType type = Imf::HALF;  ///< the widest
    double bitsPerPixel = 0;
};

/// `has 3 parts, of which only the first, "left", is read (others: "right", "depth")`; names a few.
std::string UnreadParts(const Imf::MultiPartInputFile &file) {
    if (file.parts() < 2) return {};
    const auto name = [&](int part) {
        const Imf::Header &header = file.header(part);
        return header.hasName() ? fmt::format("\"{}\"", header.name()) : "unnamed";
    };
    constexpr int kMostNames = 5;
    std::string others;
    for (int part = 1; part < std::min(file.parts(), 1 + kMostNames); ++part)
        others += (part > 1 ? ", " : "") + name(part);
    if (file.parts() > 1 + kMostNames) others += ", ...";
    return fmt::format("has {} parts, of which only the first, {}, is read (others: {})",
                       file.parts(), name(0), others);
}

/// Channels sorted by layer, in a layer R G B A or X Y Z first; nullopt where some are subsampled.
std::optional<Channels> ReadChannels(const Imf::ChannelList &list) {
    Channels channels;
    for (auto c = list.begin(); c != list.end(); ++c) {
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1) return {};
        channels.names.push_back(c.name());
        const Imf::PixelType type = c.channel().type;
        channels.bitsPerPixel += type == Imf::HALF ? 16 : 32;
        if (type != Imf::HALF) channels.type = channels.type == Imf::FLOAT ? Imf::FLOAT : type;
    }
    const auto key = [](const std::string &name) {
        const size_t dot = name.rfind('.');
        const std::string layer = dot == std::string::npos ? "" : name.substr(0, dot);
        const std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
        constexpr std::string_view kFirst = "RGBAXYZ";
        const size_t rank = last.size() == 1 ? kFirst.find(last[0]) : std::string_view::npos;
        return std::tuple(layer, rank, last);
    };
    std::sort(channels.names.begin(), channels.names.end(),
              [&](const std::string &a, const std::string &b) { return key(a) < key(b); });
    return channels;
}

}  // namespace

OrError<Image> DecodeExr(std::string_view bytes) {
    ExrInput stream(bytes);
    // Opens without a buffer for pixels, so that the size can be judged first; a table of lines
    // that is incomplete shows when they are read.
    Imf::MultiPartInputFile file(stream, Imf::globalThreadCount(), false);
    const Imf::Header &header = file.header(0);
    if (header.hasType() && Imf::isDeepData(header.type()))
        return {{}, "holds deep pixels, which are not supported"};
    const std::optional<Channels> channels = ReadChannels(header.channels());
    if (!channels) return {{}, "has subsampled channels, which are not supported"};
    const Imath::Box2i window = header.dataWindow();
    const double width = double(window.max.x) - window.min.x + 1;
    const double height = double(window.max.y) - window.min.y + 1;
    if (auto reason = Implausible(width, height, double(channels->names.size()),
                                  channels->bitsPerPixel, kMaxRatio, bytes.size()))
        return {{}, *reason};

    Image image({int(width), int(height)}, channels->names);
    const size_t pixelBytes = channels->names.size() * sizeof(float);
    Imf::FrameBuffer frame;
    for (size_t c = 0; c < channels->names.size(); ++c)
        frame.insert(channels->names[c],
                     Imf::Slice::Make(Imf::FLOAT, image.Data().data() + c, window.min,
                                      int64_t(width), int64_t(height), pixelBytes));
    Imf::InputPart part(file, 0);
    part.setFrameBuffer(frame);
    part.readPixels(window.min.y, window.max.y);
    image.metadata = ReadMetadata(header);
    image.metadata.unread = UnreadParts(file);
    image.metadata.storedAs = channels->type == Imf::HALF    ? "half"
                              : channels->type == Imf::FLOAT ? "float"
                                                             : "uint";
    return {std::move(image), {}};
}

OrError<ExrWords> DecodeExrWords(std::string_view bytes, const std::string &part) {
    ExrInput stream(bytes);
    Imf::MultiPartInputFile file(stream, Imf::globalThreadCount(), false);
    int number = 0;
    while (number < file.parts() &&
           !(file.header(number).hasName() && file.header(number).name() == part))
        ++number;
    ExrWords words;
    words.name = part;
    if (number == file.parts()) return {words, {}};
    const Imf::Header &header = file.header(number);
    const Imath::Box2i window = header.dataWindow();
    const double width = double(window.max.x) - window.min.x + 1;
    const double height = double(window.max.y) - window.min.y + 1;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
        if (c.channel().type != Imf::UINT || c.channel().xSampling != 1 ||
            c.channel().ySampling != 1)
            return {{}, fmt::format("has a part \"{}\" that does not hold whole numbers", part)};
        ++words.perPixel;
    }
    if (const auto why = Implausible(width, height, double(words.perPixel),
                                     32. * double(words.perPixel), kMaxRatio, bytes.size()))
        return {{}, *why};
    words.values.resize(size_t(width * height) * words.perPixel);
    Imf::FrameBuffer frame;
    size_t i = 0;  // channels come in the order of their names
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c, ++i)
        frame.insert(c.name(), Imf::Slice::Make(Imf::UINT, words.values.data() + i, window.min,
                                                int64_t(width), int64_t(height),
                                                sizeof(uint32_t) * words.perPixel));
    Imf::InputPart input(file, number);
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
    for (auto a = header.begin(); a != header.end(); ++a)
        if (const auto *text = dynamic_cast<const Imf::StringAttribute *>(&a.attribute()))
            words.strings[a.name()] = text->value();
    return {std::move(words), {}};
}

}  // namespace pbrt
