"""Gluing, the merge tree and the latitude sweep: sections 7, 9 and 10."""
import mpmath as mp
import sympy as sp
from sympy import Matrix, Rational as Q

from common import (
    A, A_, BODIES, EPS, Point, R_, a1, a3, check, cusp_polynomial, dot, mu, over_passive, p_, polynomials, q_, r1, s, sphere,
    sums, t, vector, x, zero,
)


@check("Lemma 7.2")
def _():
    p, q, low, high, L = sp.symbols("p q lambda Lambda L")
    T = (q - p - high * L) / (low - high)
    zero(p + low * T - (q - high * (L - T)))


@check("Lemma 7.3")
def _():
    # With J' = −2V and x' = −x(T + 4V/J) of 3.5.
    J, T, V = sp.symbols("J T V")
    zero(2 * V / J**2 / (-x * (T + 4 * V / J)) + 2 * V / (J * x * (T * J + 4 * V)))
    R, _, J, X, _ = over_passive()
    zero(sp.diff(1 / J, s) / sp.diff(X, s) + 4 * R / (s**3 * J**3 * (a3 + 3 * R / s**2)))


@check("Lemma 7.4")
def _():
    # At equal x the arm with the smaller J is above right of a cusp and below left of it; one body has cusps of both kinds.
    a, r = BODIES[3]
    sides = []
    for root in cusp_polynomial(a, r).nroots(n=40, maxsteps=200):
        if abs(sp.im(root)) > Q(1, 10**30):
            continue
        cusp, step = Q(sp.re(root)), min(abs(sp.re(root) - b) for b in a) / 10**4
        over = lambda y: Point(a, r, y).x
        first = Point(a, r, cusp - Q(step))
        low, high = cusp, cusp + 3 * Q(step)
        assert (over(low) - first.x) * (over(high) - first.x) < 0
        while high - low > step / 2**120:
            middle = (low + high) / 2
            low, high = (middle, high) if (over(middle) - first.x) * (over(high) - first.x) < 0 else (low, middle)
        second = Point(a, r, low)
        side = 1 if first.x > over(cusp) else -1
        assert ((first.h > second.h) == (first.J < second.J)) == (side == 1)
        sides.append(side)
    assert sorted(sides) == [-1, -1, 1, 1, 1, 1]


@check("Lemma 7.5")
def _():
    v, eps = sp.symbols("v epsilon")
    P, q, _ = (F.subs(r1, eps).subs(mu, a1 + eps * v) for F in sums())
    hat_p, hat_q, _ = (F.subs(mu, a1 + eps * v) for F in sums(A_[1:], R_[1:]))
    zero(P - (1 + v**2 * hat_p) / v**2)
    zero(q - (a1 + v**2 * hat_q) / v**2)
    # The integral, on a body with a small r_i: both branches over one x, by their own formulas.
    a, r = [mp.mpf(c) for c in ("1", "1.5", "1.9")], [mp.mpf(c) for c in ("0.01", "0.6", "0.8")]
    def state(v, e):
        m = a[0] + e * v
        P = v**-2 + sum((c / (m - b)) ** 2 for b, c in zip(a[1:], r[1:]))
        q = a[0] * v**-2 + sum(b * (c / (m - b)) ** 2 for b, c in zip(a[1:], r[1:]))
        R = e / v + sum(c**2 / (m - b) for b, c in zip(a[1:], r[1:]))
        return q**2 / (2 * P**1.5), (q / 2 - R) / mp.sqrt(P), 1 / v / mp.sqrt(P)
    with mp.workdps(80):
        X = mp.mpf(20)
        solve = lambda e: mp.findroot(lambda v: state(v, e)[0] - X, mp.mpf("0.025"))
        gap = state(solve(-r[0]), -r[0])[1] - state(solve(r[0]), r[0])[1]
        assert gap > 0 and abs(gap - mp.quad(lambda e: state(solve(e), e)[2], [-r[0], r[0]])) < EPS


@check("Lemma 7.6")
def _():
    T, eps = sp.symbols("T epsilon")
    hat_p, hat_q = sums(A_[1:], R_[1:])[:2]
    at = lambda F: F.subs(mu, a1 + eps / T)
    P, q = T**2 + at(hat_p), a1 * T**2 + at(hat_q)
    m = 2 * at(sp.diff(hat_q, mu)) * P - Q(3, 2) * at(sp.diff(hat_p, mu)) * q
    g = T**3 * (4 * a1 * P - 3 * q) - eps * m
    log_slope = lambda y: 2 * sp.diff(q, y) / q - Q(3, 2) * sp.diff(P, y) / P
    zero(log_slope(T) * P * q * T**2 - g)
    zero(log_slope(eps) * P * q * T - m)


@check("Lemma 9.3")
def _():
    S, d, z = sp.symbols("S Delta z")
    rise = 4 * S * z * (1 - z) - d * z
    top = sp.solve(sp.diff(rise, z), z)[0]
    zero(rise.subs(z, top) - (4 * S - d) ** 2 / (16 * S))
    J, g = sp.Function("J")(t), sp.Function("g")(t)
    U = x / J - g
    second = sp.diff(U, t, 2).subs(sp.diff(g, t, 2), -g)
    zero(second + x * J.diff(t, 2) / J**2 - 2 * x * J.diff(t) ** 2 / J**3 - g)


@check("Proposition 10.2", "Proposition 10.3")
def _():
    g, r, T, L = vector("g"), vector("r"), sp.symbols("T"), sp.symbols("L")
    u = A.inv() * r.cross(g)
    v = u.cross(g)
    J = dot(g, A * g)
    l = L * A * g / J + T * v
    om = A.inv() * l
    zero(dot(g, l) - L)
    zero(dot(om, r.cross(g)))
    zero(dot(l, om) / 2 - L**2 / (2 * J) - T**2 * dot(v, A.inv() * v) / 2)
    delta = dot(om.cross(g), A.inv() * g.cross(r))
    zero(delta - T * dot(v, A.inv() * v))
    zero(Matrix([om.T, g.T, (A.inv() * r.cross(g)).T]).det() + delta)


@check("Proposition 10.5")
def _():
    # The part of ±v at the pole is odd in e and vanishes for no e.
    n, e = sphere(p_, q_), vector("e")
    v0 = (A.inv() * n.cross(e)).cross(n)
    for i in range(3):
        zero(v0[i] + ((A.inv() * n.cross(-e)).cross(n))[i])
    # |v0|² ≥ ⟨…⟩²: v0 = 0 would need n×e ∥ An, but ⟨n×e, n⟩ = 0 ≠ ⟨An, n⟩.
    zero(dot(n.cross(e), n))


@check("Theorem 10.6")
def _():
    # The double of a sphere without k + n discs, and the paper's Table 1.
    k, n, g = sp.symbols("k n g")
    genus = sp.solve(2 - 2 * g - 2 * (2 - k - n), g)[0]
    table = {0: [None, None, 1], 1: [0, 1, 2], 2: [1, 2, 3], 3: [2, 3, 4]}
    for circles, row in table.items():
        for poles, told in enumerate(row):
            assert told is None or genus.subs({k: circles, n: poles}) == told


@check("Proposition 10.8")
def _():
    g, l, r = vector("g"), vector("l"), vector("r")
    om = A.inv() * l
    dg, dl = g.cross(om), l.cross(om) - g.cross(r)
    rate = lambda F: sum(sp.diff(F, a) * b for a, b in zip(list(g) + list(l), list(dg) + list(dl)))
    zero(rate(dot(g, r)) - dot(om, r.cross(g)))
    zero(rate(dot(om, r.cross(g))) - dot(A.inv() * dl, r.cross(g)) - dot(om, r.cross(g.cross(om))))
    zero(rate(-dot(l, l) / 2) - dot(l, g.cross(r)))


@check("Theorem 9.7")
def _():
    # Two active moments: ω' of one sign, ω(a₃) as the moment across r, and J on the great circle through γ(a₃) and e₃.
    D, p, _, rho = polynomials(A_[:2], R_[:2])
    r2_ = R_[0] ** 2 + R_[1] ** 2
    zero(sp.diff(rho, mu) * p - rho * sp.diff(p, mu) / 2 - (R_[0] * R_[1] * (A_[0] - A_[1])) ** 2)
    across = (A_[0] * R_[1] ** 2 + A_[1] * R_[0] ** 2) / r2_
    zero(rho.subs(mu, a3) - r2_ * (a3 - across))
    # On the circle γ = (w/r²) r + c t̂ + z e₃ with z² = 1 − w²/r² − c²: J is quadratic in c with the coefficient J_t − a₃.
    w, c = sp.symbols("w c")
    norm = sp.sqrt(r2_)
    flat = [w / r2_ * R_[0] - c * R_[1] / norm, w / r2_ * R_[1] + c * R_[0] / norm]
    J = A_[0] * flat[0] ** 2 + A_[1] * flat[1] ** 2 + a3 * (1 - w**2 / r2_ - c**2)
    assert sp.simplify(sp.diff(J, c, 2) / 2 - (across - a3)) == 0
    # Its zero of dJ/dc lies on the ray of γ(a₃) = adj(a₃ − A) r.
    ray = [R_[0] * (a3 - A_[1]), R_[1] * (a3 - A_[0])]
    at = sp.solve(sp.diff(J, c), c)[0]
    assert sp.simplify((flat[0] * ray[1] - flat[1] * ray[0]).subs(c, at)) == 0


@check("Lemma 9.6")
def _():
    D, p, _, rho = polynomials(A_, R_)
    tau = [mu - a for a in A_]
    weights = [(R_[i - 2] * R_[i - 1] * (A_[i - 2] - A_[i - 1])) ** 2 for i in range(3)]
    cubic = sum(c * t_**3 for c, t_ in zip(weights, tau))
    gamma = Matrix([R_[i] * tau[i - 2] * tau[i - 1] for i in range(3)])
    tangent = gamma.cross(Matrix(R_))
    zero(sum(tau[i] * tangent[i] ** 2 for i in range(3)) - cubic)
    zero(sp.diff(rho, mu) * p - rho * sp.diff(p, mu) / 2 - cubic)
