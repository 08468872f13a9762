#pragma once

#include <deque>
#include <iterator>
#include <string>

#include "pbrt/scene/entity_serializer.h"

namespace pbrt {

/// Entities in file order, packed: a scene may have millions. They are read one after the other;
/// those taken off the front give their memory back. E: Entity, ShapeEntity or InstanceUse.
template <typename E>
class PackedEntities {
  public:
    /// Gives one entity after the other, as many as there were when it was made.
    class Iterator {
      public:
        using value_type = E;
        using reference = const E &;
        using pointer = const E *;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::input_iterator_tag;

        const E &operator*() const { return entity; }
        const E *operator->() const { return &entity; }
        Iterator &operator++() {
            if (--left > 0) Read();
            return *this;
        }
        /// Meant for the comparison with end().
        bool operator==(const Iterator &other) const { return left == other.left; }

      private:
        friend class PackedEntities;
        Iterator() = default;
        Iterator(const PackedEntities &queue)
            : queue(&queue), next(queue.next), entity(queue.front), left(queue.count) {
            if (left > 0) Read();
        }
        void Read() {
            if (next == queue->blocks[block].size()) ++block, next = 0;
            next = queue->Read(block, next, &entity);
        }

        const PackedEntities *queue = nullptr;
        size_t block = 0, next = 0;  ///< where in the block
        E entity;
        size_t left = 0;
    };

    void Append(const E &entity);
    /// The first, which is no longer in the queue; valid until the next call.
    const E &Take();
    bool empty() const { return count == 0; }
    size_t size() const { return count; }
    Iterator begin() const { return Iterator(*this); }
    Iterator end() const { return {}; }
    /// Memory that the entities take.
    size_t Bytes() const;

  private:
    /// Bytes of a block, enough that the system takes a freed one back at once.
    static constexpr size_t kBlock = size_t(1) << 20;

    /// Reads the entity at `at` in a block; returns the place after it.
    size_t Read(size_t block, size_t at, E *entity) const;

    EntitySerializer packer;
    std::string packed;              ///< the entity being appended
    std::deque<std::string> blocks;  ///< whole entities each
    size_t next = 0;                 ///< in the first block
    E front;                         ///< taken last
    size_t count = 0;
};

}  // namespace pbrt
