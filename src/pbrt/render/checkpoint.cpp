#include "pbrt/render/checkpoint.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <type_traits>

#include "pbrt/util/read_file.h"

namespace pbrt {
namespace {

/// At the start of each; the number at its end is the format's.
constexpr std::string_view kMark = "pbrt-feather checkpoint 1\n";

class Writer {
  public:
    explicit Writer(std::string *out) : out(out) {}
    template <typename T>
    requires std::is_trivially_copyable_v<T>
    void Put(const T &value) { PutBytes(&value, sizeof value); }
    void Put(std::string_view text) {
        Put(uint64_t(text.size()));
        out->append(text);
    }
    void Put(const std::vector<ExactSum> &sums) {
        Put(uint64_t(sums.size()));
        PutBytes(sums.data(), sums.size() * sizeof(ExactSum));
    }

  private:
    void PutBytes(const void *bytes, size_t n) { out->append(static_cast<const char *>(bytes), n); }
    std::string *out;
};

/// Reads the same; after an end that comes too early everything is 0.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest(bytes) {}
    template <typename T>
    T Get() {
        T value{};
        Take(&value, sizeof value);
        return value;
    }
    std::string GetText() {
        std::string text(Count(1), '\0');
        Take(text.data(), text.size());
        return text;
    }
    std::vector<ExactSum> GetSums() {
        std::vector<ExactSum> sums(Count(sizeof(ExactSum)));
        Take(sums.data(), sums.size() * sizeof(ExactSum));
        return sums;
    }
    bool Sound() const { return sound; }
    bool AtEnd() const { return rest.empty(); }

  private:
    /// A number of things that the rest has room for.
    size_t Count(size_t bytesOfOne) {
        const auto n = Get<uint64_t>();
        if (n > rest.size() / bytesOfOne) sound = false;
        return sound ? size_t(n) : 0;
    }
    void Take(void *to, size_t n) {
        if (n > rest.size()) sound = false;
        if (!sound || n == 0) return;
        std::memcpy(to, rest.data(), n);
        rest.remove_prefix(n);
    }
    std::string_view rest;
    bool sound = true;
};

void Put(Writer &w, const RenderIdentity &id) {
    w.Put(std::string_view(id.version));
    w.Put(id.text);
    w.Put(id.assets);
    w.Put(std::string_view(id.options));
    w.Put(id.seed);
    w.Put(id.spp);
    w.Put(id.samples);
    w.Put(id.pixels);
    w.Put(std::string_view(id.film));
}

RenderIdentity GetIdentity(Reader &r) {
    RenderIdentity id;
    id.version = r.GetText();
    id.text = r.Get<Digest>();
    id.assets = r.Get<Digest>();
    id.options = r.GetText();
    id.seed = r.Get<int>();
    id.spp = r.Get<int>();
    id.samples = r.Get<SampleRange>();
    id.pixels = r.Get<PixelBounds>();
    id.film = r.GetText();
    return id;
}

struct Record {
    RenderState::Tile tile;
    std::vector<ExactSum> sums;
};

void Put(Writer &w, const RenderState::Tile &tile, const std::vector<ExactSum> &sums) {
    w.Put(tile.next);
    w.Put(tile.enough);
    w.Put(tile.seconds);
    w.Put(tile.rays);
    w.Put(tile.before);
    w.Put(sums);
}

Record GetRecord(Reader &r) {
    Record record;
    record.tile.next = r.Get<int>();
    record.tile.enough = r.Get<bool>();
    record.tile.seconds = r.Get<double>();
    record.tile.rays = r.Get<int64_t>();
    record.tile.before = r.GetSums();
    record.sums = r.GetSums();
    return record;
}

/// Sums are there, whole, where samples are.
bool Fits(const Record &record, SampleRange range, size_t sums) {
    const size_t wanted = record.tile.next > range.first ? sums : 0;
    const size_t before = record.tile.before.size();
    return record.tile.next >= range.first && record.tile.next <= range.last &&
           record.sums.size() == wanted && (before == 0 || before == sums);
}

/// The bytes before the digest at the end, where that is theirs.
std::optional<std::string_view> Checked(std::string_view file) {
    Digest digest;
    if (file.size() < kMark.size() + sizeof digest) return {};
    const std::string_view bytes = file.substr(0, file.size() - sizeof digest);
    std::memcpy(&digest, file.data() + bytes.size(), sizeof digest);
    if (DigestOf(bytes) != digest) return {};
    return bytes.substr(kMark.size());
}

/// The reason why not, as the rest of a sentence.
std::optional<std::string> Restore(std::string_view file, const RenderIdentity &identity,
                                   RenderState *state) {
    constexpr std::string_view kAnyFormat = kMark.substr(0, kMark.size() - 2);
    if (!file.starts_with(kAnyFormat)) return "is no checkpoint";
    if (!file.starts_with(kMark))
        return fmt::format("is a checkpoint of another version than {}", identity.version);
    const std::optional<std::string_view> bytes = Checked(file);
    if (!bytes) return "is damaged: its checksum is wrong";
    Reader r(*bytes);
    const RenderIdentity its = GetIdentity(r);
    if (!r.Sound()) return "is damaged";
    if (const auto difference = its.Difference(identity))
        return fmt::format("is a checkpoint of {}", *difference);
    RenderStats earlier;
    earlier.seconds = r.Get<double>();
    earlier.rays.closest = r.Get<int64_t>();
    earlier.rays.shadow = r.Get<int64_t>();
    std::vector<Record> records;
    bool sound = true;
    state->Look([&](const TileSums &sums, const std::vector<RenderState::Tile> &tiles) {
        for (size_t i = 0; i < tiles.size() && r.Sound(); ++i) {
            records.push_back(GetRecord(r));
            sound = sound && Fits(records.back(), state->Samples(), sums.FlatSize(i));
        }
    });
    if (!sound || !r.Sound() || !r.AtEnd()) return "is damaged";
    state->Restore(earlier, [&](TileSums &sums, std::vector<RenderState::Tile> &tiles) {
        for (size_t i = 0; i < tiles.size(); ++i) {
            tiles[i] = std::move(records[i].tile);
            sums.Flat(i) = std::move(records[i].sums);
        }
    });
    return {};
}

}  // namespace

std::string MakeCheckpoint(const RenderIdentity &identity, const RenderState &state) {
    std::string bytes(kMark);
    Writer w(&bytes);
    Put(w, identity);
    const RenderStats stats = state.Stats();
    w.Put(stats.seconds);
    w.Put(stats.rays.closest);
    w.Put(stats.rays.shadow);
    state.Look([&](const TileSums &sums, const std::vector<RenderState::Tile> &tiles) {
        size_t size = 0;
        for (size_t i = 0; i < tiles.size(); ++i)
            size += sizeof(ExactSum) * (sums.Flat(i).size() + tiles[i].before.size() + 4);
        bytes.reserve(bytes.size() + size + sizeof(Digest));
        for (size_t i = 0; i < tiles.size(); ++i)
            Put(w, tiles[i], sums.Flat(i));
    });
    w.Put(DigestOf(bytes));
    return bytes;
}

std::optional<std::string> ReadCheckpoint(const std::string &fileName,
                                          const RenderIdentity &identity, RenderState *state) {
    const FileContents file = ReadWholeFile(fileName);
    if (!file.bytes) return file.error;
    if (const auto why = Restore(*file.bytes, identity, state))
        return fmt::format("{} {}", fileName, *why);
    return {};
}

}  // namespace pbrt
