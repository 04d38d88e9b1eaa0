#!/usr/bin/env python3
"""Pairs bifdiag with the programs that one would use instead, on the same bodies in one run.

    benches/peers.py --peers DIR [--python PYTHON] [--rounds N]

DIR holds the peers' scripts p1_auto.py, p2_classify.py, p3_roots.py and p5_atlas.py with common.py (the random bodies
and the seed); PYTHON is the interpreter that has their packages (default: this one). They are run with --quick. Each
prints lines `name: figure unit  # note`; the figures wanted here are picked by their names.

Ours and theirs take turns, the order changing from round to round, and each figure is the median over the rounds. What
counts on a shared machine is CPU time: the peers' figures are CPU time, ours the fastest of several runs in one process
(examples/peer_workload.rs, median over the bodies), and the CPU time of whole processes.

Writes data/benchmarks/peers.csv and prints a table.
"""
import argparse
import csv
import json
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Peer's figure -> (what is done, script, pattern of the line, unit in microseconds, our figure).
PAIRS = [
    ("curves of the paper's body, AUTO-07p", "p1_auto", r"auto paper dsmax=0\.1 8 starts wall: .*cpu ([\d.e+-]+) ms", 1e3, "paper/polylines"),
    ("curves of a random body, AUTO-07p", "p1_auto", r"auto random bodies.*: ([\d.e+-]+) cpu ms per body", 1e3, "polylines"),
    ("class of a point, flood fill 256x512", "p2_classify", r"flood 256x512 per classification: .*cpu ([\d.e+-]+) ms", 1e3, "classify"),
    ("Betti numbers at one l, GUDHI 128x256", "p2_classify", r"gudhi 128x256 min_persistence=0\.001 .*cpu ([\d.e+-]+) ms", 1e3, "classify"),
    ("critical points at one l, numpy.roots", "p3_roots", r"numpy roots centred tol=1e-3 \+ Newton: .*cpu ([\d.e+-]+) us", 1.0, "critical"),
    ("critical points at one l, certified by FLINT", "p3_roots", r"flint certified: .*cpu ([\d.e+-]+) us", 1.0, "critical"),
    ("critical points at one l, fsolve from 100 starts", "p3_roots", r"fsolve 100 starts: .*cpu ([\d.e+-]+) us", 1.0, "critical"),
    ("200x200 points of the paper's body, flood fill", "p5_atlas", r"200x200 flood 256x512: .*cpu ([\d.e+-]+) s", 1e6, "paper/grid"),
    ("all regions of the paper's body, flood fill on 200x200", "p5_atlas", r"200x200 flood 256x512: .*cpu ([\d.e+-]+) s", 1e6, "paper/atlas"),
]

# The peers' own bodies, made by their own code so that it stays where it is.
MAKE_CASES = """
import json, sys
sys.argv = sys.argv[:1]
from common import *
rng = np.random.default_rng(SEED)
for _ in range(COUNT):
    A, r = random_body(rng)
    l = float(np.exp(rng.uniform(np.log(.3), np.log(8))))
    g = rng.normal(size=(64, 3)); g /= np.linalg.norm(g, axis=1)[:, None]
    U = l * l / (2 * (g * g) @ np.array(A)) - g @ np.array(r)
    h = float(rng.uniform(U.min(), U.max()))
    print(json.dumps({"A": [float(x) for x in A], "r": [float(x) for x in r], "h": h, "l": l}))
"""


def command_output(command, **options):
    """Standard output and CPU seconds of a command."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, check=True, capture_output=True, text=True, **options)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.stdout, cpu


class Ours:
    def __init__(self, target, cases):
        self.program = target / "release" / "bifdiag"
        self.workload = target / "release" / "examples" / "peer_workload"
        self.cases = cases
        paper = {"A": [2.0, 1.1, 1.0], "r": [0.94868, 0.0, 0.61623], "h": 3.8, "l": 3.25}
        self.paper = json.dumps(paper)
        # The grid of p5_atlas.
        steps = range(200)
        self.grid = "".join(
            json.dumps({**paper, "h": -1.5 + 17.5 * i / 199, "l": 0.04 + 7.96 * k / 199}) + "\n" for k in steps for i in steps
        )

    def figures(self):
        """Microseconds by name."""
        lines, _ = command_output([self.workload], input="\n".join(self.cases))
        rows = [json.loads(line) for line in lines.splitlines()]
        found = {name: statistics.median(row[name] for row in rows)
                 for name in ("atlas", "polylines", "classify", "critical", "locate")}
        lines, _ = command_output([self.workload], input=self.paper)
        paper = json.loads(lines)
        # Curves alone, as the continuation program makes them.
        found["paper/atlas"], found["paper/polylines"] = paper["atlas"], paper["polylines"]
        grid, cpu = command_output([self.program, "classify", "--batch", "-", "--threads", "1"], input=self.grid)
        if len(grid.splitlines()) != 40_000:
            sys.exit("the batch did not answer every point of the grid")
        found["paper/grid"] = cpu * 1e6
        arguments = ["--A", "2,1.1,1", "--r", "0.94868,0,0.61623", "--json"]
        found["process"] = 1e6 * statistics.median(command_output([self.program, *arguments])[1] for _ in range(11))
        # A body per line: one cold answer in a batch, reading and writing included.
        batch = "\n".join(self.cases * 20)
        found["batch/point"] = command_output([self.program, "classify", "--batch", "-", "--threads", "1"], input=batch)[1] * 1e6 / (20 * len(self.cases))
        return found


class Peers:
    def __init__(self, folder, python):
        self.folder, self.python = folder, python

    def cases(self, count):
        source = MAKE_CASES.replace("COUNT", str(count))
        lines, _ = command_output([self.python, "-c", source], cwd=self.folder, env=self.environment())
        return lines.splitlines()

    def environment(self):
        return {**os.environ, "PYTHONPATH": str(self.folder), "PYTHONDONTWRITEBYTECODE": "1"}

    def figures(self):
        """Microseconds by (script, pattern)."""
        found = {}
        with tempfile.TemporaryDirectory() as scratch:
            for script in dict.fromkeys(pair[1] for pair in PAIRS):
                text, _ = command_output([self.python, str(self.folder / f"{script}.py"), "--quick"], cwd=scratch,
                                         env=self.environment())
                for _, wanted, pattern, unit, _ in PAIRS:
                    match = re.search(pattern, text) if wanted == script else None
                    if match:
                        found[wanted, pattern] = float(match[1]) * unit
        return found


def human(microseconds):
    for unit, size in (("s", 1e6), ("ms", 1e3)):
        if microseconds >= size:
            return f"{microseconds / size:.3g} {unit}"
    return f"{microseconds:.3g} µs"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peers", type=pathlib.Path, required=True, help="folder with the peers' scripts")
    parser.add_argument("--python", default=sys.executable, help="interpreter that has their packages")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--bodies", type=int, default=100)
    options = parser.parse_args()
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    build = ["cargo", "build", "--release", "--quiet", "--bin", "bifdiag", "--example", "peer_workload"]
    subprocess.run(build, cwd=ROOT, check=True)
    peers = Peers(options.peers.resolve(), options.python)
    ours = Ours(target, peers.cases(options.bodies))
    rounds = []
    for number in range(options.rounds):
        sides = [ours, peers] if number % 2 == 0 else [peers, ours]
        figures = {type(side): side.figures() for side in sides}
        rounds.append((figures[Ours], figures[Peers]))
        print(f"round {number + 1} of {options.rounds} done", file=sys.stderr)
    median = lambda side, key: statistics.median(figures[side][key] for figures in rounds)

    rows = []
    for what, script, pattern, _, our_name in PAIRS:
        if all((script, pattern) in theirs for _, theirs in rounds):
            rows.append((what, our_name, median(0, our_name), median(1, (script, pattern))))
        else:
            print(f"{script} gave no figure for: {what}", file=sys.stderr)
    out = ROOT / "data" / "benchmarks" / "peers.csv"
    out.parent.mkdir(parents=True, exist_ok=True)
    with open(out, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["work", "ours_us", "peer_us", "ratio"])
        for what, _, mine, theirs in rows:
            writer.writerow([what, f"{mine:.4g}", f"{theirs:.4g}", f"{theirs / mine:.4g}"])
        for name in rounds[0][0]:
            writer.writerow([f"bifdiag {name}", f"{median(0, name):.4g}", "", ""])
    print("| work, peer | bifdiag | peer | ratio |\n| --- | ---: | ---: | ---: |")
    for what, _, mine, theirs in rows:
        print(f"| {what} | {human(mine)} | {human(theirs)} | {theirs / mine:.3g} |")
    for name in rounds[0][0]:
        print(f"{name}: {human(median(0, name))}", file=sys.stderr)


main()
