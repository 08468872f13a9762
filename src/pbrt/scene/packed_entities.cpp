#include "pbrt/scene/packed_entities.h"

namespace pbrt {

template <typename E>
void PackedEntities<E>::Append(const E &entity) {
    packed.clear();
    packer.Write(entity, &packed);
    if (blocks.empty() || blocks.back().size() + packed.size() > kBlock) {
        const bool isFirst = blocks.empty();  // often the only one, and small
        blocks.emplace_back().reserve(isFirst ? 0 : std::max(packed.size(), kBlock));
    }
    blocks.back() += packed;
    ++count;
}

template <typename E>
const E &PackedEntities<E>::Take() {
    next = Read(0, next, &front);
    --count;
    if (next == blocks.front().size()) {
        blocks.pop_front();
        next = 0;
    }
    return front;
}

template <typename E>
size_t PackedEntities<E>::Read(size_t block, size_t at, E *entity) const {
    std::string_view rest = std::string_view(blocks[block]).substr(at);
    packer.Read(&rest, entity);
    return blocks[block].size() - rest.size();
}

template <typename E>
size_t PackedEntities<E>::Bytes() const {
    size_t bytes = 0;
    for (const std::string &block : blocks)
        bytes += block.size();
    return bytes - next;
}

template class PackedEntities<Entity>;
template class PackedEntities<ShapeEntity>;
template class PackedEntities<InstanceUse>;

}  // namespace pbrt
