"""The linearised flow: section 13."""
import sympy as sp
from sympy import Matrix

from common import a1, a3, check, dot, rational, sphere, zero


def linearisation(a, g, W, m):
    """b, c of Theorem 13.1 and the 6×6 matrix at γ with multiplier m."""
    B = [W**2 * (m - y) for y in a]
    M = sp.diag(*a)
    r = Matrix([b * y for b, y in zip(B, g)])
    J, det = dot(g, M * g), a[0] * a[1] * a[2]
    v = g.cross(M * g)
    gyro = W * (sum(a) - 2 * dot(M * g, M * g) / J)
    other = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
    hessian = sum(g[i] ** 2 * B[j] * B[k] for i, j, k in other) + 4 * W**2 / J * sum(B[i] * v[i] ** 2 for i in range(3))
    b = gyro**2 * J / det + sum((B[j] * g[k] ** 2 + B[k] * g[j] ** 2) / a[i] for i, j, k in other)
    b += 4 * W**2 / J * sum(v[i] ** 2 / a[i] for i in range(3))
    l, om = W * M * g, W * g
    columns = []
    for which in range(6):
        d = Matrix([1 if which % 3 == i else 0 for i in range(3)])
        dg, dl = (d, sp.zeros(3, 1)) if which < 3 else (sp.zeros(3, 1), d)
        dom = M.inv() * dl
        columns.append(list(dg.cross(om) + g.cross(dom)) + list(dl.cross(om) + l.cross(dom) - dg.cross(r)))
    return b, hessian * J / det, Matrix(columns).T


@check("Theorem 13.1")
def _():
    y = sp.symbols("lambda")
    for _ in range(6):
        a = [rational() for _ in range(3)]
        b, c, matrix = linearisation(a, sphere(rational(), rational()), rational(), rational() - rational())
        assert matrix.charpoly(y).as_expr() == sp.expand(y**2 * (y**4 + b * y**2 + c))


@check("Corollary 13.2")
def _():
    for _ in range(200):
        # Beyond all moments: minima, elliptic.
        a = [rational(1, 1000) for _ in range(3)]
        b, c, _ = linearisation(a, sphere(rational(1, 1000), rational(1, 1000)), rational(1, 1000), max(a) + rational(1, 1000))
        assert c > 0 and b > 0 and b**2 - 4 * c >= 0
    # λ² M + λ Γ + K = 0 at one λ: the polynomial has this λ twice, and −λ.
    y, k, m1, m2, m3 = sp.symbols("lambda k m1 m2 m3")
    M = Matrix([[m1, m3], [m3, m2]])
    zero((y**2 * M - k * M).det() - M.det() * (y**2 - k) ** 2)


@check("Example 13.3")
def _():
    W, r = sp.symbols("W r", positive=True)
    a = [a1, a1, a3]
    # B₃γ₃ = r₃ with γ = −e₃: s(μ − a₃) = −r.
    b, c, _ = linearisation(a, Matrix([0, 0, -1]), W, a3 - r / W**2)
    zero(b**2 - 4 * c - (W * (2 * a1 - a3)) ** 2 / a1**4 * (W**2 * a3**2 - 4 * a1 * r))
    zero(c.subs(r, W**2 * (a3 - a1)))  # l² = A₃²r/(A₃ − A₁), where s (A₃ − A₁) = r
    zero((b**2 - 4 * c).subs(a3, 2 * a1))
    zero(a3**2 - 4 * a1 * (a3 - a1) - (a3 - 2 * a1) ** 2)


@check("Proposition 13.4")
def _():
    # With γ on the sphere rational, r and μ follow; P = s² is then a square, so that everything is rational.
    other = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
    for _ in range(6):
        a = [rational() for _ in range(3)]
        g, W, m = sphere(rational(), rational()), rational(), rational() - rational()
        b, c, _ = linearisation(a, g, W, m)
        s, tau = W**2, [m - y for y in a]
        rho = [(s * t * y) ** 2 for t, y in zip(tau, g)]
        D, det = tau[0] * tau[1] * tau[2], a[0] * a[1] * a[2]
        u = [x * D**2 / t**2 for x, t in zip(rho, tau)]
        p, q, q2 = (sum(x * y**k for x, y in zip(u, a)) for k in range(3))
        C = sum(x * y**2 / t**5 for x, y, t in zip(a, rho, tau))
        C += sum(rho[i] * rho[j] * (a[i] * tau[i] + a[j] * tau[j] + 4 * (a[i] - a[j]) ** 2) / (tau[i] * tau[j]) ** 3 for i, j in ((0, 1), (0, 2), (1, 2)))
        swing = (q * sum(a) - 2 * q2) ** 2
        for i, j, k in other:
            swing += a[j] * a[k] * (q * (tau[j] * u[k] + tau[k] * u[j]) + 4 * u[j] * u[k] * (a[j] - a[k]) ** 2)
        assert c / s**2 == C * D**5 / (p**2 * det) and b / s == swing / (p * q * det)
    # Over a passive moment: μ = a₁, γ₁ ≠ 0.
    for _ in range(6):
        a = [rational() for _ in range(3)]
        g, W = sphere(rational(), rational()), rational()
        b, c, _ = linearisation(a, g, W, a[0])
        z, r = 1 / W**4, [W**2 * (a[0] - y) * x for y, x in zip(a, g)]
        R_hat = sum(r[j] ** 2 / (a[0] - a[j]) for j in (1, 2))
        expected = g[0] ** 2 * (a[0] - a[1]) * (a[0] - a[2]) * (a[0] + 3 * z * R_hat)
        assert c / W**4 * a[0] * a[1] * a[2] == expected


@check("Proposition 13.6")
def _():
    l, l3, r, u, e = sp.symbols("l l3 r u e", positive=True)
    middle = (l - l3 * u) ** 2 / (2 * a1 * (1 - u**2))
    zero(middle - (((l - l3) ** 2 / (1 - u) + (l + l3) ** 2 / (1 + u)) / (4 * a1) - l3**2 / (2 * a1)))
    for sign in (1, -1):
        at = (middle - r * u).subs({l3: sign * l, u: sign * (1 - e)})
        zero(at - (l**2 * e / (2 * a1 * (2 - e)) - sign * r + sign * r * e))
        series = sp.series(sp.simplify(at), e, 0, 3).removeO()
        zero(series - (-sign * r + e * (l**2 / (4 * a1) + sign * r) + e**2 * l**2 / (8 * a1)))


@check("Proposition 13.7")
def _():
    s, rho = sp.symbols("s rho")
    A, B, C = sp.symbols("A B C", positive=True)
    KA, KB = rho + s * (C - A), rho + s * (C - B)
    b, c = s * (A + B - C) ** 2 + A * KA + B * KB, A * B * KA * KB
    quadratic = C**2 * (A + B - C) ** 2 * s**2 - 2 * rho * (A + B - C) * (C * (A + B) - 4 * A * B) * s + rho**2 * (A - B) ** 2
    zero(b**2 - 4 * c - quadratic)
    p, q = 2 * A - C, 2 * B - C
    zero((C * (A + B) - 4 * A * B) ** 2 - C**2 * (A - B) ** 2 - 4 * A * B * p * q)
    for _ in range(50):
        # The roots at random moments with p and q of one sign.
        for sign in (1, -1):
            k, x, y = rational(1, 99), rational(1, 99), rational(1, 99)
            a, d = k * x**2, k * y**2
            cc = 2 * a - sign * d
            bb = (cc + sign * rational(1, 99)) / 2
            if cc <= 0 or bb <= 0:
                continue
            pp, qq = 2 * a - cc, 2 * bb - cc
            product, total = a * abs(qq) * bb * abs(pp), abs(pp) + abs(qq)
            for branch in (1, -1):
                root = -2 * (a * abs(qq) + bb * abs(pp) + branch * 2 * sp.sqrt(product)) / (cc**2 * total)
                value = quadratic.subs({A: a, B: bb, C: cc, rho: 1, s: root})
                assert sp.simplify(value) == 0


def action(j, x):
    return (x[j] ** 2 + x[j + 2] ** 2) / 2


def turned_pairing(f, g, x):
    """f(J∂) g with J(q, p) = (p, −q)."""
    total = sp.Integer(0)
    for powers, coefficient in sp.Poly(f, *x).terms():
        term = g
        # q_j becomes ∂/∂p_j, p_j becomes −∂/∂q_j.
        for place, power in enumerate(powers):
            for _ in range(power):
                term = sp.diff(term, x[(place + 2) % 4]) * (1 if place < 2 else -1)
        total += coefficient * term
    return sp.expand(total)


@check("Theorem 13.10")
def _():
    x = sp.symbols("q1 q2 p1 p2")
    first, second = action(0, x), action(1, x)
    squares = [first**2, first * second, second**2]
    for i, f in enumerate(squares):
        for j, g in enumerate(squares):
            assert turned_pairing(f, g, x) == ((4, 1, 4)[i] if i == j else 0)
    u, v, i1, i2 = sp.symbols("u v i1 i2")
    h, f, b, c = u * i1 - v * i2, u**3 * i1 - v**3 * i2, u**2 + v**2, u**2 * v**2
    z = v**2 * i1**2 / 4 + u * v * i1 * i2 + u**2 * i2**2 / 4
    form = (b**2 + 2 * c) * f**2 - 2 * b * (b**2 - c) * f * h + (b**4 - 4 * b**2 * c + 6 * c**2) * h**2
    zero(form - 4 * c * (b**2 - 4 * c) * z)


@check("Proposition 13.11")
def _():
    # The mean of (|p|²/2)² over a torus of two equal oscillators: |p|²/2 = k (J + √(J² − S²) cos 2θ), k² = σ/(4ν).
    j, s, t, k = sp.symbols("J S t k", positive=True)
    mean = sp.integrate(sp.expand(k**2 * (j + sp.Symbol("w") * sp.cos(t)) ** 2), (t, 0, 2 * sp.pi)) / (2 * sp.pi)
    zero(mean.subs(sp.Symbol("w"), sp.sqrt(j**2 - s**2)) - k**2 / 2 * (3 * j**2 - s**2))


@check("Proposition 13.12")
def _():
    y, d, g, m1, m2, m3, k1, k2, k3 = sp.symbols("y d g m1 m2 m3 k1 k2 k3")
    M, K, turn = Matrix([[m1, m3], [m3, m2]]), Matrix([[k1, k3], [k3, k2]]), Matrix([[0, g], [-g, 0]])
    det = (y**2 * M + y * (turn + d * M) + K).det()
    trace, eta = (M.inv() * K).trace(), y**2 + d * y
    zero(det - M.det() * (eta**2 + trace * eta + K.det() / M.det() + g**2 / M.det() * y**2))
    b, c, G = sp.symbols("b c G")
    f = eta**2 + (b - G) * eta + c + G * y**2
    slope = (-sp.diff(f, d) / sp.diff(f, y)).subs(d, 0)
    zero(slope + (2 * y**2 + b - G) / (4 * y**2 + 2 * b))
    for sign in (1, -1):
        root = (-b + sign * sp.sqrt(b**2 - 4 * c)) / 2
        rate = -(2 * root + b - G) / (4 * root + 2 * b)
        zero(rate - (-sp.Rational(1, 2) + sign * G / (2 * sp.sqrt(b**2 - 4 * c))))
