"""Points exactly on curves, with what meets there.

    venv/bin/python curve_points.py 250 curve_points.jsonl          (3 minutes)
    cargo run --release --example tradeoff -- curves curve_points.jsonl > ../tradeoff/curves.csv

A relative equilibrium gamma with omega^2 = s obeys r = s (mu - A) gamma, l = omega J, J = <gamma, A gamma>, and
h = l^2/(2J) - <gamma, r>. So rational gamma on the sphere, differences e = mu - A and omega give bodies and points that are
rational: with V = sum e gamma^2 and T = sum gamma^2/e,
  generic      any mu;
  cusp         mu = 4/T - 3 V, where l is stationary along the family: T (J + 4 V) = 4, J = mu - V;
  pair         e_k = 0, so that r_k = 0; over mu = A_k the products omega^2 gamma_i stay, i other than k;
  pair cusp    V goes with 1/s^2 on a pair, and l^2 = s J^2 is stationary where J = -4 V, mu = -3 V;
  pitchfork    e_k = 0 and gamma_k = 0;
  pole         r with rational length, any l;
  double       on a pole line h = l^2/(2 J_r) -+ |r| as well: with e_i gamma_i = R w_i for a rational unit vector w and
               W = sum e w^2, J_r = mu - W: (mu - V)(V - W) = 2 (mu - W)(V +- R), which is linear in mu;
  pair double  likewise with e_k = w_k = 0: a pair on a pole line;
  axis double  r and w on axis k: a pair over a second axis on a critical line;
  line         r on an axis and gamma with it: a critical line.

At l (1 +- delta), with a moderate delta, all curves come from certified root isolation (exact.py). Those that pass through
the point lie within reach of their slopes; `around` holds a double in the middle of every gap between them there and
one below and one above them: what meets at the point is what lies at these.
"""

import json
import os
import random
import sys
from fractions import Fraction as F

from flint import arb, fmpq

from exact import Body, rational

SEED = 20261123
LEAST = F(1, 10**24)
KINDS = ["generic", "cusp", "pair", "pair cusp", "pitchfork", "pole", "double", "pair double", "axis double", "line"]


def unit(rng, zero=()):
    """A rational unit vector; the components in `zero` vanish."""
    free = [k for k in range(3) if k not in zero]
    v = [F(0)] * 3
    if len(free) == 1:
        v[free[0]] = F(rng.choice((-1, 1)))
        return v
    t = [F(rng.choice((-1, 1)) * rng.randint(1, 12), rng.randint(1, 12)) for _ in free[1:]]
    n = 1 + sum(x * x for x in t)
    v[free[0]] = (2 - n) / n
    for k, x in zip(free[1:], t):
        v[k] = 2 * x / n
    return v


def difference(rng):
    return F(rng.choice((-1, 1)) * rng.randint(1, 40), rng.randint(1, 20))


def sample(kind, rng):
    """(A, r, h, l), or None where this choice gives no body."""
    k = rng.randrange(3)
    omega, size = F(rng.randint(1, 30), rng.randint(1, 15)), F(rng.randint(1, 30), rng.randint(1, 15))
    e = [difference(rng) for _ in range(3)]
    mu = F(rng.randint(1, 80), rng.randint(1, 20))
    others = [j for j in range(3) if j != k]
    gamma = unit(rng, {"pitchfork": [k], "axis double": [rng.choice(others)], "line": others}.get(kind, []))
    if kind in ("pair", "pair cusp", "pitchfork"):
        e[k] = F(0)
    if kind in ("double", "pair double"):
        w = unit(rng, [k] if kind == "pair double" else [])
        if not all(gamma):
            return None
        e = [size * x / g for x, g in zip(w, gamma)]
    elif kind == "axis double":
        # The pair stands over the axis that has a part of gamma beside k.
        e = [F(0) if j != k and gamma[j] else x for j, x in enumerate(e)]
        w = [F(0) if j != k else F(1) for j in range(3)]
        size = abs(e[k] * gamma[k])
    v = sum(x * g * g for x, g in zip(e, gamma))
    if kind == "cusp":
        t = sum(g * g / x for x, g in zip(e, gamma))
        if t == 0:
            return None
        mu = 4 / t - 3 * v
    elif kind == "pair cusp":
        mu = -3 * v
    elif kind.endswith("double"):
        turn = sum(x * y * y for x, y in zip(e, w))
        target = v + rng.choice((-1, 1)) * size
        slope = (v - turn) - 2 * target
        if slope == 0:
            return None
        mu = (v * (v - turn) - 2 * turn * target) / slope
    a = [mu - x for x in e]
    if not all(F(1, 1000) < x < 1000 for x in a):
        return None
    if kind == "pole":
        w = unit(rng)
        j, l = sum(x * y * y for x, y in zip(a, w)), F(rng.randint(1, 60), rng.randint(1, 15))
        return a, [size * x for x in w], l * l / (2 * j) + rng.choice((-1, 1)) * size, l
    r = [omega * omega * x * g for x, g in zip(e, gamma)]
    j = mu - v
    l = omega * j
    return a, r, l * l / (2 * j) - sum(x * g for x, g in zip(r, gamma)), l


def exact(ball):
    mantissa, exponent = ball.mid().man_exp()
    return F(int(mantissa)) * F(2) ** int(exponent)


def heights(body, l):
    l2, norm = rational(str(l)) ** 2, arb(body.r2).sqrt()
    found = [exact(c["h"]) for c in body.critical(str(l))]
    j_r = sum((a * r * r for a, r in zip(body.a, body.r)), fmpq(0)) / body.r2
    found += [exact(arb(l2 / (2 * j_r)) + sign * norm) for sign in (-1, 1)]
    found.sort()
    merged = found[:1]
    for h in found[1:]:
        if h - merged[-1] > abs(h) / 10**60:
            merged.append(h)
    return merged


def beside(body, h, l, fastest, delta):
    """The heights that lie within reach of the point at l (1 -+ delta), and whether all others are far away."""
    reach = 2 * fastest * l * delta
    sides, clear = [], True
    for side in (1 - delta, 1 + delta):
        there = l * side if delta == LEAST else F(float(l * side))
        every = heights(body, there)
        near = [x for x in every if abs(x - h) < reach]
        clear &= all(abs(x - h) > 6 * reach for x in every if x not in near)
        sides.append((there, near))
    return sides, clear, reach


def around(a, r, h, l):
    """Doubles (h, l) in all that meets at a point; None where something else is near."""
    body = Body([str(x) for x in a], [str(x) for x in r])
    fastest = l / min(a)
    for delta in (F(1, 10**3), F(1, 10**4), F(1, 10**5), F(1, 10**6)):
        sides, clear, reach = beside(body, h, l, fastest, delta)
        # Only what passes through the point is as near at the least distance.
        nearest = beside(body, h, l, fastest, LEAST)
        if not (clear and nearest[1]) or [len(s[1]) for s in sides] != [len(s[1]) for s in nearest[0]]:
            continue
        found = []
        for there, near in sides:
            marks = [h - 3 * reach, *near, h + 3 * reach] if near else [h + reach, h + reach]
            gaps = list(zip(marks, marks[1:]))
            clear &= not near or all(high - low > abs(h) / 10**11 for low, high in gaps)
            found += [(float((low + high) / 2), float(there)) for low, high in gaps]
        if clear:
            return found
    return None


def line(kind, number):
    rng = random.Random(f"{SEED} {kind} {number}")
    while True:
        drawn = sample(kind, rng)
        if drawn is None:
            continue
        a, r, h, l = drawn
        if l <= 0 or all(x == 0 for x in r):
            continue
        found = around(a, r, h, l)
        if found is not None:
            texts = [str(x) for x in a], [str(x) for x in r]
            return dict(kind=kind, A=texts[0], r=texts[1], h=str(h), l=str(l), around=found)


def main():
    count, path = int(sys.argv[1]), sys.argv[2]
    done = sum(1 for _ in open(path)) if os.path.exists(path) else 0
    with open(path, "a") as out:
        for n in range(done, count * len(KINDS)):
            number, kind = divmod(n, len(KINDS))
            print(json.dumps(line(KINDS[kind], number)), file=out, flush=True)
            if n % 20 == 0:
                print(f"\r{n} of {count * len(KINDS)}", end="", file=sys.stderr, flush=True)


main()
