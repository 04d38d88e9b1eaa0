"""Arnold's determinant in the six variables (γ, 𝐥) without canonical coordinates: Theorem 13.13.

The amplitudes ζ₁, ζ₂ of the two modes are followed to third order in the quadratic equations of Euler and Poisson; what they
add to the frequencies is 2K₁₁I₁ + K₁₂I₂ and K₁₂I₁ + 2K₂₂I₂.
"""
import mpmath as mp

from common import check


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Flow:
    """The flow about γ with Ω = 1 and r = (μ − A)γ. A vector is (ω, γ)."""

    def __init__(self, a, gamma, mu):
        self.a, self.gamma, self.mu = a, gamma, mu
        tau, momentum = [mu - x for x in a], self.times(gamma)
        self.momentum, self.j = momentum, dot(gamma, momentum)
        k = min(range(3), key=lambda i: abs(gamma[i]))
        e = cross(gamma, [mp.mpf(i == k) for i in range(3)])
        e = [x / mp.sqrt(dot(e, e)) for x in e]
        basis = (e, cross(gamma, e))
        det = a[0] * a[1] * a[2]
        bend = [x - self.j * y for x, y in zip(momentum, gamma)]
        mass = [[det / self.j * sum(x * y / c for x, y, c in zip(p, q, a)) for q in basis] for p in basis]
        hessian = [[sum(x * y * c for x, y, c in zip(p, q, tau)) + 4 / self.j * dot(bend, p) * dot(bend, q) for q in basis]
                   for p in basis]
        gyro = sum(a) - 2 * dot(momentum, momentum) / self.j
        cofactor = mass[0][0] * hessian[1][1] + mass[1][1] * hessian[0][0] - 2 * mass[0][1] * hessian[0][1]
        self.b = (gyro**2 + cofactor) * self.j / det
        self.c = (hessian[0][0] * hessian[1][1] - hessian[0][1] ** 2) * self.j / det
        root = mp.sqrt(mp.mpc(self.b**2 - 4 * self.c))
        self.omega = [mp.sqrt((self.b + root) / 2), mp.sqrt((self.b - root) / 2)]
        self.rates = [1j * self.omega[0], 1j * self.omega[1], -1j * self.omega[0], -1j * self.omega[1]]
        self.modes = [self.mode(rate, mass, hessian, gyro, basis) for rate in self.rates]
        self.energies = [self.energy(self.modes[k - 2], self.modes[k]) for k in range(4)]

    def times(self, x):
        return [c * y for c, y in zip(self.a, x)]

    def mode(self, rate, mass, hessian, gyro, basis):
        p, q = (rate**2 * mass[0][k] + hessian[0][k] for k in range(2))
        g = [(rate * gyro - q) * x + p * y for x, y in zip(*basis)]
        turned = cross(self.gamma, g)
        along = (rate * dot(self.momentum, turned) - 2 * dot(self.momentum, g)) / self.j
        return [x - rate * y + along * z for x, y, z in zip(g, turned, self.gamma)], g

    def energy(self, y, z):
        """The second variation of H − l·Ω + μ|γ|²/2, under which different modes are orthogonal."""
        return sum(c * (p * q - p * h - q * g + self.mu * g * h / c) for c, p, g, q, h in zip(self.a, *y, *z))

    def shares(self, y):
        return [self.energy(self.modes[k - 2], y) / self.energies[k] for k in range(4)]

    def sum(self, factors, vectors):
        return tuple([sum(f * v[n][i] for f, v in zip(factors, vectors)) for i in range(3)] for n in range(2))

    def rest(self, y):
        return self.sum([1] + [-x for x in self.shares(y)], [y] + self.modes)

    def quadratic(self, y, z):
        """Twice the symmetric bilinear part of the equations."""
        (p, g), (q, h) = y, z
        turn = [x + y for x, y in zip(cross(self.times(p), q), cross(self.times(q), p))]
        return [x / c for x, c in zip(turn, self.a)], [x + y for x, y in zip(cross(g, q), cross(h, p))]

    def second(self, i, j):
        """The coefficient of ζᵢζⱼ."""
        forced = self.sum([mp.mpf(1) / (1 + (i == j))], [self.quadratic(self.modes[i], self.modes[j])])
        shares = self.shares(forced)
        if abs(i - j) == 2:  # constant: |γ| and ⟨γ, 𝐥⟩ keep their values
            (p, g), (q, h) = self.modes[i], self.modes[j]
            length, moment = -dot(g, h), -dot(self.times(g), q) - dot(self.times(h), p)
            zero = [mp.mpf(0)] * 3
            kernel = [self.rest((zero, self.gamma)), self.rest((self.gamma, zero))]
            return self.sum([-x / r for x, r in zip(shares, self.rates)] + [length, moment / self.j - length],
                            self.modes + kernel)
        rate = self.rates[i] + self.rates[j]
        return self.sum([x / (rate - r) for x, r in zip(shares, self.rates)] + [1 / rate], self.modes + [self.rest(forced)])

    def shift(self, k, *pairs):
        total = self.sum([1] * len(pairs), [self.quadratic(self.modes[m], self.second(*ij)) for m, ij in pairs])
        return self.shares(total)[k] / 1j

    def determinant(self):
        """D₄/s, and K₁₂ from both frequencies."""
        n = [self.energies[0] / self.omega[0], -self.energies[1] / self.omega[1]]
        k11 = self.shift(0, (0, (0, 2)), (2, (0, 0))) / (2 * n[0])
        k22 = -self.shift(1, (1, (1, 3)), (3, (1, 1))) / (2 * n[1])
        k12 = self.shift(0, (0, (1, 3)), (1, (0, 3)), (3, (0, 1))) / n[1]
        other = -self.shift(1, (1, (0, 2)), (0, (1, 2)), (2, (0, 1))) / n[0]
        one, two = self.omega
        return k11 * two**2 + k12 * one * two + k22 * one**2, k12, other


def numerator(a, r, mu):
    """𝒩 on the generic family."""
    active = [k for k in range(3) if r[k]]
    u = [mp.fprod([r[k]] + [mu - a[j] for j in active if j != k]) for k in range(3)]
    p = dot(u, u)
    flow = Flow(a, [x / mp.sqrt(p) for x in u], mu)
    value, one, other = flow.determinant()
    assert abs(one - other) < mp.mpf(10) ** -60 * (1 + abs(one)) and abs(value.imag) < mp.mpf(10) ** -60 * (1 + abs(value))
    b, c = flow.b, flow.c
    value = value.real * c * (b**2 - 4 * c)
    return value if len(active) == 1 else value * c * (4 * b**2 - 25 * c) * p**9


@check("Theorem 13.13")
def _():
    with mp.workdps(200):
        for a, r, degree, zeros in [
            ("2 1.1 1", "0.9 0 0.6", 27, {1: 0, 2: 0, mp.mpf("1.1"): 1}),
            ("1.3 2 3", "1 1.7 0.8", 45, {mp.mpf("1.3"): 0, 2: 0, 3: 0}),
            ("1.7 2.9 3.1", "0 0 1", 5, {}),
            ("1.7 1.7 3.1", "0.3 0 0.4", 27, {mp.mpf("1.7"): 2, mp.mpf("3.1"): 0}),
            ("1.7 1.7 3.1", "0.3 0 0", 5, {mp.mpf("1.7"): 1}),
        ]:
            a, r = [[mp.mpf(x) for x in row.split()] for row in (a, r)]
            row = [numerator(a, r, mp.mpf(k) / 7 + mp.mpf(1) / 1000 - 2) for k in range(degree + 3)]
            size = max(abs(x) for x in row)
            for _ in range(degree):
                row = [y - x for x, y in zip(row, row[1:])]
            assert abs(row[0]) > mp.mpf(10) ** -60 * size and abs(row[1] - row[0]) < mp.mpf(10) ** -100 * size
            for place, order in zeros.items():
                far, near = [abs(numerator(a, r, place + mp.mpf(10) ** -k)) for k in (20, 30)]
                assert abs(mp.log10(far / near) / 10 - order) < 0.01, (a, r, place)
