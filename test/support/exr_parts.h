#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>

#include <string>
#include <vector>

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Writes an EXR file with a part of that size for each name; R, G and B are 1 in the first part, 2
/// in the second and so on.
inline void WriteExrParts(const std::string &path, const std::vector<std::string> &names,
                          Point2i size) {
    std::vector<Imf::Header> headers(names.size(), Imf::Header(size.x, size.y));
    for (size_t i = 0; i < names.size(); ++i) {
        headers[i].setName(names[i]);
        headers[i].setType(Imf::SCANLINEIMAGE);
        for (const char *channel : {"R", "G", "B"})
            headers[i].channels().insert(channel, Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
    for (size_t i = 0; i < names.size(); ++i) {
        const std::vector<float> values(size_t(size.x) * size.y, float(i + 1));
        Imf::FrameBuffer frame;
        for (const char *channel : {"R", "G", "B"})
            frame.insert(channel,
                         Imf::Slice::Make(Imf::FLOAT, values.data(), headers[i].dataWindow()));
        Imf::OutputPart part(file, int(i));
        part.setFrameBuffer(frame);
        part.writePixels(size.y);
    }
}

}  // namespace pbrt
