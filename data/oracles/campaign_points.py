"""Points (h, l) at every distance from curves of bodies of every stratum, with the truth about them.

    venv/bin/python campaign_points.py 1000 points.jsonl          (five minutes of a core)
    cargo run --release --example tradeoff -- classify points.jsonl > data/tradeoff/classify.csv

Arguments: bodies of each stratum, the file; a third one, `bodies`, leaves out all points but a random one for each body,
as in ../tradeoff/points.jsonl. Each body has a seed of its own, so that a file that was begun goes on where it ends.

At an exact l every relative equilibrium and both pole lines come from certified root isolation (exact.py). One line for
each body: A, r, l and `points`, of which each tells
  distance  the relative distance, in l^2/(2J) + |r|, from a random curve; null for a random point,
  h         a decimal with as many digits as it takes,
  critical  how many relative equilibria lie below h,
  euler     the Euler characteristic of U_hl by Morse theory: each below h counts (-1)^index, a circle 0, the sphere 2,
  poles     whether the north and the south pole, r/|r| and -r/|r|, lie in U_hl; null for r = 0,
  middle    doubles near the middles of the gap between curves in which the point lies (above all curves, or below: one that
            lies there too), where a method with errors in the last digits of a double can tell the class; null where no
            double lies well inside.
"""

import json
import os
import random
import sys
from fractions import Fraction

from flint import arb, ctx, fmpq

from exact import Body, rational

ctx.dps = 130
SEED = 20261122
DISTANCES = [2, 4, 6, 8, 10, 12, 14, 15, 16, 17, 18, 20, 25, 30, 40, 50, 60]
STRATA = ["generic", "plane", "axis", "near axis", "tiny r", "symmetric", "near symmetric", "Lagrange", "near Lagrange"]
STRATA += ["Euler", "isotropic", "rod", "plate", "unphysical", "Katok", "scaled", "tiny l", "huge l"]


def body_of(stratum, rng):
    a = [Fraction(rng.randint(300_000, 2_000_000), 10**6) for _ in range(3)]
    r = [Fraction(round(rng.gauss(0, 1) * 10**6) or 1, 10**6) for _ in range(3)]
    i, j, k = rng.sample(range(3), 3)

    def tiny(low, high):
        return Fraction(rng.randint(1, 99), 10) * Fraction(1, 10 ** rng.randint(low, high))

    if stratum == "plane":
        r[i] = Fraction(0)
    elif stratum == "axis":
        r[i] = r[j] = Fraction(0)
    elif stratum == "near axis":
        r[j], r[k] = r[j] * tiny(2, 9), r[k] * tiny(2, 9)
    elif stratum == "tiny r":
        r[i] *= tiny(3, 12)
    elif stratum == "symmetric":
        a[i] = a[j]
    elif stratum == "near symmetric":
        a[i] = a[j] * (1 + tiny(2, 12))
    elif stratum == "Lagrange":
        a[i], r[i], r[j] = a[j], Fraction(0), Fraction(0)
    elif stratum == "near Lagrange":
        a[i], r[i], r[j] = a[j] * (1 + tiny(2, 9)), tiny(2, 9), tiny(2, 9)
    elif stratum == "Euler":
        r = [Fraction(0)] * 3
    elif stratum == "isotropic":
        a = [a[0]] * 3
    elif stratum == "rod":
        thin = tiny(2, 9)
        a[i], a[j], a[k] = thin, Fraction(1) + thin * Fraction(9, 10), Fraction(1)
    elif stratum == "plate":
        a[i] = a[j] + a[k]
    elif stratum == "unphysical":
        a[i] *= tiny(1, 3)
    elif stratum == "Katok":
        a[i], r = Fraction(1), [Fraction(int(n == i)) for n in range(3)]
    elif stratum == "scaled":
        p, q = rng.randint(-40, 40), rng.randint(-40, 40)
        a, r = [x * Fraction(10) ** p for x in a], [x * Fraction(10) ** q for x in r]
    return a, r


def decimal(x):
    """A rational whose denominator divides a power of ten."""
    sign, x, exponent = "-" if x < 0 else "", abs(x), 0
    while x.denominator != 1:
        x, exponent = x * 10, exponent - 1
    return f"{sign}{x.numerator}e{exponent}" if exponent else f"{sign}{x.numerator}"


def rounded(x, digits):
    """A rational to some significant decimal digits."""
    if x == 0:
        return x
    size = 0
    while abs(x) * Fraction(10) ** -size >= 1:
        size += 1
    while abs(x) * Fraction(10) ** -size < Fraction(1, 10):
        size -= 1
    unit = Fraction(10) ** (size - digits)
    return round(x / unit) * unit


def momentum(stratum, a, r, rng):
    norm2 = float(sum(x * x for x in r)) or 1.0
    size = (norm2**0.5 * float(max(a))) ** 0.5
    low, high = {"tiny l": (-6, -2), "huge l": (2, 6)}.get(stratum, (-0.7, 1.0))
    return rounded(Fraction(size * 10 ** rng.uniform(low, high)), 8)


def exact(ball):
    mantissa, exponent = ball.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def curves(body, l):
    """(height, scale, the equilibrium or the sign of the pole), ascending; heights to 100 digits of the scale."""
    l2, norm = rational(l) ** 2, arb(body.r2).sqrt()
    found = [(c["h"], c["j"], c) for c in body.critical(l)]
    if body.r2 != 0:
        j_r = sum((a * r * r for a, r in zip(body.a, body.r)), fmpq(0)) / body.r2
        found += [(arb(l2 / (2 * j_r)) - pole * norm, arb(j_r), pole) for pole in (1, -1)]
    out = []
    for h, j, what in found:
        scale = arb(l2) / (2 * j) + norm
        assert float(h.rad()) < 1e-100 * float(scale)
        out.append((exact(h), exact(scale), what))
    return sorted(out, key=lambda c: c[0])


def weight(what):
    """What an equilibrium adds to the Euler characteristic."""
    return {"circle": 0, "sphere": 2}.get(what["multiplicity"], 1 - 2 * (what["index"] % 2))


def middle(below, above):
    """A double well inside a gap."""
    if not below:
        return None
    low, scale = below[-1][0], below[-1][1]
    high = above[0][0] if above else low + 2 * scale
    candidate = float((low + high) / 2)
    room = (high - low) / 8
    return candidate if low + room < Fraction(candidate) < high - room else None


def point(heights, distance, rng):
    if distance is None:
        low, high = heights[0][0], heights[-1][0]
        share = Fraction(rng.uniform(-0.1, 1.1))
        h = rounded(low + share * max(high - low, heights[0][1] / 1000), 12)
    else:
        height, scale, _ = rng.choice(heights)
        off = rng.choice((-1, 1)) * Fraction(rng.randint(10, 99), 10) / 10**distance * scale
        # Digits below the distance, however small h is against it.
        unit = Fraction(10) ** (len(str(int(scale.numerator))) - len(str(int(scale.denominator))) - distance - 6)
        h = round((height + off) / unit) * unit
    below = [c for c in heights if c[0] < h]
    above = heights[len(below) :]
    assert all(abs(c[0] - h) > c[1] / 10**90 for c in heights), "on a curve"
    equilibria = [c[2] for c in below if isinstance(c[2], dict)]
    poles = [any(c[2] == pole for c in below) for pole in (1, -1)]
    return {
        "distance": None if distance is None else f"1e-{distance}",
        "h": decimal(h),
        "critical": len(equilibria),
        "euler": sum(map(weight, equilibria)),
        "poles": None if all(isinstance(c[2], dict) for c in heights) else poles,
        "middle": middle(below, above),
    }


def line(stratum, number, whole):
    rng = random.Random(f"{SEED} {stratum} {number}")
    a, r = body_of(stratum, rng)
    l = momentum(stratum, a, r, rng)
    texts = [decimal(x) for x in a], [decimal(x) for x in r], decimal(l)
    body = Body(*texts[:2])
    heights = curves(body, texts[2])
    points = [point(heights, distance, rng) for distance in ([None, *DISTANCES] if whole else [None])]
    return dict(stratum=stratum, A=texts[0], r=texts[1], l=texts[2], points=points)


def main():
    bodies, path, whole = int(sys.argv[1]), sys.argv[2], sys.argv[3:] != ["bodies"]
    done = sum(1 for _ in open(path)) if os.path.exists(path) else 0
    with open(path, "a") as out:
        for n in range(done, bodies * len(STRATA)):
            number, stratum = divmod(n, len(STRATA))
            print(json.dumps(line(STRATA[stratum], number, whole)), file=out, flush=True)
            if n % 100 == 0:
                print(f"\r{n} of {bodies * len(STRATA)}", end="", file=sys.stderr, flush=True)


main()
