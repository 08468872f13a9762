#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/scene/entities.h"

namespace pbrt {

/// Turns entities into bytes and back: a sphere takes some 40 where the object and its parameter
/// fill 700, an instance 110. Bytes are read by the packer that wrote them, in the order of
/// writing.
class EntitySerializer {
  public:
    // Appended to `bytes`.
    void Write(const Entity &e, std::string *bytes);
    void Write(const ShapeEntity &s, std::string *bytes);
    void Write(const InstanceUse &use, std::string *bytes);

    // From the front of `bytes`, which moves on. `e`, `s`, `use` hold the entity read before (at
    // first a new one): what both have in common stays, and so does the memory of parameters.
    void Read(std::string_view *bytes, Entity *e) const;
    void Read(std::string_view *bytes, ShapeEntity *s) const;
    void Read(std::string_view *bytes, InstanceUse *use) const;

  private:
    class Writer;
    class Reader;

    /// Values that many entities share, each written as its number here.
    template <typename T>
    class Shared {
      public:
        /// Looks among the last few only, so that many different ones cost no time.
        size_t NumberOf(const T &value);
        const T &operator[](size_t number) const { return values[number]; }

      private:
        std::vector<T> values;
    };

    void WriteLocation(const FileLoc &loc, const FileLoc &near, Writer &out);
    FileLoc ReadPlace(const FileLoc &near, Reader &in) const;
    void WriteParameter(const ParsedParameter &p, const FileLoc &near, Writer &out);
    void ReadParameter(const FileLoc &near, Reader &in, ParsedParameter *p) const;

    Shared<std::string_view> files, types;
    Shared<const RGBColorSpace *> colorSpaces;
    Shared<std::shared_ptr<const Entity>> areaLights;
    TransformPair lastTransform;  ///< of the shape written last
};

}  // namespace pbrt
