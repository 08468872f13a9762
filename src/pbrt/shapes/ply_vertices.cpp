#include "pbrt/shapes/ply_vertices.h"

#include <algorithm>
#include <array>

#include "pbrt/base/ray_tracer.h"

namespace pbrt {
namespace {

constexpr size_t kRowsAtOnce = 4096;

/// A property and where its number goes: the k-th of a vertex in an array.
struct Column {
    int property;
    int array;  ///< 0 p, 1 n, 2 uv
    int k;
};
constexpr size_t kStride[3] = {3, 3, 2};

/// Destinations of the next row's numbers, by array.
using Destinations = std::array<float *, 3>;

class VertexReader {
  public:
    VertexReader(const PlyElement &e, PlyValues &values, PlyMesh *mesh)
        : e(e), values(values), stream(values.Stream()), mesh(mesh) {}

    bool FindColumns(std::string *problem) {
        if (!Find({"x", "y", "z"}, 0)) {
            *problem = "its vertices have no x, y and z";
            return false;
        }
        mesh->p.reserve(values.RowsAhead(e) + kPointsBehindLast);
        if (Find({"nx", "ny", "nz"}, 1)) mesh->n.reserve(values.RowsAhead(e));
        static constexpr std::array<std::array<std::string_view, 2>, 4> kUV{
            {{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};
        for (const auto &[u, v] : kUV)
            if (Find({u, v}, 2)) {
                mesh->uv.reserve(values.RowsAhead(e));
                break;
            }
        return true;
    }

    bool ReadRows(std::string *problem) {
        const bool inBlocks =
            values.Format() != PlyFormat::Ascii && !HasLists() && rowBytes <= PlyStream::kMostAhead;
        for (size_t done = 0; done < e.count;) {
            size_t rows = std::min(kRowsAtOnce, e.count - done);
            if (inBlocks) {
                if (!stream.Fill(rowBytes)) return Ends(done, problem);
                rows = std::min(rows, stream.Available() / rowBytes);
            }
            Destinations to = Grow(done, rows);
            if (inBlocks) {
                Block(rows, to);
            } else {
                for (size_t row = 0; row < rows; ++row)
                    if (!Row(row, to)) return Ends(done + row, problem);
            }
            done += rows;
        }
        return true;
    }

  private:
    /// Adds columns for the named properties if all are there as single numbers.
    bool Find(std::initializer_list<std::string_view> names, int array) {
        std::vector<Column> found;
        for (const std::string_view name : names) {
            const int i = e.Find(name);
            if (i < 0 || e.properties[size_t(i)].IsList()) return false;
            found.push_back({i, array, int(found.size())});
        }
        columns.insert(columns.end(), found.begin(), found.end());
        return true;
    }

    bool HasLists() const {
        return std::any_of(e.properties.begin(), e.properties.end(),
                           [](const PlyProperty &p) { return p.IsList(); });
    }

    Destinations Grow(size_t done, size_t rows) {
        Destinations to{};
        for (const Column &c : columns) {
            if (c.k != 0) continue;
            if (c.array == 0) mesh->p.resize(done + rows), to[0] = &mesh->p[done].x;
            if (c.array == 1) mesh->n.resize(done + rows), to[1] = &mesh->n[done].x;
            if (c.array == 2) mesh->uv.resize(done + rows), to[2] = &mesh->uv[done].x;
        }
        return to;
    }

    void Block(size_t rows, const Destinations &destinations) {
        for (const Column &c : columns) {
            size_t offset = 0;
            for (int i = 0; i < c.property; ++i)
                offset += PlySize(e.properties[size_t(i)].type);
            const PlyType type = e.properties[size_t(c.property)].type;
            const uint8_t *from = stream.Data() + offset;
            float *to = destinations[size_t(c.array)] + c.k;
            const size_t stride = kStride[c.array];
            const bool swap = values.Swaps();
            if (type == PlyType::Float32 && !swap)
                for (size_t i = 0; i < rows; ++i, from += rowBytes, to += stride)
                    *to = LoadValue<float>(from, false);
            else
                for (size_t i = 0; i < rows; ++i, from += rowBytes, to += stride)
                    *to = float(LoadValue(from, type, swap));
        }
        stream.Skip(rows * rowBytes);
    }

    bool Row(size_t row, const Destinations &to) {
        for (size_t i = 0; i < e.properties.size(); ++i) {
            double value;
            if (!values.NextOrSkipList(e.properties[i], &value)) return false;
            for (const Column &c : columns)
                if (c.property == int(i))
                    to[size_t(c.array)][row * kStride[c.array] + size_t(c.k)] = float(value);
        }
        return true;
    }

    bool Ends(size_t row, std::string *problem) const {
        *problem = values.ProblemIn(e, row);
        return false;
    }

    const PlyElement &e;
    PlyValues &values;
    PlyStream &stream;
    PlyMesh *mesh;
    std::vector<Column> columns;
    const size_t rowBytes = e.LeastRowBytes(values.Format());
};

}  // namespace

bool ReadPlyVertices(const PlyElement &e, PlyValues &values, PlyMesh *mesh, std::string *problem) {
    VertexReader reader(e, values, mesh);
    return reader.FindColumns(problem) && reader.ReadRows(problem);
}

}  // namespace pbrt
