#pragma once

#include <unistd.h>

namespace pbrt {

/// A file descriptor that closes itself; -1: none.
struct Descriptor {
    int fd = -1;
    explicit Descriptor(int fd) : fd(fd) {}
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;
    ~Descriptor() {
        if (fd >= 0) close(fd);
    }
};

}  // namespace pbrt
