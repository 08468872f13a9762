#pragma once

#include <optional>
#include <string>

#include "pbrt/image/origin.h"
#include "pbrt/render/render.h"
#include "pbrt/scene/scene_content.h"

namespace pbrt {

/// All that decides the bits of a picture.
struct RenderIdentity {
    std::string version;  ///< of this program
    Digest text{};        ///< of the scene's files
    Digest assets{};      ///< of the files that these name
    std::string options;  ///< of the command line or `Option`, but for those below
    int seed = 0;
    int spp = 0;          ///< of the whole picture
    SampleRange samples;  ///< that are rendered
    PixelBounds pixels;
    std::string film;  ///< its type

    /// One digest for text, assets and options.
    Digest Scene() const;
    /// How `other` differs, as the end of "is of ...": "another scene (its text differs)"; nullopt
    /// where nothing does.
    std::optional<std::string> Difference(const RenderIdentity &other) const;
};

/// The identity as far as the description tells it; to be called before the scene is built, which
/// uses it up. Reads the assets.
RenderIdentity IdentityOf(const SceneDescription &description, const Overrides &overrides);
/// Adds what is known after the scene was built.
void Complete(const RenderTask &task, RenderIdentity *identity);

Origin OriginOf(const RenderIdentity &identity);

}  // namespace pbrt
