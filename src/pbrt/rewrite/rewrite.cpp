#include "pbrt/rewrite/rewrite.h"

#include "pbrt/rewrite/read_statements.h"
#include "pbrt/rewrite/to_ply.h"
#include "pbrt/rewrite/upgrade.h"
#include "pbrt/rewrite/write_statements.h"
#include "pbrt/scene/scene_file.h"
#include "pbrt/util/upstream.h"

namespace pbrt::rewrite {
namespace {

/// Spellings of pbrt-v3 that every task takes.
void TakeOldSpellings(Statement *s) {
    for (Parameter &p : s->parameters) {
        const OldName *const old = FindOldName("parameter type", p.type);
        if (old && old->was != "xyz") p.type = old->is;
        if (p.type != "bool") continue;
        for (std::string &value : p.values)
            value = Unquoted(value);
    }
    if (s->directive != "WorldEnd") return;
    s->directive.clear();
    if (!s->remark.empty()) s->comments.push_back(s->remark);
}

class Rewriter {
  public:
    Rewriter(Task task, Diagnostics &log) : task(task), upgrade(&log), toPly(&log), log(log) {}

    void Add(std::string_view text, std::string_view name, const std::string &dir) {
        StatementReader reader(text, name, &log);
        toPly.SetFolder(dir);
        while (std::optional<Statement> s = reader.Next()) {
            TakeOldSpellings(&*s);
            if (task == Task::Upgrade) upgrade.Apply(&*s);
            if (task == Task::ToPly) toPly.Apply(&*s);
            writer.Write(*s);
        }
    }
    std::string Text() const { return log.HasErrors() ? std::string() : writer.Text(); }

  private:
    Task task;
    Upgrade upgrade;
    ToPly toPly;
    StatementWriter writer;
    Diagnostics &log;
};

}  // namespace

std::string RewriteFiles(const std::vector<std::string> &files, Task task, Diagnostics &log) {
    Rewriter rewriter(task, log);
    for (const std::string &file : files.empty() ? std::vector<std::string>{"-"} : files)
        if (const auto text = ReadFileContents(file, Pipes::Taken, {}, log))
            rewriter.Add(*text, file == "-" ? "<stdin>" : std::string_view(file), FolderOf(file));
    return rewriter.Text();
}

std::string RewriteText(std::string_view text, std::string_view name, const std::string &dir,
                        Task task, Diagnostics &log) {
    Rewriter rewriter(task, log);
    rewriter.Add(text, name, dir);
    return rewriter.Text();
}

}  // namespace pbrt::rewrite
