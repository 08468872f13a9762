#include "pbrt/feathergen/mesh.h"

#include <fmt/format.h>

#include <bit>

#include "pbrt/util/check.h"

namespace pbrt::feathergen {
namespace {

template <typename T>
void Append(std::string *bytes, T value) {
    static_assert(std::endian::native == std::endian::little);
    bytes->append(reinterpret_cast<const char *>(&value), sizeof value);
}

std::string Header(const Mesh &mesh) {
    std::string text = fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment feathergen\nelement vertex {}\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\n",
        mesh.p.size());
    if (!mesh.uv.empty()) text += "property float u\nproperty float v\n";
    text +=
        fmt::format("element face {}\nproperty list uchar int vertex_indices\n", mesh.NTriangles());
    if (!mesh.faces.empty()) text += "property int face_indices\n";
    return text + "end_header\n";
}

}  // namespace

std::string ToPly(const Mesh &mesh) {
    DCHECK(mesh.n.size() == mesh.p.size());
    DCHECK(mesh.uv.empty() || mesh.uv.size() == mesh.p.size());
    DCHECK(mesh.faces.empty() || mesh.faces.size() == mesh.NTriangles());
    std::string bytes = Header(mesh);
    bytes.reserve(bytes.size() + 32 * mesh.p.size() + 17 * mesh.NTriangles());
    for (size_t i = 0; i < mesh.p.size(); ++i) {
        Append(&bytes, mesh.p[i]);
        Append(&bytes, mesh.n[i]);
        if (!mesh.uv.empty()) Append(&bytes, mesh.uv[i]);
    }
    for (size_t i = 0; i < mesh.NTriangles(); ++i) {
        Append(&bytes, uint8_t(3));
        for (int k = 0; k < 3; ++k)
            Append(&bytes, mesh.indices[3 * i + size_t(k)]);
        if (!mesh.faces.empty()) Append(&bytes, mesh.faces[i]);
    }
    return bytes;
}

}  // namespace pbrt::feathergen
