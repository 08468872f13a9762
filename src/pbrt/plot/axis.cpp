#include "pbrt/plot/axis.h"

#include <cmath>

namespace pbrt::plot {

std::vector<double> Axis::Ticks(int count) const {
    const double rough = (hi - lo) / count, decade = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * decade;
    for (double s : {5.0, 2.0, 1.0})
        if (s * decade >= rough * 0.999) step = s * decade;
    std::vector<double> ticks;
    const double slack = step * 1e-6;
    for (double k = std::ceil((lo - slack) / step); k * step <= hi + slack; ++k)
        ticks.push_back(k * step + 0.0);  // no -0
    return ticks;
}

}  // namespace pbrt::plot
