"""Writes classify2.jsonl: points beside curves, and on which side they lie.

    venv/bin/python classify2.py > classify2.jsonl

At an exact decimal l all critical values and both pole lines are known to 60 digits (exact.py). A point is put at
h = h_c (1 + eps), eps relative to l^2/(2J) + r of the curve, |eps| = 1e-2 ... 1e-15. `below` and `above` are the curves between
which it lies (30 digits; null: none); `middle` is an h half way between them at the same l, in the same region, where any
method can tell the class; `relative` the distance to the nearest curve over l^2/(2J) + r.
"""

import json
import random
import sys

from flint import arb, ctx, fmpq

from exact import Body, digits, rational

ctx.dps = 90
rng = random.Random(77)


def decimal(x, places=4):
    return f"{x:.{places}e}"


def body_of(kind):
    a = [decimal(rng.uniform(0.5, 1.9)) for _ in range(3)]
    r = [decimal(rng.choice([-1, 1]) * rng.uniform(0.2, 1.2)) for _ in range(3)]
    i, j, k = rng.sample(range(3), 3)
    if kind == "plane":
        r[i] = "0"
    elif kind == "axis":
        r[i] = r[j] = "0"
    elif kind == "tiny_r":
        r[i] = decimal(float(r[i]) * 10 ** rng.uniform(-12, -3))
    elif kind == "near_axis":
        r[i] = decimal(float(r[i]) * 10 ** rng.uniform(-4, -2))
        r[j] = decimal(float(r[j]) * 10 ** rng.uniform(-4, -2))
    elif kind == "symmetric":
        a[i] = a[j]
    elif kind == "near_equal":
        a[i] = decimal(float(a[j]) * (1 + 10 ** rng.uniform(-7, -2)), 15)
    elif kind == "rod":
        a[i] = decimal(10 ** rng.uniform(-4, -1))
    elif kind == "lagrange":
        a[i] = a[j]
        r[i] = r[j] = "0"
    return a, r


def main():
    kinds = ["generic"] * 8 + ["plane", "axis", "tiny_r", "near_axis", "symmetric", "near_equal", "rod", "lagrange"]
    for n in range(1280):
        kind = kinds[n % len(kinds)]
        a, r = body_of(kind)
        body = Body(a, r)
        norm = arb(body.r2).sqrt()
        size = float(norm) ** 0.5 * max(map(float, a)) ** 0.5
        l = decimal(size * 10 ** rng.uniform(-0.7, 0.9), rng.choice([4, 12, 25]))
        l2 = rational(l) ** 2
        curves = [(c["h"], l2 / 2 / c["j"] + norm, "critical") for c in body.critical(l)]
        j_r = sum((x * w for x, w in body.weights.items()), fmpq(0)) / body.r2
        for sign in (-1, 1):
            curves.append((l2 / 2 / arb(j_r) + sign * norm, l2 / 2 / arb(j_r) + norm, "P+" if sign < 0 else "P-"))
        curves.sort(key=lambda c: float(c[0]))
        h_c, scale, what = rng.choice(curves)
        eps = rng.choice([-1, 1]) * arb(10) ** -(2 + n // len(kinds) % 14) * rng.choice([1, 2, 3])
        h_text = (h_c + eps * scale).str(28, radius=False)
        h = arb(rational(h_text))
        under = [c for c in curves if c[0] < h]
        over = [c for c in curves if c[0] > h]
        if len(under) + len(over) != len(curves):
            print("left out", file=sys.stderr)
            continue
        below = max(under, key=lambda c: float(c[0] - h)) if under else None
        above = min(over, key=lambda c: float(c[0] - h)) if over else None
        if below is None:
            middle = above[0] - above[1]
        elif above is None:
            middle = below[0] + below[1]
        else:
            middle = (below[0] + above[0]) / 2
        relative = min(float(abs(c[0] - h) / c[1]) for c in (below, above) if c)
        print(json.dumps(dict(
            kind=kind, A=a, r=r, l=l, h=h_text, curve=what, relative=relative,
            below=below and digits(below[0], 30), above=above and digits(above[0], 30), middle=middle.str(20, radius=False),
        )))


main()
