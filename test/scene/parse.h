#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pbrt/scene/description.h"

namespace pbrt {

/// A scene read from text, with what was said about it.
struct Parsed {
    SceneDescription scene;
    Diagnostics log;
    std::vector<std::string> Messages() const {
        std::vector<std::string> texts;
        for (const Message &m : log.Messages())
            texts.push_back(m.text);
        return texts;
    }
};

inline std::unique_ptr<Parsed> Parse(std::string_view text, std::string_view dir = "") {
    auto parsed = std::make_unique<Parsed>();
    ParseString(text, "test.pbrt", dir, parsed->scene, parsed->log);
    return parsed;
}

/// The same with the text after WorldBegin, on the line after it.
inline std::unique_ptr<Parsed> ParseWorld(std::string_view text, std::string_view dir = "") {
    return Parse("WorldBegin\n" + std::string(text), dir);
}

/// A queue's entities, which stay in it.
template <typename E>
std::vector<E> All(const PackedEntities<E> &queue) {
    return {queue.begin(), queue.end()};
}

using Texts = std::vector<std::string>;

}  // namespace pbrt
