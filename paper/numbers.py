"""Checks that every measured number of joss.md is that of the recorded data: python3 paper/numbers.py

Each line says what is measured, where it is recorded and how the paper words it; exit status 1 if the paper words it
otherwise.
"""
import csv
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def rows(name):
    with open(ROOT / "data" / name, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def peers(work, column):
    return next(float(row[column]) for row in rows("benchmarks/peers.csv") if row["work"].startswith(work))


def rounded(microseconds, digits):
    """In the unit in which it is at least a half."""
    units = ((1e6, "s"), (1e3, "ms"), (1, "µs"))
    size, unit = next(((size, unit) for size, unit in units if microseconds >= size / 2), units[-1])
    return f"{float(f'{microseconds / size:.{digits}g}'):g} {unit}"


def facts():
    exact = [row for row in rows("tradeoff/classify.csv") if row["method"] == "exact"]
    total = {key: sum(int(row[key]) for row in exact) for key in ("points", "wrong", "undecided", "untold")}
    assert total["wrong"] == total["undecided"] == 0
    yield f"Of {total['points']:,} points"
    yield f"for {total['untold']:,} of them"
    strata = {row["stratum"] for row in exact}
    yield f"{len(strata)} strata"
    yield f"{sum(int(row['points']) for row in exact if not row['distance']):,} bodies"
    nearest = min((row["distance"] for row in exact if row["distance"]), key=float)
    yield f"$10^{{{nearest.removeprefix('1e')}}}$"
    curves = rows("tradeoff/curves.csv")
    assert sum(int(row["wrong"]) for row in curves) == 0
    yield f"On {sum(int(row['points']) for row in curves):,} points exactly on curves"
    medians = {row["benchmark"]: float(row["median_ns"]) for row in rows("benchmarks/criterion.csv")}
    yield f"| {rounded(medians['atlas/generic'] / 1e3, 2)} | – |"
    flood = "all regions of the paper's body"
    yield f"| {rounded(peers(flood, 'ours_us'), 2)} | flood fill on 200×200 points: {rounded(peers(flood, 'peer_us'), 2)} |"
    auto = "curves of the paper's body"
    yield f"| {rounded(peers(auto, 'ours_us'), 2)} | AUTO-07p: {rounded(peers(auto, 'peer_us'), 2)} |"
    point = "class of a point"
    yield f"| {rounded(peers(point, 'ours_us'), 2)} | flood fill: {rounded(peers(point, 'peer_us'), 2)} |"
    flint = "critical points at one l, certified"
    yield f"| {rounded(peers(flint, 'ours_us'), 2)} | FLINT, certified: {rounded(peers(flint, 'peer_us'), 2)} |"
    section = {row["work"]: row for row in rows("benchmarks/section_peers.csv")}
    ours = float(section["bifdiag, states, to T"]["median_per_cpu_second"])
    yield f"{ours / 1e6:.2g} million crossings per second"
    yield f"{float(section['heyoka, batch 8, states, to T']['ratio']):.2g} times as many as heyoka"
    classes = json.loads((ROOT / "data/classes.json").read_text(encoding="utf-8"))["classes"]
    yield f"{sum(c['physical'] for c in classes)} classes"
    scan = json.loads((ROOT / "data/survey/general.summary.json").read_text(encoding="utf-8"))
    assert scan["rows"] == 1_000_000 and not any("k4" in str(kind) for kind in scan["types"])
    yield f"a million random bodies show {len(scan['classes'])}"


def main():
    text = " ".join((ROOT / "paper/joss.md").read_text(encoding="utf-8").split())
    missing = [fact for fact in facts() if fact not in text]
    for fact in missing:
        print(f"not in joss.md: {fact}")
    sys.exit(1 if missing else 0)


if __name__ == "__main__":
    main()
