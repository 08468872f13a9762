#pragma once

#include <optional>
#include <string_view>

namespace pbrt::cli {

/// While one lives, the first SIGINT, SIGTERM or SIGHUP is only noted, and interrupts a call that
/// waits, as for the reader of a pipe; a second one ends the program whatever it does. A SIGHUP
/// that is ignored, as under nohup, stays so.
class Interrupts {
  public:
    Interrupts();
    ~Interrupts();
    Interrupts(const Interrupts &) = delete;
    Interrupts &operator=(const Interrupts &) = delete;

    struct Caught {
        std::string_view name;  ///< "SIGINT" ...
        int exitCode;           ///< 128 and the number, as shells have it
    };
    std::optional<Caught> First() const;
};

}  // namespace pbrt::cli
