#!/usr/bin/env python3
"""Euler's and Lagrange's tops by Jacobi's elliptic functions, as an oracle of crates/enclosure/tests/proved.rs.

    pip install mpmath; python3 elliptic_motion.py

Writes elliptic_motion.jsonl beside this file: A, r, the start, a time, and what is known then to 50 digits: omega of Euler's
top (Landau and Lifshitz, Mechanics, section 37), gamma3 of Lagrange's from the cubic of its nutation.
"""
import json
import os
import random
from fractions import Fraction

import mpmath as mp

mp.mp.dps = 70
HERE = os.path.dirname(os.path.abspath(__file__))


def real(x):
    return mp.mpf(x.numerator) / x.denominator


def text(x):
    return mp.nstr(x, 52, strip_zeros=False)


def euler(rng):
    """From omega2 = 0 with L^2 > 2 T I2, moments I1 < I2 < I3."""
    while True:
        i = sorted(Fraction(rng.randint(20, 100), 100) for _ in range(3))
        w = [Fraction(rng.randint(1, 200), 100), Fraction(0), Fraction(rng.randint(1, 200), 100)]
        energy2 = sum(m * x * x for m, x in zip(i, w))
        square = sum(m * m * x * x for m, x in zip(i, w))
        if i[0] < i[1] < i[2] and square > energy2 * i[1]:
            break
    time = Fraction(rng.randint(1, 2000), 100)
    rate = mp.sqrt(real((i[2] - i[1]) * (square - energy2 * i[0]) / (i[0] * i[1] * i[2])))
    m = real((i[1] - i[0]) * (energy2 * i[2] - square) / ((i[2] - i[1]) * (square - energy2 * i[0])))
    sn, cn, dn = (mp.ellipfun(name, rate * real(time), m=m) for name in ("sn", "cn", "dn"))
    omega = [real(w[0]) * cn, mp.sqrt(real((energy2 * i[2] - square) / (i[1] * (i[2] - i[1])))) * sn, real(w[2]) * dn]
    return {"kind": "euler", "A": i, "r": [0, 0, 0], "gamma0": [0, 0, 1], "omega0": w, "time": time,
            "omega": [text(x) for x in omega]}


def lagrange(rng):
    """From a turning point of the nutation: gamma = (3, 0, +-4)/5, omega = (omega1, 0, n)."""
    a, c, rho = (Fraction(rng.randint(20, 100), 100) for _ in range(3))
    c = min(c, a * 2)
    u0 = Fraction(rng.choice([4, -4]), 5)
    w1, n = Fraction(rng.randint(-300, 300), 100), Fraction(rng.randint(-300, 300), 100)
    h = a * w1 * w1 / 2 - rho * u0
    vertical = a * Fraction(3, 5) * w1 + c * n * u0
    # u'^2 = (1 - u^2)(2/a)(h + rho u) - ((l - c n u)/a)^2
    cubic = [-2 * rho / a, -2 * h / a - (c * n / a) ** 2, 2 * rho / a + 2 * vertical * c * n / a**2, 2 * h / a - (vertical / a) ** 2]
    # Without the known root.
    q = [cubic[0], cubic[1] + u0 * cubic[0]]
    q.append(cubic[2] + u0 * q[1])
    root = mp.sqrt(real(q[1] ** 2 - 4 * q[0] * q[2]))
    others = [(-real(q[1]) + sign * root) / (2 * real(q[0])) for sign in (1, -1)]
    low, first, last = sorted([*others, real(u0)])
    time = Fraction(rng.randint(1, 2000), 100)
    m = (last - first) / (last - low)
    at = mp.sqrt(real(rho) * (last - low) / (2 * real(a))) * real(time)
    if abs(last - real(u0)) > abs(first - real(u0)):
        at += mp.ellipk(m)
    u = last - (last - first) * mp.ellipfun("sn", at, m=m) ** 2
    return {"kind": "lagrange", "A": [a, a, c], "r": [0, 0, rho], "gamma0": [3, 0, 4 if u0 > 0 else -4], "omega0": [w1, 0, n],
            "time": time, "gamma3": text(u)}


def main():
    rng = random.Random(37)
    with open(os.path.join(HERE, "elliptic_motion.jsonl"), "w") as file:
        for k in range(40):
            case = (euler if k % 2 else lagrange)(rng)
            for key in ("A", "r", "gamma0", "omega0"):
                case[key] = [str(x) for x in case[key]]
            case["time"] = str(case["time"])
            file.write(json.dumps(case) + "\n")


if __name__ == "__main__":
    main()
