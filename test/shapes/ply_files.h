#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "support/gzipped.h"

namespace pbrt {

enum class PlyKind { Ascii, Little, Big };

/// Writes PLY files of any kind, number by number.
class PlyWriter {
  public:
    explicit PlyWriter(PlyKind kind) : kind(kind) {
        const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
        text = std::string("ply\nformat ") + names[int(kind)] + " 1.0\ncomment by a test\n";
    }
    void Line(const std::string &line) { text += line + "\n"; }

    template <typename T>
    void Put(T value) {
        if (kind == PlyKind::Ascii) {
            char word[40];
            const bool isFloat = std::is_floating_point_v<T>;
            std::snprintf(word, sizeof word, isFloat ? "%.9g " : "%.0f ", double(value));
            text += word;
            return;
        }
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        const bool reversed =
            (kind == PlyKind::Big) == (std::endian::native == std::endian::little);
        for (size_t i = 0; i < sizeof(T); ++i)
            text += bytes[reversed ? sizeof(T) - 1 - i : i];
    }
    void EndRow() {
        if (kind == PlyKind::Ascii) text += "\n";
    }
    const std::string &Text() const { return text; }

  private:
    PlyKind kind;
    std::string text;
};

}  // namespace pbrt
