#pragma once

#include <Iex.h>
#include <ImfIO.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace pbrt {

/// OpenEXR's view of bytes in memory.
class ExrInput : public Imf::IStream {
  public:
    explicit ExrInput(std::string_view bytes) : IStream("picture"), bytes(bytes) {}
    /// False where these were the last bytes, as OpenEXR wants it.
    bool read(char out[], int n) override {
        if (n < 0 || position > bytes.size() || size_t(n) > bytes.size() - position)
            throw Iex::InputExc("it ends too early");
        std::memcpy(out, bytes.data() + position, n);
        position += n;
        return position < bytes.size();
    }
    uint64_t tellg() override { return position; }
    void seekg(uint64_t p) override { position = p; }

  private:
    std::string_view bytes;
    uint64_t position = 0;
};

/// Grows as OpenEXR writes.
class ExrOutput : public Imf::OStream {
  public:
    ExrOutput() : OStream("picture") {}
    void write(const char in[], int n) override {
        if (position + n > bytes.size()) bytes.resize(position + n);
        std::memcpy(bytes.data() + position, in, n);
        position += n;
    }
    uint64_t tellp() override { return position; }
    void seekp(uint64_t p) override { position = p; }
    std::string &Bytes() { return bytes; }

  private:
    std::string bytes;
    uint64_t position = 0;
};

}  // namespace pbrt
