#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
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

/// Values of a picture as they go into the file.
class FilePixels {
  public:
    FilePixels(const Image &image, ExrPixels pixels)
        : image(image),
          isHalf(pixels == ExrPixels::Half),
          halves(isHalf ? ToHalf(image.Data()) : std::vector<Imath::half>()) {}

    void AddChannels(Imf::Header *header, Imf::FrameBuffer *frame) const {
        const Imf::PixelType type = isHalf ? Imf::HALF : Imf::FLOAT;
        const size_t bytes = isHalf ? sizeof(Imath::half) : sizeof(float);
        const char *const values = isHalf ? reinterpret_cast<const char *>(halves.data())
                                          : reinterpret_cast<const char *>(image.Data().data());
        const auto [width, height] = image.Resolution();
        for (int c = 0; c < image.NChannels(); ++c) {
            const std::string &name = image.ChannelNames()[c];
            header->channels().insert(name, Imf::Channel(type));
            frame->insert(name, Imf::Slice::Make(type, values + c * bytes, header->dataWindow().min,
                                                 width, height, bytes * image.NChannels()));
        }
    }

  private:
    const Image &image;
    bool isHalf;
    std::vector<Imath::half> halves;
};

/// Header and pixels of the part that holds the words.
void AddWords(const ExrWords &words, Point2i size, Imf::Header *header, Imf::FrameBuffer *frame) {
    const size_t bytes = sizeof(uint32_t) * words.perPixel;
    for (const auto &[name, text] : words.strings)
        header->insert(name, Imf::StringAttribute(text));
    for (size_t i = 0; i < words.perPixel; ++i) {
        const std::string name = fmt::format("{:05}", i);
        header->channels().insert(name, Imf::Channel(Imf::UINT));
        frame->insert(name, Imf::Slice::Make(Imf::UINT, words.values.data() + i,
                                             header->dataWindow().min, size.x, size.y, bytes));
    }
}

void WriteParts(Imf::Header *headers, const Imf::FrameBuffer *frames, int height,
                ExrOutput *stream) {
    Imf::MultiPartOutputFile file(*stream, headers, 2, true);
    for (int i = 0; i < 2; ++i) {
        Imf::OutputPart part(file, i);
        part.setFrameBuffer(frames[i]);
        part.writePixels(height);
    }
}

}  // namespace

OrError<std::string> EncodeExr(const Image &image, ExrPixels pixels, const ExrWords *words) {
    const auto [width, height] = image.Resolution();
    const auto &b = image.metadata.pixelBounds;
    if (b != std::array<int, 4>{} && (b[1] - b[0] != width || b[3] - b[2] != height))
        return {{}, "has pixel bounds that are not the size of the picture"};
    Imf::Header headers[2]{MakeHeader(image), MakeHeader(image)};
    Imf::FrameBuffer frames[2];
    AddMetadata(&headers[0], image.metadata);
    const FilePixels filePixels(image, pixels);
    filePixels.AddChannels(&headers[0], &frames[0]);
    ExrOutput stream;
    if (words) {
        AddWords(*words, image.Resolution(), &headers[1], &frames[1]);
        headers[0].setName("picture");
        headers[1].setName(words->name);
        for (Imf::Header &header : headers)
            header.setType(Imf::SCANLINEIMAGE);
        WriteParts(headers, frames, height, &stream);
    } else {
        Imf::OutputFile file(stream, headers[0]);
        file.setFrameBuffer(frames[0]);
        file.writePixels(height);
    }  // the table of lines is written here
    return {std::move(stream.Bytes()), {}};
}

}  // namespace pbrt
