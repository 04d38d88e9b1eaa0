"""The league table of the engines that are installed, and its picture: error against cost.

    python3 league.py [--out DIR] [--tops NAME,NAME]

writes league.csv (a row for each engine, setting and top), league.md and league.svg.
"""
import argparse
import csv
import math
import os
import statistics

from engines import installed
from heavytop import HERE, names, score

COLUMNS = ["engine", "name", "step", "angle", "omega", "energy", "momentum", "length", "seconds"]


def run(tops):
    for label, engine, settings in installed():
        for step in settings:
            for name in tops:
                yield {"engine": label, **score(engine, name, step)}
            print(f"{label}, {step:g}")


def median(rows, key):
    return statistics.median(row[key] for row in rows)


def grouped(rows):
    groups = {}
    for row in rows:
        groups.setdefault((row["engine"], row["step"]), []).append(row)
    return groups


def slope(groups, label):
    """The order of convergence: log error against log step, from the two finest steps of which the errors are small; for
    engines of fixed steps only."""
    steps = sorted(step for engine, step in groups if engine == label)
    if max(steps) / min(steps) > 100:
        return "adaptive"
    fine, coarse = ({row["name"]: row["angle"] for row in groups[label, step]} for step in steps[:2])
    ratios = [math.log2(coarse[n] / fine[n]) / math.log2(steps[1] / steps[0]) for n in fine if 1e-11 < fine[n] and coarse[n] < 0.1]
    return f"{statistics.median(ratios):.1f}" if ratios else "-"


def markdown(rows):
    groups = grouped(rows)
    lines = ["| engine | step or tolerance | median angle error (rad) | worst | median energy drift | order | CPU s |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    for (label, step), group in groups.items():
        lines.append(f"| {label} | {step:g} | {median(group, 'angle'):.1e} | {max(row['angle'] for row in group):.1e} "
                     f"| {median(group, 'energy'):.1e} | {slope(groups, label)} | {sum(row['seconds'] for row in group):.2f} |")
    return "\n".join(lines) + "\n"


COLOURS = ["#1b6ca8", "#c1440e", "#2e7d32", "#7b3f98", "#b8860b", "#555555", "#00838f", "#ad1457"]


def picture(rows):
    """Median error in angle against CPU seconds, both logarithmic."""
    points = {}
    for (label, _), group in grouped(rows).items():
        points.setdefault(label, []).append((max(sum(r["seconds"] for r in group), 1e-3), max(median(group, "angle"), 1e-15)))
    xs = [math.log10(x) for line in points.values() for x, _ in line]
    ys = [math.log10(y) for line in points.values() for _, y in line]
    x0, x1, y0, y1 = math.floor(min(xs)), math.ceil(max(xs)), math.floor(min(ys)), math.ceil(max(ys))
    width, height, left, top = 720, 460, 70, 20
    plot_width, plot_height = 400, 380

    def place(x, y):
        return (left + plot_width * (math.log10(x) - x0) / (x1 - x0), top + plot_height * (y1 - math.log10(y)) / (y1 - y0))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
           f'<rect width="{width}" height="{height}" fill="white"/>']
    for k in range(x0, x1 + 1):
        x, _ = place(10.0**k, 10.0**y0)
        out.append(f'<path d="M{x:.1f} {top}v{plot_height}" stroke="#ddd"/><text x="{x:.1f}" y="{top + plot_height + 18}" text-anchor="middle">1e{k}</text>')
    for k in range(y0, y1 + 1, 2):
        _, y = place(10.0**x0, 10.0**k)
        out.append(f'<path d="M{left} {y:.1f}h{plot_width}" stroke="#ddd"/><text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">1e{k}</text>')
    for n, (label, line) in enumerate(points.items()):
        colour = COLOURS[n % len(COLOURS)]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(*point) for point in line))
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>' for x, y in (place(*point) for point in line)]
        y = top + 14 + 22 * n
        out.append(f'<circle cx="{left + plot_width + 20}" cy="{y - 4}" r="4" fill="{colour}"/><text x="{left + plot_width + 30}" y="{y}">{label}</text>')
    out.append(f'<text x="{left + plot_width / 2}" y="{height - 18}" text-anchor="middle">CPU time for all tops, s</text>')
    out.append(f'<text transform="translate(18 {top + plot_height / 2}) rotate(-90)" text-anchor="middle">median of the largest error in angle, rad</text>')
    return "\n".join(out) + "\n</svg>\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", default=HERE)
    parser.add_argument("--tops", default="")
    options = parser.parse_args()
    rows = list(run(options.tops.split(",") if options.tops else names()))
    os.makedirs(options.out, exist_ok=True)
    with open(os.path.join(options.out, "league.csv"), "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    for name, contents in (("league.md", markdown(rows)), ("league.svg", picture(rows))):
        with open(os.path.join(options.out, name), "w") as file:
            file.write(contents)


if __name__ == "__main__":
    main()
