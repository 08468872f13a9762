"""bench/RESULTS.md, its plot, and the table in README.md, from what was measured."""

import dataclasses
import datetime
import json
import pathlib
import platform
import re
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from . import error, measure, runs

HERE = pathlib.Path(__file__).resolve().parent.parent
# Render seconds of pbrt-v4 (June 2026, CPU build), measured once on another machine of two cores on
# which Mitsuba took the second number.
ELSEWHERE = {"matte-spheres": (40.5, 3.07), "glass-caustic": (50.5, 4.32), "mesh-1m": (37.5, 5.80),
             "hairball": (117.5, 26.0)}
METHOD = f"""
Each renderer renders each scene in turn, every run in a process of its own; seconds are the least of
the runs, memory is the largest resident set, also in relation to what must be held at least: the most
that Embree allocates (while it builds; it need not touch all of that), and the scene's files; the
program itself and its libraries take some 12 MiB. Mitsuba compiles its kernel in a picture of one
sample before the timed one; *warm-up* is what that takes when the kernel is in its cache. Both trace
the same geometry, lights and camera to the same depth, with a box filter of one pixel, Russian
roulette from the second bounce; ours uses the zsobol sampler, Mitsuba its independent one. `mesh-1m`
has a layered `coateddiffuse` ground here, and there `roughplastic`, which gives some 2 % more light:
`mesh-1m-matte` is the same with a ground that both have. Hair takes the same absorption in both.

The error is the mean over the runs (each with its own seed) against a converged picture of the same
renderer: *rel. MSE* is the mean over pixels and channels of (x - r)^2 / (r^2 + {error.EPSILON}), less
the share of the reference's own noise; *trimmed* leaves out the largest 0.1 % of the values; FLIP is
HDR-FLIP (Andersson et al. 2021), smaller is better. *Efficiency* is 1 / (rel. MSE x render seconds)
over that of Mitsuba's llvm_ad_spectral: above 1, a given error is reached sooner here. rays/s counts
closest-hit and shadow rays; Mitsuba does not count. pbrt-v4's seconds were measured on another
machine and are scaled by what Mitsuba took there and here.
"""


def table(head, rows):
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def number(value, digits=3):
    return "" if not value else f"{value:.{digits}g}"


def mib(size):
    return f"{size / 2**20:.0f}"


def machine():
    cpu = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    memory = re.search(r"MemTotal:\s*(\d+)", pathlib.Path("/proc/meminfo").read_text())
    system = platform.freedesktop_os_release().get("PRETTY_NAME", platform.system())
    return f"{cpu[1] if cpu else platform.machine()}, {int(memory[1]) / 2**20:.0f} GiB, {system}"


def commit():
    result = subprocess.run(["git", "-C", runs.ROOT, "describe", "--always", "--dirty"],
                            capture_output=True, text=True, check=False)
    return result.stdout.strip() or "unknown commit"


def by_name(rows, renderer):
    return next((r for r in rows if r.renderer == renderer.name), None)


def efficiency(row, rows):
    base = by_name(rows, runs.LLVM)
    return row.efficiency() / base.efficiency() if base and row.mse else None


def quoted(scene, rows):
    """pbrt-v4's row: measured elsewhere, scaled by Mitsuba's time here."""
    base = by_name(rows, runs.LLVM)
    if scene not in ELSEWHERE or not base:
        return []
    theirs, mitsuba = ELSEWHERE[scene]
    return [["pbrt-v4 (elsewhere, scaled)", "", "", number(theirs * base.render / mitsuba)]
            + [""] * 7]


def ratio(value):
    return "" if value is None else f"{value:.2f}"


def bare_line(bare, ours, threads):
    """Embree alone, our traversal, and whole paths with all shading, per thread."""
    rates = {**bare, "rendering": ours.rays_per_second * 1e-6 / threads}
    limit = bare["rtcIntersect1 alone"]
    parts = ", ".join(f"{name} {rate:.2f} ({100 * rate / limit:.0f} %)"
                      for name, rate in rates.items())
    return (f"\nBare: million rays/s of one thread, closest-hit rays of diffuse paths for all but the "
            f"last, which counts shadow rays, too: {parts}.\n")


def comparison(scene, result, threads):
    rows, agreement = result.rows, result.agreement
    head = ["renderer", "load + build s", "warm-up s", "render s", "M rays/s", "peak MiB",
            "/ (Embree + input)", "rel. MSE", "trimmed", "FLIP", "efficiency"]
    lines = [[r.renderer, number(r.load), number(r.warm_up), number(r.render),
              number(r.rays_per_second * 1e-6), mib(r.peak), ratio(r.memory_ratio), number(r.mse),
              number(r.trimmed), number(r.flip), number(efficiency(r, rows))] for r in rows]
    text = f"### {scene}\n\n" + table(head, lines + quoted(scene, rows))
    if agreement:
        text += (f"\nPictures: ratio of the means {agreement.ratio:.4f}; largest difference of a "
                 f"block of 20 x 20 pixels beyond 5 sigma of noise {100 * agreement.beyond_noise:.1f}"
                 f" %: {'agree' if agreement.ok else '**do not agree**'}.\n")
    return text + bare_line(result.bare, by_name(rows, runs.OURS), threads)


def summary(results):
    head = ["scene", "seconds", "Mitsuba 3 llvm", "times faster", "times more efficient"]
    lines = []
    for scene, result in results.items():
        rows = result.rows
        ours, base = by_name(rows, runs.OURS), by_name(rows, runs.LLVM)
        if base:
            lines.append([scene, number(ours.render), number(base.render),
                          number(base.render / ours.render), number(efficiency(ours, rows))])
        else:
            lines.append([scene, number(ours.render), "", "", ""])
    return table(head, lines)


def scaling_table(points):
    head = ["series", "size", "input MB", "load + build s", "ns a sample", "peak MiB",
            "peak / (Embree + input)", "relative variance"]
    return table(head, [[p.series, str(p.size), f"{p.input_bytes / 1e6:.1f}", number(p.load),
                         f"{p.nanoseconds():.0f}", mib(p.peak), ratio(p.memory_ratio()),
                         number(p.mse, 2)] for p in points])


def plot(points, path):
    """Load seconds, cost of a sample and peak memory against size."""
    series = [s for s in dict.fromkeys(p.series for p in points) if not s.startswith("material")]
    figure, axes = plt.subplots(1, 3, figsize=(13, 4))
    values = [("load + build, s", lambda p: p.load), ("one camera sample, ns", lambda p: p.nanoseconds()),
              ("peak memory, MiB", lambda p: p.peak / 2**20)]
    for axis, (label, value) in zip(axes, values):
        for name in series:
            mine = [p for p in points if p.series == name]
            axis.plot([p.size for p in mine], [value(p) for p in mine], "o-", ms=4, label=name)
        axis.set(xscale="log", yscale="log", xlabel="size", title=label)
        axis.grid(linewidth=0.3)
    axes[0].legend(fontsize=7)
    figure.tight_layout()
    path.parent.mkdir(exist_ok=True)
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def reading(points):
    """Text is read in `parse`; a PLY when the scene is built, with Embree's tree over it."""
    lines = []
    for p in points:
        seconds = p.parse if "text" in p.series else p.load
        lines.append([p.series.split(",")[0], str(p.size), number(seconds),
                      f"{p.size / seconds:.0f}", number(p.load), mib(p.peak),
                      ratio(p.memory_ratio())])
    return table(["what", "MB", "seconds", "MB/s", "with building, s", "peak MiB",
                  "peak / (Embree + input)"], lines)


def references(checks):
    head = ["scene", "ratio of the means", "beyond noise", ""]
    return table(head, [[name, f"{a.ratio:.4f}", f"{100 * a.beyond_noise:.1f} %",
                         "agree" if a.ok else "**do not agree**"] for name, a in checks.items()])


def results_page(found, setting):
    versions = f"pbrt-feather {commit()}"
    if setting.llvm or setting.scalar:
        versions += f", Mitsuba {measure.version(runs.LLVM)}"
    text = (f"# Benchmark\n\nMade by `bench/run.sh` on {datetime.date.today()}: {machine()}; "
            f"{versions}; {setting.threads} threads, {setting.spp} samples a pixel, least of "
            f"{setting.repeats} runs, references of {setting.reference_spp} samples "
            "(hairball: half).\n\n")
    text += summary(found.results) + METHOD + "\n## Scenes\n\n"
    text += "\n".join(comparison(s, r, setting.threads) for s, r in found.results.items())
    if found.checks:
        text += ("\n## Against pbrt-v4's pictures\n\nOf 100 x 100 pixels, `bench/reference/`: they agree "
                 "where each channel's mean does within 0.5 %. Beyond noise: blocks of 10 x 10, whose "
                 "noise two pictures tell, badly for hair. The coated ground of mesh-1m is 1 to 2 % "
                 "darker here: our closed form agrees with a random walk of the same model "
                 "(test/bxdf/coated_diffuse_test.cpp), from which pbrt-v4's own seems to differ by "
                 "half of what the coat absorbs.\n\n" + references(found.checks))
    if found.points:
        text += ("\n## Cost against size\n\n![Cost against size](results/scaling.svg)\n\n"
                 f"An empty scene of one pixel: {1000 * found.start_up:.0f} ms from start to end.\n\n"
                 + scaling_table(found.points) + "\n## Reading\n\n" + reading(found.reading))
    return text


def fill_readme(text, content):
    marks = re.compile(r"(<!-- bench -->\n).*?(<!-- end -->)", re.S)
    return marks.sub(lambda m: m[1] + content + m[2], text)


def store(found, path):
    """Everything measured, as JSON."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(dataclasses.asdict(found), indent=1) + "\n")


def write(found, setting):
    (HERE / "RESULTS.md").write_text(results_page(found, setting))
    store(found, HERE / "results" / "results.json")
    if found.points:
        plot(found.points, HERE / "results" / "scaling.svg")
    readme = runs.ROOT / "README.md"
    readme.write_text(fill_readme(readme.read_text(), summary(found.results)))
