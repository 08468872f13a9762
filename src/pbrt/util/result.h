#pragma once

#include <optional>
#include <string>

namespace pbrt {

/// Either a value or the reason why there is none: a sentence for the user, file name included.
template <typename T>
struct OrError {
    std::optional<T> value;
    std::string error;
    explicit operator bool() const { return value.has_value(); }
};

}  // namespace pbrt
