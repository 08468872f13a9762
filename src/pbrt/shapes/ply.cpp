#include "pbrt/shapes/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pbrt/shapes/ply_vertices.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

class PlyReader {
  public:
    PlyReader(const std::string &fileName, std::string *problem)
        : stream(fileName), problem(problem) {}

    std::optional<PlyMesh> Read() {
        const auto header = ReadPlyHeader(stream, problem);
        if (!header) return {};
        format = header->format;
        values.emplace(stream, format);
        bool hasVertices = false, hasFaces = false;
        for (const PlyElement &e : header->elements) {
            bool good;
            if (e.name == "vertex")
                good = hasVertices =
                    Promised(e) && HasRoom(e) && ReadPlyVertices(e, *values, &mesh, problem);
            else if (e.name == "face")
                good = hasFaces = Promised(e) && HasRoom(e) && Faces(e);
            else
                good = Promised(e) && SkipElement(e);
            if (!good) return {};
        }
        if (!hasVertices) return Fail("has no \"element vertex\"");
        if (!hasFaces) return Fail("has no \"element face\"");
        if (!CheckIndices(mesh.triangles) || !CheckIndices(mesh.quads)) return {};
        return std::move(mesh);
    }

  private:
    /// False where the file is too short for the element's rows.
    bool Promised(const PlyElement &e) {
        const uint64_t least = uint64_t(e.LeastRowBytes(format)) * e.count;
        // The last ascii number needs no space behind it.
        const uint64_t slack = format == PlyFormat::Ascii ? 1 : 0;
        if (least <= stream.BytesLeft() + slack) return true;
        Fail(fmt::format("is too short: {} x \"{}\" need at least {} bytes, {} are left{}", e.count,
                         e.name, least, stream.BytesLeft(),
                         stream.KnowsLength() ? "" : " at most when unpacked"));
        return false;
    }

    /// False where memory is too small for so many rows of vertices or faces.
    bool HasRoom(const PlyElement &e) {
        // Point, normal and uv, or the corners of a quad and a face index.
        const uint64_t rowBytes = std::max(sizeof(Point3f) + sizeof(Normal3f) + sizeof(Point2f),
                                           4 * sizeof(uint32_t) + sizeof(int));
        const auto why = WhyTooLarge(e.count * rowBytes);
        if (why) Fail(fmt::format("has {} x \"{}\": {}", e.count, e.name, *why));
        return !why;
    }

    bool Faces(const PlyElement &e) {
        int list = e.Find("vertex_indices");
        if (list < 0) list = e.Find("vertex_index");
        if (list < 0 || !e.properties[size_t(list)].IsList() ||
            !IsIntegral(e.properties[size_t(list)].type)) {
            Fail("its faces have no list of integers \"vertex_indices\"");
            return false;
        }
        const int face = e.Find("face_indices");
        const bool hasFaceIndices = face >= 0 && !e.properties[size_t(face)].IsList();
        mesh.triangles.reserve(3 * values->RowsAhead(e));
        const PlyProperty &p = e.properties[size_t(list)];
        const bool plain = e.properties.size() == 1 && format != PlyFormat::Ascii &&
                           PlySize(*p.countType) == 1 && PlySize(p.type) == 4;
        for (size_t done = 0; done < e.count;) {
            if (plain) done += TriangleRun(e.count - done);
            if (done == e.count) break;
            int faceIndex = 0;
            if (!FaceRow(e, list, hasFaceIndices ? face : -1, &faceIndex)) return EndsIn(e, done);
            if (hasFaceIndices) AddFaceIndex(faceIndex);
            ++done;
        }
        return true;
    }

    /// Takes as many triangles (one byte 3, then three 4-byte indices) as lie in the window.
    size_t TriangleRun(size_t most) {
        constexpr size_t kBytes = 1 + 3 * 4;
        if (!stream.Fill(kBytes)) return 0;
        const uint8_t *from = stream.Data();
        most = std::min(most, stream.Available() / kBytes);
        size_t n = 0;
        while (n < most && from[n * kBytes] == 3)
            ++n;
        const size_t before = mesh.triangles.size();
        mesh.triangles.resize(before + 3 * n);
        uint32_t *to = mesh.triangles.data() + before;
        const bool swap = values->Swaps();
        for (size_t i = 0; i < n; ++i, from += kBytes, to += 3)
            for (int k = 0; k < 3; ++k)
                to[k] = LoadValue<uint32_t>(from + 1 + 4 * k, swap);
        stream.Skip(n * kBytes);
        return n;
    }

    bool FaceRow(const PlyElement &e, int list, int face, int *faceIndex) {
        for (int i = 0; i < int(e.properties.size()); ++i) {
            const PlyProperty &p = e.properties[size_t(i)];
            double value;
            if (i == list) {
                if (!Face(p)) return false;
            } else {
                if (!values->NextOrSkipList(p, &value)) return false;
                if (i == face && !FaceIndex(value, faceIndex)) return false;
            }
        }
        return true;
    }

    /// False where the number is no int.
    bool FaceIndex(double value, int *index) {
        constexpr auto kLimits = std::numeric_limits<int>();
        if (value >= kLimits.min() && value <= kLimits.max() && value == std::floor(value)) {
            *index = int(value);
            return true;
        }
        misfit = fmt::format("{:g}", value);
        return false;
    }

    /// Adds the polygon whose corner list comes next.
    bool Face(const PlyProperty &p) {
        double count;
        if (!values->Next(*p.countType, &count)) return false;
        lastCorners = count >= 0 ? uint64_t(count) : 0;
        if (lastCorners != 3 && lastCorners != 4) {
            ++mesh.otherFaces;
            return values->Skip(p.type, lastCorners);
        }
        uint32_t corner[4];
        for (uint64_t i = 0; i < lastCorners; ++i) {
            double index;
            if (!values->Next(p.type, &index)) return false;
            // Out of range either way; CheckIndices tells. Corners are integral, so never NaN.
            corner[i] = uint32_t(int64_t(std::clamp(index, -2147483648., 4294967295.)));
        }
        if (lastCorners == 3)
            mesh.triangles.insert(mesh.triangles.end(), corner, corner + 3);
        else
            for (const int i : {0, 1, 3, 2})
                mesh.quads.push_back(corner[i]);
        return true;
    }

    void AddFaceIndex(int index) {
        if (lastCorners == 3) mesh.triangleFaces.push_back(index);
        if (lastCorners == 4) mesh.quadFaces.push_back(index);
    }

    bool CheckIndices(const std::vector<uint32_t> &indices) {
        const size_t count = mesh.p.size();
        uint32_t largest = 0;
        for (const uint32_t i : indices)
            largest = std::max(largest, i);
        if (indices.empty() || largest < count) return true;
        Fail(fmt::format("names vertex {}, but has {} vertices",
                         largest > 0x7fffffffu ? int64_t(int32_t(largest)) : int64_t(largest),
                         count));
        return false;
    }

    bool SkipElement(const PlyElement &e) {
        // Rows without bytes are skipped at once, however many the header promises.
        for (size_t row = 0; row < e.count && !e.properties.empty(); ++row)
            for (const PlyProperty &p : e.properties) {
                double value;
                if (!values->NextOrSkipList(p, &value)) return EndsIn(e, row);
            }
        return true;
    }

    bool EndsIn(const PlyElement &e, size_t row) {
        *problem = misfit.empty() ? values->ProblemIn(e, row)
                                  : fmt::format("face_indices of face {} is {}, no 32-bit integer",
                                                row, misfit);
        return false;
    }
    std::nullopt_t Fail(std::string message) {
        *problem = stream.Problem().empty() ? std::move(message) : stream.Problem();
        return std::nullopt;
    }

    PlyStream stream;
    std::string *problem;
    PlyFormat format = PlyFormat::Ascii;
    std::optional<PlyValues> values;
    PlyMesh mesh;
    uint64_t lastCorners = 0;
    std::string misfit;  ///< a face index that is no int
};

}  // namespace

std::optional<PlyMesh> ReadPly(const std::string &fileName, std::string *problem) {
    return PlyReader(fileName, problem).Read();
}

}  // namespace pbrt
