#pragma once

#include "pbrt/feather/barbule.h"
#include "pbrt/feather/pigment.h"

namespace pbrt::bsdftool {

/// Integrates TRT so finely that only edges of what is seen are left as error: rms 3e-6 of the mean
/// for films up to 2 um, 5 ms per pair of directions.
using OracleQuadrature = feather::Converged<16, 8>;

}  // namespace pbrt::bsdftool
