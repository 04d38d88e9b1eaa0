"""What the checks share: symbols, points, sums, bodies."""
import random

import mpmath as mp
import sympy as sp
from sympy import Matrix, Rational as Q

mp.mp.dps = 40
EPS = mp.mpf(10) ** -25
RANDOM = random.Random(20240601)
CHECKS = []
a1, a2, a3 = A_ = sp.symbols("a1:4", positive=True)
r1, r2, r3 = R_ = sp.symbols("r1:4", positive=True)
mu, s, x, h, t = sp.symbols("mu s x h t")
A = sp.diag(*A_)


def check(*statements):
    def enter(function):
        CHECKS.append((statements, function))
        return function
    return enter


def zero(expression):
    """A rational function is identically 0."""
    assert sp.expand(sp.numer(sp.together(expression))) == 0, expression


def dot(u, v):
    return (u.T * v)[0]


def vector(name):
    return Matrix(sp.symbols(name + "1:4"))


def sphere(p, q):
    """A rational point of the sphere."""
    n = 1 + p * p + q * q
    return Matrix([2 * p / n, 2 * q / n, (p * p + q * q - 1) / n])


def critical(p, q):
    """γ, r and J with s(μ − A)γ = r."""
    gamma = sphere(p, q)
    return gamma, s * (mu * sp.eye(3) - A) * gamma, dot(gamma, A * gamma)


def sums(a=A_, r=R_):
    tau = [mu - b for b in a]
    return (sum(c**2 / d**2 for c, d in zip(r, tau)), sum(b * c**2 / d**2 for b, c, d in zip(a, r, tau)),
            sum(c**2 / d for c, d in zip(r, tau)))


def means(a=A_, r=R_):
    """J, T, V of Lemma 3.5."""
    P, q, _ = sums(a, r)
    tau = [mu - b for b in a]
    w = [c**2 / d**2 / P for c, d in zip(r, tau)]
    pairs = [(i, j) for i in range(len(a)) for j in range(i)]
    return (q / P, sum(c / d for c, d in zip(w, tau)),
            sum(w[i] * w[j] * (a[i] - a[j]) ** 2 / tau[i] / tau[j] for i, j in pairs))


def over_passive():
    """R̂, P̂, J, x, h of Theorem 3.3 over a3."""
    R = r1**2 / (a3 - a1) + r2**2 / (a3 - a2)
    P = r1**2 / (a3 - a1) ** 2 + r2**2 / (a3 - a2) ** 2
    J = a3 - R / s**2
    return R, P, J, s * J**2 / 2, s * a3 / 2 - 3 * R / (2 * s)


p_, q_, u_, v_ = sp.symbols("p q u v")


def polynomials(a, r):
    """D, p = P D², q = Q D², RD as expressions."""
    D = sp.prod([mu - b for b in a])
    rest = [sp.prod([mu - c for j, c in enumerate(a) if j != i]) for i in range(len(a))]
    p = sum(c**2 * f**2 for c, f in zip(r, rest))
    q = sum(b * c**2 * f**2 for b, c, f in zip(a, r, rest))
    return D, p, q, sum(c**2 * f for c, f in zip(r, rest))


def cusp_polynomial(a, r):
    D, p, q, _ = polynomials(a, r)
    dD, dp, dq = (sp.diff(f, mu) for f in (D, p, q))
    return sp.Poly(sp.expand(-(4 * (dq * D - 2 * q * dD) * p - 3 * (dp * D - 2 * p * dD) * q) / 2), mu)


BODIES = [
    ([Q(2), Q(11, 10), Q(1)], [Q(3, 10), Q(1, 2), Q(7, 10)]),
    ([Q(1), Q(13, 10), Q(19, 10)], [Q(8, 10), Q(1, 10), Q(6, 10)]),
    ([Q(57847392, 10**8), Q(53739099, 10**8), Q(1)], [Q(595273, 10**8), Q(176367, 10**8), Q(99998073, 10**8)]),
    ([Q(1), Q(27, 25), Q(103, 50)], [Q(1, 5000), Q(101, 1000), Q(1)]),
]


def data(n):
    """Moments and centres of mass: symbols for n ≤ 1, else random rationals, for which the expansions are short."""
    if n == 1:
        return [(A_[:1], R_[:1])]
    return [([rational(1, 999) for _ in range(n)], [rational(1, 999) for _ in range(n)]) for _ in range(4)]


class Point:
    """A relative equilibrium of the generic family in 40 digits."""

    def __init__(self, a, r, root):
        self.mu = mp.mpf(root.p) / root.q
        a, r = [[mp.mpf(c.p) / c.q for c in row] for row in (a, r)]
        tau = [self.mu - b for b in a]
        P = sum((c / d) ** 2 for c, d in zip(r, tau))
        self.s = mp.sqrt(P)
        self.gamma = [c / self.s / d for c, d in zip(r, tau)]
        w = [g**2 for g in self.gamma]
        self.J = sum(b * c for b, c in zip(a, w))
        self.x = self.s * self.J**2 / 2
        self.h = self.x / self.J - sum(g * c for g, c in zip(self.gamma, r))
        pairs = [(i, j) for i in range(3) for j in range(i)]
        T = sum(c / d for c, d in zip(w, tau))
        V = sum(w[i] * w[j] * (a[i] - a[j]) ** 2 / tau[i] / tau[j] for i, j in pairs)
        determinant = tau[0] * tau[1] * tau[2] * (T + 4 * V / self.J)
        trace = sum((1 - c) * d for c, d in zip(w, tau))
        trace += 4 / self.J * sum(w[i] * w[j] * (a[i] - a[j]) ** 2 for i, j in pairs)
        self.index = 1 if determinant < 0 else 0 if trace > 0 else 2


def bisected(f, low, high):
    """An isolating interval of a simple root, narrowed to 2^-200 by exact signs."""
    coefficients = [int(c) for c in f.all_coeffs()]

    def sign(y):
        # Horner's rule in integers: denominator^n f(numerator/denominator).
        value, power = 0, 1
        for c in coefficients:
            value = value * y.p + c * power
            power *= y.q
        return (value > 0) - (value < 0)

    at_low = sign(low)
    assert at_low * sign(high) < 0
    while high - low > Q(1, 2**200):
        middle = (low + high) / 2
        at_middle = sign(middle)
        if at_middle == 0:
            return middle, middle
        low, high = (middle, high) if at_middle == at_low else (low, middle)
    return low, high


def critical_points(a, r, X):
    """All critical points for n = 3 at x = X: the real roots of the degree-18 polynomial, isolated exactly."""
    D, p, q, _ = polynomials(a, r)
    f = sp.Poly(sp.expand(q**4 - 4 * X**2 * p**3 * D**2), mu)
    assert sp.gcd(f, f.diff()).degree() == 0
    _, f = f.clear_denoms(convert=True)
    found = []
    for (low, high), _ in f.intervals():
        if low != high:
            low, high = bisected(f, Q(low), Q(high))
        found.append((low + high) / 2)
    points = [Point(a, r, root) for root in found]
    assert all(abs(c.x - mp.mpf(X.p) / X.q) < EPS * X for c in points)
    return points


def rational(low=1, high=10**9):
    return Q(RANDOM.randint(low, high), RANDOM.randint(low, high))
