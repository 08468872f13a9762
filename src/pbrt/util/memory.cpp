#include "pbrt/util/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

namespace pbrt {
namespace {

constexpr uint64_t kUnlimited = std::numeric_limits<uint64_t>::max();

uint64_t Minus(uint64_t limit, uint64_t used) {
    return limit == kUnlimited ? limit : limit - std::min(limit, used);
}

/// The number behind `key` at the beginning of a line, as in "MemFree:  12 kB" or "cache 12".
std::optional<uint64_t> NumberAfter(const std::string &fileName, std::string_view key) {
    std::ifstream file(fileName);
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(key)) continue;
        const char *from = line.data() + key.size(), *const end = line.data() + line.size();
        from = std::find_if(from, end, [](unsigned char c) { return std::isdigit(c); });
        uint64_t number = 0;
        if (std::from_chars(from, end, number).ec == std::errc()) return number;
    }
    return {};
}

uint64_t LeftOfLimit(int which, std::string_view used) {
    rlimit limit{};
    if (getrlimit(which, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
    return Minus(limit.rlim_cur, 1024 * NumberAfter("/proc/self/status", used).value_or(0));
}

uint64_t LeftOfMachine() {
    const auto available = NumberAfter("/proc/meminfo", "MemAvailable:");
    if (!available) return kUnlimited;
    return 1024 * (*available + NumberAfter("/proc/meminfo", "SwapFree:").value_or(0));
}

/// Names of what a version of control groups tells, in the folder of a group.
struct GroupFiles {
    std::string_view root, limit, used, inactive, active;
};
constexpr GroupFiles kVersion1{"/sys/fs/cgroup/memory", "memory.limit_in_bytes",
                               "memory.usage_in_bytes", "total_inactive_file ",
                               "total_active_file "};
constexpr GroupFiles kVersion2{"/sys/fs/cgroup", "memory.max", "memory.current", "inactive_file ",
                               "active_file "};

uint64_t LeftOfGroup(const std::filesystem::path &folder, const GroupFiles &names) {
    const auto limit = NumberAfter(folder / names.limit, "");  // "max": no number
    const auto used = NumberAfter(folder / names.used, "");
    if (!limit || !used) return kUnlimited;
    const std::string statistics = folder / "memory.stat";
    const uint64_t ofFiles = NumberAfter(statistics, names.inactive).value_or(0) +
                             NumberAfter(statistics, names.active).value_or(0);
    return Minus(*limit, Minus(*used, ofFiles));
}

/// `path` as in /proc/self/cgroup. In a container it may name a folder that is not to be seen from
/// inside; the group is then the root itself.
uint64_t LeftOfGroups(const std::string &path, const GroupFiles &names) {
    uint64_t left = kUnlimited;
    std::filesystem::path relative = std::filesystem::path(path).relative_path();
    for (;; relative = relative.parent_path()) {
        left = std::min(left, LeftOfGroup(names.root / relative, names));
        if (relative.empty()) return left;
    }
}

uint64_t LeftOfGroups() {
    uint64_t left = kUnlimited;
    std::ifstream file("/proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {  // "4:memory:/path", "0::/path"
        const size_t first = line.find(':'), second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers =
            fmt::format(",{},", line.substr(first + 1, second - first - 1));
        if (controllers == ",,")
            left = std::min(left, LeftOfGroups(line.substr(second + 1), kVersion2));
        else if (controllers.find(",memory,") != std::string::npos)
            left = std::min(left, LeftOfGroups(line.substr(second + 1), kVersion1));
    }
    return left;
}

constexpr std::string_view kUnits = "KMGTPE";

}  // namespace

uint64_t AvailableMemory() {
    return std::min({LeftOfLimit(RLIMIT_AS, "VmSize:"), LeftOfLimit(RLIMIT_DATA, "VmData:"),
                     LeftOfGroups(), LeftOfMachine()});
}

std::optional<std::string> WhyTooLarge(uint64_t bytes) {
    const uint64_t left = AvailableMemory();
    if (bytes <= left) return {};
    return fmt::format("needs {} of memory, {} are left", ByteText(bytes), ByteText(left));
}

std::string ByteText(uint64_t bytes) {
    double number = double(bytes);
    int unit = -1;
    for (; number >= 999.5; number /= 1000)
        ++unit;
    if (unit < 0) return fmt::format("{} bytes", bytes);
    return fmt::format("{:.{}f} {}B", number, number < 9.95 ? 1 : 0, kUnits[size_t(unit)]);
}

std::optional<uint64_t> ParseBytes(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !(number >= 0)) return {};
    std::string unit;
    for (const char *c = end; c != text.data() + text.size(); ++c)
        if (*c != ' ') unit += char(std::toupper(static_cast<unsigned char>(*c)));
    if (unit.ends_with('B')) unit.pop_back();
    if (unit.size() == 1 && kUnits.find(unit) != std::string_view::npos)
        number *= std::pow(1000., double(kUnits.find(unit)) + 1);
    else if (!unit.empty())
        return {};
    if (number >= 0x1p63) return {};
    return uint64_t(number);
}

std::optional<std::string> LimitMemory(uint64_t bytes) {
    rlimit limit{};
    int error = getrlimit(RLIMIT_DATA, &limit) == 0 ? 0 : errno;
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    limit.rlim_max = limit.rlim_cur;
    if (error == 0 && setrlimit(RLIMIT_DATA, &limit) != 0) error = errno;
    if (error == 0) return {};
    return fmt::format("memory cannot be limited to {}: {}", ByteText(bytes), std::strerror(error));
}

}  // namespace pbrt
