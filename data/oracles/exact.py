"""Relative equilibria of a heavy rigid body in exact rational and certified ball arithmetic (python-flint).

Shares nothing with the crate: every real root comes from FLINT's certified isolation of a polynomial with rational
coefficients, so no critical point can be missed and none invented. Formulas: Schmidt, Dullin and Richter (2008), with
(mu - A) gamma s = r at a critical point:
  P = sum r_i^2/(mu-A_i)^2, Q = sum A_i r_i^2/(mu-A_i)^2, R = sum r_i^2/(mu-A_i); s = sqrt(P), J = Q/P, l^4 = Q^4/P^3,
  h = (Q/2 - R)/sqrt(P); with D = prod(mu-A_i) over the distinct moments that carry r, p = P D^2, q = Q D^2:
  l^4 p^3 D^2 = q^4, all of whose real roots count. Cusps: 4 Q' P = 3 P' Q.
Over a moment A_i whose eigenspace carries no r lies a pair (or circle): l^2 s^3 = (A_i s^2 - R^)^2, s^2 > P^.
"""

from fractions import Fraction

from flint import arb, ctx, fmpq, fmpq_poly, fmpz

ctx.dps = 90


def rational(text):
    f = Fraction(text)
    return fmpq(fmpz(f.numerator), fmpz(f.denominator))


def real_roots(poly):
    """Distinct real roots of a rational polynomial, ascending, as balls; certified."""
    if poly.degree() < 1:
        return []
    squarefree = poly / poly.gcd(poly.derivative()) if poly.gcd(poly.derivative()).degree() > 0 else poly
    numer = squarefree.numer()
    roots = [z.real for z, _ in numer.complex_roots() if z.imag.is_zero()]
    return sorted(roots, key=lambda b: Fraction(int(b.mid().man_exp()[0])) * Fraction(2) ** int(b.mid().man_exp()[1]))


class Body:
    """A body given by texts; everything else is exact."""

    def __init__(self, moments, center):
        self.text_a, self.text_r = list(moments), list(center)
        self.a = [rational(t) for t in moments]
        self.r = [rational(t) for t in center]
        weights = {}
        for a, r in zip(self.a, self.r):
            weights[a] = weights.get(a, fmpq(0)) + r * r
        self.active = sorted((a for a, w in weights.items() if w != 0), key=lambda x: Fraction(int(x.p), int(x.q)))
        self.passive = [a for a, w in weights.items() if w == 0]
        self.weights = weights
        self.r2 = sum((r * r for r in self.r), fmpq(0))
        mu = fmpq_poly([0, 1])
        one = fmpq_poly([1])
        self.d, self.p, self.q = one, fmpq_poly([0]), fmpq_poly([0])
        for a in self.active:
            self.d *= mu - a
        for a in self.active:
            rest = one
            for b in self.active:
                if b != a:
                    rest *= (mu - b) * (mu - b)
            self.p += rest * weights[a]
            self.q += rest * weights[a] * a

    # The generic family ------------------------------------------------------------------------------------------

    def generic(self, mu):
        """(l^2, h, gamma, J, s) at a ball mu."""
        big_p = sum((self.weights[a] / (mu - arb(a)) ** 2 for a in self.active), arb(0))
        big_q = sum((a * self.weights[a] / (mu - arb(a)) ** 2 for a in self.active), arb(0))
        big_r = sum((self.weights[a] / (mu - arb(a)) for a in self.active), arb(0))
        s = big_p.sqrt()
        gamma = [arb(0) if r == 0 else arb(r) / (s * (mu - arb(a))) for a, r in zip(self.a, self.r)]
        j = big_q / big_p
        return s * j * j, (big_q / 2 - big_r) / s, gamma, j, s

    def generic_roots(self, l2):
        """All mu with l(mu)^2 = l2 (rational)."""
        if not self.active:
            return []
        return real_roots(self.p**3 * self.d**2 * (l2 * l2) - self.q**4)

    def cusp_roots(self):
        if len(self.active) < 2:
            return []
        p, q, d = self.p, self.q, self.d
        dp, dq, dd = p.derivative(), q.derivative(), d.derivative()
        return real_roots((dq * d - q * dd * 2) * p * 4 - (dp * d - p * dd * 2) * q * 3)

    def j_extrema(self):
        """mu at which J = Q/P is stationary."""
        if len(self.active) < 2:
            return []
        return real_roots(self.q.derivative() * self.p - self.p.derivative() * self.q)

    # Pairs and circles -------------------------------------------------------------------------------------------

    def hats(self, a):
        p_hat = sum((w / (a - b) ** 2 for b, w in self.weights.items() if w != 0), fmpq(0))
        r_hat = sum((w / (a - b) for b, w in self.weights.items() if w != 0), fmpq(0))
        return p_hat, r_hat

    def pair(self, a, s):
        """(l^2, h, gamma with the free component(s) in the first axis of the eigenspace, J, s)."""
        p_hat, r_hat = self.hats(a)
        free = (1 - p_hat / s**2).sqrt()
        gamma, used = [], False
        for b, r in zip(self.a, self.r):
            if b == a:
                gamma.append(arb(0) if used else free)
                used = True
            else:
                gamma.append(arb(0) if r == 0 else arb(r) / (s * arb(a - b)))
        j = a - r_hat / s**2
        return s * j * j, s * a / 2 - 3 * r_hat / (2 * s), gamma, j, s

    def pair_roots(self, a, l2):
        p_hat, r_hat = self.hats(a)
        s = fmpq_poly([0, 1])
        square = s * s * a - r_hat
        found = []
        for root in real_roots(s * s * s * l2 - square * square):
            if root > 0 and root**2 > arb(p_hat):
                found.append(root)
            elif not (root <= 0 or root**2 < arb(p_hat)):
                raise ArithmeticError("on a pitchfork")
        return found

    def pair_cusp(self, a):
        """s at the cusp of the pair, or None."""
        p_hat, r_hat = self.hats(a)
        if r_hat < 0 and -3 * r_hat / a > p_hat:
            return (arb(-3 * r_hat) / a).sqrt()
        return None

    # All critical points -----------------------------------------------------------------------------------------

    def critical(self, l_text):
        """All critical points at one l: dicts with balls, ascending in h."""
        l = rational(l_text)
        l2 = l * l
        found = []
        if self.r2 == 0:
            for a in sorted(set(self.a), key=lambda x: Fraction(int(x.p), int(x.q))):
                axes = [k for k in range(3) if self.a[k] == a]
                kind = {1: 1, 2: "circle", 3: "sphere"}[len(axes)]
                higher = sum(1 for b in self.a if b > a)
                for sign in (1, -1) if kind == 1 else (1,):
                    gamma = [arb(sign) if k == axes[0] else arb(0) for k in range(3)]
                    found.append(dict(h=arb(l2 / (2 * a)), gamma=gamma, j=arb(a), index=higher, multiplicity=kind))
            return sorted(found, key=lambda c: float(c["h"]))
        for mu in self.generic_roots(l2):
            _, h, gamma, j, s = self.generic(mu)
            found.append(dict(h=h, gamma=gamma, j=j, multiplicity=1, index=self.index(gamma, j, s, None)))
        for a in self.passive:
            axes = [k for k in range(3) if self.a[k] == a]
            for root in self.pair_roots(a, l2):
                _, h, gamma, j, s = self.pair(a, root)
                kind = "circle" if len(axes) == 2 else 1
                index = self.index(gamma, j, s, axes if kind == "circle" else None)
                found.append(dict(h=h, gamma=gamma, j=j, multiplicity=kind, index=index))
                if kind == 1:
                    mirrored = [-g if k == axes[0] else g for k, g in enumerate(gamma)]
                    found.append(dict(h=h, gamma=mirrored, j=j, multiplicity=1, index=index))
        return sorted(found, key=lambda c: (float(c["h"]), [float(g) for g in c["gamma"]]))

    def index(self, gamma, j, s, circle):
        """Morse index from the Hessian -s A + (4 s/J) A gamma (A gamma)^T + <gamma, s A gamma + r> on the tangent plane."""
        a = [arb(x) for x in self.a]
        moment = [x * g for x, g in zip(a, gamma)]
        normal = sum((g * (s * m + arb(r)) for g, m, r in zip(gamma, moment, self.r)), arb(0))
        smallest = min(range(3), key=lambda k: abs(float(gamma[k])))
        axis = [arb(int(k == smallest)) for k in range(3)]
        e = cross(gamma, axis)
        norm = dot(e, e).sqrt()
        e = [x / norm for x in e]
        f = cross(gamma, e)

        def entry(u, v):
            identity = normal if u is v else arb(0)
            return identity - s * dot(u, [x * y for x, y in zip(a, v)]) + 4 * s / j * dot(u, moment) * dot(v, moment)

        ee, ef, ff = entry(e, e), entry(e, f), entry(f, f)
        trace, det = ee + ff, ee * ff - ef * ef
        if circle is not None:  # one eigenvalue is zero by symmetry
            if trace > 0:
                return 0
            assert trace < 0
            return 1
        if det < 0:
            return 1
        assert det > 0, "degenerate critical point"
        return 0 if trace > 0 else 2


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def digits(ball, count):
    """Decimal text of a ball, count significant digits, exponent form when that is shorter."""
    if ball.is_zero():
        return "0"
    text = ball.str(count + 3, radius=False)
    assert ball.rel_accuracy_bits() > 3.4 * count, (ball, count)
    return arb(text).str(count, radius=False)
