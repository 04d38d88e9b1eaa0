#!/usr/bin/env python3
"""Pairs the Poincaré section with heyoka.py, the Taylor integrator that one would use instead, in one run.

    python3 -m venv v && v/bin/pip install heyoka numpy
    v/bin/python benches/section_peers.py [--orbits 64] [--crossings 1000] [--rounds 5]

The work: the paper's body at (h, l) = (4.45, 3.25), the same starts on S = 0 for both, tolerance 1e-15, one thread.

- to T: every orbit to the same time T = 0.85 per crossing wanted; all crossings count, no SIMD lane is ever idle.
- x N: every orbit to N crossings; only those count. heyoka has no such stop: a lane that has enough waits for the
  slowest of its batch, target times being extrapolated from each lane's own rate, lanes sorted by it (a pilot run that
  is not counted).

heyoka's batches of 8 (AVX-512) and of 4; `states` stores time and state of every crossing in a Python callback, which is
what a section needs; `times` stores the time only, near to what its C++ interface would cost. Ours
(examples/section_rate.rs) stores times, states, angles, sheet and dS/dt.

Rates are crossings per second of CPU time. Ours and theirs take turns in every round, the order changing; a figure is the
median over the rounds, with the best beside it. `peak` is the share of the fused multiply-adds that one core can do,
measured in the same process, that the nine Cauchy products of the series alone use.

Writes data/benchmarks/section_peers.csv and prints a table in Markdown.
"""
import argparse
import csv
import gc
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

import heyoka as hy
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
A = np.array([2.0, 1.1, 1.0])
R = np.array([0.94868, 0.0, 0.61623])
H, L = 4.45, 3.25
SEED = 20080303


def starts(count):
    """States on S = 0, eq. (lofgamma), gamma uniform on the accessible part of the sphere."""
    rng = np.random.default_rng(SEED)
    found = []
    while len(found) < count:
        gamma = rng.normal(size=3)
        gamma /= np.linalg.norm(gamma)
        sign = 1 if rng.uniform() < 0.5 else -1
        moment = gamma @ (A * gamma)
        potential = L * L / 2 / moment - gamma @ R
        if potential <= H:
            v = np.cross(np.cross(R, gamma) / A, gamma)
            found.append(np.r_[gamma, L * A * gamma / moment + sign * v * np.sqrt(2 * (H - potential) / (v @ (v / A)))])
    return np.array(found)


def drift(states):
    """Largest deviation of H, <gamma,l>, <gamma,gamma>."""
    gamma, l = states[:, :3], states[:, 3:]
    integrals = ((l * l / A).sum(1) / 2 - gamma @ R - H, (gamma * l).sum(1) - L, (gamma * gamma).sum(1) - 1)
    return max(abs(x).max() for x in integrals)


class Heyoka:
    def __init__(self, lanes, record):
        gamma, l = hy.make_vars("g1", "g2", "g3"), hy.make_vars("l1", "l2", "l3")
        omega = [l[i] * (1 / A[i]) for i in range(3)]
        cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        r = [float(x) for x in R]
        d_gamma, torque, arm = cross(gamma, omega), cross(gamma, r), cross(r, gamma)
        # Nine products: l x omega with the differences of the inverse moments.
        gyro = [(1 / A[(i + 2) % 3] - 1 / A[(i + 1) % 3]) * (l[(i + 1) % 3] * l[(i + 2) % 3]) for i in range(3)]
        section = omega[0] * arm[0] + omega[1] * arm[1] + omega[2] * arm[2]
        system = [(gamma[i], d_gamma[i]) for i in range(3)] + [(l[i], gyro[i] - torque[i]) for i in range(3)]
        self.lanes, self.found, self.counts = lanes, [], [0] * lanes
        found, counts = self.found, self.counts

        def times(ta, t, direction, lane):
            counts[lane] += 1
            found.append((lane, t))

        def states(ta, t, direction, lane):
            ta.update_d_output(t)
            counts[lane] += 1
            found.append((lane, t, direction, ta.d_output[:, lane].copy()))

        event = hy.nt_event_batch(section, {"times": times, "states": states}[record])
        self.ta = hy.taylor_adaptive_batch(system, np.zeros((6, lanes)), tol=1e-15, nt_events=[event])

    def load(self, states):
        self.ta.set_time(0.0)
        self.ta.state[:] = states.T
        self.counts[:] = [0] * self.lanes

    def to_time(self, states, end):
        total, ends = 0, []
        for k in range(0, len(states), self.lanes):
            self.load(states[k:k + self.lanes])
            self.ta.propagate_until([end] * self.lanes)
            total += sum(self.counts)
            ends += list(self.ta.state.T.copy())
        return total, np.array(ends)

    def to_count(self, states, wanted):
        total, ends = 0, []
        for k in range(0, len(states), self.lanes):
            self.load(states[k:k + self.lanes])
            ahead = [0.5 * wanted * 0.85] * self.lanes
            while True:
                self.ta.propagate_until(ahead)
                if min(self.counts) >= wanted:
                    break
                ahead = [t if n >= wanted else t + max(1.0, (wanted - n) * t / max(n, 1) * 1.002 + 0.3)
                         for t, n in zip(ahead, self.counts)]
            total += wanted * self.lanes
            ends += list(self.ta.state.T.copy())
        return total, np.array(ends)

    def rate(self, work):
        """Crossings, their rate per CPU second, drift at the ends, order."""
        self.found.clear()
        gc.collect()
        gc.disable()
        begin = time.process_time()
        total, ends = work()
        seconds = time.process_time() - begin
        gc.enable()
        return {"crossings": total, "rate": total / seconds, "drift": drift(ends), "order": self.ta.order}


def ours(program, text, mode, value):
    run = subprocess.run([program, mode, str(value), "5"], input=text, capture_output=True, text=True, check=True)
    report = json.loads(run.stdout)
    return {
        "crossings": report["crossings"],
        "rate": report["crossings"] / statistics.median(report["seconds"]),
        "drift": max(report["drift"]),
        "order": report["order"],
        "best": report["crossings"] / min(report["seconds"]),
        "peak": report["products_per_second"] / report["peak_per_second"],
        "multiply_adds": report["peak_per_second"],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--orbits", type=int, default=64, help="a multiple of 8")
    parser.add_argument("--crossings", type=int, default=1000)
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    if options.orbits < 8 or options.orbits % 8:
        parser.error(f"--orbits {options.orbits}: a multiple of 8 is needed")
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    subprocess.run(["cargo", "build", "--release", "--quiet", "--example", "section_rate"], cwd=ROOT, check=True)
    program = target / "release" / "examples" / "section_rate"

    states = starts(options.orbits)
    text = "\n".join(" ".join(repr(float(x)) for x in state) for state in states)
    end, wanted = 0.85 * options.crossings, options.crossings
    peers = {(lanes, record): Heyoka(lanes, record) for lanes in (8, 4) for record in ("states", "times")}
    pilot = peers[8, "times"]
    rates = []
    for k in range(0, len(states), 8):
        pilot.load(states[k:k + 8])
        pilot.ta.propagate_until([100.0] * 8)
        rates += pilot.counts
    by_rate = states[np.argsort(rates)]
    works = {"to T": ("time", end), "x N": ("crossings", wanted)}
    jobs = {}
    for work, (mode, value) in works.items():
        jobs[f"bifdiag, states, {work}"] = lambda mode=mode, value=value: ours(program, text, mode, value)
        for (lanes, record), peer in peers.items():
            job = (lambda peer=peer: peer.to_time(states, end)) if mode == "time" else (
                lambda peer=peer: peer.to_count(by_rate, wanted))
            jobs[f"heyoka, batch {lanes}, {record}, {work}"] = lambda peer=peer, job=job: peer.rate(job)
    for job in jobs.values():
        job()
    results = {name: [] for name in jobs}
    loads = []
    for number in range(options.rounds):
        for name in sorted(jobs, reverse=bool(number % 2)):
            results[name].append(jobs[name]())
        loads.append(os.getloadavg()[0])
        print(f"round {number + 1} of {options.rounds} done", file=sys.stderr)

    rows = []
    for name, found in results.items():
        rate = statistics.median(x["rate"] for x in found)
        best = max(x.get("best", x["rate"]) for x in found)
        peak = statistics.median(x["peak"] for x in found) if "peak" in found[0] else None
        reference = statistics.median(x["rate"] for x in results[f"bifdiag, states, {name.rsplit(', ', 1)[1]}"])
        rows.append((name, found[0]["order"], found[0]["crossings"], rate, best, reference / rate,
                     max(x["drift"] for x in found), peak))
    out = ROOT / "data" / "benchmarks" / "section_peers.csv"
    with open(out, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["work", "order", "crossings", "median_per_cpu_second", "best_per_cpu_second", "ratio", "drift", "peak"])
        for row in rows:
            writer.writerow([row[0], row[1], row[2], f"{row[3]:.4g}", f"{row[4]:.4g}", f"{row[5]:.3g}", f"{row[6]:.1e}",
                             "" if row[7] is None else f"{row[7]:.3f}"])
    print("| program, what is stored, work | order | crossings/s, median | best | bifdiag is faster by | drift | of the peak |\n"
          "| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for name, order, _, rate, best, ratio, worst, peak in rows:
        share = "" if peak is None else f"{100 * peak:.0f} %"
        faster = "" if name.startswith("bifdiag") else f"{ratio:.2g}"
        print(f"| {name} | {order} | {rate / 1e3:,.0f} k | {best / 1e3:,.0f} k | {faster} | {worst:.0e} | {share} |")
    peak = statistics.median(x["multiply_adds"] for name in results for x in results[name] if "multiply_adds" in x)
    print(f"\nheyoka.py {hy.__version__}, {options.orbits} orbits, T = {end:g}, N = {wanted}, "
          f"{peak * 1e-9:.3g} G multiply-adds a second at the peak; load average {min(loads):.1f} to {max(loads):.1f}, "
          f"{os.cpu_count()} processors.")


main()
