#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "pbrt/bsdftool/command_line.h"
#include "pbrt/bsdftool/energy.h"
#include "pbrt/cli/options.h"

namespace pbrt::bsdftool {
namespace {

constexpr int kWavelengths = 48;

struct Options {
    CommonOptions common;
    std::string thetas = "0,15,30,45,60,75,85", phis = "0,90,180", csv;
    int samples = 4096;
};

constexpr char kDescription[] =
    "What becomes of light of one direction that falls on a material, as shares of it, means "
    "over wavelengths of equal energy: scattered to its own side and to the other, of this R "
    "and TRT, straight through (T), and absorbed, which is the rest. (featherbarbule leaves "
    "light out that meets a second barbule; it counts as absorbed.)";

void DefineOptions(CLI::App *app, Options *o) {
    AddMaterial(app, &o->common);
    cli::AddText(app, "--thetas", &o->thetas,
                 "angles to the normal, degrees; beyond 90: from below", "theta,theta,...");
    cli::AddText(app, "--phis", &o->phis,
                 "azimuths from x (across barbules) towards y (along them), degrees",
                 "phi,phi,...");
    cli::AddNumber(app, "--samples", &o->samples, {.lo = 16, .hi = 1 << 24},
                   "directions drawn per row and four wavelengths");
    cli::AddText(app, "--csv", &o->csv, "file for the same table as CSV");
}

struct Row {
    float theta, phi;
    Albedo energy;
};

struct Column {
    std::string_view name;
    double (*value)(const Albedo &e);
};

constexpr Column kReflected{"reflected", [](const Albedo &e) { return Albedo::Mean(e.reflected); }};
constexpr Column kTransmitted{"transmitted",
                              [](const Albedo &e) { return Albedo::Mean(e.transmitted); }};
constexpr Column kR{"R", [](const Albedo &e) { return Albedo::Mean(e.R); }};
constexpr Column kTRT{"TRT", [](const Albedo &e) { return Albedo::Mean(e.TRT); }};
constexpr Column kT{"T", [](const Albedo &e) { return e.gap; }};
constexpr Column kAbsorbed{"absorbed", [](const Albedo &e) { return e.Absorbed(); }};
constexpr Column kError{"+-", [](const Albedo &e) { return e.error; }};

std::vector<Column> ColumnsFor(const Material &material) {
    if (std::holds_alternative<FeatherBarbuleMaterial>(material))
        return {kReflected, kTransmitted, kR, kTRT, kT, kAbsorbed, kError};
    return {kReflected, kTransmitted, kAbsorbed, kError};
}

std::string Table(const std::vector<Column> &columns, const std::vector<Row> &rows) {
    std::string table = fmt::format("{:>6} {:>6}", "theta", "phi");
    for (const Column &c : columns)
        table += fmt::format(" {:>11}", c.name);
    table += '\n';
    for (const Row &row : rows) {
        table += fmt::format("{:6g} {:6g}", row.theta, row.phi);
        for (const Column &c : columns)
            table += fmt::format(" {:11.5f}", c.value(row.energy));
        table += '\n';
    }
    return table;
}

std::string Csv(const std::vector<Column> &columns, const std::vector<Row> &rows) {
    std::string csv = "theta,phi";
    for (const Column &c : columns)
        csv += fmt::format(",{}", c.name == kError.name ? "error" : c.name);
    csv += '\n';
    for (const Row &row : rows) {
        csv += fmt::format("{:g},{:g}", row.theta, row.phi);
        for (const Column &c : columns)
            csv += fmt::format(",{:.9g}", c.value(row.energy));
        csv += '\n';
    }
    return csv;
}

Outcome WithOptions(Options &o) {
    Diagnostics log;
    const auto source = ReadMaterial(o.common, log);
    const std::vector<float> thetas = ReadNumbers(o.thetas, "--thetas", 0, 180, log);
    const std::vector<float> phis = ReadNumbers(o.phis, "--phis", -360, 360, log);
    CheckWritable(o.csv, log);
    if (log.HasErrors()) return Finish(log);

    std::vector<Row> rows;
    for (float theta : thetas)
        for (float phi : phis)
            rows.push_back({theta, phi, {}});
    const std::vector<float> lambda = MiddleWavelengths(kWavelengths);
    tbb::parallel_for(size_t(0), rows.size(), [&](size_t i) {
        const LocalDirection w = Spherical(rows[i].theta, rows[i].phi);
        rows[i].energy = AlbedoFrom(source->material, w, lambda, o.samples);
    });
    const std::vector<Column> columns = ColumnsFor(source->material);
    WriteText(o.csv, Csv(columns, rows), log);
    return Finish(log, Table(columns, rows));
}

}  // namespace

Outcome RunFurnace(Args args) {
    return cli::RunWithOptions(args, "bsdftool furnace", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::bsdftool
