#pragma once

#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pbrt {

/// A place in a scene file. `file` points into text owned by the parsed scene (or is a literal).
/// Lines and columns count from 1; line 0 means "no place".
struct FileLoc {
    std::string_view file;
    int line = 0, column = 0;
    bool operator==(const FileLoc &) const = default;
};

enum class Severity { Warning, Error };

struct Message {
    Severity severity;
    std::string text;  ///< "file:line:column: message"
    int file;          ///< 0: none; else files count in the order in which messages came
    int line, column;
};

struct OldName;

/// Text for a message: what is longer than `most` bytes loses its middle ("abc ... xyz"), and of
/// the characters that steer a terminal only line ends are left.
std::string Shortened(std::string_view text, size_t most = 60);

/// Collects the user's mistakes, so that one run reports as many as it can.
class Diagnostics {
  public:
    /// Messages of more than some 2000 bytes are shortened.
    void Error(const FileLoc &loc, std::string_view message);
    void Warning(const FileLoc &loc, std::string_view message);
    /// A warning about what may be met at many places: only the first of the same words is kept.
    void WarningOnce(const FileLoc &loc, std::string_view message);
    /// An error about a file that a scene in `folder` names and that is not there. Of each name the
    /// first place is told, and of many in one folder the first ones; MissingFiles() counts all.
    /// Further errors at a place that names a missing file are dropped: they follow from it.
    void MissingFile(const FileLoc &loc, std::string_view name, std::string_view folder);
    /// A line for each folder with missing files: how many, and where they were looked for.
    std::vector<std::string> MissingFiles() const;
    /// Takes note of a name of pbrt-v3; false where it has been noted before.
    bool NoteOldName(const OldName &name, const FileLoc &loc);
    struct OldNameUse {
        const OldName *name;
        FileLoc loc;  ///< of the first
    };
    /// Different ones, in the order in which they were noted.
    const std::vector<OldNameUse> &OldNames() const { return oldNames; }
    bool HasErrors() const { return errors > 0; }
    int ErrorCount() const { return errors; }
    const std::vector<Message> &Messages() const { return messages; }
    /// The same by place: those without one, then file by file and line by line.
    std::vector<const Message *> InOrderOfPlace() const;

  private:
    struct MissingFolder {
        std::vector<std::string> lookedIn;
        std::set<std::string, std::less<>> names;
    };

    void Add(Severity severity, const FileLoc &loc, std::string_view message);
    bool FollowsFromMissingFile(const FileLoc &loc) const;

    std::vector<Message> messages;  ///< in order, without immediate repetitions
    std::set<std::string, std::less<>> warnedOnce;
    std::map<std::string, int, std::less<>> fileNumbers;  ///< see Message::file
    std::map<std::string, MissingFolder> missing;         ///< by the folder in the files' names
    std::vector<FileLoc> namingMissing;                   ///< places that name a missing file
    std::vector<OldNameUse> oldNames;
    int errors = 0;
};

/// The candidate with the fewest edits from `name` (case ignored); empty where none is near, that
/// is, within a third of the longer name's length or beginning with `name`.
std::string_view NearestName(std::string_view name, std::span<const std::string_view> candidates);
/// `; did you mean "x"?` or nothing.
std::string DidYouMean(std::string_view name, std::span<const std::string_view> candidates);
/// `unknown KIND "name"; did you mean "x"? Known: "a", "b" or "c"`; of a name that pbrt-v4 has, or
/// pbrt-v3 had, what to use instead.
std::string UnknownName(std::string_view kind, std::string_view name,
                        std::span<const std::string_view> known);
/// "a", "b" or "c" - for messages that list what is allowed.
std::string QuotedList(std::span<const std::string_view> names);

}  // namespace pbrt
