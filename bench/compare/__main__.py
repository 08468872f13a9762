"""python -m compare: measures and writes bench/RESULTS.md. See --help; bench/run.sh sets it up."""

import argparse
import dataclasses
import os
import sys

from . import measure, pictures, report, runs, scaling, scenes


@dataclasses.dataclass
class Found:
    """All that was measured."""

    results: dict = dataclasses.field(default_factory=dict)
    checks: dict = dataclasses.field(default_factory=dict)
    points: list = dataclasses.field(default_factory=list)
    reading: list = dataclasses.field(default_factory=list)
    start_up: float = 0.0


def arguments():
    names = list(scenes.SCENES) + [measure.FEATHER]
    parser = argparse.ArgumentParser(prog="bench/run.sh", description=report.METHOD,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", default=",".join(names), help="default: all of %(default)s")
    parser.add_argument("--repeats", type=int, default=3, help="runs of each (default 3)")
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--reference-spp", type=int, default=512,
                        help="of the references, kept in build/bench (default 512)")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--text-mb", type=int, default=200, help="of the long scene text")
    parser.add_argument("--ply-triangles", type=int, default=40_000_000,
                        help="of the large PLY, 25 bytes each (default: 1 GB)")
    parser.add_argument("--no-llvm", action="store_true", help="without Mitsuba llvm_ad_spectral")
    parser.add_argument("--no-scalar", action="store_true", help="without Mitsuba scalar_spectral")
    parser.add_argument("--no-scaling", action="store_true", help="without cost against size")
    parser.add_argument("--dry", action="store_true", help="print; do not write RESULTS.md, README")
    options = parser.parse_args()
    options.scenes = [n for n in options.scenes.split(",") if n]
    unknown = set(options.scenes) - set(names)
    if unknown:
        parser.error(f"no such scene: {', '.join(sorted(unknown))}; there are {', '.join(names)}")
    return options


def run(options, setting):
    found = Found()
    for name in options.scenes:
        found.results[name] = measure.measure(name, setting)
        report.store(found, setting.build / "results.json")
    for name in options.scenes:
        if pictures.has_reference(name):
            found.checks[name] = pictures.check(name, setting)
    if not options.no_scaling:
        folder = setting.build / "scaling"
        print("cost against size", flush=True)
        found.start_up = scaling.start_up(folder, setting.threads)
        found.points = scaling.all_series(setting.build, setting.threads)
        found.reading = list(scaling.parsing(folder, setting.threads, options.text_mb,
                                             options.ply_triangles))
    return found


def disagreements(found):
    """What does not agree, as sentences."""
    for name, result in found.results.items():
        if result.agreement and not result.agreement.ok:
            yield f"{name}: the renderers' pictures differ: {result.agreement}"
    for name, check in found.checks.items():
        if not check.ok:
            yield f"{name}: differs from pbrt-v4's picture: {check}"


def main():
    options = arguments()
    setting = measure.Setting(runs.ROOT / "build" / "bench", options.spp, options.repeats,
                              options.threads, options.reference_spp, not options.no_llvm,
                              not options.no_scalar)
    found = run(options, setting)
    if options.dry:
        print(report.results_page(found, setting))
    else:
        report.write(found, setting)
        print(report.summary(found.results))
    wrong = list(disagreements(found))
    for sentence in wrong:
        print(f"Error: {sentence}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
