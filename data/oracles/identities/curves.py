"""Curves and their cusps: section 4."""
import sympy as sp
from sympy import Matrix, Rational as Q

from common import (
    A, A_, BODIES, Point, R_, a1, a2, a3, check, critical, critical_points,
    cusp_polynomial, data, dot, means, mu, over_passive, p_,
    polynomials, q_, r1, r2, s, sums, vector, x, zero,
)


@check("Proposition 4.1")
def _():
    g, r, J = critical(p_, q_)
    c = vector("c")
    e = g.cross(c)
    X = s * J**2 / 2
    # |γ + te|² = 1 + t²|e|²: the second derivative at t = 0 of x N/⟨γ+te, A(γ+te)⟩ − ⟨γ+te, r⟩/√N, N = 1 + t²|e|².
    n, b1, b2 = dot(e, e), dot(g, A * e), dot(e, A * e)
    second = X * (2 * n / J - 2 * b2 / J**2 + 8 * b1**2 / J**3) + dot(g, r) * n
    zero(second - s * (mu * n - b2 + 4 / J * b1**2))


@check("Proposition 4.2")
def _():
    w1, w2, w3 = w = sp.symbols("w1:4", positive=True)
    g = Matrix([sp.sqrt(c) for c in w])
    on_sphere = {w3: 1 - w1 - w2}
    J = dot(g, A * g)
    tau = [mu - a for a in A_]
    N = sp.diag(*tau) + 4 / J * A * g * (A * g).T
    determinant = dot(g, N.adjugate() * g)
    T = sum(c / d for c, d in zip(w, tau))
    V = sum(w[i] * w[j] * (A_[i] - A_[j]) ** 2 / tau[i] / tau[j] for i in range(3) for j in range(i))
    variance = sum(w[i] * w[j] * (A_[i] - A_[j]) ** 2 for i in range(3) for j in range(i))
    product = tau[0] * tau[1] * tau[2]
    zero((determinant - product * (T + 4 * V / J)).subs(on_sphere))
    trace = N.trace() - dot(g, N * g)
    zero((trace - sum((1 - c) * d for c, d in zip(w, tau)) - 4 / J * variance).subs(on_sphere))
    # Over a passive a3: R̂/s² = a3 − J and (2/J) dx/ds = a3 + 3R̂/s².
    over = w3 * (a3 - a1) * (a3 - a2) * (a3 + 3 * (a3 - J)) / J
    zero((determinant.subs(mu, a3) - over).subs(on_sphere))


@check("Proposition 4.3")
def _():
    # Both terms of 3.9 are ≥ 0; the point beyond all moments has the least energy.
    for a, r in BODIES:
        for X in (Q(1, 10), Q(3), Q(40)):
            points = critical_points(a, r, X)
            assert min(points, key=lambda c: c.h).mu > max(a)


@check("Lemma 4.5")
def _():
    P, q, _ = sums()
    J, T, V = means()
    C = P**2 * (T * J + 4 * V)
    zero(C + (4 * sp.diff(q, mu) * P - 3 * sp.diff(P, mu) * q) / 2)
    tau = [mu - a for a in A_]
    fractions = sum(a * r**4 / d**5 for a, r, d in zip(A_, R_, tau))
    for i in range(3):
        for j in range(i):
            top = A_[i] * tau[i] + A_[j] * tau[j] + 4 * (A_[i] - A_[j]) ** 2
            fractions += R_[i] ** 2 * R_[j] ** 2 * top / (tau[i] * tau[j]) ** 3
    zero(C - fractions)
    for n in (1, 2, 3):
        _, p, q, _ = polynomials(A_[:n], R_[:n])
        cusps = cusp_polynomial(A_[:n], R_[:n])
        norm, moment = sum(r**2 for r in R_[:n]), sum(a * r**2 for a, r in zip(A_[:n], R_[:n]))
        assert cusps.degree() == 5 * (n - 1)
        zero(cusps.LC() - norm * moment)  # |r|⁴ J_r
    # A passive moment in D adds its fifth power.
    with_passive = cusp_polynomial(A_, (r1, r2, sp.S(0)))
    zero(with_passive.as_expr() - cusp_polynomial(A_[:2], R_[:2]).as_expr() * (mu - a3) ** 5)


@check("Proposition 4.6")
def _():
    for a, r in BODIES:
        cusps = cusp_polynomial(a, r)
        low, middle, high = sorted(a)
        count = [cusps.count_roots(None, low), cusps.count_roots(low, middle), cusps.count_roots(middle, high),
                 cusps.count_roots(high, None)]
        assert sp.gcd(cusps, cusps.diff()).degree() == 0
        assert count[0] % 2 == 0 and count[1] % 2 == 1 and count[2] % 2 == 1 and count[3] == 0, count
    # The body with four boundary circles of 11.10.
    cusps = cusp_polynomial(*BODIES[3])
    assert [cusps.count_roots(*ends) for ends in ((None, 1), (1, Q(27, 25)), (Q(27, 25), Q(103, 50)))] == [4, 1, 1]


@check("Proposition 4.7")
def _():
    R, _, J, X, _ = over_passive()
    zero(sp.diff(X, s) * 2 * s**2 / J - (a3 * s**2 + 3 * R))
    # A double passive moment: Lagrange's top (1, 1, 3/2) on its axis, index 2 left and 0 right of μ = 1.
    for m, index in ((Q(9, 10), 2), (Q(11, 10), 0)):
        assert Point([Q(1), Q(1), Q(3, 2)], [Q(0), Q(0), Q(1)], m).index == index


@check("Proposition 4.8")
def _():
    for n in (1, 2, 3):
        for a, r in data(n):
            D, p, q, _ = polynomials(a, r)
            f = sp.Poly(sp.expand(q**4) - 4 * x**2 * sp.expand(p**3 * D**2), mu)
            assert f.degree() == 8 * n - 6
            zero(f.LC() + 4 * x**2 * sum(c**2 for c in r) ** 3)
            assert all(f.eval(b) == sp.expand(b**4 * p.subs(mu, b) ** 4) != 0 for b in a)
    D, p, q, _ = polynomials(A_, (r1, r2, 0))
    E, v, w, _ = polynomials(A_[:2], R_[:2])
    tau = mu - a3
    zero(D - E * tau)
    zero(p - v * tau**2)
    zero(q - w * tau**2)
    R, _, _, X, _ = over_passive()
    zero(2 * X * s**3 - (a3 * s**2 - R) ** 2)


@check("Theorem 4.9")
def _():
    assert [(n + 1) + 5 * (n - 1) + 4 * (3 - n) for n in (3, 2, 1)] == [14, 12, 10]
    a, r = BODIES[2]
    assert len(critical_points(a, r, Q(145, 100) ** 2 / 2)) == 10


@check("Theorem 4.12")
def _():
    # V = (μ − J) T − 1 by a_k = μ − τ_k.
    w1, w2, w3 = w = sp.symbols("w1:4", positive=True)
    tau = [mu - b for b in A_]
    j, t = sum(a * b for a, b in zip(A_, w)), sum(c / d for c, d in zip(w, tau))
    v = sum(w[i] * w[k] * (A_[i] - A_[k]) ** 2 / tau[i] / tau[k] for i in range(3) for k in range(i))
    zero((v - (mu - j) * t + 1).subs(w3, 1 - w1 - w2))
    # The curvatures of 7.3 at a pitchfork: μ − J = a_i − J = m = R̂/s², x = sJ²/2.
    J, T, m, S = sp.symbols("J T m S")
    V = m * T - 1
    generic, pair = -2 * V / (J * S * J**2 / 2 * (T * J + 4 * V)), -4 * m * S**2 / (S**3 * J**3 * (J + 4 * m))
    zero(generic - pair - 4 / (S * J**2 * (T * J + 4 * V) * (J + 4 * m)))
    zero(T * J + 4 * V - (T * (J + 4 * m) - 4))
    # a_i + 3R̂/s² of 3.7 is J + 4m.
    R, _, moment, _, _ = over_passive()
    zero(a3 + 3 * R / s**2 - moment - 4 * R / s**2)


@check("Proposition 4.10")
def _():
    for a, r in BODIES:
        for X in (Q(1, 10), Q(1), Q(8), Q(100)):
            assert sum((-1) ** c.index for c in critical_points(a, r, X)) == 2


@check("Lemma 4.11")
def _():
    P, q, R = sums()
    # With s for the root of P: the difference vanishes where s² = P.
    X = s * (q / P) ** 2 / 2
    H = (q / 2 - R) / s
    zero(H * q**2 - X * P * (q - 2 * R) - (q - 2 * R) * q**2 / 2 * (1 / s - s / P))
    hat = sp.symbols("hatR")
    X, H = (a3 * s**2 - hat) ** 2 / (2 * s**3), (a3 * s**2 - 3 * hat) / (2 * s)
    zero(H * (a3 * s**2 - hat) ** 2 - X * s**2 * (a3 * s**2 - 3 * hat))
