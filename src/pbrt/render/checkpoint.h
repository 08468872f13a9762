#pragma once

#include <optional>
#include <string>

#include "pbrt/render/identity.h"
#include "pbrt/render/render_state.h"

namespace pbrt {

// A checkpoint is a file with all that a stopped render needs to go on: the exact sums of each tile
// and how many samples are in them. As pieces that were not finished are left out, the rest gives
// the bits of a render that never stopped.
//
// The file: a mark, the identity of the render, times and counts, a record for each tile, and the
// digest of all before it; numbers as the processor has them.

/// The bytes of a checkpoint of the state as it is now. The render goes on meanwhile, but for the
/// time it takes to copy the sums.
std::string MakeCheckpoint(const RenderIdentity &identity, const RenderState &state);

/// Puts a checkpoint into a state that is new. The reason why not: the file cannot be read, is none
/// or damaged, or is of another render than `identity`; then the state is as before.
std::optional<std::string> ReadCheckpoint(const std::string &fileName,
                                          const RenderIdentity &identity, RenderState *state);

}  // namespace pbrt
