#include "bench/feather/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bench/feather/cases.h"
#include "bench/feather/rough_film_errors.h"
#include "pbrt/bsdftool/command_line.h"
#include "pbrt/cli/options.h"

namespace pbrt::bench {
namespace {

using namespace bsdftool;

/// Timed in the same run.
constexpr std::string_view kConductor =
    "Material \"conductor\" \"float roughness\" 0.3 \"bool remaproughness\" false";

struct Options {
    CommonOptions common;
    std::string csv, roughFilms;
    int rounds = 20, pairs = 1000;
};

/// R is zero for most pairs and cheap: so many more of them than for TRT.
constexpr int kPairsForParts = 16;

constexpr char kDescription[] =
    "Nanoseconds per f, PDF and Sample_f of a material (4 wavelengths, one thread, directions "
    "uniform on the upper hemisphere, the fastest of several runs), beside other materials and "
    "sinf. For featherbarbule also the time of Sample_f without f, time and error of each "
    "quadrature of TRT, and the errors of R, PDF and T, all against double precision with a "
    "converged quadrature, and a film's reflectance beside the complex series.";

void DefineOptions(CLI::App *app, Options *o) {
    AddMaterial(app, &o->common);
    cli::AddNumber(app, "--rounds", &o->rounds, {.lo = 1, .hi = 100000},
                   "rounds of three passes, of which the fastest counts (default: 20)");
    cli::AddNumber(app, "--pairs", &o->pairs, {.lo = 1, .hi = 1000000},
                   "pairs of directions for errors (default: 1000)");
    cli::AddText(app, "--csv", &o->csv, "file for the same table as CSV");
    cli::AddText(app, "--rough-films", &o->roughFilms,
                 "file for errors of films of varying thickness, as CSV (half a minute)");
}

std::vector<Case> Yardsticks() {
    std::vector<Case> cases{SineCase(), HairCase()};
    Diagnostics log;
    if (const auto source = ReadMaterial(std::string(kConductor), "", log))
        cases.push_back(CaseOf("conductor, GGX 0.3", source->material));
    return cases;
}

std::string Cell(const std::optional<double> &value, int digits) {
    return value ? fmt::format(" {:9.{}f}", *value, digits) : fmt::format(" {:>9}", "");
}

std::optional<double> Percent(const std::optional<double> &share) {
    if (!share) return {};
    return *share * 100;
}

std::string Table(const std::vector<Case> &cases) {
    std::string table = fmt::format("{:<22} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "", "f ns",
                                    "PDF ns", "Sample_f", "without f", "light %", "f %");
    for (const Case &c : cases) {
        const Row &r = c.row;
        table += fmt::format("{:<22}", r.name) + Cell(r.f, 1) + Cell(r.pdf, 1) + Cell(r.sample, 1) +
                 Cell(r.draw, 1) + Cell(Percent(r.lightError), 3) + Cell(Percent(r.fError), 3);
        table.erase(table.find_last_not_of(' ') + 1);
        table += '\n';
    }
    return table;
}

std::string Csv(const std::vector<Case> &cases) {
    const auto cell = [](const std::optional<double> &value) {
        return value ? fmt::format(",{:.6g}", *value) : std::string(",");
    };
    std::string csv =
        "name,f_ns,pdf_ns,sample_ns,sample_without_f_ns,trt_light_error,trt_f_error,film_error,"
        "R_error,pdf_error,T_error\n";
    for (const auto &[r, timers] : cases)
        csv += fmt::format("\"{}\"", r.name) + cell(r.f) + cell(r.pdf) + cell(r.sample) +
               cell(r.draw) + cell(r.lightError) + cell(r.fError) + cell(r.filmError) +
               cell(r.partR) + cell(r.partPdf) + cell(r.partT) + "\n";
    return csv;
}

/// What the targets are about: times that hardly depend on the machine.
std::string Ratios(const Row &row, const Row &sine) {
    const double unit = *sine.f;
    std::string text = fmt::format("{}: f {:.1f}, PDF {:.1f}, Sample_f {:.1f}", row.name,
                                   *row.f / unit, *row.pdf / unit, *row.sample / unit);
    if (row.draw) text += fmt::format(", without f {:.1f}", *row.draw / unit);
    return text + " times sinf\n";
}

std::string Describe(const PartErrors &e) {
    return fmt::format(
        "light %, f %: rms error of TRT times both cosines, and of TRT, relative to the mean\n"
        "Largest errors away from edges: R {:.2g} of its largest wavelength ({} pairs), PDF "
        "{:.2g}; "
        "T {:.2g}\n",
        e.R, e.lit, e.pdf, e.gap);
}

std::string DescribeFilms(const std::vector<Case> &cases) {
    std::string text;
    for (const auto &[r, timers] : cases)
        if (r.filmError)
            text += fmt::format("{}: largest error {:.2g} up to 89.4 degrees and 2 um\n", r.name,
                                *r.filmError);
    return text;
}

Outcome WithOptions(Options &o) {
    Diagnostics log;
    const auto source = ReadMaterial(o.common, log);
    CheckWritable(o.csv, log);
    CheckWritable(o.roughFilms, log);
    if (log.HasErrors()) return Finish(log);

    std::vector<Case> cases{CaseOf(source->type, source->material)};
    const auto add = [&](std::vector<Case> more) {
        std::move(more.begin(), more.end(), std::back_inserter(cases));
    };
    add(Yardsticks());
    const auto *barbule = std::get_if<FeatherBarbuleMaterial>(&source->material);
    PartErrors parts;
    if (barbule) {
        add(FilmCases());
        add(PartCases(*barbule));
        add(QuadratureCases(*barbule, o.pairs));
        parts = MeasureParts(*barbule, kPairsForParts * o.pairs);
        cases[0].row.partR = parts.R;
        cases[0].row.partPdf = parts.pdf;
        cases[0].row.partT = parts.gap;
    }
    RunTimers(cases, o.rounds);
    WriteText(o.csv, Csv(cases), log);
    if (!o.roughFilms.empty()) WriteText(o.roughFilms, RoughFilmCsv(), log);
    std::string text = Table(cases) + Ratios(cases[0].row, cases[1].row);
    if (barbule) text += Describe(parts) + DescribeFilms(cases);
    return Finish(log, std::move(text));
}

}  // namespace

cli::Outcome Run(cli::Args args) {
    return cli::RunWithOptions(args, "bench_feather", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::bench
