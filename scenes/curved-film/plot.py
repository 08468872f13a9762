"""Draws the table of curved_film_csv (standard input) as a PNG: plot.py out.png"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

rows = list(csv.DictReader(sys.stdin))
angle = [float(row["angle"]) for row in rows]
figure, axes = plt.subplots(figsize=(7, 4.2), dpi=110, layout="constrained")
for name, label, style in [
    ("radius_4um", "radius 4 µm", "C1-"),
    ("radius_40um", "radius 40 µm", "C0-"),
    ("flat", "flat", "k--"),
]:
    axes.plot(angle, [float(row[name]) for row in rows], style, label=label, linewidth=1.6)
axes.set(
    xlabel="angle between the light's way in and its way out [degrees]",
    ylabel="reflectance",
    xlim=(0, 180),
    ylim=(0, 1),
    title="Keratin film, 650 nm thick, at 520 nm: curved against flat",
)
axes.legend(loc="upper left")
figure.savefig(sys.argv[1])
