#!/usr/bin/env python3
"""Looks for periodic orbits that `bifdiag periodic` does not list: periodic_orbits.py BIFDIAG [--starts N] [--seed K] [--points A:B]

At each point Newton's method is started at random states of the section, on the flow and with the events of heyoka, in
(gamma, omega), which shares nothing with the program. Each closed motion that it finds has to be one of the list. A list that says
that it is not complete may lack some: those are counted apart. 20 points of 10 bodies; 5,000 starts at each are 100,000. Needs
heyoka and NumPy.
"""

import argparse
import json
import subprocess
import sys
import time

import heyoka as hy
import numpy as np

PAPER = ("2,1.1,1", "0.94868,0,0.61623")
# Bodies that are not integrable, with points (h, l).
POINTS = [
    (*PAPER, "2.6", "3.25"),
    (*PAPER, "4.45", "3.25"),
    (*PAPER, "6.5", "3.25"),
    ("2,1.5,1", "0.3,0.5,0.8", "1.5", "0.5"),
    ("2,1.5,1", "0.3,0.5,0.8", "3", "1.7"),
    ("1.9,1.2,1", "0.2,0.1,1", "2.5", "0.8"),
    ("1.5,1.4,1", "1,0.2,0.1", "2", "1"),
    ("2,1.5,1.3", "0,0.6,0.8", "0.7", "0.4"),
    ("1.9,1.2,1", "0.2,0.1,1", "4", "1.6"),
    ("1.5,1.4,1", "1,0.2,0.1", "1.9", "1.9"),
    ("2,1.5,1.3", "0,0.6,0.8", "2.1", "1.2"),
    # Katok's first and third.
    ("1,1.6,1.3", "1,0,0", "1.5", "0.6"),
    ("1,1.6,1.3", "1,0,0", "2.3", "1.8"),
    ("1,1.3,0.5", "1,0,0", "1.2", "0.5"),
    ("1,1.3,0.5", "1,0,0", "2.4", "1.1"),
    ("3,2.2,1.7", "0.3,-0.5,0.8", "1.5", "1"),
    ("3,2.2,1.7", "0.3,-0.5,0.8", "2.2", "2.4"),
    ("1.8,1.3,0.9", "0.5,0.4,0.6", "2", "0.7"),
    ("1.8,1.3,0.9", "0.5,0.4,0.6", "2.8", "2.2"),
    ("1.2,1.1,0.6", "0.7,0.2,0.4", "1.1", "0.9"),
]
CROSSINGS = 4
CLOSED = 1e-9
SAME = 1e-5
LONGEST = 80.0


class Top:
    def __init__(self, moments, center):
        self.a, self.r = np.array(moments), np.array(center)
        g, w = hy.make_vars("g1", "g2", "g3"), hy.make_vars("w1", "w2", "w3")
        a, r = self.a, self.r

        def cross(u, v):
            return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]

        momentum = [a[i] * w[i] for i in range(3)]
        turn = [x - y for x, y in zip(cross(momentum, w), cross(g, r))]
        system = list(zip(g, cross(g, w))) + [(w[i], turn[i] / a[i]) for i in range(3)]
        section = sum(w[i] * x for i, x in enumerate(cross(r, g)))
        event = hy.t_event(section, direction=hy.event_direction.negative)
        self.flow = hy.taylor_adaptive(system, np.zeros(6), t_events=[event])

    def returned(self, x, turns):
        """The state and time of the next crossings inward, or None."""
        flow = self.flow
        flow.reset_cooldowns()
        flow.state[:], flow.time = x, 0.0
        for k in range(turns):
            while True:
                # -1: the first event ended it.
                if flow.propagate_until(LONGEST)[0].value != -1:
                    return None
                # At the start itself, which is on the section but for rounding: near its tangency the zero lies further off in time.
                if flow.time > 1e-6 or k > 0:
                    break
        return flow.state.copy(), flow.time

    def constraints(self, x, h, l):
        g, w = x[:3], x[3:]
        energy = 0.5 * np.dot(w, self.a * w) - np.dot(g, self.r)
        section = np.dot(w, np.cross(self.r, g))
        return np.array([np.dot(g, g) - 1, np.dot(g, self.a * w) - l, energy - h, section])

    def start(self, random, h, l):
        """A random state of the section on its part inward."""
        while True:
            g = random.normal(size=3)
            g /= np.linalg.norm(g)
            j = np.dot(g, self.a * g)
            left = h - (0.5 * l * l / j - np.dot(g, self.r))
            if left < 0:
                continue
            v = np.cross(np.cross(self.r, g) / self.a, g)
            size = np.sqrt(2 * left / np.dot(v, v / self.a)) * random.choice([-1, 1])
            w = l * g / j + size * v / self.a
            turn = (np.cross(self.a * w, w) - np.cross(g, self.r)) / self.a
            rate = np.dot(turn, np.cross(self.r, g)) + np.dot(w, np.cross(self.r, np.cross(g, w)))
            if rate < 0:
                return np.concatenate([g, w])

    def closed(self, x, turns, h, l):
        """Gauss and Newton's method; the state and period, or None."""
        def value(x):
            back = self.returned(x, turns)
            return None if back is None else (np.concatenate([back[0] - x, self.constraints(x, h, l)]), back[1])

        for _ in range(15):
            here = value(x)
            if here is None:
                return None
            residual, period = here
            size = np.linalg.norm(residual)
            if size < CLOSED:
                return x, period
            if size > 20:
                return None
            columns = []
            for i in range(6):
                beside = x.copy()
                beside[i] += 1e-7
                there = value(beside)
                if there is None:
                    return None
                columns.append((there[0] - residual) / 1e-7)
            step = np.linalg.lstsq(np.array(columns).T, residual, rcond=1e-8)[0]
            length = np.linalg.norm(step)
            x = x - step * min(1.0, 0.5 / length)
        return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bifdiag")
    parser.add_argument("--starts", type=int, default=300)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--points", default=f"0:{len(POINTS)}", help="which of the points, the first counted as 0")
    arguments = parser.parse_args()
    lacking, begun_at, ended_at = 0, *map(int, arguments.points.split(":"))
    for moments, center, h, l in POINTS[begun_at:ended_at]:
        command = [arguments.bifdiag, "periodic", "--A", moments, "--r", center, "--h", h, "--l", l, "--json", "--threads", "1"]
        begin = time.process_time()
        answer = subprocess.run([*command, "--crossings", str(CROSSINGS)], check=False, capture_output=True, text=True)
        if answer.returncode:
            print(f"A {moments} r {center} h {h} l {l}: {answer.stderr.strip()}")
            continue
        listed = json.loads(answer.stdout)
        top = Top([float(x) for x in moments.split(",")], [float(x) for x in center.split(",")])
        points = [(np.array(o["gamma"] + o["omega"]), o["crossings"] // 2) for o in listed["orbits"]]
        random = np.random.default_rng(arguments.seed)
        hits, tried, on_continua, seen, new = 0, 0, 0, set(), []
        begin = time.process_time()
        for number in range(arguments.starts):
            turns = 1 + number % (CROSSINGS // 2)
            found = top.closed(top.start(random, float(h), float(l)), turns, float(h), float(l))
            tried += 1
            if found is None:
                continue
            hits += 1
            x = found[0]
            images = [x] + [top.returned(x, k)[0] for k in range(1, turns)]
            near = [k for k, (p, m) in enumerate(points) if turns % m == 0 and any(np.linalg.norm(y - p) < SAME for y in images)]
            if near:
                seen.add(near[0])
            elif listed["continua"]:
                on_continua += 1
            else:
                new.append((turns, found))
        lacking += len(new) if listed["complete"] else 0
        proved = sum(o["proved"] for o in listed["orbits"])
        print(
            f"A {moments} r {center} h {h} l {l}: {len(points)} orbits, {proved} proved, complete {listed['complete']}, "
            f"index sums {listed['index_sums']}; {tried} starts, {hits} closed, onto {len(seen)} orbits, "
            f"{len(new)} not in the list, {time.process_time() - begin:.1f} s",
            flush=True,
        )
        for turns, (x, period) in new[:5]:
            print(f"  m {turns} T {period:.9f} gamma, omega {x.tolist()}")
    sys.exit(1 if lacking else 0)


if __name__ == "__main__":
    main()
