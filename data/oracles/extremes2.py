"""Writes extremes2.jsonl: every relative equilibrium of extreme bodies, with Morse index.

    python3 -m venv venv && venv/bin/pip install python-flint && venv/bin/python extremes2.py > extremes2.jsonl

Method: exact.py. `cusp_distance` = l/l_c - 1 for the nearest cusp or pitchfork in l (null when there is none within a factor of ten).
"""

import json
import random
import sys

from flint import arb, ctx

from exact import Body, digits, rational

rng = random.Random(20080229)


def decimal(x, places=4):
    return f"{x:.{places}e}"


def uniform():
    return [decimal(rng.uniform(0.3, 2.0)) for _ in range(3)], [decimal(rng.gauss(0, 1)) for _ in range(3)]


def log_uniform(low, high):
    return 10 ** rng.uniform(low, high)


def axes():
    order = [0, 1, 2]
    rng.shuffle(order)
    return order


def near(text, relative):
    """text * (1 + relative) as an exact decimal."""
    from decimal import Decimal, getcontext

    getcontext().prec = 60
    return str(Decimal(text) * (1 + Decimal(relative)))


def scale(values, exponent):
    return [v if float(v) == 0 else f"{v}".replace("e", "E").split("E")[0] + f"e{int(f'{v}'.lower().split('e')[1]) + exponent}" for v in values]


def body_of(kind):
    a, r = uniform()
    i, j, k = axes()
    if kind == "tiny_r":
        r[i] = decimal(rng.choice([-1, 1]) * log_uniform(-16, -11))
    elif kind == "tiny_r_two":
        r[i] = decimal(log_uniform(-14, -9))
        r[j] = decimal(-log_uniform(-14, -9))
    elif kind == "near_equal":
        a[i] = near(a[j], rng.choice(["1e-9", "-1e-9", "3.7e-11", "1e-6"]))
    elif kind == "near_isotropic":
        a[i] = near(a[j], rng.choice(["1e-9", "-2e-8"]))
        a[k] = near(a[j], rng.choice(["1e-7", "-3e-9"]))
    elif kind == "rod":
        a[i] = decimal(log_uniform(-6.2, -5.5))
        a[k] = near(a[j], rng.choice(["1e-3", "-1e-6"]))
    elif kind == "scale":
        e = rng.choice([-6, 6])
        r = [decimal(float(x) * 10.0**e) for x in r]
    elif kind == "all":
        a[i] = near(a[j], rng.choice(["1e-9", "-1e-9"]))
        r[i] = decimal(log_uniform(-12, -8))
        e = rng.choice([-6, 6])
        r = [decimal(float(x) * 10.0**e) for x in r]
    elif kind == "plane":
        r[i] = "0"
    elif kind == "axis":
        r[i] = r[j] = "0"
    elif kind == "symmetric":
        a[i] = a[j]
    elif kind == "symmetric_plane":
        a[i] = a[j]
        r[rng.choice([i, j])] = "0"
    elif kind == "symmetric_axis":
        a[i] = a[j]
        r[j] = r[k] = "0"
    elif kind == "equatorial":
        a[i] = a[j]
        r[k] = "0"
    elif kind == "lagrange":
        a[i] = a[j]
        r[i] = r[j] = "0"
    elif kind == "isotropic":
        a = [a[0]] * 3
    elif kind == "euler":
        r = ["0"] * 3
        if rng.random() < 0.5:
            a[i] = a[j]
    elif kind == "plane_near_equal":
        r[i] = "0"
        a[i] = near(a[j], rng.choice(["1e-9", "-1e-9"]))
    elif kind == "near_lagrange":
        a[i] = near(a[j], rng.choice(["1e-4", "-1e-2", "1e-7"]))
        r[i] = decimal(float(r[i]) * log_uniform(-5, -1))
        r[j] = decimal(float(r[j]) * log_uniform(-5, -1))
    return a, r


def special_l(body):
    """l^2 at every cusp and pitchfork."""
    found = [body.generic(mu)[0] for mu in body.cusp_roots()]
    if body.r2 == 0:
        return found
    for a in body.passive:
        p_hat, r_hat = body.hats(a)
        s = arb(p_hat).sqrt()
        found.append(s * (a - r_hat / s**2) ** 2)
        s = body.pair_cusp(a)
        if s is not None:
            found.append(body.pair(a, s)[0])
    return found


def record(kind, a, r, l):
    for dps in (90, 200, 400):
        ctx.dps = dps
        try:
            body = Body(a, r)
            found = body.critical(l)
            points = []
            for c in found:
                omega = arb(rational(l)) / c["j"]
                points.append(dict(
                    h=digits(c["h"], 30), omega=digits(omega, 20), gamma=[digits(g, 20) for g in c["gamma"]],
                    index=c["index"], multiplicity=c["multiplicity"],
                ))
            distances = [float((arb(rational(l)) ** 2 / l2).sqrt() - 1) for l2 in special_l(body)]
            close = [d for d in distances if abs(d) < 9]
            nearest = min(close, key=abs) if close else None
            print(json.dumps(dict(kind=kind, A=a, r=r, l=l, cusp_distance=nearest, critical=points)))
            return True
        except (AssertionError, ArithmeticError) as error:
            last = error
    print("left out:", kind, a, r, l, repr(last), file=sys.stderr)
    return False


def main():
    kinds = ["tiny_r", "tiny_r_two", "near_equal", "near_isotropic", "rod", "scale", "all", "plane", "axis", "symmetric",
             "symmetric_plane", "symmetric_axis", "equatorial", "lagrange", "isotropic", "euler", "plane_near_equal",
             "near_lagrange", "generic"]
    for kind in kinds:
        for n in range(8):
            a, r = body_of(kind)
            size = (max(map(lambda x: abs(float(x)), r)) or 1.0) ** 0.5 * max(map(float, a)) ** 0.5
            l = [decimal(size * rng.uniform(0.3, 4)), decimal(size * rng.uniform(0.3, 4)), decimal(log_uniform(-6, -3)),
                 decimal(log_uniform(4, 8)), decimal(size * log_uniform(-1, 1)), "1e-6", "1e8", decimal(size * log_uniform(-2, 2))][n]
            record(kind, a, r, l)
    # Delicate: l beside a cusp or pitchfork.
    for kind in ["generic", "plane", "near_lagrange", "near_equal", "tiny_r", "rod", "scale", "all", "symmetric", "axis", "lagrange", "equatorial", "plane_near_equal"]:
        for n in range(13):
            while True:
                a, r = body_of(kind)
                ctx.dps = 90
                try:
                    candidates = special_l(Body(a, r))
                except ArithmeticError:
                    continue
                if candidates:
                    break
            l = rng.choice(candidates).sqrt()
            exponent = [3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 15, 16, 17][n]
            sign = rng.choice([-1, 1])
            l = l * (1 + arb(sign) * rng.choice([1, 2, 5]) / arb(10) ** exponent)
            record(kind + "_beside_cusp", a, r, arb(l.str(50, radius=False)).str(28, radius=False))


main()
