#include "pbrt/scene/parser.h"

#include <fmt/format.h>

#include <filesystem>

#include "pbrt/scene/frame_text.h"
#include "pbrt/scene/scene_file.h"

namespace pbrt {
namespace {

/// After this many errors a file is no scene, and more messages help nobody.
constexpr int kMostErrors = 200;
/// Files that include two others each, a few dozen deep, would otherwise be read for ever; and each
/// that is open takes a piece of the stack. A scene of 3.2 million instances includes 168421.
constexpr int kMostIncluded = 300000;
constexpr size_t kMostOpen = 200;

/// Reason why the text cannot be a scene; else empty.
std::string_view NotAScene(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return "the file is in UTF-16; scene files are UTF-8";
    if (text.starts_with("\x1F\x8B")) return "the file is compressed; name it .gz";
    if (text.find('\0') != text.npos) return "the file is not text";
    return {};
}

/// The same for all names of one file.
std::string CanonicalPath(const std::string &path) {
    std::error_code unknown;
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, unknown);
    return unknown ? path : canonical.string();
}

/// Reports that `use` names a file that is not there, or returns false. Some scenes come with a
/// script that makes files.
bool ReportMissing(const std::string &path, const std::string &name, const std::string &dir,
                   const FileLoc &use, Diagnostics *log) {
    std::error_code unknown;
    if (std::filesystem::status(path, unknown).type() != std::filesystem::file_type::not_found)
        return false;
    log->MissingFile(use, name, dir);
    const std::string folder = FolderOf(use.file);
    const std::string script = folder.empty() ? "generate.sh" : folder + "/generate.sh";
    if (std::filesystem::exists(script, unknown))
        log->Warning(use,
                     fmt::format("{} may make it: run that with the folder of the programs, or "
                                 "render.sh",
                                 script));
    return true;
}

}  // namespace

Parser::Parser(SceneDescription *scene, Diagnostics *log)
    : scene(scene),
      log(log),
      context(
          scene, [](std::string_view word) { return FindDirective(word) != nullptr; }, log,
          [this](const std::string &name, const FileLoc &use) { ReadNested(name, use); }) {}

void Parser::ReadFile(const std::string &path) {
    const std::string_view name = scene->fileNames.emplace_back(path == "-" ? "<stdin>" : path);
    const std::optional<std::string> text = ReadFileContents(path, Pipes::Taken, {}, *log);
    if (!text) {
        allFilesRead = false;
        return;
    }
    open = {{std::string(name), CanonicalPath(path)}};
    dir = FolderOf(path);
    scene->dir = dir;
    ReadTokens(*text, name);
}

void Parser::ReadText(std::string_view text, std::string_view name, std::string_view folder) {
    open = {{std::string(name), CanonicalPath(std::string(name))}};
    dir = folder;
    scene->dir = dir;
    ReadTokens(text, scene->fileNames.emplace_back(name));
}

void Parser::Finish() {
    if (!context.builder.InWorld() && allFilesRead)
        log->Error({open[0].shown, 0, 0}, "the scene ends without WorldBegin");
    context.builder.Finish();
    if (IsOld(*log)) ReportOld();
}

void Parser::ReportOld() {
    std::string names;
    for (const auto &[old, loc] : log->OldNames()) {
        const bool isPlugIn = old->kind != "directive" && !old->kind.ends_with(" type");
        if (isPlugIn)
            log->Error(loc, fmt::format("{} \"{}\": {}", old->kind, old->was, CalledNow(*old)));
        names += fmt::format("{}{} -> {}", names.empty() ? "" : ", ", old->was,
                             old->is.empty() ? "nothing" : old->is);
    }
    log->Error({open[0].shown, 0, 0},
               fmt::format("this is a scene for pbrt-v3 or older: \"pbrt --upgrade old.pbrt > "
                           "new.pbrt\" rewrites it ({})",
                           names));
}

void Parser::ReadTokens(std::string_view written, std::string_view name) {
    const std::optional<std::string> replaced = WithFrame(written, name);
    const std::string_view text = replaced ? *replaced : written;
    scene->content.AddText(text, dir);
    if (const std::string_view why = NotAScene(text); !why.empty()) {
        allFilesRead = false;
        return log->Error({name, 0, 0}, why);
    }
    Lexer *const outer = context.arguments.Source();
    Lexer lexer(text, name, log);
    context.arguments.ReadFrom(&lexer);
    while (lexer.Peek().kind != TokenKind::End) {
        ReadDirective(lexer);
        if (log->ErrorCount() >= kMostErrors) {
            // Without a line, so that it stands before the messages by place, which are cut off.
            log->Error({name, 0, 0}, fmt::format("{} errors; reading stopped at line {}",
                                                 log->ErrorCount(), lexer.Loc().line));
            break;
        }
    }
    context.arguments.ReadFrom(outer);
}

std::optional<std::string> Parser::WithFrame(std::string_view text, std::string_view name) {
    if (!scene->options.frame) return {};
    OrError<std::string> replaced = PutFrame(text, *scene->options.frame);
    if (!replaced) log->Error({name, 0, 0}, replaced.error);
    return std::move(replaced.value);
}

void Parser::ReadDirective(Lexer &lexer) {
    const Token &token = lexer.Peek();
    const Directive *const directive =
        token.kind == TokenKind::Word ? FindDirective(token.text) : nullptr;
    context.arguments.Begin(directive ? directive->name : "");
    if (!directive) {
        if (!lexer.ReportMissingQuote()) {
            RefuseDirective(token);
            const bool isIntegrator = token.text == "SurfaceIntegrator";
            if (token.kind != TokenKind::Open) lexer.Advance();
            if (isIntegrator) context.NoteIfOld("integrator", lexer.Peek().text, lexer.Loc());
        }
        return context.arguments.Resynchronise();
    }
    lexer.Advance();
    if (!CheckPlace(*directive)) return context.arguments.Resynchronise();
    directive->read(context);
}

void Parser::RefuseDirective(const Token &token) {
    if (token.kind == TokenKind::Broken) return;  // reported by the lexer
    const FileLoc &at = context.arguments.At();
    if (token.kind != TokenKind::Word || !MayBeDirective(token.text))
        return log->Error(at, fmt::format("expected a directive, found {}", Describe(token)));
    const std::string old = OldDirectiveHint(token.text);
    context.NoteIfOld("directive", token.text, at);
    log->Error(at, fmt::format("unknown directive {}{}", Describe(token),
                               old.empty() ? DidYouMean(token.text, DirectiveNames())
                                           : fmt::format("; {}", old)));
}

/// A directive before WorldBegin that belongs after it is read all the same, so that its own
/// mistakes are found; the others misplaced in the same way are then not reported again.
bool Parser::CheckPlace(const Directive &d) {
    if (d.where == Where::BeforeWorld && context.builder.InWorld()) {
        log->Error(context.arguments.At(),
                   fmt::format("{} is allowed only before WorldBegin", d.name));
        return false;
    }
    if (d.where == Where::InWorld && !context.builder.InWorld() && !saidNotInWorld) {
        log->Error(context.arguments.At(),
                   fmt::format("{} is allowed only after WorldBegin", d.name));
        saidNotInWorld = true;
    }
    return true;
}

void Parser::ReadNested(const std::string &name, const FileLoc &use) {
    const std::string path = ResolvePath(name, dir);
    const OpenFile file{path == "-" ? "<stdin>" : path, CanonicalPath(path)};
    for (const OpenFile &f : open)
        if (f.identity == file.identity) return ReportCycle(file, use);
    if (!MayInclude(use) || (path != "-" && ReportMissing(path, name, dir, use, log))) return;
    const std::optional<std::string> text = ReadFileContents(path, Pipes::Refused, use, *log);
    if (!text) return;
    open.push_back(file);
    ReadTokens(*text, scene->fileNames.emplace_back(file.shown));
    open.pop_back();
}

bool Parser::MayInclude(const FileLoc &use) {
    if (open.size() >= kMostOpen) {
        log->Error(use, fmt::format("files include each other more than {} deep", kMostOpen));
        return false;
    }
    if (++included == kMostIncluded + 1)
        log->Error(use, fmt::format("more than {} files are included", kMostIncluded));
    return included <= kMostIncluded;
}

void Parser::ReportCycle(const OpenFile &again, const FileLoc &use) {
    std::string chain;
    bool within = false;
    for (const OpenFile &f : open) {
        within = within || f.identity == again.identity;
        if (within) chain += fmt::format("\"{}\" -> ", f.shown);
    }
    log->Error(use, fmt::format("the file includes itself: {}\"{}\"", chain, again.shown));
}

bool IsOld(const Diagnostics &log) {
    constexpr size_t kFewest = 2;  // one is a slip of the hand
    return log.OldNames().size() >= kFewest;
}

void ParseFiles(const std::vector<std::string> &files, SceneDescription &scene, Diagnostics &log) {
    Parser parser(&scene, &log);
    if (files.empty()) parser.ReadFile("-");
    for (const std::string &file : files)
        parser.ReadFile(file);
    parser.Finish();
}

void ParseString(std::string_view text, std::string_view name, std::string_view dir,
                 SceneDescription &scene, Diagnostics &log) {
    Parser parser(&scene, &log);
    parser.ReadText(text, name, dir);
    parser.Finish();
}

}  // namespace pbrt
