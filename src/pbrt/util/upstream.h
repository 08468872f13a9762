#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pbrt {

/// A name that pbrt-v4 knows (docs/PBRT_FORMAT.md) and nothing here answers to, unless a plug-in of
/// that name has been added since: then the row has no effect and may go.
struct UpstreamName {
    std::string_view kind;    ///< as in messages; parameters: whose, as in `material "diffuse"`
    std::string_view name;    ///< of options the letters and digits alone
    std::string_view advice;  ///< what to do instead, a sentence without its full stop, or empty
};

std::span<const UpstreamName> NotBuiltHere();

/// For messages: `pbrt-v4 has it; not built here. Use "x"`, or nothing where pbrt-v4 has no such
/// name either.
std::string PbrtHasIt(std::string_view kind, std::string_view name);

/// A name of pbrt-v3 (or older) and what pbrt-v4 calls it, as its `--upgrade` does (PBRT_FORMAT
/// 3.1).
struct OldName {
    std::string_view kind;  ///< as in messages; "parameter" for those of all plug-ins
    std::string_view was;
    std::string_view is;  ///< empty: pbrt-v4 does without
};
/// For messages: `pbrt-v4 calls it "x"`, and of what is not built here, that too.
std::string CalledNow(const OldName &old);
/// nullptr where the name is none of these, as where pbrt-v4 has it, too.
const OldName *FindOldName(std::string_view kind, std::string_view name);

}  // namespace pbrt
