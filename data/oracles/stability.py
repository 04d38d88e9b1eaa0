#!/usr/bin/env python3
"""Relative equilibria and their eigenvalues, with 60 digits, by other means than the program's.

    python3 data/oracles/stability.py > data/oracles/stability.jsonl
    python3 data/oracles/stability.py 2000 > generic.jsonl      # a campaign: so many generic bodies

For each body and l the critical points of U_l are found from Staude's equation by sign changes of
l(mu) - l on a dense grid, refined with 60 digits (mpmath), and from the equation of the pairs; each is put into the full
6x6 matrix of the linearised Euler-Poisson equations, whose characteristic polynomial (by Faddeev and LeVerrier, not by
the closed form of docs/mathematics.md) is lambda^2 (lambda^4 + b lambda^2 + c). Eigenvalues are its roots. A point
whose type hangs on |quantity| < 1e-40 of its scale counts as zero or double.

Every line: {"A", "r", "l", "points": [{"h", "gamma", "type", "eigenvalues": [[re, im], [re, im]]}]} with 25 digits.
Cases: generic bodies, a body near Lagrange's, r near a plane, rods and discs, Lagrange's top about each axis, scaled
and on both sides of both thresholds and on them, Kovalevskaya, Euler.
"""

import json
import random
import sys
from fractions import Fraction

from mpmath import mp, mpf, sqrt, matrix, findroot

mp.dps = 60
TINY = mpf(10) ** -40


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def whole(A, r, gamma, omega):
    """The matrix of (dgamma, dl) -> time derivatives, column by column."""
    w = [omega * g for g in gamma]
    l = [a * x for a, x in zip(A, w)]
    m = matrix(6, 6)
    for column in range(3):
        e = [mpf(int(column == k)) for k in range(3)]
        top, weight = cross(e, w), cross(e, r)
        tilt, turn, drag = cross(gamma, e), cross(e, w), cross(l, e)
        for row in range(3):
            m[row, column] = top[row]
            m[row + 3, column] = -weight[row]
            m[row, column + 3] = tilt[row] / A[column]
            m[row + 3, column + 3] = turn[row] + drag[row] / A[column]
    return m


def characteristic(m):
    """b and c of lambda^6 + b lambda^4 + c lambda^2, and the largest of the coefficients that vanish."""
    n = m.rows
    power, coefficients = mp.eye(n), [mpf(1)]
    for k in range(1, n + 1):
        power = m * power
        trace = sum(power[i, i] for i in range(n))
        coefficients.append(-trace / k)
        for i in range(n):
            power[i, i] += coefficients[-1]
    return coefficients[2], coefficients[4], max(abs(coefficients[k]) for k in (1, 3, 5, 6))


def eigenvalues(b, c, scale):
    """Type and the two roots with re >= 0 and im >= 0."""
    disc = b * b - 4 * c
    b0, c0, d0 = (abs(x) <= TINY * s for x, s in ((b, scale), (c, scale**2), (disc, scale**2)))

    def pair(square):
        return [sqrt(square), mpf(0)] if square > 0 else [mpf(0), sqrt(-square)]

    if c0:
        return "zero", [pair(-b) if not b0 else [mpf(0)] * 2, [mpf(0), mpf(0)]]
    if d0:
        return ("double-elliptic" if b > 0 else "double-real"), [pair(-b / 2)] * 2
    if disc < 0:
        root = sqrt(mp.mpc(-b / 2, sqrt(-disc) / 2))
        return "complex", [[abs(root.real), abs(root.imag)]] * 2
    squares = [(-b + sqrt(disc)) / 2, (-b - sqrt(disc)) / 2]
    name = {2: "saddle", 1: "saddle-centre", 0: "elliptic"}[sum(s > 0 for s in squares)]
    return name, sorted((pair(s) for s in squares), key=lambda p: (-p[0], -p[1]))


def staude(A, r, mu):
    """s, gamma and l on the generic family."""
    P = sum(x * x / (mu - a) ** 2 for a, x in zip(A, r) if x)
    s = sqrt(P)
    gamma = [x / (s * (mu - a)) if x else mpf(0) for a, x in zip(A, r)]
    return s, gamma, sqrt(s) * sum(a * g * g for a, g in zip(A, gamma))


def grid(low, high):
    """(base, offset) by rising mu between two ends (None: infinite), closing in on both; plain floats."""
    far = [2.0 ** (k / 6) for k in range(-260, 200)]
    if low is None:
        return [(high, -d) for d in reversed(far)]
    if high is None:
        return [(low, d) for d in far]
    half = float(high - low) / 2
    near = sorted({half * 2.0 ** (-k / 4) for k in range(200)} | {half * k / 400 for k in range(1, 400)})
    return [(low, d) for d in near] + [(high, -d) for d in reversed(near)]


def refined(f, p, q):
    """The root of f between p and q, by bisection to 20 bits and secants with all digits."""
    fp = f(p)
    if fp == 0:
        return p
    for _ in range(20):
        middle = (p + q) / 2
        value = f(middle)
        if value * fp > 0:
            p, fp = middle, value
        else:
            q = middle
    return findroot(f, (p, q), solver="anderson", tol=mpf(10) ** -100, verify=False, maxsteps=30)


def changes(points, f):
    """Neighbouring points between which f changes its sign, a zero counting as negative."""
    values = [(p, f(p)) for p in points]
    return [(p, q) for (p, fp), (q, fq) in zip(values, values[1:]) if (fp <= 0) != (fq <= 0)]


def equilibria(A, r, l):
    """gamma, s of all relative equilibria at l > 0; circles are represented by one point."""
    found = []
    active = sorted({a for a, x in zip(A, r) if x})
    target = float(l)
    for low, high in zip([None] + active, active + [None]) if active else []:
        # The search is done in floats, with mu - a as an offset plus a difference of moments.
        apart = {base: [(float(base - a), float(a), float(x) ** 2) for a, x in zip(A, r) if x] for base in (low, high) if base is not None}

        def rough(point):
            base, offset = point
            terms = [(rho / (offset + d) ** 2, a) for d, a, rho in apart[base]]
            P = sum(t for t, _ in terms)
            return P**0.25 * sum(t * a for t, a in terms) / P - target

        for (p, d), (q, e) in changes(grid(low, high), rough):
            mu = refined(lambda m: staude(A, r, m)[2] - l, p + mpf(d), q + mpf(e))
            found.append(staude(A, r, mu)[:2])
    for value in sorted(set(A)):
        if value in active:
            continue
        axis = A.index(value)
        others = [(k, x / (value - A[k])) for k, x in enumerate(r) if x]
        floor = sqrt(sum(g * g for _, g in others))
        shift = sum(r[k] * g for k, g in others)
        unit = floor if floor else mpf(1)
        momentum = lambda s: sqrt(s) * (value - shift / s**2) - l
        rough = lambda t: float(floor + unit * t) ** 0.5 * (float(value) - float(shift) / float(floor + unit * t) ** 2) - target
        for p, q in changes([2.0 ** (k / 8) for k in range(-320, 320)], rough):
            s = refined(momentum, floor + unit * mpf(p), floor + unit * mpf(q))
            gamma = [mpf(0)] * 3
            for k, g in others:
                gamma[k] = g / s
            gamma[axis] = sqrt(1 - sum(g * g for g in gamma))
            mirrored = list(gamma)
            mirrored[axis] = -gamma[axis]
            found.append((s, gamma))
            if A.count(value) == 1:
                found.append((s, mirrored))
    return found


def solved(A, r, l):
    exact = [Fraction(x) for x in A], [Fraction(x) for x in r], Fraction(l)
    a, c = ([mpf(x.numerator) / x.denominator for x in side] for side in exact[:2])
    momentum = mpf(exact[2].numerator) / exact[2].denominator
    # Inside an eigenspace r is turned onto its first axis.
    turned = list(c)
    for i in range(3):
        same = [k for k in range(3) if a[k] == a[i]]
        turned[i] = sqrt(sum(c[k] ** 2 for k in same)) if i == same[0] else mpf(0)
    points = []
    for s, gamma in equilibria(a, turned, momentum):
        omega = sqrt(s)
        m = whole(a, turned, gamma, omega)
        b, k, rest = characteristic(m)
        scale = max(abs(m[i, j]) for i in range(6) for j in range(6)) ** 2
        assert rest < mpf(10) ** -40 * max(1, scale**3), rest
        name, roots = eigenvalues(b, k, scale)
        h = s * sum(x * g * g for x, g in zip(a, gamma)) / 2 - sum(x * g for x, g in zip(turned, gamma))
        text = lambda x: mp.nstr(x, 25)
        points.append({"h": text(h), "type": name, "eigenvalues": [[text(x) for x in pair] for pair in roots]})
    points.sort(key=lambda point: mpf(point["h"]))
    return {"A": A, "r": r, "l": l, "points": points}


def cases():
    rng = random.Random(18)
    digits = lambda x, n=5: f"{x:.{n}f}"
    momenta = lambda: [digits(10 ** rng.uniform(-1.5, 1.3), 4) for _ in range(2)]
    for _ in range(110):
        A = [digits(rng.uniform(0.2, 2)) for _ in range(3)]
        yield from ((A, [digits(rng.gauss(0, 1)) for _ in range(3)], l) for l in momenta())
    for _ in range(30):
        A = ["1", f"{1 + 10 ** rng.uniform(-7, -2):.9f}", digits(rng.uniform(0.3, 1.9))]
        r = [f"{10 ** rng.uniform(-6, -1):.9f}", "0", digits(rng.uniform(0.3, 1))]
        yield from ((A, r, l) for l in momenta())
    for _ in range(30):
        A = [digits(rng.uniform(0.2, 2)) for _ in range(3)]
        r = [digits(rng.gauss(0, 1)) for _ in range(3)]
        r[rng.randrange(3)] = "0"
        yield from ((A, r, l) for l in momenta())
    for _ in range(20):
        A = ["1/1000", "1", f"{1 + 10 ** rng.uniform(-6, 0):.9f}"]
        rng.shuffle(A)
        yield from ((A, [digits(rng.gauss(0, 1)) for _ in range(3)], l) for l in momenta())
    for axis in range(3):
        for scale in (1, 4, 9, 25):
            for along in ("1/2", "1", "3/2", "2", "5/2"):
                # l^2 = 4 A r with A = scale, r = scale: l = 2 scale.
                A = [str(scale)] * 3
                A[axis] = str(Fraction(along) * scale)
                r = ["0"] * 3
                r[axis] = str(scale if axis != 1 else -scale)
                for l in ("1/3", "19/10", "2", "21/10", "7"):
                    yield A, r, str(Fraction(l) * scale)
    for l in ("1/2", "1.84", "2", "1.755", "3", "20"):
        yield ["2", "2", "1"], ["1", "0", "0"], l
        yield ["2", "2", "1"], ["3/5", "4/5", "0"], l
        yield ["4", "4", "1"], ["1", "0", "0"], l
    for A in (["2", "1.5", "1"], ["3", "2", "1"], ["1", "1", "2"], ["2", "2", "1"]):
        for l in ("1/10", "1", "30"):
            yield A, ["0", "0", "0"], l


def generic(count):
    """Generic bodies for a campaign, one l each."""
    rng = random.Random(2000)
    digits = lambda x, n=5: f"{x:.{n}f}"
    for _ in range(count):
        A = [digits(rng.uniform(0.2, 2)) for _ in range(3)]
        yield A, [digits(rng.gauss(0, 1)) for _ in range(3)], digits(10 ** rng.uniform(-1.5, 1.3), 4)


def main():
    for A, r, l in generic(int(sys.argv[1])) if len(sys.argv) > 1 else cases():
        print(json.dumps(solved(A, r, l)))
        sys.stdout.flush()


if __name__ == "__main__":
    main()
