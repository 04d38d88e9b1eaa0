"""At most three boundary circles: section 11."""
import math

import mpmath as mp
import sympy as sp
from sympy import Rational as Q

from common import (
    A, A_, BODIES, RANDOM, R_, a1, a2, a3, bisected, check, critical, critical_points, cusp_polynomial, dot, h, means,
    mu, p_, polynomials, q_, r1, r2, r3, s, sums, x, zero,
)


@check("Lemma 11.5")
def _():
    b1, b2, u = sp.symbols("b1 b2 u", positive=True)
    w = -3 * u + 6 * (b1 + b2) * u**2 - 8 * b1 * b2 * u**3
    slope = sp.diff(w, u)
    zero(slope.subs(u, 1 / b1) - (9 - 12 * b2 / b1))
    zero(slope.subs(u, 1 / b2) - (9 - 12 * b1 / b2))
    zero(sp.solve(sp.diff(slope, u), u)[0] - (1 / b1 + 1 / b2) / 4)
    zero(Q(1, 4) * (Q(4, 3) + 1) - Q(7, 12))


@check("Lemma 11.6")
def _():
    b1, b2, f, y = sp.symbols("b1 b2 phi y", positive=True)
    J = b1 * sp.cos(f) ** 2 + b2 * sp.sin(f) ** 2
    w = lambda u: -3 * u + 6 * (b1 + b2) * u**2 - 8 * b1 * b2 * u**3
    polynomial = lambda F: sp.expand(sp.numer(sp.together(sp.expand_trig(F)))).subs(sp.cos(f), sp.sqrt(1 - y**2)).subs(sp.sin(f), y)
    assert sp.expand(polynomial(1 / J + sp.diff(1 / J, f, 2) - w(1 / J))) == 0
    S = sp.symbols("s", positive=True)
    kappa = x * (1 + S**2) / (b2 + b1 * S**2) - h
    F = sp.sqrt(1 + S**2) * kappa
    u = (1 + S**2) / (b2 + b1 * S**2)
    second = sp.diff(F, S, 2) * (1 + S**2) ** Q(3, 2)  # F''/sin³φ
    zero(sp.simplify(second) - (x * w(u) - h))
    assert sp.simplify(sp.diff(F, S).subs(S, 0)) == 0
    # The claim itself on samples: along each arc U − h changes its sign at most twice.
    changes = {0: 0, 2: 0}
    for _ in range(300):
        low, high = sorted(RANDOM.random() for _ in range(2))
        f_r, X = RANDOM.uniform(0, math.pi / 2), RANDOM.expovariate(1)
        moment = lambda f: low * math.cos(f) ** 2 + high * math.sin(f) ** 2
        side = RANDOM.choice((1, -1))
        grid = [f_r + (math.pi - 2 * f_r) * k / 800 for k in range(801)]
        values = [X / moment(f) - math.cos(f - side * f_r) for f in grid]
        top = X / moment(f_r) - 1
        if min(values) >= top:
            continue
        level = RANDOM.uniform(min(values), top)
        changes[sum((a > level) != (b > level) for a, b in zip(values, values[1:]))] += 1
    assert changes[2] > 50


@check("Proposition 11.8")
def _():
    g, r, J = critical(p_, q_)
    # On the critical set of f: h + ℓ = sJ/2.
    ell = dot(g, r)
    H = s * J / 2 - ell
    grad = J * r + 2 * (H + ell) * A * g
    tangential = grad - dot(grad, g) * g
    for i in range(3):
        zero(tangential[i])
    P, _, R = (F.subs(dict(zip(R_, r)), simultaneous=True) for F in sums())
    zero(2 * H * s - (mu * P - 3 * R))
    D, p, _, RD = polynomials(A_, R_)
    f = sp.Poly(sp.expand((mu * p - 3 * RD * D) ** 2 - 4 * h**2 * p * D**2), mu)  # times D⁴
    norm = r1**2 + r2**2 + r3**2
    assert f.degree() == 10
    zero(f.LC() - 4 * norm * (norm - h**2))
    zero(f.as_expr().subs(mu, a1) - a1**2 * r1**4 * ((a1 - a2) * (a1 - a3)) ** 4)


@check("Theorem 11.10")
def _():
    table = [
        ((Q(1), Q(27, 25), Q(103, 50)), (Q(1, 5000), Q(101, 1000), Q(1)), Q(641, 400), Q(179927, 10**5), "1.7991920", "1.7993485", 2),
        ((Q(1), Q(21, 20), Q(101, 50)), (Q(1, 10000), Q(133, 2000), Q(1)), Q(15953, 10**4), Q(179335, 10**5), "1.7933377", "1.7933640", 1),
    ]
    for a, r, X, level, below, above, poles in table:
        assert a[0] + a[1] > a[2]
        points = sorted(critical_points(a, r, X), key=lambda c: -c.h)
        H = mp.mpf(level.p) / level.q
        high = [c for c in points if c.h > H]
        assert len(high) == 4 and all(c.index == 2 for c in high)
        assert mp.nstr(points[4].h, 8, strip_zeros=False) == below and mp.nstr(high[3].h, 8, strip_zeros=False) == above
        norm = sum(c**2 for c in r)
        j = sum(b * c**2 for b, c in zip(a, r)) / norm
        at = [mp.mpf((X / j).p) / (X / j).q - sign * mp.sqrt(mp.mpf(norm.p) / norm.q) for sign in (1, -1)]
        assert at[0] < H and (at[1] < H) == (poles == 2)


@check("Proposition 11.11")
def _():
    J, T, V = means()
    P, _, _ = sums()
    w = [c**2 / (mu - b) ** 2 / P for b, c in zip(A_, R_)]
    moment = lambda power: sum(v * (4 * b - 3 * J) / (mu - b) ** power for b, v in zip(A_, w))
    # The identities at random rational points: together they are too large to expand.
    for _ in range(3):
        at = {y: Q(RANDOM.randint(1, 10**6), RANDOM.randint(1, 10**6)) for y in (*A_, *R_, mu)}
        there = lambda y: y.subs(at)
        F = sp.diff(P, mu)
        assert there(F + 2 * P * T) == 0
        assert there(moment(1) - J * T - 4 * V) == 0
        slope = sp.diff(moment(1), mu)
        assert there(slope) == there(2 * T * moment(1) - 3 * moment(2) + 6 * V * T)
    # Left of the zero of T x' has exactly one, whatever it has beyond.
    beyond = set()
    for a, r in [*BODIES, ([Q(1), Q(100006, 10**5), Q(199966, 10**5)], [Q(1, 10**8), Q(83, 10**8), Q(1)])]:
        low, middle, _ = sorted(a)
        D, p, _, _ = polynomials(a, r)
        _, turn = sp.Poly(sp.expand(sp.diff(p, mu) * D - 2 * p * sp.diff(D, mu)), mu).clear_denoms(convert=True)
        [((left, right), _)] = turn.intervals(inf=low, sup=middle)
        left, right = bisected(turn, Q(left), Q(right)) if left != right else (left, right)
        cusps = cusp_polynomial(a, r)
        assert cusps.count_roots(low, left) == 1 and cusps.count_roots(left, right) == 0
        beyond.add(cusps.count_roots(right, middle))
    assert beyond == {0, 2}, beyond
