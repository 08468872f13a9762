// Shows that the model compiles alone: no include path, nothing but the standard library.

#include "../simd/math.h"
#include "../simd/permute.h"
#include "../simd/simd.h"
#include "../simd/trig.h"
#include "arc.h"
#include "barbule.h"
#include "bend.h"
#include "direction.h"
#include "dispersion.h"
#include "facets.h"
#include "fields.h"
#include "gap.h"
#include "params.h"
#include "pigment.h"
#include "pigment_fast.h"
#include "pigment_nodes.h"
#include "pigment_rule.h"
#include "pigment_x16.h"
#include "quadrature.h"
#include "rough_film.h"
#include "row.h"
#include "thin_film.h"
#include "units.h"
#include "vane.h"
#include "view.h"

namespace pbrt::feather {

template struct Film<float>;
template struct Film<double>;
template struct Arc<float>;
template struct Arc<double>;
template class Row<float>;
template class Row<double>;
template class Bend<float>;
template class Bend<double>;
template class Barbule<float, 4>;
template class Barbule<double, 4>;
template class Barbule<double, 4, Converged<16, 32>>;
using Sixteen = FloatX16;
template std::array<Sixteen, 4> Barbule<Sixteen, 4>::f(const View<Sixteen> &,
                                                       const Direction<Sixteen> &) const;
template Sixteen Barbule<Sixteen, 4>::PDF(const View<Sixteen> &, const Direction<Sixteen> &) const;

static_assert([] {
    for (const FloatParam &p : kParams)
        if (!p.Legal(p.def)) return false;
    return true;
}());

}  // namespace pbrt::feather
