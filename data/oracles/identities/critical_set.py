"""The closed form, the Morse index and the sphere: sections 1 to 3."""
import sympy as sp
from sympy import Rational as Q

from common import (
    A, A_, EPS, R_, a1, a2, a3, check, critical, critical_points, dot, h, means, mu, over_passive, p_, q_,
    r1, r2, r3, s, sphere, sums, u_, v_, vector, x, zero,
)


@check("Definition 1.1")
def _():
    # Second moments of masses at points: ∫ x_k² dm = (A_i + A_j − A_k)/2, and 0 only if all mass, and so r, has x_k = 0.
    y, z, m = vector("y"), vector("z"), sp.symbols("m n", positive=True)
    second = [m[0] * a**2 + m[1] * b**2 for a, b in zip(y, z)]
    moments = [sum(second) - c for c in second]
    for k in range(3):
        zero((sum(moments) - 2 * moments[k]) / 2 - second[k])


@check("Proposition 1.2")
def _():
    g, l, r = vector("g"), vector("l"), vector("r")
    om = A.inv() * l
    dg, dl = g.cross(om), l.cross(om) - g.cross(r)
    zero(dot(g, dg))
    zero(dot(dg, l) + dot(g, dl))
    zero(dot(om, dl) - dot(dg, r))


@check("Proposition 1.3")
def _():
    g, l, r = vector("g"), vector("l"), vector("r")
    field = lambda A, r, g, l: (g.cross(A.inv() * l), l.cross(A.inv() * l) - g.cross(r))
    dg, dl = field(A, r, g, l)
    c, k = sp.symbols("c k", positive=True)  # A → c² A, r → k² r
    eg, el = field(c**2 * A, k**2 * r, g, c * k * l)
    for i in range(3):
        zero(eg[i] - dg[i] * k / c)
        zero(el[i] - dl[i] * c * k * k / c)
    # A reflection and an odd permutation reverse the time, an even permutation does not.
    odd, even = sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, 1]]), sp.Matrix([[0, 1, 0], [0, 0, 1], [1, 0, 0]])
    for M, sign in ((sp.diag(-1, 1, 1), -1), (odd, -1), (even, 1)):
        eg, el = field(M * A * M.T, M * r, M * g, M * l)
        for i in range(3):
            zero(eg[i] - sign * (M * dg)[i])
            zero(el[i] - sign * (M * dl)[i])


@check("Proposition 2.2")
def _():
    g, l, r = vector("g"), vector("l"), vector("r")
    J, L = dot(g, A * g), dot(g, l)
    m = l - L * A * g / J
    zero(dot(l, A.inv() * l) - L**2 / J - dot(m, A.inv() * m))


@check("Lemma 2.3", "Lemma 11.2")
def _():
    m, e, f, z = vector("m"), vector("e"), vector("f"), sp.symbols("z")
    r = vector("r")
    g = m + e * (z + 1 / z) / 2 + f * (z - 1 / z) / (2 * sp.I)
    J = dot(g, A * g)
    degree = lambda F, d: sp.Poly(sp.expand(F * z**d), z).degree() <= 2 * d
    assert degree(J, 2) and degree(J * (h + dot(g, r)) - x, 3)
    zero(x / dot(m, A * m) - dot(m, r) - h + (dot(m, A * m) * (h + dot(m, r)) - x) / dot(m, A * m))


@check("Proposition 3.1")
def _():
    g, r, J = critical(p_, q_)
    W = sp.symbols("W")
    om = W * g
    l = A * om
    rate = (l.cross(om) - g.cross(r)).subs(s, W**2)
    for i in range(3):
        zero(rate[i])
    grad = -(2 * x / J**2 * A * g + r).subs(x, s * J**2 / 2)
    tangential = grad - dot(grad, g) * g
    for i in range(3):
        zero(tangential[i])


@check("Theorem 3.2")
def _():
    g, r, J = critical(p_, q_)
    P, q, R = (F.subs(dict(zip(R_, r)), simultaneous=True) for F in sums())
    zero(P - s**2)
    zero(q / P - J)
    zero(R / s - dot(g, r))
    zero((s * J**2 / 2) / J - dot(g, r) - (q / 2 - R) / s)


@check("Theorem 3.3")
def _():
    R, P, J, X, H = over_passive()
    g1, g2 = r1 / s / (a3 - a1), r2 / s / (a3 - a2)
    w3 = 1 - P / s**2
    zero(a1 * g1**2 + a2 * g2**2 + a3 * w3 - J)
    zero(g1**2 + g2**2 + w3 - 1)
    zero(r1 * g1 + r2 * g2 - R / s)
    zero(X / J - R / s - H)


@check("Lemma 3.5")
def _():
    P, q, _ = sums()
    J, T, V = means()
    zero(sp.diff(J, mu) + 2 * V)
    zero(2 * sp.diff(q, mu) / q - Q(3, 2) * sp.diff(P, mu) / P + T + 4 * V / J)


@check("Proposition 3.6")
def _():
    P, q, R = sums()
    # h' and x'/J, both times √P, with x = q²/(2P^{3/2}).
    slope = sp.diff(q / 2 - R, mu) - (q / 2 - R) * sp.diff(P, mu) / (2 * P)
    zero(slope - (q * sp.diff(q, mu) / P - Q(3, 4) * q**2 * sp.diff(P, mu) / P**2) * P / q)
    _, _, J, X, H = over_passive()
    zero(sp.diff(H, s) - sp.diff(X, s) / J)


@check("Proposition 3.7")
def _():
    R, _, J, X, _ = over_passive()
    zero(sp.diff(J, s) - 2 * R / s**3)
    zero(sp.diff(X, s) - J / 2 * (a3 + 3 * R / s**2))


@check("Proposition 3.8")
def _():
    P, _, _ = sums()
    V = means()[2]
    c = [r2**2 * r3**2 * (a2 - a3) ** 2, r1**2 * r3**2 * (a1 - a3) ** 2, r1**2 * r2**2 * (a1 - a2) ** 2]
    cubic = sum(k * (mu - a) ** 3 for k, a in zip(c, A_))
    zero(P**2 * V - cubic / ((mu - a1) * (mu - a2) * (mu - a3)) ** 3)
    sign = r3**2 * (a2 - a1) - r1**2 * (a3 - a2)
    zero(cubic.subs(mu, a2) - r2**2 * (a3 - a2) ** 2 * (a2 - a1) ** 2 * sign)


def difference(p, q, u, v):
    """U(γ') − U(γ) and what Proposition 3.9 needs."""
    g, r, J = critical(p, q)
    k = sphere(u, v)
    K = dot(k, A * k)
    d = k - g
    return s * J**2 / 2 * (1 / K - 1 / J) - dot(d, r), g, d, J, K


@check("Proposition 3.9")
def _():
    gap, _, d, J, K = difference(p_, q_, u_, v_)
    zero(gap - s / 2 * (dot(d, (mu * sp.eye(3) - A) * d) + (K - J) ** 2 / K))


@check("Corollary 3.10")
def _():
    Ja, Jb, ma, mb, dd, e, H = sp.symbols("Ja Jb ma mb dd e H")
    there = -H - x / Ja**2 * (ma * dd - e + (Ja - Jb) ** 2 / Jb)
    back = H - x / Jb**2 * (mb * dd - e + (Ja - Jb) ** 2 / Ja)
    solution = sp.solve([there, back], [H, e], dict=True)[0][H]
    zero(solution - x * ((mb - ma) * dd - (Ja - Jb) ** 3 / (Ja * Jb)) / (Ja**2 + Jb**2))
    points = critical_points([Q(2), Q(11, 10), Q(1)], [Q(3, 10), Q(1, 2), Q(7, 10)], Q(6))
    assert len(points) >= 4
    for a in points:
        for b in points:
            distance = sum((c - d) ** 2 for c, d in zip(a.gamma, b.gamma))
            gap = 6 * ((b.mu - a.mu) * distance - (a.J - b.J) ** 3 / a.J / b.J) / (a.J**2 + b.J**2)
            assert abs(a.h - b.h - gap) < EPS


@check("Corollary 3.11")
def _():
    gap, g, d, J, K = difference(p_, q_, u_, v_)
    alpha, beta = dot(d, A * g), dot(d, A * d)
    zero(K - J - 2 * alpha - beta)
    form = 4 * alpha**2 + 2 * alpha * beta + J * (mu * dot(d, d) - beta) + mu * dot(d, d) * (2 * alpha + beta)
    zero(gap - s / (2 * K) * form)
