#pragma once

#include <cstdio>
#include <cstdlib>

namespace pbrt {
/// Reports a broken promise of this program (never a user's mistake) and aborts.
[[noreturn]] inline void CheckFailed(const char *condition, const char *file, int line) {
    std::fprintf(stderr, "internal error: %s:%d: %s does not hold\n", file, line, condition);
    std::abort();
}
}  // namespace pbrt

#ifdef NDEBUG
#define DCHECK(condition) ((void)sizeof(condition))
#else
#define DCHECK(condition) \
    ((condition) ? void(0) : ::pbrt::CheckFailed(#condition, __FILE__, __LINE__))
#endif
