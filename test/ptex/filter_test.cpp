#include <cmath>

#include "pbrt/util/math.h"
#include "ptex/samples.h"

namespace pbrt {
namespace {

/// A plane of 3 x 3 quads whose (u, v) are turned by quarters: turns[i] for face i.
struct QuadPlane {
    int log2;
    std::array<int, 9> turns{};

    /// (u, v) of a face in the face's place in the plane, [0, 1]^2.
    static Point2f Turned(Point2f uv, int quarters) {
        for (; quarters > 0; --quarters)
            uv = {1 - uv.y, uv.x};
        return uv;
    }
    Point2f InPlane(int face, Point2f uv) const {
        const Point2f p = Turned(uv, turns[size_t(face)]);
        return {p.x + float(face % 3), p.y + float(face / 3)};
    }
    template <typename F>
    PtexContent Content(F f) const {
        PtexContent content;
        const int n = 1 << log2;
        for (int face = 0; face < 9; ++face) {
            PtexFace info{log2, log2};
            for (int e = 0; e < 4; ++e) {
                // The face's edge e lies on side e + turns of its place.
                const int side = (e + turns[size_t(face)]) % 4;
                const int x = face % 3 + (side == 1) - (side == 3);
                const int y = face / 3 + (side == 2) - (side == 0);
                if (x < 0 || x > 2 || y < 0 || y > 2) continue;
                const int other = 3 * y + x;
                info.neighbours[size_t(e)] = other;
                info.neighbourEdges[size_t(e)] = (side + 2 + 4 - turns[size_t(other)]) % 4;
            }
            content.faces.push_back(info);
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x)
                    content.texels.push_back(f(InPlane(
                        face, {(float(x) + 0.5f) / float(n), (float(y) + 0.5f) / float(n)})));
        }
        return content;
    }
};

QuadPlane RandomPlane(std::mt19937 &random) {
    QuadPlane plane{3};
    for (int &t : plane.turns)
        t = int(random() % 4);
    return plane;
}

float Unit(std::mt19937 &random) {
    return float(random() >> 8) * 0x1p-24f;
}

TEST(PtexFilter, LinearFunctionsPassEdgesOfAnyOrientation) {
    std::mt19937 random(1);
    const auto linear = [](Point2f p) { return 2 * p.x - 0.7f * p.y; };
    for (int i = 0; i < 100; ++i) {
        const QuadPlane plane = RandomPlane(random);
        const PtexTexture texture(PackPtex(plane.Content(linear)));
        for (int k = 0; k < 200; ++k) {
            const Point2f uv{Unit(random), Unit(random)};
            // The same width for both: the narrower side chooses the level.
            const float w = k % 4 == 0 ? 0 : Unit(random);
            EXPECT_NEAR(LookupAll(texture, 4, uv, {w, w})[0], linear(plane.InPlane(4, uv)), 1e-5f)
                << uv.x << " " << uv.y << " " << w;
        }
    }
}

TEST(PtexFilter, AnyWidthAveragesToOne) {
    std::mt19937 random(2);
    for (const PtexMesh mesh : {PtexMesh::Quad, PtexMesh::Triangle}) {
        // Differing resolutions; only one texel is unlike the others, so that none is constant.
        std::vector<PtexFace> faces{{4, 4, {1, 2, 0, 3}, {0, 1, 2, 0}},
                                    {2, 2, {0, -1, 2, -1}, {0, 0, 0, 0}},
                                    {6, 6, {1, 0, -1, -1}, {2, 1, 0, 0}},
                                    {0, 0, {-1, -1, -1, -1}, {}}};
        if (mesh == PtexMesh::Quad) faces[0].log2U = 7;
        PtexContent content = RandomPtex(mesh, PtexType::Float, 1, faces, 3);
        for (float &v : content.texels)
            v = 3;
        content.texels[5] = 3.0001f;
        const PtexTexture texture(PackPtex(content));
        for (int k = 0; k < 3000; ++k)
            EXPECT_NEAR(LookupAll(texture, k % 3, {Unit(random), Unit(random)},
                                  {2 * Unit(random) * Unit(random), Unit(random)})[0],
                        3, 1.1e-4f);
    }
}

TEST(PtexFilter, TheBoxIsTheMeanOfTheInterpolation) {
    std::mt19937 random(4);
    const PtexTexture texture(
        PackPtex(RandomPtex(PtexMesh::Quad, PtexType::UInt8, 1, {{4, 4}}, 5)));
    for (int k = 0; k < 30; ++k) {
        const Point2f uv{Unit(random), Unit(random)};
        // Less than 2 x 8 texels: the finest level.
        const Vector2f w{1.9f / 16 * Unit(random), 0.5f * Unit(random)};
        constexpr int n = 200;
        double sum = 0;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                // Beyond the border the texture goes on as it is there.
                const auto at = [&](float c, float width, int s) {
                    return c + width * ((float(s) + 0.5f) / n - 0.5f);
                };
                sum += LookupAll(texture, 0, {at(uv.x, w.x, i), at(uv.y, w.y, j)})[0];
            }
        // The midpoint rule's error: kinks of slope 1 per texel, 8 / 200 texels apart.
        EXPECT_NEAR(LookupAll(texture, 0, uv, w)[0], sum / (n * n), 5e-4);
    }
}

TEST(PtexFilter, WideLookupsApproachTheMean) {
    for (const PtexMesh mesh : {PtexMesh::Quad, PtexMesh::Triangle}) {
        PtexContent content = RandomPtex(mesh, PtexType::UInt16, 1, {{7, 7}}, 6);
        double mean = 0;
        for (const float v : content.texels)
            mean += v / double(content.texels.size());
        const PtexTexture texture(PackPtex(content));
        EXPECT_NEAR(LookupAll(texture, 0, {0.3f, 0.4f}, {1, 1})[0], mean, 1e-4);
        // Noise of standard deviation sqrt(1 / 12) over at least 12 x 12 texels: 3 sigma.
        EXPECT_NEAR(LookupAll(texture, 0, {0.3f, 0.4f}, {0.1f, 0.1f})[0], mean, 0.072);
    }
}

TEST(PtexFilter, FinerAndCoarserNeighboursMeet) {
    // Left 1 x 1, right 8 x 8 with columns 0..7 and above it a strip of 1 x 32.
    PtexContent content;
    content.faces = {{0, 0, {-1, 1, -1, -1}, {0, 3, 0, 0}},
                     {3, 3, {-1, -1, 2, 0}, {0, 0, 0, 1}},
                     {0, 5, {1, -1, -1, -1}, {2, 0, 0, 0}}};
    content.texels = {10};
    for (int i = 0; i < 64; ++i)
        content.texels.push_back(float(i % 8));
    for (int i = 0; i < 32; ++i)
        content.texels.push_back(float(i / 4) * 100);
    const PtexTexture texture(PackPtex(content));
    // On the edge: half the coarse texel, half the mean of the fine face or its first column.
    EXPECT_NEAR(LookupAll(texture, 0, {1, 0.5f})[0], (10 + 3.5f) / 2, 1e-5f);
    EXPECT_NEAR(LookupAll(texture, 1, {0, 0.5f})[0], (10 + 0) / 2.f, 1e-5f);
    // The strip's lowest four texels are 0; row 7 of the fine face is 0 to 7.
    EXPECT_NEAR(LookupAll(texture, 1, {0.4375f, 1})[0], 1.5f, 1e-5f);
    // Seen from the strip, the face below is one column of 32: its mean along u.
    EXPECT_NEAR(LookupAll(texture, 2, {0.5f, 0})[0], 3.5f / 2, 1e-5f);
}

TEST(PtexFilter, TrianglesMeetWhicheverWayTheyAreTurned) {
    // Face 0 and the face behind each of its edges, those turned in all ways: what is seen from
    // face 0 stays the same.
    std::mt19937 random(7);
    const int log2 = 3, n = 1 << log2;
    const auto height = [](float u, float v) { return std::sin(2 * u) + v * v; };
    // Barycentrics (opposite edges 0, 1, 2) of a neighbour's point become those of face 0.
    const auto inFace0 = [](int edge, int to, std::array<float, 3> b) {
        const auto at = [&](int i) { return b[size_t(i % 3)]; };
        std::array<float, 3> p;
        p[size_t(edge)] = -at(to);
        p[size_t((edge + 1) % 3)] = at(to + 2) + at(to);
        p[size_t((edge + 2) % 3)] = at(to + 1) + at(to);
        return p;
    };
    std::vector<std::vector<float>> seen;
    for (int turn = 0; turn < 3; ++turn) {
        PtexContent content;
        content.mesh = PtexMesh::Triangle;
        content.faces.resize(4, {log2, log2});
        const auto addTexels = [&](auto toFace0) {
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const bool upright = x + y < n;
                    const float u = upright ? float(x) + 1 / 3.f : float(n - 1 - y) + 2 / 3.f;
                    const float v = upright ? float(y) + 1 / 3.f : float(n - 1 - x) + 2 / 3.f;
                    const std::array<float, 3> p =
                        toFace0({v / float(n), 1 - (u + v) / float(n), u / float(n)});
                    content.texels.push_back(height(p[2], p[0]));
                }
        };
        addTexels([](std::array<float, 3> b) { return b; });
        for (int e = 0; e < 3; ++e) {
            const int to = (e + turn) % 3;
            content.faces[0].neighbours[size_t(e)] = e + 1;
            content.faces[0].neighbourEdges[size_t(e)] = to;
            content.faces[size_t(e) + 1].neighbours[size_t(to)] = 0;
            content.faces[size_t(e) + 1].neighbourEdges[size_t(to)] = e;
            addTexels([&](std::array<float, 3> b) { return inFace0(e, to, b); });
        }
        const PtexTexture texture(PackPtex(content));
        std::mt19937 points(8);
        seen.emplace_back();
        for (int k = 0; k < 300; ++k) {
            const float u = Unit(points), v = (1 - u) * Unit(points);
            seen.back().push_back(LookupAll(texture, 0, {u, v}, {0.2f, 0.1f})[0]);
            // Away from the corners the kernel sees a smooth function on all its sides.
            if (std::min({std::max(u, v), std::max(u, 1 - u - v), std::max(v, 1 - u - v)}) >
                0.45f) {
                EXPECT_NEAR(seen.back().back(), height(u, v), 0.03f) << u << " " << v;
            }
        }
    }
    for (int turn = 1; turn < 3; ++turn)
        for (size_t k = 0; k < seen[0].size(); ++k)
            EXPECT_NEAR(seen[size_t(turn)][k], seen[0][k], 1e-5f);
}

TEST(PtexFilter, SubfacesMeetOnlySubfaces) {
    PtexContent content = ConstantPtex(1, {1, 2, 3});
    content.faces[0].neighbours = {-1, 1, -1, -1};
    content.faces[0].neighbourEdges = {0, 3, 0, 0};
    content.faces[1].neighbours = {-1, 2, -1, 0};
    content.faces[1].neighbourEdges = {0, 3, 0, 1};
    content.faces[2].neighbours = {-1, -1, -1, 1};
    content.faces[2].neighbourEdges = {0, 0, 0, 1};
    PtexData data = PackPtex(content);
    data.neighbours[1].subface = data.neighbours[2].subface = true;
    const PtexTexture texture(std::move(data));
    EXPECT_EQ(LookupAll(texture, 0, {1, 0.5f})[0], 1);
    EXPECT_EQ(LookupAll(texture, 1, {0, 0.5f})[0], 2);
    EXPECT_EQ(LookupAll(texture, 1, {1, 0.5f})[0], 2.5f);
}

TEST(PtexFilter, OddArgumentsAreHarmless) {
    const PtexTexture quad = ReadPtexOrFail(kPtexData + "quad_float.ptx");
    const PtexTexture triangle = ReadPtexOrFail(kPtexData + "tri_u8.ptx");
    for (const int face : {-1, 4, 1 << 30})
        EXPECT_EQ(LookupAll(quad, face, {0.5f, 0.5f})[0], 0);
    EXPECT_EQ(LookupAll(quad, 1, {-3, 7})[0], LookupAll(quad, 1, {0, 1})[0]);
    EXPECT_EQ(LookupAll(quad, 1, {NAN, 1})[0], LookupAll(quad, 1, {0, 1})[0]);
    EXPECT_EQ(LookupAll(quad, 0, {0.1f, 0.2f}, {Infinity, NAN})[0],
              LookupAll(quad, 0, {0.1f, 0.2f}, {1, 0})[0]);
    EXPECT_EQ(LookupAll(triangle, 1, {0.6f, 0.8f})[0], LookupAll(triangle, 1, {0.6f, 0.4f})[0]);
}

}  // namespace
}  // namespace pbrt
