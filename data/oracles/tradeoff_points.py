"""Points (h, l) of random bodies with the truth about them, for examples/tradeoff.rs.

    venv/bin/python tradeoff_points.py > ../tradeoff/points.jsonl

At an exact decimal l every relative equilibrium and both pole lines come from certified root isolation (exact.py). Written
are, for each point: `critical`, how many relative equilibria lie below h, and how many there are; and `middle`, an h (a
double) about half way between the two curves between which the point lies, in the same region, where a method that
proves its answers can tell the class; null below the minimum, and where no double lies inside. `distance` is the relative distance
from a random curve, in l^2/(2J) + r, at which the point was put; null for a random point of the stratum.
"""

import json
import random
from fractions import Fraction

from flint import arb, ctx, fmpq

from exact import Body, rational

ctx.dps = 90
RNG = random.Random(20261121)
RANDOM_POINTS = 150
POINTS_BESIDE = 40


def body_of(stratum):
    a = [RNG.uniform(0.3, 2.0) for _ in range(3)]
    r = [RNG.gauss(0, 1) for _ in range(3)]
    length = 10 ** RNG.uniform(-1, 1) / sum(x * x for x in r) ** 0.5
    i, j, k = RNG.sample(range(3), 3)
    if stratum == "near axis":
        r[j], r[k] = r[j] * 10 ** RNG.uniform(-6, -2), r[k] * 10 ** RNG.uniform(-6, -2)
    elif stratum == "near symmetric":
        a[i] = a[j] * (1 + 10 ** RNG.uniform(-9, -2))
    elif stratum == "rod":
        thin = 10 ** RNG.uniform(-6, -2)
        a = [1.0, 1.0, 1.0]
        a[i], a[j] = thin, 1 + 0.9 * thin
    return [repr(x) for x in a], [repr(x * length) for x in r]


def momentum(stratum, body):
    size = (float(arb(body.r2).sqrt()) * max(float(arb(x)) for x in body.a)) ** 0.5
    low, high = {"tiny l": (-6, -2), "huge l": (2, 6)}.get(stratum, (-0.7, 1.0))
    return repr(size * 10 ** RNG.uniform(low, high))


def exact(ball):
    mantissa, exponent = ball.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def curves(body, l):
    """(height, scale, is a relative equilibrium), ascending; heights to 60 digits and apart."""
    l2, norm = rational(l) ** 2, arb(body.r2).sqrt()
    found = [(c["h"], c["j"], True) for c in body.critical(l)]
    j_r = sum((a * r * r for a, r in zip(body.a, body.r)), fmpq(0)) / body.r2
    found += [(arb(l2 / (2 * j_r)) + sign * norm, arb(j_r), False) for sign in (-1, 1)]
    out = []
    for h, j, critical in found:
        scale = arb(l2) / (2 * j) + norm
        assert float(h.rad()) < 1e-50 * float(scale)
        out.append((exact(h), float(scale), critical))
    return sorted(out)


def point(stratum, distance):
    a, r = body_of(stratum)
    body = Body(a, r)
    l = momentum(stratum, body)
    heights = curves(body, l)
    if distance is None:
        low, high = float(heights[0][0]), float(heights[-1][0])
        h = repr(low + RNG.uniform(-0.1, 1.1) * max(high - low, 1e-3 * heights[0][1]))
    else:
        height, scale, _ = RNG.choice(heights)
        h = repr(float(height + Fraction(RNG.choice((-1, 1)) * distance * scale)))
    value = Fraction(h)
    below = [c for c in heights if c[0] < value]
    assert all(abs(c[0] - value) > Fraction(1, 10**50) * abs(value) for c in heights)
    middle = None
    if below and len(below) < len(heights):
        low, high = below[-1][0], heights[len(below)][0]
        candidate = float((low + high) / 2)
        if low < Fraction(candidate) < high:
            middle = candidate
    elif below:
        middle = float(below[-1][0]) + below[-1][1]
    line = dict(stratum=stratum, distance=distance, A=a, r=r, h=h, l=l)
    line |= dict(critical=[sum(c[2] for c in below), sum(c[2] for c in heights)], middle=middle)
    print(json.dumps(line), flush=True)


for name in ("generic", "near axis", "near symmetric", "rod", "tiny l", "huge l"):
    for _ in range(RANDOM_POINTS):
        point(name, None)
for power in range(2, 16):
    for _ in range(POINTS_BESIDE):
        point("generic", 10.0**-power)
for name in ("near axis", "near symmetric", "rod", "tiny l", "huge l"):
    for power in (3, 6, 9, 12, 15):
        for _ in range(POINTS_BESIDE // 2):
            point(name, 10.0**-power)
