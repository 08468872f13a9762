#include "pbrt/shapes/write_ply.h"

#include <fmt/format.h>

#include <bit>

#include "pbrt/util/check.h"

namespace pbrt {
namespace {

template <typename T>
void Append(std::string *bytes, T value) {
    static_assert(std::endian::native == std::endian::little);
    bytes->append(reinterpret_cast<const char *>(&value), sizeof value);
}

std::string Header(const PlyTriangles &mesh, std::string_view maker) {
    std::string text = fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n"
        "property float x\nproperty float y\nproperty float z\n",
        maker, mesh.p.size());
    if (!mesh.n.empty()) text += "property float nx\nproperty float ny\nproperty float nz\n";
    if (!mesh.uv.empty()) text += "property float u\nproperty float v\n";
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n",
                        mesh.indices.size() / 3);
    if (!mesh.faces.empty()) text += "property int face_indices\n";
    return text + "end_header\n";
}

}  // namespace

std::string PlyText(const PlyTriangles &mesh, std::string_view maker) {
    const size_t triangles = mesh.indices.size() / 3;
    DCHECK(mesh.n.empty() || mesh.n.size() == mesh.p.size());
    DCHECK(mesh.uv.empty() || mesh.uv.size() == mesh.p.size());
    DCHECK(mesh.faces.empty() || mesh.faces.size() == triangles);
    std::string bytes = Header(mesh, maker);
    bytes.reserve(bytes.size() + 32 * mesh.p.size() + 17 * triangles);
    for (size_t i = 0; i < mesh.p.size(); ++i) {
        Append(&bytes, mesh.p[i]);
        if (!mesh.n.empty()) Append(&bytes, mesh.n[i]);
        if (!mesh.uv.empty()) Append(&bytes, mesh.uv[i]);
    }
    for (size_t i = 0; i < triangles; ++i) {
        Append(&bytes, uint8_t(3));
        for (size_t k = 0; k < 3; ++k)
            Append(&bytes, mesh.indices[3 * i + k]);
        if (!mesh.faces.empty()) Append(&bytes, mesh.faces[i]);
    }
    return bytes;
}

}  // namespace pbrt
