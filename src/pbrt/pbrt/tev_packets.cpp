#include "pbrt/pbrt/tev_packets.h"

#include <bit>
#include <cstdint>

namespace pbrt::program::tev {
namespace {

class Packet {
  public:
    explicit Packet(Kind kind) : bytes(4, '\0') {
        Put(char(kind));
        Put('\0');  // whether the viewer is to come to the front
    }
    void Put(char c) { bytes += c; }
    void Put(uint32_t x) {
        for (int i = 0; i < 4; ++i)
            Put(char(x >> (8 * i)));
    }
    void Put(int x) { Put(uint32_t(x)); }
    void Put(float x) { Put(std::bit_cast<uint32_t>(x)); }
    void Put(std::string_view text) { bytes.append(text).push_back('\0'); }

    /// With its length in the first four bytes.
    std::string Finish() {
        for (size_t i = 0; i < 4; ++i)
            bytes[i] = char(uint32_t(bytes.size()) >> (8 * i));
        return std::move(bytes);
    }

  private:
    std::string bytes;
};

}  // namespace

std::string CreateImage(std::string_view name, Point2i size,
                        std::span<const std::string_view> channels) {
    Packet packet(Kind::CreateImage);
    packet.Put(name);
    packet.Put(size.x);
    packet.Put(size.y);
    packet.Put(int(channels.size()));
    for (const std::string_view channel : channels)
        packet.Put(channel);
    return packet.Finish();
}

std::string UpdateImage(std::string_view name, std::string_view channel, Point2i corner,
                        Point2i size, std::span<const float> values) {
    Packet packet(Kind::UpdateImage);
    packet.Put(name);
    packet.Put(channel);
    for (const int x : {corner.x, corner.y, size.x, size.y})
        packet.Put(x);
    for (const float value : values)
        packet.Put(value);
    return packet.Finish();
}

}  // namespace pbrt::program::tev
