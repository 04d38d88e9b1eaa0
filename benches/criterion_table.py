#!/usr/bin/env python3
"""Collects the estimates of `cargo bench` and writes tables.

    benches/criterion_table.py [TARGET_DIR]

Reads TARGET_DIR/criterion (default: $CARGO_TARGET_DIR or target), writes data/benchmarks/criterion.csv (nanoseconds per
call: median of the samples with its confidence interval, mean, standard deviation) and prints the table in Markdown.
"""
import csv
import json
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def estimates(folder):
    for path in sorted(folder.glob("**/new/estimates.json")):
        name = json.loads((path.parent / "benchmark.json").read_text())["full_id"]
        data = json.loads(path.read_text())
        median = data["median"]
        interval = median["confidence_interval"]
        yield (name, median["point_estimate"], interval["lower_bound"], interval["upper_bound"],
               data["mean"]["point_estimate"], data["std_dev"]["point_estimate"])


def human(nanoseconds):
    for unit, size in (("ms", 1e6), ("µs", 1e3)):
        if nanoseconds >= size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds:.3g} ns"


def main():
    target = sys.argv[1] if len(sys.argv) > 1 else os.environ.get("CARGO_TARGET_DIR", "target")
    rows = list(estimates(pathlib.Path(target) / "criterion"))
    if not rows:
        sys.exit(f"no estimates under {target}/criterion; run cargo bench first")
    out = ROOT / "data" / "benchmarks" / "criterion.csv"
    out.parent.mkdir(parents=True, exist_ok=True)
    with open(out, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["benchmark", "median_ns", "median_low_ns", "median_high_ns", "mean_ns", "std_dev_ns"])
        for name, *values in rows:
            writer.writerow([name] + [f"{value:.1f}" for value in values])
    print("| benchmark | median | 95 % interval |\n| --- | ---: | ---: |")
    for name, median, low, high, *_ in rows:
        print(f"| `{name}` | {human(median)} | {human(low)} – {human(high)} |")


main()
