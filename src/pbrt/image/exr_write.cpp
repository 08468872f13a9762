#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>

#include "pbrt/image/codecs.h"
#include "pbrt/image/exr_stream.h"

namespace pbrt {
namespace {

void AddMatrix(Imf::Header *header, const char *name,
               const std::optional<std::array<std::array<float, 4>, 4>> &m) {
    if (!m) return;
    Imath::M44f matrix;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            matrix[i][j] = (*m)[i][j];
    header->insert(name, Imf::M44fAttribute(matrix));
}

/// OpenEXR counts windows with both ends inside.
Imf::Header MakeHeader(const Image &image) {
    const ImageMetadata &metadata = image.metadata;
    const auto [width, height] = image.Resolution();
    const auto [x0, x1, y0, y1] = metadata.pixelBounds == std::array<int, 4>{}
                                      ? std::array<int, 4>{0, width, 0, height}
                                      : metadata.pixelBounds;
    const Point2i full = metadata.fullResolution == Point2i{}
                             ? Point2i{std::max(x1, 1), std::max(y1, 1)}
                             : metadata.fullResolution;
    const Imath::Box2i data({x0, y0}, {x1 - 1, y1 - 1});
    const Imath::Box2i display({0, 0}, {full.x - 1, full.y - 1});
    Imf::Header header(display, data);
    header.compression() = Imf::ZIP_COMPRESSION;
    return header;
}

void AddMetadata(Imf::Header *header, const ImageMetadata &metadata) {
    for (const auto &[name, text] : metadata.strings)
        header->insert(name, Imf::StringAttribute(text));
    if (metadata.chromaticities) {
        const auto &xy = *metadata.chromaticities;
        const auto point = [&](int i) { return Imath::V2f(xy[i][0], xy[i][1]); };
        header->insert("chromaticities", Imf::ChromaticitiesAttribute(Imf::Chromaticities(
                                             point(0), point(1), point(2), point(3))));
    }
    if (metadata.renderTimeSeconds)
        header->insert("renderTimeSeconds", Imf::FloatAttribute(*metadata.renderTimeSeconds));
    if (metadata.samplesPerPixel)
        header->insert("samplesPerPixel", Imf::IntAttribute(*metadata.samplesPerPixel));
    if (metadata.mse) header->insert("MSE", Imf::FloatAttribute(*metadata.mse));
    AddMatrix(header, "worldToCamera", metadata.cameraFromWorld);
    AddMatrix(header, "worldToNDC", metadata.ndcFromWorld);
}

std::vector<Imath::half> ToHalf(const std::vector<float> &values) {
    constexpr float kLargest = 65504;
    std::vector<Imath::half> halves(values.size());
    for (size_t i = 0; i < values.size(); ++i)  // NaN fails both comparisons of clamp and stays
        halves[i] = Imath::half(std::clamp(values[i], -kLargest, kLargest));
    return halves;
}

}  // namespace

OrError<std::string> EncodeExr(const Image &image, ExrPixels pixels) {
    const auto [width, height] = image.Resolution();
    const auto &b = image.metadata.pixelBounds;
    if (b != std::array<int, 4>{} && (b[1] - b[0] != width || b[3] - b[2] != height))
        return {{}, "has pixel bounds that are not the size of the picture"};
    Imf::Header header = MakeHeader(image);
    AddMetadata(&header, image.metadata);
    const bool isHalf = pixels == ExrPixels::Half;
    const Imf::PixelType type = isHalf ? Imf::HALF : Imf::FLOAT;
    const size_t valueBytes = isHalf ? sizeof(Imath::half) : sizeof(float);
    const std::vector<Imath::half> halves =
        isHalf ? ToHalf(image.Data()) : std::vector<Imath::half>();
    const char *values = isHalf ? reinterpret_cast<const char *>(halves.data())
                                : reinterpret_cast<const char *>(image.Data().data());
    Imf::FrameBuffer frame;
    for (int c = 0; c < image.NChannels(); ++c) {
        const std::string &name = image.ChannelNames()[c];
        header.channels().insert(name, Imf::Channel(type));
        frame.insert(name, Imf::Slice::Make(type, values + c * valueBytes, header.dataWindow().min,
                                            width, height, valueBytes * image.NChannels()));
    }
    ExrOutput stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(height);
    }  // the table of lines is written here
    return {std::move(stream.Bytes()), {}};
}

}  // namespace pbrt
