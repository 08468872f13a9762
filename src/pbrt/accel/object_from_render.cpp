#include "pbrt/accel/object_from_render.h"

namespace pbrt {

ObjectFromRender::ObjectFromRender(const Transform &renderFromObject) {
    const Matrix4 &f = renderFromObject.Matrix();
    const Vector3d x{f[0][0], f[1][0], f[2][0]}, y{f[0][1], f[1][1], f[2][1]},
        z{f[0][2], f[1][2], f[2][2]}, t{f[0][3], f[1][3], f[2][3]};
    const Vector3d yz = Cross(y, z), zx = Cross(z, x), xy = Cross(x, y);
    const double invDet = 1 / Dot(x, yz);
    const Vector3d rows[3] = {yz * invDet, zx * invDet, xy * invDet};
    for (int i = 0; i < 3; ++i) {
        m[i][0] = rows[i].x;
        m[i][1] = rows[i].y;
        m[i][2] = rows[i].z;
        m[i][3] = -Dot(rows[i], t);
    }
}

}  // namespace pbrt
