// The curves of S-fig.2b as CSV on standard output: reflectance of a flat film and of tubes of 40
// and 4 um, against the angle in degrees between the light's way in and its way out.

#include <cstdio>

#include "oracle/curved_film.h"

int main() {
    using namespace pbrt::oracle;
    const AiryFilm film{520, 650, 1.532 + 5890.0 / (520 * 520)};  // nm; keratin
    std::puts("angle,flat,radius_40um,radius_4um");
    for (int tenths = 0; tenths < 1800; tenths += 5) {
        const double angle = tenths * std::numbers::pi / 1800;
        std::printf("%.1f,%.6f,%.6f,%.6f\n", tenths / 10.0,
                    Unpolarised<AirySum>(film, std::cos(angle / 2)).r,
                    Reflectance(CurvedFilm{film, 40e3}, angle),
                    Reflectance(CurvedFilm{film, 4e3}, angle));
    }
}
