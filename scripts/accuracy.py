"""Plots and tables of docs/ACCURACY.md from docs/accuracy/*.csv; called by accuracy.sh."""

import csv
import pathlib
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

DOCS = pathlib.Path(__file__).resolve().parent.parent / "docs"
MODEL, RENDERS, DEFAULT = "featherbarbule", "featherbarbule, by 16", "adaptive"


def read(name):
    with open(DOCS / "accuracy" / f"{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


def number(row, column):
    return float(row[column]) if row.get(column) else None


def cell(value, digits):
    return "" if value is None else f"{value:.{digits}f}"


def markdown(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def times(bench):
    sine = number(bench["sinf"], "f_ns")
    rows = []
    for name in [RENDERS, MODEL, "hair", "conductor, GGX 0.3", "film, real numbers",
                 "film, complex series", "film, series in double", "sinf"]:
        row = bench[name]
        rows.append([name])
        for column in ["f_ns", "pdf_ns", "sample_ns", "sample_without_f_ns"]:
            ns = number(row, column)
            rows[-1].append("" if ns is None else f"{ns:.1f} ({ns / sine:.1f})")
    return markdown(["", "f, ns (times sinf)", "PDF", "Sample_f", "Sample_f without f"], rows)


def is_quadrature(row):
    return bool(row["trt_light_error"])


def quadratures(bench, others):
    rows = []
    for name, row in bench.items():
        if not is_quadrature(row):
            continue
        percent = [100 * number(row, "trt_light_error"), 100 * number(row, "trt_f_error")]
        percent += [100 * number(other[name], "trt_light_error") for other in others]
        rows.append([name, cell(number(row, "f_ns"), 0), *(f"{p:.3f}" for p in percent)])
    return markdown(["rule", "f, ns", "light, %", "f, %", "light, d = 2 um", "light, opening 0.6"],
                    rows)


def targets(bench, sparse):
    renders, alone, sine = bench[RENDERS], bench[MODEL], number(bench["sinf"], "f_ns")
    hair = number(bench["hair"], "f_ns")
    # In float the series is less exact; in double it is what is no less exact.
    real = bench["film, real numbers"]
    series = min((row for name, row in bench.items() if "series" in name
                  and number(row, "film_error") <= number(real, "film_error")),
                 key=lambda row: number(row, "f_ns"))

    def ratio(column, unit):
        return [number(row, column) / unit for row in (renders, alone)]

    def error(column):
        return [100 * number(row, column) for row in (renders, bench[DEFAULT])]

    def worst(column):
        return [max(number(kind[MODEL], column) for kind in (bench, sparse))]

    speedup = number(series, "f_ns") / number(real, "f_ns")
    lines = [
        ("f, times sinf", "<= 90", ratio("f_ns", sine)),
        ("PDF, times sinf", "<= 8", ratio("pdf_ns", sine)),
        ("Sample_f without f, times sinf", "<= 27", ratio("sample_without_f_ns", sine)),
        ("f, times f of hair", "<= 1", ratio("f_ns", hair)),
        ("R, largest relative error away from edges", "<= 1e-5", worst("R_error")),
        ("T, largest error (default and spacing 2.5)", "<= 1e-5", worst("T_error")),
        ("TRT, rms error over mean, of light, %", "<= 0.5", error("trt_light_error")),
        ("TRT, rms error over mean, of f, %", "<= 0.5", error("trt_f_error")),
        ("film, times faster than the complex series of no larger error", ">= 5", [speedup]),
    ]
    rows = []
    for what, bound, values in lines:
        sign, limit = bound.split()
        met = values[0] >= float(limit) if sign == ">=" else values[0] <= float(limit)
        alone = f"{values[1]:.3g}" if len(values) > 1 else ""
        rows.append([what, bound, f"{values[0]:.3g}", "yes" if met else "**no**", alone])
    return markdown(["target", "bound", "as rendered", "met", "one call alone"], rows)


def sampling(rows):
    spp = sorted({int(row["spp"]) for row in rows})
    ways = list(dict.fromkeys(row["way"] for row in rows))
    table = []
    for way in ways:
        mine = {int(r["spp"]): r for r in rows if r["way"] == way}
        table.append([way] + [f'{float(mine[n]["rms_error"]):.3f} in {float(mine[n]["seconds"]):.2f} s'
                              for n in spp])
    return markdown(["rms error / mean, processor time"] + [f"{n} spp" for n in spp], table)


def rough_reflectances(rows):
    mine = [r for r in rows if r["kind"] == "reflectance"]
    deviations = sorted({float(r["deviation"]) for r in mine})
    table = []
    for angles in dict.fromkeys((r["from"], r["to"]) for r in mine):
        band = {float(r["deviation"]): r for r in mine if (r["from"], r["to"]) == angles}
        table.append(["{} to {}".format(*angles), f'{float(band[deviations[0]]["mean"]):.2f}'] +
                     ["{:.1e} / {:.0e}".format(float(band[d]["rms"]), float(band[d]["most"]))
                      for d in deviations])
    return markdown(["incidence, deg", "mean R"] + [f"up to {d:g} nm" for d in deviations], table)


def rough_returns(rows):
    mine = [r for r in rows if r["kind"].startswith("return")]
    deviations = sorted({float(r["deviation"]) for r in mine})
    table = []
    for kind in dict.fromkeys(r["kind"] for r in mine):
        by = {float(r["deviation"]): r for r in mine if r["kind"] == kind}
        percent = [[100 * float(by[d][c]) / float(by[d]["mean"]) for c in ("bias", "rms")]
                   for d in deviations]
        table.append([kind.split(", ")[1]] + [f"{bias:.2f} / {rms:.2f}" for bias, rms in percent])
    return markdown(["bias / rms, %"] + [f"{d:g} nm" for d in deviations], table)


def rough_times(bench, rough, cells):
    def ns(kind, row, column="f_ns"):
        return f"{number(kind[row], column):.1f}"
    part = "vertex's input"
    return markdown(["ns", "plain", "`filmroughness` 10", "cells"],
                    [["f, by 16", ns(bench, RENDERS), ns(rough, RENDERS), ns(cells, RENDERS)],
                     ["Sample_f, by 16"] + [ns(k, RENDERS, "sample_ns")
                                            for k in (bench, rough, cells)],
                     [part, ns(bench, part), ns(rough, part), ns(cells, part)]])


def save(figure, name):
    figure.tight_layout()
    figure.savefig(DOCS / "images" / f"{name}.png", dpi=110, metadata={"Software": None})
    plt.close(figure)


def plot_quadratures(bench):
    figure, axes = plt.subplots(figsize=(7.2, 4.4))
    families = [("Gauss, ", "plain Gauss-Legendre", "s"), ("segments", "lanes of segments", "o"),
                (DEFAULT, "adaptive, one call", "D"), (RENDERS, "adaptive, by 16: renders", "*")]
    for key, label, marker in families:
        rows = [r for r in bench.values() if is_quadrature(r) and key in r["name"]]
        x = [number(r, "f_ns") for r in rows]
        y = [100 * number(r, "trt_light_error") for r in rows]
        axes.plot(x, y, marker, label=label, markersize=13 if marker == "*" else 6)
        for row, a, b in zip(rows, x, y):
            if row["name"] in (DEFAULT, RENDERS):
                continue  # the legend names them
            name = row["name"].replace(" segments", "").replace("Gauss, ", "")
            axes.annotate(name, (a, b), xytext=(6, 4), textcoords="offset points", fontsize=7)
    axes.axhline(0.5, color="grey", linewidth=0.8, linestyle="--")
    axes.text(axes.get_xlim()[1], 0.53, "target ", ha="right", fontsize=7, color="grey")
    axes.set(xscale="log", yscale="log", xlabel="one f, four wavelengths (ns)",
             ylabel="rms error of TRT light over its mean (%)",
             title="Pigment return: error against time")
    axes.legend()
    save(figure, "accuracy-quadrature")


def plot_sampling(rows):
    figure, axes = plt.subplots(figsize=(7.2, 4.4))
    for way, marker in zip(dict.fromkeys(r["way"] for r in rows), "os^"):
        mine = [r for r in rows if r["way"] == way]
        axes.plot([float(r["seconds"]) for r in mine], [float(r["rms_error"]) for r in mine],
                  marker=marker, label=way)
    axes.set(xscale="log", yscale="log", xlabel="processor time (s)",
             ylabel="rms error over the picture's mean",
             title="dove-swatch, 160 x 120: error against time")
    axes.legend(title="feathers are sampled by")
    axes.grid(which="both", linewidth=0.3)
    save(figure, "accuracy-sampling")


def fill(text, name, table):
    """Replaces what stands between the marks of `name`."""
    return re.sub(rf"(<!-- {name} -->\n).*?(\n<!-- end -->)", lambda m: m[1] + table + m[2], text,
                  flags=re.S)


def main():
    bench = {row["name"]: row for row in read("default")}
    sparse, thick, bent = ({row["name"]: row for row in read(n)} for n in ["sparse", "thick", "bent"])
    rough, cells = ({row["name"]: row for row in read(n)} for n in ["rough", "cells"])
    films = read("rough-films")
    rows = read("sampling")
    plot_quadratures(bench)
    plot_sampling(rows)
    tables = {"targets": targets(bench, sparse), "times": times(bench),
              "quadratures": quadratures(bench, [thick, bent]), "sampling": sampling(rows),
              "rough reflectances": rough_reflectances(films), "rough returns": rough_returns(films),
              "rough times": rough_times(bench, rough, cells)}
    for page in [DOCS / "ACCURACY.md", DOCS.parent / "README.md"]:
        text = page.read_text()
        for name, table in tables.items():
            text = fill(text, name, table)
        page.write_text(text)


if __name__ == "__main__":
    main()
