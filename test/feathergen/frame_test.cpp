// The material's frame on a grown feather, as rays find it, against the geometry it stands for.

#include "grow_test.h"
#include "pbrt/feathergen/vane_grid.h"
#include "pbrt/materials/materials.h"
#include "pbrt/util/rng.h"

namespace pbrt::feathergen {
namespace {

/// What a ray straight down onto a place of the vane meets.
struct Met {
    SurfaceInteraction sp;
    Frame frame;
};

class Frames : public Grown {
  protected:
    void Grow(const std::vector<std::string> &settings) {
        std::vector<std::string> args{"--seed", "5", "--out", Path("out")};
        std::string problem;
        Parameters p = PresetNamed("rock-dove-neck", &problem);
        for (const std::string &s : settings) {
            args.insert(args.end(), {"--set", s});
            const size_t equals = s.find('=');
            ASSERT_EQ(SetParameter(s.substr(0, equals), std::stod(s.substr(equals + 1)), &p), "");
        }
        Succeed(args);
        feather.emplace(p, 5);
        world = Scene("out/feather.pbrt");
        ASSERT_TRUE(world);
    }
    /// The vane at a place of a bank, found from a little above it; nothing where other parts stand
    /// in the way.
    std::optional<Met> Meet(const VanePoint &at, int bankIndex) const {
        const Vector3f n = Rounded(at.Normal());
        return Meet(*world, {Rounded(at.p) + 0.02f * n, -n, 0.04f}, bankIndex);
    }
    std::optional<Met> Meet(const RenderScene &in, const Ray &ray, int bankIndex) const {
        Hit hit;
        if (!in.accel->Intersect(ray, &hit)) return {};
        const Geometry &geometry = in.geometries[hit.geometry];
        const auto *vane =
            std::get_if<FeatherBarbuleMaterial>(&in.materials.Data()[geometry.material]);
        if (!vane) return {};
        Met met{in.SurfaceAt(hit, ray), {}};
        const VaneGrid grid(*feather);
        if (met.sp.faceIndex / (grid.nAlong * grid.nAcross) != bankIndex) return {};
        met.frame = vane->TurnFrame(met.sp.ShadingFrame(), in.TextureContext(met.sp));
        return met;
    }
    /// A random place of the vane, and its bank's number.
    std::pair<VanePoint, int> Place(Rng &rng) const {
        const auto index = int(rng.Below(uint32_t(feather->barbs.size())));
        const double u = 0.02 + 0.96 * double(rng.Uniform());
        const Bank bank = rng.Below(2) ? Bank::Right : Bank::Left;
        const double v = (0.05 + 0.9 * double(rng.Uniform())) * (bank == Bank::Left ? 1 : -1);
        return {feather->barbs[size_t(index)].Surface(feather->parameters, u, v),
                VaneGrid(*feather).BankIndex(index, bank)};
    }

    std::optional<Feather> feather;
    std::unique_ptr<RenderScene> world;
};

/// The analytic frame: z outwards; y along the barbules, which stand at `span` to the barb's
/// tangent; the right bank mirrors the left one, so that its y points to the ramus.
Frame Expected(const VanePoint &at, double span, Bank bank) {
    const Vec3d z = at.Normal();
    const Vec3d along = Normalize(at.dpdu), left = Cross(z, along);
    const double side = bank == Bank::Left ? 1 : -1;
    const Vec3d y = (side * std::cos(span)) * along + std::sin(span) * left;
    return {Rounded(Cross(y, z)), Rounded(y), Rounded(z)};
}

TEST_F(Frames, AlongTheBarbulesAndOutwardOnBothBanks) {
    Grow({});
    Rng rng(1);
    int met[2] = {0, 0};
    float worstY = 0, worstZ = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto [at, bankIndex] = Place(rng);
        const Bank bank = bankIndex % 2 == 0 ? Bank::Left : Bank::Right;
        const auto found = Meet(at, bankIndex);
        if (!found) continue;
        const Frame expected = Expected(at, feather->parameters.span, bank);
        EXPECT_LT(Length(found->sp.p - Rounded(at.p)), 5e-3f);
        ++met[int(bank)];
        worstY = std::max(worstY, AngleBetween(found->frame.y, expected.y));
        worstZ = std::max(worstZ, AngleBetween(found->frame.z, expected.z));
        EXPECT_GT(Dot(found->sp.n, expected.z), 0.9f) << "geometric normal outward";
    }
    EXPECT_GT(met[0], 3000);
    EXPECT_GT(met[1], 3000);
    // Quads are chords, off by half a quad's turn at their ends: 1/64 of curl and droop (0.75 rad)
    // and of the change of the edge's slope where barbs widen (width/2 0.18, length 5, 0.55 * 6 /
    // 0.2^2 a unit of u): 0.012 + 0.046. Normals are interpolated: half of that.
    EXPECT_LT(worstY, 0.06f);
    EXPECT_LT(worstZ, 0.03f);
}

TEST_F(Frames, OfAMirroredFeatherAreMirrored) {
    Grow({});
    const auto across = Scene("out/feather.pbrt", "Scale -1 1 1\n");
    const auto mirror = [](Vector3f v) { return Vector3f{-v.x, v.y, v.z}; };
    Rng rng(2);
    int met = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto [at, bankIndex] = Place(rng);
        const Vector3f n = Rounded(at.Normal());
        const Point3f o = Rounded(at.p) + 0.02f * n;
        const auto straight = Meet(*world, {o, -n, 0.04f}, bankIndex);
        const auto mirrored = Meet(*across, {mirror(o), mirror(-n), 0.04f}, bankIndex);
        ASSERT_EQ(straight.has_value(), mirrored.has_value());
        if (!straight) continue;
        ++met;
        // Some ten roundings in a frame.
        EXPECT_LT(AngleBetween(mirrored->frame.x, mirror(straight->frame.x)), 1e-5f);
        EXPECT_LT(AngleBetween(mirrored->frame.y, mirror(straight->frame.y)), 1e-5f);
        EXPECT_LT(AngleBetween(mirrored->frame.z, mirror(straight->frame.z)), 1e-5f);
    }
    EXPECT_GT(met, 1500);
}

}  // namespace
}  // namespace pbrt::feathergen
