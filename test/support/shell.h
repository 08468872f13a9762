#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace pbrt {

/// How a command ended.
struct Outcome {
    int exitCode;      ///< -1: by a signal
    std::string said;  ///< what it wrote to both streams
};

/// Runs a command line of the shell.
inline Outcome Shell(const std::string &command) {
    Outcome outcome;
    FILE *const pipe = popen((command + " 2>&1").c_str(), "r");
    char buffer[4096];
    while (const size_t n = fread(buffer, 1, sizeof buffer, pipe))
        outcome.said.append(buffer, n);
    const int status = pclose(pipe);
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

}  // namespace pbrt
