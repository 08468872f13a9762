#pragma once

#include <string>
#include <vector>

#include "pbrt/util/result.h"

namespace pbrt {

/// Wavelengths (nm, strictly increasing) and values, as Spectrum::PiecewiseLinear takes them.
struct SpectrumPoints {
    std::vector<float> lambda, values;
};

/// The same with the end values held out to 360 and 830 nm.
SpectrumPoints HoldingEnds(SpectrumPoints points);

/// Reads `lambda value` pairs separated by white space; `#` starts a comment up to the end of its
/// line. Errors: unreadable file, a word that is not a finite number, no or an odd number of
/// them, wavelengths that do not increase, none of them from 360 to 830 nm.
OrError<SpectrumPoints> ReadSpectrumFile(const std::string &fileName);

}  // namespace pbrt
