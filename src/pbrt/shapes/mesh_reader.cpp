#include "pbrt/shapes/mesh_reader.h"

#include <fmt/format.h>

namespace pbrt {

bool MeshReader::PointsAndIndices(std::vector<Point3f> *p, std::vector<uint32_t> *indices) {
    *p = params.GetPoint3fArray(kP);
    const std::vector<int> given = params.GetIntArray(kIndices);
    if (p->empty() && params.IsNamed(kP.name)) return ok = false;  // wrong, and reported
    if (p->empty()) return Fail("", fmt::format("{} needs \"point3 P\"", params.What()));
    if (given.empty() && p->size() != size_t(corners))
        return Fail("", fmt::format("{} needs \"integer indices\", for it has {} points and "
                                    "not {}",
                                    params.What(), p->size(), corners));
    if (given.size() % corners != 0)
        return Fail("indices", fmt::format("\"integer indices\": {} values are not a multiple "
                                           "of {}",
                                           given.size(), corners));
    for (size_t i = 0; i < given.size(); ++i)
        if (given[i] < 0 || size_t(given[i]) >= p->size())
            return Fail("indices",
                        fmt::format("\"integer indices\": value {} is {}, but \"P\" has {} "
                                    "points (0 to {})",
                                    i, given[i], p->size(), p->size() - 1));
    indices->assign(given.begin(), given.end());
    for (int i = 0; given.empty() && i < corners; ++i)
        indices->push_back(uint32_t(i));
    return true;
}
void MeshReader::CheckCount(const ArrayParam &row, std::string_view of, size_t count,
                            size_t values) {
    if (values != 0 && values != count)
        Fail(row.name,
             fmt::format("\"{} {}\": {} values for {} {}", row.type, row.name, values, count, of));
}

bool MeshReader::Fail(std::string_view name, std::string_view message) {
    if (name.empty())
        params.Error(message);
    else
        params.Error(name, message);
    return ok = false;
}
}  // namespace pbrt
