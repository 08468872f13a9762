#include "pbrt/scene/entity_serializer.h"

#include <algorithm>

namespace pbrt {
namespace {

/// Kinds of values that a parameter has, and whether they are inherited.
enum : uint8_t { Floats, Ints, Strings, Bools, MayBeUnused = 4 };

constexpr std::array<float, 4> kAffineRow{0, 0, 0, 1};

enum : uint8_t { SameTransform = 1, Moves = 2, Reversed = 4, Shines = 8 };

}  // namespace

class EntitySerializer::Writer {
  public:
    explicit Writer(std::string *to) : to(to) {}
    void Byte(uint8_t b) { to->push_back(char(b)); }
    /// Seven bits a byte, the lowest first; the eighth says that more follow.
    void Number(uint64_t n) {
        for (; n >= 128; n >>= 7)
            Byte(uint8_t(n | 128));
        Byte(uint8_t(n));
    }
    /// Small ones are short, of either sign.
    void Signed(int64_t n) { Number(n < 0 ? 2 * ~uint64_t(n) + 1 : 2 * uint64_t(n)); }
    void Text(std::string_view text) {
        Number(text.size());
        to->append(text);
    }
    template <typename T>
    void Raw(const T *values, size_t count) {
        to->append(reinterpret_cast<const char *>(values), count * sizeof(T));
    }
    /// Without the last rows where they are (0, 0, 0, 1).
    void Transformation(const Transform &t) {
        const bool affine = t.Matrix()[3] == kAffineRow && t.InverseMatrix()[3] == kAffineRow;
        Byte(affine);
        Raw(t.Matrix().data(), affine ? 3 : 4);
        Raw(t.InverseMatrix().data(), affine ? 3 : 4);
    }
    void Motion(const TransformPair &t, bool moves) {
        Transformation(t[0]);
        if (moves) Transformation(t[1]);
    }

  private:
    std::string *to;
};

class EntitySerializer::Reader {
  public:
    explicit Reader(std::string_view *from) : from(from) {}
    uint8_t Byte() {
        const char b = from->front();
        from->remove_prefix(1);
        return uint8_t(b);
    }
    uint64_t Number() {
        uint64_t n = 0;
        for (int shift = 0;; shift += 7) {
            const uint8_t b = Byte();
            n |= uint64_t(b & 127) << shift;
            if (b < 128) return n;
        }
    }
    int64_t Signed() {
        const uint64_t n = Number();
        return int64_t(n % 2 ? ~(n / 2) : n / 2);
    }
    std::string_view Text() {
        const size_t size = Number();
        const std::string_view text = from->substr(0, size);
        from->remove_prefix(size);
        return text;
    }
    template <typename T>
    void Raw(T *values, size_t count) {
        if (count == 0) return;  // memcpy wants no null
        std::memcpy(values, from->data(), count * sizeof(T));
        from->remove_prefix(count * sizeof(T));
    }
    Transform Transformation() {
        const size_t rows = Byte() ? 3 : 4;
        Matrix4 m, inverse;
        m[3] = inverse[3] = kAffineRow;
        Raw(m.data(), rows);
        Raw(inverse.data(), rows);
        return Transform::FromMatrixPair(m, inverse);
    }
    void Motion(bool moves, TransformPair *t) {
        (*t)[0] = Transformation();
        (*t)[1] = moves ? Transformation() : (*t)[0];
    }

  private:
    std::string_view *from;
};

template <typename T>
size_t EntitySerializer::Shared<T>::NumberOf(const T &value) {
    constexpr size_t kLooked = 16;
    for (size_t i = values.size(); i-- > 0 && values.size() - i <= kLooked;)
        if (values[i] == value) return i;
    values.push_back(value);
    return values.size() - 1;
}

// --- Definitions and parameters ---

void EntitySerializer::WriteLocation(const FileLoc &loc, const FileLoc &near, Writer &out) {
    out.Number(files.NumberOf(loc.file));
    out.Signed(int64_t(loc.line) - near.line);
    out.Number(uint64_t(loc.column));
}

FileLoc EntitySerializer::ReadPlace(const FileLoc &near, Reader &in) const {
    FileLoc loc;
    loc.file = files[in.Number()];
    loc.line = int(near.line + in.Signed());
    loc.column = int(in.Number());
    return loc;
}

void EntitySerializer::WriteParameter(const ParsedParameter &p, const FileLoc &near, Writer &out) {
    out.Number(types.NumberOf(p.type));
    out.Text(p.name);
    WriteLocation(p.loc, near, out);
    WriteLocation(p.valueLoc, p.loc, out);
    out.Number(colorSpaces.NumberOf(p.colorSpace));
    const auto kind = [&](uint8_t k) { out.Byte(p.mayBeUnused ? k | MayBeUnused : k); };
    const auto numbers = [&](uint8_t k, const auto &values) {
        kind(k);
        out.Number(values.size());
        out.Raw(values.data(), values.size());
    };
    if (!p.ints.empty()) return numbers(Ints, p.ints);
    if (!p.bools.empty()) return numbers(Bools, p.bools);
    if (p.strings.empty()) return numbers(Floats, p.floats);
    kind(Strings);
    out.Number(p.strings.size());
    for (const std::string &s : p.strings)
        out.Text(s);
}

void EntitySerializer::ReadParameter(const FileLoc &near, Reader &in, ParsedParameter *p) const {
    p->type = types[in.Number()];
    p->name = in.Text();
    p->loc = ReadPlace(near, in);
    p->valueLoc = ReadPlace(p->loc, in);
    p->colorSpace = colorSpaces[in.Number()];
    const uint8_t kind = in.Byte();
    p->mayBeUnused = kind & MayBeUnused;
    const size_t count = in.Number();
    const auto numbers = [&](uint8_t k, auto *values) {
        values->resize((kind & 3) == k ? count : 0);
        in.Raw(values->data(), values->size());
    };
    numbers(Floats, &p->floats);
    numbers(Ints, &p->ints);
    numbers(Bools, &p->bools);
    p->strings.resize((kind & 3) == Strings ? count : 0);
    for (std::string &s : p->strings)
        s = in.Text();
}

// --- Entities ---

void EntitySerializer::Write(const Entity &e, std::string *bytes) {
    Writer out(bytes);
    out.Text(e.type);
    WriteLocation(e.loc, {}, out);
    out.Number(colorSpaces.NumberOf(e.colorSpace));
    out.Number(e.params.size());
    for (const ParsedParameter &p : e.params)
        WriteParameter(p, e.loc, out);
}

void EntitySerializer::Read(std::string_view *bytes, Entity *e) const {
    Reader in(bytes);
    e->type = in.Text();
    e->loc = ReadPlace({}, in);
    e->colorSpace = colorSpaces[in.Number()];
    e->params.resize(in.Number());
    for (ParsedParameter &p : e->params)
        ReadParameter(e->loc, in, &p);
}

void EntitySerializer::Write(const ShapeEntity &s, std::string *bytes) {
    Write(static_cast<const Entity &>(s), bytes);
    Writer out(bytes);
    const TransformPair &t = s.worldFromObject;
    const bool same = t == lastTransform, moves = t[0] != t[1];
    out.Byte(uint8_t((same ? SameTransform : 0) | (moves ? Moves : 0) |
                     (s.reverseOrientation ? Reversed : 0) | (s.areaLight ? Shines : 0)));
    if (!same) out.Motion(t, moves);
    lastTransform = t;
    out.Signed(s.material);
    out.Text(s.namedMaterial);
    if (s.areaLight) out.Number(areaLights.NumberOf(s.areaLight));
}

void EntitySerializer::Read(std::string_view *bytes, ShapeEntity *s) const {
    Read(bytes, static_cast<Entity *>(s));
    Reader in(bytes);
    const uint8_t flags = in.Byte();
    TransformPair &t = s->worldFromObject;
    if (!(flags & SameTransform)) in.Motion(flags & Moves, &t);
    s->reverseOrientation = flags & Reversed;
    s->material = int(in.Signed());
    s->namedMaterial = in.Text();
    s->areaLight = flags & Shines ? areaLights[in.Number()] : nullptr;
}

void EntitySerializer::Write(const InstanceUse &use, std::string *bytes) {
    Writer out(bytes);
    out.Text(use.name);
    WriteLocation(use.loc, {}, out);
    const bool moves = use.worldFromInstance[0] != use.worldFromInstance[1];
    out.Byte(moves);
    out.Motion(use.worldFromInstance, moves);
}

void EntitySerializer::Read(std::string_view *bytes, InstanceUse *use) const {
    Reader in(bytes);
    use->name = in.Text();
    use->loc = ReadPlace({}, in);
    const bool moves = in.Byte();
    in.Motion(moves, &use->worldFromInstance);
}

}  // namespace pbrt
