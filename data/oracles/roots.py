"""Cusps and meetings with pole lines of 60 bodies by FLINT's certified root isolation (python-flint).

One JSON object a line: A, r, and `cusps` and `poles`: for each the real roots mu (30 digits, ascending) of odd
multiplicity of the polynomial, those at the moments themselves left out. Units are the body's own.
"""

import json
import random

from flint import ctx, fmpq, fmpq_poly

from exact import Body

ctx.dps = 90


def roots(poly, moments):
    """Real roots of odd multiplicity, without those at the moments, as decimals."""
    found = []
    for factor, multiplicity in poly.numer().factor()[1]:
        if multiplicity % 2 == 0:
            continue
        for root, _ in factor.complex_roots():
            if root.imag.is_zero() and not any((root.real - a).contains(0) for a in moments):
                found.append(root.real)
    return [x.str(30, radius=False) for x in sorted(found, key=lambda x: float(x.mid().str(40, radius=False)))]


def polynomials(body):
    p, q, d = body.p, body.q, body.d
    dp, dq, dd = p.derivative(), q.derivative(), d.derivative()
    cusp = 4 * (dq * d - 2 * q * dd) * p - 3 * (dp * d - 2 * p * dd) * q
    r = fmpq_poly([0])
    for a in body.active:
        rest = fmpq_poly([1])
        for b in body.active:
            if b != a:
                rest *= fmpq_poly([-b, 1])
        r += rest * body.weights[a]
    j = sum((a * w for a, w in body.weights.items()), fmpq(0)) / body.r2
    n = (q / 2 - r * d) * p - q * q / (2 * j)
    return cusp, n * n - p**3 * d**2 * body.r2


def main():
    rng = random.Random(20261121)
    with open("roots.jsonl", "w", encoding="utf-8") as out:
        for k in range(60):
            a = [f"{rng.uniform(0.2, 2):.4f}" for _ in range(3)]
            r = [f"{rng.uniform(-1, 1):.4f}" for _ in range(3)]
            if k % 4 == 1:
                r[rng.randrange(3)] = "0"
            if k % 4 == 2:
                r[rng.randrange(3)] = f"{rng.uniform(1, 9):.3f}e-{rng.randrange(4, 12)}"
            if k % 8 == 3:
                a[1] = a[0]
            body = Body(a, r)
            cusp, pole = polynomials(body)
            line = {"A": a, "r": r, "cusps": roots(cusp, body.active), "poles": roots(pole, body.active)}
            out.write(json.dumps(line) + "\n")


if __name__ == "__main__":
    main()
