"""Pole lines, asymptotes and events: sections 5 and 6."""
import mpmath as mp
import sympy as sp
from sympy import Rational as Q

from common import (
    A_, BODIES, EPS, Point, R_, a1, a2, a3, check, critical, data, dot, mu, over_passive, p_, polynomials,
    q_, r1, r2, r3, s, sums, zero,
)


@check("Proposition 5.2")
def _():
    for a, r in BODIES:
        norm = sum(c**2 for c in r)
        j_r = sum(b * c**2 for b, c in zip(a, r)) / norm
        for k in range(-6, 7):
            for root in (max(a) + Q(10) ** k, min(a) - Q(10) ** k):
                c = Point(a, r, root)
                assert (c.J > mp.mpf(j_r.p) / j_r.q) == (root > max(a))


@check("Proposition 5.3")
def _():
    g, r, J = critical(p_, q_)
    P, q, R = (F.subs(dict(zip(R_, r)), simultaneous=True) for F in sums())
    j = sp.symbols("j")
    X = s * J**2 / 2
    zero((X / J - dot(g, r) - X / j) * s**3 - ((q / 2 - R) * P - q**2 / (2 * j)))
    for n in (1, 2, 3):
        for a, r in data(n):
            norm, moment = sum(c**2 for c in r), sum(b * c**2 for b, c in zip(a, r))
            square = sum(b**2 * c**2 for b, c in zip(a, r))
            # Times 2⟨r, Ar⟩, so that the coefficients are polynomials.
            F = sp.Poly(pole_polynomial(a, r), mu)
            if n == 1:
                assert F.is_zero
            else:
                assert F.degree() == 8 * (n - 1)
                zero(F.LC() / (4 * moment**2) - norm**4 * (square / norm - moment**2 / norm**2))
    for a, r in data(2):
        passive = pole_polynomial([*a, Q(7, 3)], [*r, sp.S(0)])
        zero(passive - pole_polynomial(a, r) * (mu - Q(7, 3)) ** 8)
    # J_r = a₂: the polynomial is 0 there, which is no meeting; at other active moments it is not.
    for a, r, on_wall in (([Q(1), Q(2), Q(3)], [Q(1), Q(1), Q(1)], True), (*BODIES[0], False)):
        assert (pole_polynomial(a, r).subs(mu, a[1]) == 0) == on_wall
    a, r = BODIES[0]
    F = sp.Poly(pole_polynomial(a, r), mu)
    norm = sum(c**2 for c in r)
    j_r = sum(b * c**2 for b, c in zip(a, r)) / norm
    signs = set()
    for root in F.real_roots():
        c = Point(a, r, Q(int(sp.floor(root.evalf(60) * 10**45)), 10**45))
        offset = c.h - c.x * j_r.q / j_r.p
        radius = mp.sqrt(mp.mpf(norm.p) / norm.q)
        assert min(abs(offset - radius), abs(offset + radius)) < EPS
        N = offset * c.s**3
        assert (N < 0) == (abs(offset + radius) < EPS)  # P+ is h = x/J_r − r
        signs.add(N < 0)
    assert signs == {True, False}


def pole_polynomial(a, r):
    """(2⟨r,Ar⟩)² (𝒩² − |r|² p³ D²)."""
    D, p, q, RD = polynomials(a, r)
    norm, moment = sum(c**2 for c in r), sum(b * c**2 for b, c in zip(a, r))
    N = 2 * moment * (q / 2 - RD * D) * p - q**2 * norm
    return sp.expand(N**2 - 4 * moment**2 * norm * p**3 * D**2)


@check("Proposition 5.4")
def _():
    R, _, _, X, H = over_passive()
    j, rr = sp.symbols("j rr")
    E = (a3 * s**2 - R) ** 2 / j - a3 * s**4 + 3 * R * s**2
    zero((H - X / j + rr) * 2 * s**3 - (2 * rr * s**3 - E))  # 0 on P+ where E = 2 r s³
    zero((H - X / j - rr) * 2 * s**3 - (-2 * rr * s**3 - E))
    # A meeting of each sign, found from the heights alone.
    a, r = [mp.mpf(2), mp.mpf("1.1"), mp.mpf(1)], [mp.mpf("0.94868"), 0, mp.mpf("0.61623")]
    hat = r[0] ** 2 / (a[1] - a[0]) + r[2] ** 2 / (a[1] - a[2])
    norm = mp.sqrt(r[0] ** 2 + r[2] ** 2)
    j_r = (a[0] * r[0] ** 2 + a[2] * r[2] ** 2) / norm**2
    height = lambda y: y * a[1] / 2 - 3 * hat / (2 * y)
    X = lambda y: y * (a[1] - hat / y**2) ** 2 / 2
    found = mp.findroot(lambda y: height(y) - X(y) / j_r - norm, 6.7)
    E = (a[1] * found**2 - hat) ** 2 / j_r - a[1] * found**4 + 3 * hat * found**2
    assert abs(E + 2 * norm * found**3) < EPS * found**4  # P−, E < 0


@check("Proposition 5.5")
def _():
    a, d, g, r, sign = sp.symbols("a d g r sigma")
    S = sign * r / (g * d)
    J = a + d - r**2 / d / S**2
    X = S * J**2 / 2
    gap = X / J - sign * r * g - (X / a - sign * r)
    expected = -sign * r * (1 - g) ** 2 * (a + d * (1 + g) ** 2) / (2 * a * g)
    for value in (1, -1):
        zero((gap - expected).subs(sign, value))


@check("Proposition 6.1")
def _():
    e = sp.symbols("e", positive=True)  # 1/μ; both ends at once by the sign
    norm = sp.sqrt(r1**2 + r2**2 + r3**2)
    values = {a1: 1, a2: Q(13, 10), a3: Q(19, 10), r1: Q(2, 7), r2: Q(3, 7), r3: Q(6, 7)}  # |r| = 1
    P, q, R = (F.subs(mu, 1 / e).subs(values) for F in sums())
    P, q, R = (sp.series(sp.cancel(F), e, 0, 7).removeO() for F in (P, q, R))
    for sign in (1, -1):
        root = sp.series(sp.sqrt(sp.expand(P.subs(e, sign * e) / e**2)), e, 0, 4).removeO() * e
        X = sp.series((q.subs(e, sign * e) ** 2 / (2 * root**3)), e, 0, 4).removeO()
        H = sp.series(((q / 2 - R).subs(e, sign * e) / root), e, 0, 3).removeO()
        j = sum(values[a] * values[r] ** 2 for a, r in zip(A_, R_))
        c = sum(values[a] ** 2 * values[r] ** 2 for a, r in zip(A_, R_)) - j**2
        rest = sp.series(H - X / j + sign + sign * 2 * c * X**2 / j**4, e, 0, 3).removeO()
        assert sp.expand(rest) == 0
        assert sp.limit(X / e, e, 0) == j**2 / 2
    assert norm.subs(values) == 1


@check("Proposition 6.2", "Corollary 6.3")
def _():
    e = sp.symbols("e", positive=True)  # |μ − a2|
    values = {a1: 1, a2: Q(13, 10), a3: Q(19, 10), r1: Q(2, 7), r2: Q(3, 7), r3: Q(6, 7)}
    hat = (r1**2 / (a2 - a1) + r3**2 / (a2 - a3)).subs(values)
    for sign in (1, -1):
        P, q, R = (sp.expand(sp.series(sp.cancel((F.subs(mu, a2 + sign * e) * e**2).subs(values)), e, 0, 6).removeO())
                   for F in sums())
        root = sp.series(sp.sqrt(P), e, 0, 5).removeO()  # s e
        X = sp.series(q**2 / (2 * root**3), e, 0, 4).removeO() / e
        H = sp.series((q / 2 - R) / root, e, 0, 4).removeO() / e
        rest = H - X / values[a2] + sign * values[r2] + values[a2] ** 2 * hat / (4 * X)
        assert sp.limit(rest / e, e, 0) == 0
    # The index beside a double active moment: one more on the left.
    for sign, index in ((-1, 2), (1, 1)):
        assert Point([Q(1), Q(1), Q(2)], [Q(1), Q(0), Q(1, 2)], 1 + sign * Q(1, 10**6)).index == index
    R, _, _, X, H = over_passive()
    rest = (H - X / a3 + a3**2 * R / (4 * X)) * s**2
    assert sp.limit(rest.subs(values), s, sp.oo) == 0
