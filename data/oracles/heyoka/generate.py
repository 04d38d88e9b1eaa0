#!/usr/bin/env python3
"""Section crossings by heyoka.py (batch of one, tol 1e-18, high_accuracy), as the oracle of tests/section.rs.

    python3 -m venv v && v/bin/pip install heyoka numpy && v/bin/python generate.py

Writes crossings.csv beside this file: case,orbit,index,time,gamma,l for some of the first 200 crossings of regular
orbits; index 0 is the start, on S = 0.

Doubles are written in shortest round-trip form. Crossings are the roots of heyoka's own event polynomial.
"""
import csv
import os

import heyoka as hy
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
SEED = 20080101
CROSSINGS = 200


def state_on_section(A, r, h, l, gamma, sign):
    """Eq. lofgamma."""
    J = gamma @ (A * gamma)
    U = l * l / 2 / J - gamma @ r
    if U > h:
        return None
    v = np.cross(np.cross(r, gamma) / A, gamma)
    return np.r_[gamma, l * A * gamma / J + sign * v * np.sqrt(2 * (h - U) / (v @ (v / A)))]


def draw(rng):
    gamma = rng.normal(size=3)
    return gamma / np.linalg.norm(gamma), 1 if rng.uniform() < 0.5 else -1


def integrator(A, r):
    g = hy.make_vars("g1", "g2", "g3")
    m = hy.make_vars("l1", "l2", "l3")
    w = [m[i] / float(A[i]) for i in range(3)]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    rr = [float(x) for x in r]
    dg, lw, gr, rg = cross(g, w), cross(m, w), cross(g, rr), cross(rr, g)
    section = w[0] * rg[0] + w[1] * rg[1] + w[2] * rg[2]
    out = []

    def record(ta, t, sign):
        ta.update_d_output(t)
        out.append((t, ta.d_output.copy()))

    system = [(g[i], dg[i]) for i in range(3)] + [(m[i], lw[i] - gr[i]) for i in range(3)]
    ta = hy.taylor_adaptive(system, [0.0] * 6, tol=1e-18, high_accuracy=True, nt_events=[hy.nt_event(section, record)])
    return ta, out


def crossings(ta, out, state):
    out.clear()
    ta.time = 0.0
    ta.state[:] = state
    t = 0.0
    while len(out) < CROSSINGS + 2:
        t += 20.0
        ta.propagate_until(t)
    # The start itself lies on the section: heyoka may or may not see it.
    return [(t, x) for t, x in out if t > 1e-6][:CROSSINGS]


def divergence(ta, state, time):
    """Growth of a perturbation of 1e-9 over `time`: small for regular orbits."""
    ends = []
    for shift in (0.0, 1e-9):
        ta.time = 0.0
        ta.state[:] = state
        ta.state[3] += shift
        ta.propagate_until(time)
        ends.append(ta.state.copy())
    return np.abs(ends[1] - ends[0]).max() / 1e-9


# name, A, r, h, l, number of orbits wanted
CASES = [
    ("paper", (2.0, 1.1, 1.0), (0.94868, 0.0, 0.61623), 4.45, 3.25, 4),
    ("paper-low", (2.0, 1.1, 1.0), (0.94868, 0.0, 0.61623), 2.6, 3.25, 3),
    ("kovalevskaya", (2.0, 2.0, 1.0), (1.0, 0.0, 0.0), 3.4, 2.87, 3),
    ("katok", (2.0, 1.5, 1.0), (1.0, 0.0, 0.0), 80.5, 12.80, 3),
    ("lagrange", (1.0, 1.0, 0.6), (0.0, 0.0, 1.0), 2.0, 1.3, 2),
    ("general", (1.7, 1.3, 0.8), (0.3, -0.5, 0.9), 1.4, 1.1, 3),
]


def main():
    rng = np.random.default_rng(SEED)
    with open(os.path.join(HERE, "crossings.csv"), "w", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow("case orbit index time gamma1 gamma2 gamma3 l1 l2 l3".split())
        for name, A, r, h, l, wanted in CASES:
            A, r = np.array(A), np.array(r)
            ta, events = integrator(A, r)
            orbit = 0
            while orbit < wanted:
                state = state_on_section(A, r, h, l, *draw(rng))
                if state is None:
                    continue
                points = crossings(ta, events, state)
                if divergence(ta, state, points[-1][0]) > 3e3:
                    continue
                out.writerow([name, orbit, 0, "0.0"] + [repr(float(x)) for x in state])
                for k in list(range(1, 11)) + list(range(20, CROSSINGS, 20)) + [CROSSINGS - 1, CROSSINGS]:
                    t, x = points[k - 1]
                    out.writerow([name, orbit, k, repr(float(t))] + [repr(float(v)) for v in x])
                orbit += 1


if __name__ == "__main__":
    main()
