"""Reference orbits of the paper's body for examples/orbit_accuracy.rs: crossing 100 of S = 0 to 30 digits.

Shares nothing with the crate: Taylor series of the Euler-Poisson equations
  gamma' = gamma x omega,  l' = l x omega - gamma x r,  omega = A^-1 l
with mpmath (pip install mpmath), order 64 and 50 digits. Crossings of S = <omega, r x gamma> are bracketed on a fine mesh of
each step's dense output and refined by Newton's method. Each orbit is computed a second time with order 76, 60 digits
and other steps; `agreement` is the largest difference of the two. The body and the starts are the doubles that are
written, taken exactly.

  python3 orbit_reference.py > orbit_reference.csv
"""

import random

from mpmath import mp, mpf

CROSSINGS = 100
MOMENTS, CENTER, MOMENTUM = [2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623], 3.25


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def starts(rng, h, count):
    """States with energy h and <gamma, l> = MOMENTUM, to rounding, off the section."""
    found = []
    while len(found) < count:
        gamma = [rng.gauss(0, 1) for _ in range(3)]
        norm = dot(gamma, gamma) ** 0.5
        gamma = [g / norm for g in gamma]
        moment = [a * g for a, g in zip(MOMENTS, gamma)]
        j = dot(gamma, moment)
        excess = h - (MOMENTUM**2 / (2 * j) - dot(gamma, CENTER))
        if excess < 0.02:
            continue
        w = cross(gamma, [rng.gauss(0, 1) for _ in range(3)])
        size = (2 * excess / sum(x * x / a for x, a in zip(w, MOMENTS))) ** 0.5
        found.append((gamma, [MOMENTUM * m / j + size * x for m, x in zip(moment, w)]))
    return found


class Series:
    """The Taylor series of one step."""

    def __init__(self, gamma, l, order):
        a, r = [mpf(x) for x in MOMENTS], [mpf(x) for x in CENTER]
        g, m, o = [[x] for x in gamma], [[x] for x in l], [[x / y] for x, y in zip(l, a)]
        for k in range(order):
            back = [o[i][k::-1] for i in range(3)]
            product = lambda u, v: mp.fdot(u, v)
            dg = [product(g[p], back[q]) - product(g[q], back[p]) for p, q in ((1, 2), (2, 0), (0, 1))]
            dm = [product(m[p], back[q]) - product(m[q], back[p]) for p, q in ((1, 2), (2, 0), (0, 1))]
            torque = cross([g[i][k] for i in range(3)], r)
            for i in range(3):
                g[i].append(dg[i] / (k + 1))
                m[i].append((dm[i] - torque[i]) / (k + 1))
                o[i].append(m[i][k + 1] / a[i])
        self.g, self.m, self.order = g, m, order
        # S is the derivative of <gamma, r>.
        height = [dot([g[i][k] for i in range(3)], r) for k in range(order + 1)]
        self.s = [k * height[k] for k in range(1, order + 1)]
        self.ds = [k * self.s[k] for k in range(1, order)]

    def step(self):
        """The last two terms stay below the precision."""
        size = lambda k: max(abs(x[k]) for x in self.g + self.m)
        small = mpf(10) ** (5 - mp.dps)
        return min((small / size(k)) ** (mpf(1) / k) for k in (self.order - 1, self.order))

    def at(self, t):
        value = lambda c: mp.polyval(c[::-1], t)
        return [value(c) for c in self.g], [value(c) for c in self.m]


def crossing(start, order, digits):
    """Time and state of crossing CROSSINGS."""
    mp.dps = digits
    gamma, l = [mpf(x) for x in start[0]], [mpf(x) for x in start[1]]
    time, seen = mpf(0), 0
    while True:
        series = Series(gamma, l, order)
        length = series.step()
        s = [float(c) for c in series.s]
        # Crossings are of order one apart: the mesh is 24 to 64 times finer than a step of 0.3.
        mesh = [float(length) * k / 24 for k in range(25)]
        value = lambda t: mp.polyval(series.s[::-1], t)
        rough = [sum(c * t**k for k, c in enumerate(s)) for t in mesh]
        assert all(abs(v) > 1e-9 for v in rough[1:-1]), "a mesh point lies on the section"
        ends = [value(mpf(0)), value(length)]
        rough[0], rough[-1] = ends
        for k in range(24):
            if (rough[k] > 0) == (rough[k + 1] > 0):
                continue
            seen += 1
            if seen < CROSSINGS:
                continue
            t = mpf(mesh[k] + mesh[k + 1]) / 2
            for _ in range(12):
                t -= value(t) / mp.polyval(series.ds[::-1], t)
            assert mesh[k] <= t <= mesh[k + 1], "Newton's method left its bracket"
            return [time + t], *series.at(t)
        gamma, l = series.at(length)
        time += length


def main():
    names = [f"{name}_{k}" for name in ("start_gamma", "start_l") for k in (1, 2, 3)]
    names += ["time"] + [f"{name}_{k}" for name in ("gamma", "l") for k in (1, 2, 3)] + ["agreement"]
    print(",".join(["h"] + names), flush=True)
    rng = random.Random(20080303)
    for h in (2.6, 4.45):
        for start in starts(rng, h, 4):
            first = [x for part in crossing(start, 64, 50) for x in part]
            second = [x for part in crossing(start, 76, 60) for x in part]
            off = max(abs(x - y) for x, y in zip(first, second))
            row = [repr(h)] + [repr(x) for part in start for x in part] + [mp.nstr(x, 30) for x in second]
            print(",".join(row + [mp.nstr(off, 2)]), flush=True)


main()
