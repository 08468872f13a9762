#include "pbrt/accel/world_sphere.h"

#include "pbrt/shapes/rounding.h"

namespace pbrt {

namespace {

/// Largest cosine that counts as a right angle's: Rotate's is 6e-17, for pi is rounded. It moves
/// points along the normal by 2e-15 of the radius at most, where PlaceQuadric grants 4e-15.
constexpr float kRightAngle = 1e-15f;

/// True if an axis of the map lies along one of space, as long as `scale`.
bool IsStraight(Vector3f axis, float scale) {
    const Vector3f a = Abs(axis);
    int along = 0, across = 0;
    for (int i = 0; i < 3; ++i) {
        along += a[i] == scale;
        across += a[i] <= kRightAngle * scale;
    }
    return along == 1 && across == 2;
}

}  // namespace

std::optional<WorldSphere> WorldSphere::Of(const Shape &shape) {
    const auto *const sphere = std::get_if<Sphere>(&shape);
    if (!sphere || !sphere->IsFull()) return {};
    const Matrix4 &m = sphere->renderFromObject.Matrix();
    const float scale = MaxComponent(Abs(Vector3f{m[0][0], m[0][1], m[0][2]}));
    for (int i = 0; i < 3; ++i)
        for (const Vector3f &axis :
             {Vector3f{m[i][0], m[i][1], m[i][2]}, Vector3f{m[0][i], m[1][i], m[2][i]}})
            if (!IsStraight(axis, scale)) return {};
    return WorldSphere{{m[0][3], m[1][3], m[2][3]}, double(scale) * double(sphere->radius)};
}

namespace {

/// First hit of a ray with a sphere in (0, tMax]; t has no meaning where there is none.
template <typename T>
struct SphereHit {
    MaskFor<T> hit;
    T t;
};

/// For T one double or eight; o: from the sphere's center. As CrossRadius in shapes/quadric.h,
/// but of the two roots only the wanted one is computed.
template <typename T>
inline SphereHit<T> Intersect(T radius, Vec3<T> o, Vec3<T> d, T tMax) {
    const T r2 = radius * radius;
    const T a = Dot(d, d), b = -Dot(o, d), c = Dot(o, o) - r2;
    const T discriminant = r2 * a - LengthSquared(Cross(o, d));
    MaskFor<T> hit = (discriminant >= 0) & ((c <= 0) | (b > 0));
    if (!Any(hit)) return {hit, T{}};
    const T root = Sqrt(discriminant);
    // By comparison, not by its sign bit: from the center b may be -0.
    const T q = b + Select(b < 0, T(-root), root);
    const auto entering = (c > 0) | (b < 0);
    const T t = Select(entering, c, q) / Select(entering, q, a);
    hit = hit & (t > 0) & (t <= tMax);
    return {hit, t};
}

/// First hit of one ray of a packet of any width.
bool MeetsRay(const WorldSphere &ball, RTCRayN *r, unsigned n, unsigned i, double *t) {
    const Vector3d center = ToDouble(ball.center);
    const Vector3d o{RTCRayN_org_x(r, n, i), RTCRayN_org_y(r, n, i), RTCRayN_org_z(r, n, i)};
    const Vector3d d{RTCRayN_dir_x(r, n, i), RTCRayN_dir_y(r, n, i), RTCRayN_dir_z(r, n, i)};
    const auto met = Intersect<double>(ball.radius, o - center, d, RTCRayN_tfar(r, n, i));
    *t = met.t;
    return met.hit;
}

/// Lanes that a test in float cannot rule out: its terms are off by less than 16 roundings of
/// |o|^2 |d|^2, and twice that is granted.
LaneBits MayMeet(const WorldSphere &ball, const RTCRay16 &r) {
    const Vector3fX16 d{LoadX16(r.dir_x), LoadX16(r.dir_y), LoadX16(r.dir_z)};
    const Vector3fX16 o{LoadX16(r.org_x) - ball.center.x, LoadX16(r.org_y) - ball.center.y,
                        LoadX16(r.org_z) - ball.center.z};
    const FloatX16 b = -Dot(o, d);
    const FloatX16 outside =
        Dot(o, o) * (1 - 2e-6f) - float(ball.radius * ball.radius) * (1 + 1e-6f);
    const MaskX16 misses = (b * b < Dot(d, d) * outside) | ((b < 0) & (outside > 0));
    return ~BitsOf(misses);
}

/// Eight rays of a packet in double.
SphereHit<DoubleX8> IntersectHalf(const WorldSphere &ball, const RTCRay16 &r, int first) {
    const auto load = [first](const float *from) {
        return Convert<double>(Simd<float, 8>::Load(from + first));
    };
    const Vec3<DoubleX8> o{load(r.org_x) - double(ball.center.x),
                           load(r.org_y) - double(ball.center.y),
                           load(r.org_z) - double(ball.center.z)};
    const Vec3<DoubleX8> d{load(r.dir_x), load(r.dir_y), load(r.dir_z)};
    return Intersect<DoubleX8>(ball.radius, o, d, load(r.tfar));
}

/// First hits of a packet's rays with the sphere.
SphereHit<FloatX16> IntersectPacket(const WorldSphere &ball, const RTCRay16 &r, LaneBits lanes) {
    LaneBits hit = 0;
    float t[kPacketSize] = {};
    for (int first = 0; first < kPacketSize; first += 8) {
        if ((lanes >> first & 0xff) == 0) continue;
        const SphereHit<DoubleX8> half = IntersectHalf(ball, r, first);
        hit |= BitsOf(half.hit) << first;
        Store(Convert<float>(half.t), t + first);
    }
    return {MaskOf(hit & lanes), LoadX16(t)};
}

LaneBits ValidLanes(const int *valid) {
    return BitsOf(LoadX16(valid) != 0);
}

/// Calls one(lane, t) for each ray that meets the sphere, or many(met) for all of a packet.
template <typename One, typename Many>
void ForEachThatMeets(const WorldSphere &ball, const int *valid, RTCRayN *rays, unsigned n, One one,
                      Many many) {
    const auto tryOne = [&](unsigned i) {
        double t;
        if (MeetsRay(ball, rays, n, i, &t)) one(i, float(t));
    };
    if (n != kPacketSize) {
        for (unsigned i = 0; i < n; ++i)
            if (valid[i] != 0) tryOne(i);
        return;
    }
    const auto &packet = *reinterpret_cast<const RTCRay16 *>(rays);
    LaneBits lanes = ValidLanes(valid);
    if (std::has_single_bit(lanes)) return tryOne(unsigned(std::countr_zero(lanes)));
    lanes &= MayMeet(ball, packet);
    if (std::popcount(lanes) <= 2) return ForEachLane(lanes, [&](int i) { tryOne(unsigned(i)); });
    many(IntersectPacket(ball, packet, lanes));
}

}  // namespace

void IntersectBall(const WorldSphere &ball, uint32_t localId,
                   const RTCIntersectFunctionNArguments *args) {
    const unsigned n = args->N, instance = args->context->instID[0];
    RTCRayN *const rays = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN *const hits = RTCRayHitN_HitN(args->rayhit, n);
    const auto one = [&](unsigned i, float t) {
        RTCRayN_tfar(rays, n, i) = t;
        RTCHitN_u(hits, n, i) = RTCHitN_v(hits, n, i) = 0;
        RTCHitN_primID(hits, n, i) = 0;
        RTCHitN_geomID(hits, n, i) = localId;
        RTCHitN_instID(hits, n, i, 0) = instance;
    };
    const auto many = [&](const SphereHit<FloatX16> &met) {
        auto &packet = *reinterpret_cast<RTCRayHit16 *>(args->rayhit);
        const auto set = [&](auto value, auto *to) {
            Store(Select(met.hit, value, LoadX16(to)), to);
        };
        set(met.t, packet.ray.tfar);
        set(FloatX16(0), packet.hit.u);
        set(FloatX16(0), packet.hit.v);
        set(UintX16(0), packet.hit.primID);
        set(UintX16(localId), packet.hit.geomID);
        set(UintX16(instance), packet.hit.instID[0]);
    };
    ForEachThatMeets(ball, args->valid, rays, n, one, many);
}

void OccludedBall(const WorldSphere &ball, const RTCOccludedFunctionNArguments *args) {
    const auto one = [&](unsigned i, float) { RTCRayN_tfar(args->ray, args->N, i) = -Infinity; };
    const auto many = [&](const SphereHit<FloatX16> &met) {
        float *const tfar = reinterpret_cast<RTCRay16 *>(args->ray)->tfar;
        Store(Select(met.hit, -Infinity, LoadX16(tfar)), tfar);
    };
    ForEachThatMeets(ball, args->valid, args->ray, args->N, one, many);
}

}  // namespace pbrt
