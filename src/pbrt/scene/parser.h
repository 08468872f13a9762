#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/scene/directives.h"

namespace pbrt {

/// Reads scene files, directive by directive (directives.h), and the files these name. After a
/// mistake it goes on at the next directive, so that one run reports them all.
class Parser {
  public:
    Parser(SceneDescription *scene, Diagnostics *log);
    /// A top-level file: a path, or "-" for standard input.
    void ReadFile(const std::string &path);
    /// A top-level file's text.
    void ReadText(std::string_view text, std::string_view name, std::string_view dir);
    /// After the last file.
    void Finish();

  private:
    /// One file on the way from the top-level file to the current one.
    struct OpenFile {
        std::string shown;     ///< name in messages
        std::string identity;  ///< tells whether two are the same file
    };

    void ReadTokens(std::string_view written, std::string_view name);
    /// The text of a frame, where frames are rendered.
    std::optional<std::string> WithFrame(std::string_view text, std::string_view name);
    void ReadDirective(Lexer &lexer);
    void RefuseDirective(const Token &token);
    bool CheckPlace(const Directive &d);
    /// A file that a directive names: checked, read, parsed.
    void ReadNested(const std::string &name, const FileLoc &use);
    /// Counts one more; false, once with an error, where these are too many or too deep.
    bool MayInclude(const FileLoc &use);
    /// Says that the whole scene is of an older pbrt, and which names changed.
    void ReportOld();
    void ReportCycle(const OpenFile &again, const FileLoc &use);

    SceneDescription *scene;
    Diagnostics *log;
    DirectiveContext context;
    std::string dir;  ///< folder of the top-level file
    std::vector<OpenFile> open;
    int included = 0;          ///< files that directives named
    bool allFilesRead = true;  ///< the top-level ones
    bool saidNotInWorld = false;
};

}  // namespace pbrt
