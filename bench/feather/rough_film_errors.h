#pragma once

#include <string>

namespace pbrt::bench {

/// Errors of a film of varying thickness against the mean itself, found by brute force, as CSV.
///
/// Rows of the kind "reflectance": unpolarised, of keratin films of 100 to 2000 nm at 380 to 780 nm
/// and the angles of incidence from `from` to `to` (degrees), whose standard deviation is uniform
/// up to `deviation` (nm): mean, and rms and largest error. Rows of the kinds "return, as rendered"
/// and "return, reference": TRT's T_s T_s + T_p T_p of films of 400 to 800 nm of just that
/// deviation, both directions distributed as their cosine: mean, mean error and rms error.
std::string RoughFilmCsv();

}  // namespace pbrt::bench
