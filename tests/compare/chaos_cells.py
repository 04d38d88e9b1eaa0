#!/usr/bin/env python3
"""Cells of a map of chaos in a second of processor time, beside a map by variational equations: chaos_cells.py PROGRAM [options]

The map is that of the paper's body in 200 x 200 cells over its whole diagram, every share to a standard deviation of 0.03.
`bifdiag chaos` makes some of the 200 shards of it, and after each of them heyoka measures cells of the same shard that are chosen at
random: it follows states that are drawn in Liouville measure, anywhere in the cell, with one tangent vector each, and calls an orbit
chaotic as soon as ln|δ| has grown by more than 20 and regular if it has not until T. More orbits follow until the error of the
share, by the same formula, is 0.03. A lane of its batch whose orbit is decided gets the next orbit.

Before that, T is chosen on cells of a coarse map: of the times that are doubled from 250 to 8,000 the first at which no more than 4 % of
the verdicts differ from the last ones, about as many as the map leaves open. Needs heyoka and NumPy.
"""
import argparse
import json
import os
import pathlib
import random
import subprocess
import tempfile
import time

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

import heyoka as hy
import numpy as np

from chaos import RESCALED_EVERY, children_time, integrator, states

CELLS = 200
SHARDS = 200
ERROR = 0.03
FIRST = 32
TIMES = [250 * 2**k for k in range(6)]
DIFFER = 0.04
CHAOTIC = 20.0


def part_of_map(program, cells, error, *more):
    """The rows of a map or of a shard by the program, the processor time and the sides of a cell."""
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory) / "map.json"
        line = ["chaos", "--A", "2,1.1,1", "--r", "0.94868,0,0.61623", "--cells", f"{cells}x{cells}", "--error", str(error)]
        begin = children_time()
        subprocess.run([program, *line, *more, "--threads", "1", "-q", "--out", str(file)], check=True, capture_output=True)
        used = children_time() - begin
        document = json.loads(file.read_text())
    sides = [(document["window"][name][1] - document["window"][name][0]) / cells for name in "hl"]
    return [row for row in document.get("rows", []) if row["orbits"]], used, sides


def alone(rows):
    """Rows of cells that lie in one region and where E has one component: there a state needs no sorting."""
    count = {}
    for row in rows:
        count[tuple(row["cell"])] = count.get(tuple(row["cell"]), 0) + 1
    return [row for row in rows if count[tuple(row["cell"])] == 1 and row["part"] == 1]


def orbits_of(rows):
    """How many orbits were followed: the cells of a block have the same."""
    blocks = {(row["cell"][0] // row["block"], row["cell"][1] // row["block"], row["block"], row["region"], row["component"]): row for row in rows}
    return sum(row["orbits"] for row in blocks.values())


class Tangents:
    """Growth of tangent vectors by heyoka, in batches whose lanes are filled anew."""

    def __init__(self, seed):
        self.taylor = integrator(hy.recommended_simd_size())
        self.lanes = self.taylor.state.shape[1]
        self.random = np.random.default_rng(seed)
        # Processor time of following alone: drawing the states does not count.
        self.used = 0.0

    def starts(self, row, sides, count):
        """States anywhere in the cell."""
        found = []
        while len(found) < count:
            h, l = (row[name] + side * (self.random.random() - 0.5) for name, side in zip("hl", sides))
            found.append(states(h, l, 1, self.random)[0])
        return found

    def follow(self, starts, until, stop=CHAOTIC):
        """The times at which ln|δ| of each orbit has exceeded CHAOTIC, infinite if not by `until`; one that exceeds `stop` is left."""
        taylor, lanes = self.taylor, self.lanes
        begin = time.process_time()
        logs, passed = np.zeros(len(starts)), np.full(len(starts), np.inf)
        orbit, ends = np.full(lanes, -1), np.zeros(lanes)
        waiting, fill = iter(range(len(starts))), range(lanes)
        while True:
            times = np.array(taylor.time)
            for lane in fill:
                orbit[lane] = next(waiting, -1)
                # A lane without an orbit goes along with the first one's state.
                taylor.state[:, lane] = starts[max(orbit[lane], 0)]
                times[lane] = ends[lane] = 0.0
            if (orbit < 0).all():
                self.used += time.process_time() - begin
                return passed
            taylor.set_time(times)
            ends += RESCALED_EVERY
            taylor.propagate_until(ends)
            size = np.linalg.norm(taylor.state[6:], axis=0)
            taylor.state[6:] /= size
            held = orbit >= 0
            logs[orbit[held]] += np.log(size[held])
            first = held & (logs[orbit] > CHAOTIC) & np.isinf(passed[orbit])
            passed[orbit[first]] = ends[first]
            fill = np.flatnonzero(~held | (logs[orbit] > stop) | (ends >= until))

    def share(self, row, sides, until):
        """Chaotic share of a cell to the wanted error, and the orbits that it took."""
        chaotic, count = 0, 0
        while True:
            passed = self.follow(self.starts(row, sides, self.lanes if count else FIRST), until)
            chaotic, count = chaotic + np.isfinite(passed).sum(), count + len(passed)
            p = (chaotic + 1) / (count + 2)
            if np.sqrt(p * (1 - p) / (count + 3)) <= ERROR:
                return chaotic / count, count


def chosen_time(tangents, rows, sides, each):
    """The first of TIMES at which hardly a verdict differs from the last one; all are printed."""
    starts = [state for row in rows for state in tangents.starts(row, sides, each)]
    passed = tangents.follow(starts, TIMES[-1], np.inf)
    chosen, chaotic = None, passed <= TIMES[-1]
    print(f"{len(starts)} orbits in {len(rows)} cells until {TIMES[-1]}: {100 * chaotic.mean():.1f} % chaotic, "
          f"{1e3 * tangents.used / len(starts):.1f} ms each")
    for until in TIMES:
        differ = ((passed <= until) != chaotic).mean()
        print(f"T = {until}: {100 * differ:.2f} % differ from the last", flush=True)
        if chosen is None and differ <= DIFFER:
            chosen = until
    return chosen


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--shards", type=int, default=8, help="how many of the 200, equally spaced")
    parser.add_argument("--sample", type=int, default=6, help="cells of each shard that heyoka measures")
    parser.add_argument("--pilot", type=int, default=60, help="cells with 4 orbits each by which T is chosen")
    options = parser.parse_args()
    choose, tangents = random.Random(41), Tangents(41)

    rows, _, sides = part_of_map(options.program, 20, 0.3, "--steps", "320")
    until = chosen_time(tangents, choose.sample(alone(rows), options.pilot), sides, 4)
    print(f"T = {until}", flush=True)

    total = dict.fromkeys(("cells", "ours", "our orbits", "sampled", "theirs", "their orbits", "for all"), 0)
    compared = []
    for k in range(options.shards):
        number = 1 + (2 * k + 1) * SHARDS // (2 * options.shards)
        rows, used, sides = part_of_map(options.program, CELLS, ERROR, "--shard", f"{number}/{SHARDS}")
        followed, begin = 0, tangents.used
        sample = choose.sample(alone(rows), min(options.sample, len(alone(rows))))
        if not sample:
            print(f"shard {number}: {len(rows)} rows, none for heyoka to measure; left out", flush=True)
            continue
        for row in sample:
            share, count = tangents.share(row, sides, until)
            followed += count
            compared.append((row["fraction"], row["open"], share))
        theirs = tangents.used - begin
        print(f"shard {number}: {len(rows)} rows in {used:.1f} s, {orbits_of(rows)} orbits; "
              f"heyoka {len(sample)} cells in {theirs:.1f} s, {followed} orbits", flush=True)
        parts = len(rows), used, orbits_of(rows), len(sample), theirs, followed, theirs / len(sample) * len(rows)
        total = {name: total[name] + part for name, part in zip(total, parts)}
    fraction, left_open, share = np.mean(compared, axis=0)
    print(f"over the {len(compared)} cells: {fraction:.3f} + {left_open:.3f} open, heyoka {share:.3f}")
    print(f"bifdiag {total['cells'] / total['ours']:.1f} rows a second, heyoka {total['cells'] / total['for all']:.3f}: "
          f"{total['for all'] / total['ours']:.0f} times as many")
    print(f"orbits a second: bifdiag {total['our orbits'] / total['ours']:.0f}, heyoka {total['their orbits'] / total['theirs']:.0f}")


if __name__ == "__main__":
    main()
