#!/usr/bin/env python3
"""Motions by Taylor series of 84 digits in integers, as the oracle of crates/enclosure/tests/proved.rs.

    pip install mpmath; python3 motion.py [--cases N] [--seed K] [--out FILE]

Writes motion.jsonl beside this file: a line for each case with A, r, the start (gamma of any length, omega, phi), a time,
and gamma, omega and the quaternion (w, x, y, z) then, to 60 digits. Nothing is shared with the program: gamma, omega and the
quaternion are integrated side by side in fixed-point integers, and each case ends with a check that |gamma| = 1, energy and
vertical momentum are what they were and that the quaternion turns gamma up, to 1e-62.
"""
import argparse
import json
import os
import random
from fractions import Fraction
from operator import mul

import mpmath as mp

BITS = 280
ONE = 1 << BITS
ORDER = 72
mp.mp.dps = 95
HERE = os.path.dirname(os.path.abspath(__file__))


def strata(rng):
    """Moments and centre of mass as decimals, one family of bodies each."""
    def d(lo, hi, places=4):
        return str(Fraction(rng.randint(int(lo * 10**places), int(hi * 10**places)), 10**places))

    def body():
        while True:
            a = sorted((Fraction(d(0.2, 2)) for _ in range(3)), reverse=True)
            if a[1] + a[2] > a[0] > a[1] > a[2]:
                rng.shuffle(a)
                return a

    a, r = body(), [Fraction(d(-1, 1)) for _ in range(3)]
    k = rng.randrange(3)
    i, j = [m for m in range(3) if m != k]
    kind = rng.choice(["generic", "plane", "on-axis", "near-axis", "symmetric", "nearly-equal", "lagrange", "near-lagrange",
                       "euler", "isotropic", "rod", "plate", "unphysical", "katok", "scaled"])
    tiny = Fraction(1, 10**rng.randint(3, 12))
    if kind == "plane":
        r[k] = Fraction(0)
    elif kind == "on-axis":
        r[i] = r[j] = Fraction(0)
    elif kind == "near-axis":
        r[i], r[j] = r[i] * tiny, r[j] * tiny
    elif kind == "symmetric":
        a[i] = a[j]
    elif kind == "nearly-equal":
        a[i] = a[j] * (1 + tiny)
    elif kind in ("lagrange", "near-lagrange"):
        a[i] = a[j]
        r[i] = r[j] = Fraction(0)
        if kind == "near-lagrange":
            r[i], a[i] = tiny, a[i] * (1 + tiny)
    elif kind == "euler":
        r = [Fraction(0)] * 3
    elif kind == "isotropic":
        a = [a[0]] * 3
    elif kind == "rod":
        a[i] = a[j]
        a[k] = a[k] / 1000
        r[i], r[j] = r[i] / 1000, r[j] / 1000
    elif kind == "plate":
        a[k] = a[i] + a[j]
        r[k] = Fraction(0)
    elif kind == "unphysical":
        a[k] = 3 * (a[i] + a[j])
    elif kind == "katok":
        a[0], r = Fraction(1), [Fraction(1), Fraction(0), Fraction(0)]
    elif kind == "scaled":
        power = Fraction(10) ** rng.randint(-8, 8)
        a = [x * power for x in a]
        power = Fraction(10) ** rng.randint(-8, 8)
        r = [x * power for x in r]
    return kind, a, r


def fixed(x):
    """A rational or an mpf in units of 2^-BITS."""
    if isinstance(x, Fraction):
        return (x.numerator << BITS) // x.denominator
    return int(mp.nint(x * mp.mpf(2) ** BITS))


def follow(a, r, speed, state, time):
    """q, gamma, omega/speed in fixed point at a time in units of 1/speed."""
    turn = [fixed((a[1] - a[2]) / a[0]), fixed((a[2] - a[0]) / a[1]), fixed((a[0] - a[1]) / a[2])]
    pull = [[fixed(r[m] / (a[n] * speed * speed)) for m in range(3)] for n in range(3)]
    left = fixed(time)
    step = ONE // 8
    while left > 0:
        step = min(step, left)
        while True:
            x = [[value] for value in state]
            for k in range(ORDER):
                def conv(m, n):
                    return sum(map(mul, x[m], reversed(x[n]))) >> BITS
                q, g, w = [0, 1, 2, 3], [4, 5, 6], [7, 8, 9]
                new = [
                    -(conv(q[1], w[0]) + conv(q[2], w[1]) + conv(q[3], w[2])) >> 1,
                    conv(q[0], w[0]) + conv(q[2], w[2]) - conv(q[3], w[1]) >> 1,
                    conv(q[0], w[1]) + conv(q[3], w[0]) - conv(q[1], w[2]) >> 1,
                    conv(q[0], w[2]) + conv(q[1], w[1]) - conv(q[2], w[0]) >> 1,
                ]
                for i in range(3):
                    j, l = (i + 1) % 3, (i + 2) % 3
                    new.append(conv(g[j], w[l]) - conv(g[l], w[j]))
                for i in range(3):
                    j, l = (i + 1) % 3, (i + 2) % 3
                    torque = x[g[l]][k] * pull[i][j] - x[g[j]][k] * pull[i][l]
                    new.append((turn[i] * conv(w[j], w[l]) + torque) >> BITS)
                for row, value in zip(x, new):
                    row.append(value * step // (k + 1) >> BITS)
            last = max(max(abs(row[-1]), abs(row[-2])) for row in x)
            if last < 1 << (BITS - 225):
                break
            step = step * 2 // 3
        state = [sum(row) for row in x]
        left -= step
        if last < 1 << (BITS - 235):
            step = step * 9 // 8
    return state


def real(x):
    return mp.mpf(x) / mp.mpf(2) ** BITS


def rational(x):
    return mp.mpf(x.numerator) / x.denominator


def case(rng):
    kind, a, r = strata(rng)
    gamma = [Fraction(rng.randint(-1000, 1000), 1000) for _ in range(3)]
    if rng.random() < 0.05:
        gamma = [Fraction(0), Fraction(0), Fraction(rng.choice([-1, 1]))]
    if gamma == [0, 0, 0]:
        gamma[0] = Fraction(1)
    pull = max(abs(x) for x in r) / min(a)
    natural = Fraction(str(round(float(pull) ** 0.5, 12 - 0))) or Fraction(1)
    omega = [Fraction(rng.randint(-2000, 2000), 1000) * Fraction("%.3g" % float(natural)) for _ in range(3)]
    phi = Fraction(rng.choice([0, 0, rng.randint(-3000, 3000)]), 1000)
    scale = max(natural, max(abs(x) for x in omega))
    speed = Fraction(2) ** int(mp.floor(mp.log(rational(scale), 2)))
    time = Fraction("%.4g" % (rng.uniform(0.1, 1) * rng.choice([1, 4, 12]) / float(scale)))
    length = mp.sqrt(sum(rational(x) ** 2 for x in gamma))
    g = [rational(x) / length for x in gamma]
    theta, psi = mp.atan2(mp.hypot(g[0], g[1]), g[2]), mp.atan2(g[0], g[1]) if g[0] or g[1] else mp.mpf(0)
    f = rational(phi)
    q = [mp.cos(theta / 2) * mp.cos((f + psi) / 2), mp.sin(theta / 2) * mp.cos((f - psi) / 2),
         mp.sin(theta / 2) * mp.sin((f - psi) / 2), mp.cos(theta / 2) * mp.sin((f + psi) / 2)]
    start = [fixed(x) for x in q + g] + [fixed(x / speed) for x in omega]
    end = [real(x) for x in follow(a, r, speed, start, time * speed)]
    for before, after in zip(*(integrals(a, r, speed, [real(x) for x in state]) for state in (start, [fixed(x) for x in end]))):
        assert abs(before - after) < mp.mpf(10) ** -62 * (1 + abs(before)), (kind, before - after)
    w, x, y, z = end[:4]
    up = [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]
    assert max(abs(u - v) for u, v in zip(up, end[4:7])) < mp.mpf(10) ** -62
    def text(values):
        return [mp.nstr(value, 62, strip_zeros=False) for value in values]
    return {"kind": kind, "A": [str(x) for x in a], "r": [str(x) for x in r], "gamma0": [str(x) for x in gamma],
            "omega0": [str(x) for x in omega], "phi": str(phi), "time": str(time), "gamma": text(end[4:7]),
            "omega": text([rational(speed) * x for x in end[7:]]), "quaternion": text(end[:4])}


def integrals(a, r, speed, state):
    """|gamma|^2, energy and vertical momentum in units of the largest moment and the speed."""
    g, w = state[4:7], state[7:]
    unit = rational(max(a))
    m = [rational(x) / unit for x in a]
    p = [rational(x / (speed * speed)) / unit for x in r]
    return [sum(x * x for x in g), sum(m[i] * w[i] ** 2 / 2 - p[i] * g[i] for i in range(3)),
            sum(m[i] * w[i] * g[i] for i in range(3))]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cases", type=int, default=240)
    parser.add_argument("--seed", type=int, default=42)
    parser.add_argument("--out", default=os.path.join(HERE, "motion.jsonl"))
    options = parser.parse_args()
    rng = random.Random(options.seed)
    with open(options.out, "w") as file:
        for _ in range(options.cases):
            file.write(json.dumps(case(rng)) + "\n")
            file.flush()


if __name__ == "__main__":
    main()
