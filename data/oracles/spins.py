"""Critical spins of tilted asymmetric parts from the linearised Euler-Poisson equations, 60 digits.

pip install mpmath numpy; python3 data/oracles/spins.py > data/oracles/spins.jsonl

For each part: a tensor about the centre of mass, tilted by a rational rotation, the centre of mass on a principal axis, and
the spins at which the eigenvalues of the 6x6 matrix of (gamma, l) change their type while the body turns about that axis
(up: its end is up). Knows nothing of the closed form: the characteristic polynomial of the whole matrix is computed by
Faddeev and LeVerrier at each spin, and a change is a zero of its coefficient c or of its discriminant b^2 - 4c, found by
bisection between neighbours of a grid of 2000 spins in geometric progression, from a ten-thousandth of the fastest on.
"""
import json
import random
from fractions import Fraction

import numpy
from mpmath import mp, mpf, matrix, eye, sqrt

mp.dps = 60
STEPS = 2000


def rotation(q):
    """Cayley's rotation of a rational vector."""
    x, y, z = map(Fraction, q)
    n = 1 + x * x + y * y + z * z
    m = [[1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y)],
         [2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x)],
         [2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z]]
    return [[e / n for e in row] for row in m]


def skew(v):
    return matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def linearised(inertia, r, gamma, omega):
    """d/dt of (dgamma, dl) for gamma' = gamma x w, l' = l x w - gamma x r, w = I^-1 l."""
    inverse = inertia ** -1
    w = omega * gamma
    momentum = inertia * w
    top = -skew(w)
    whole = matrix(6, 6)
    blocks = [[top, skew(gamma) * inverse], [skew(r), skew(momentum) * inverse - skew(w)]]
    for i in range(6):
        for j in range(6):
            whole[i, j] = blocks[i // 3][j // 3][i % 3, j % 3]
    return whole


def coefficients(inertia, r, gamma, omega):
    """b and c of lambda^2 (lambda^4 + b lambda^2 + c)."""
    a = linearised(inertia, r, gamma, omega)
    m, coefficient = eye(6) * 0, mpf(1)
    found = [mpf(1)]
    for k in range(1, 7):
        m = a * m + coefficient * eye(6)
        product = a * m
        coefficient = -sum(product[i, i] for i in range(6)) / k
        found.append(coefficient)
    size = 1 + max(abs(x) for x in found)
    assert max(abs(found[k]) for k in (1, 3, 5, 6)) < size * mpf(10) ** -45, found
    return found[2], found[4]


def coarse(inertia, r, gamma, spins):
    """The same in floats at many spins, to find where to look: b and c at each."""
    rows = lambda m: numpy.array([[float(m[i, j]) for j in range(6)] for i in range(6)])
    # The matrix is linear in omega.
    still, fixed = rows(linearised(inertia, r, gamma, mpf(0))), rows(linearised(inertia, r * 0, gamma, mpf(0)))
    slope = rows(linearised(inertia, r * 0, gamma, mpf(1))) - fixed
    a = still + numpy.array([float(omega) for omega in spins])[:, None, None] * slope
    m, coefficient, found = numpy.zeros_like(a), numpy.ones(len(a)), []
    for k in range(1, 5):
        m = a @ m + coefficient[:, None, None] * numpy.eye(6)
        coefficient = -numpy.trace(a @ m, axis1=1, axis2=2) / k
        found.append(coefficient)
    return list(zip(found[1], found[3]))


def kind(b, c):
    if c < 0:
        return "saddle-centre"
    if b * b < 4 * c:
        return "complex"
    return "elliptic" if b > 0 else "saddle"


def changes(inertia, r, gamma, fastest):
    at = lambda omega: coefficients(inertia, r, gamma, omega)
    tests = [lambda b, c: c, lambda b, c: b * b - 4 * c]
    found = []
    grid = [fastest * mpf(10) ** (mpf(4 * k) / STEPS - 4) for k in range(STEPS + 1)]
    values = coarse(inertia, r, gamma, grid)
    for test in tests:
        for k in range(STEPS):
            low, high = grid[k], grid[k + 1]
            if (test(*values[k]) > 0) == (test(*values[k + 1]) > 0):
                continue
            first, last = test(*at(low)), test(*at(high))
            assert (first > 0) != (last > 0)
            # Illinois' variant of the false position.
            side = 0
            for _ in range(80):
                middle = (low * last - high * first) / (last - first)
                here = test(*at(middle))
                if abs(high - low) < mpf(10) ** -40 * high or here == 0:
                    break
                if (here > 0) == (last > 0):
                    high, last = middle, here
                    if side == 1:
                        first /= 2
                    side = 1
                else:
                    low, first = middle, here
                    if side == -1:
                        last /= 2
                    side = -1
            gap = (grid[k + 1] - grid[k]) / 1000
            before, after = kind(*at(middle - gap)), kind(*at(middle + gap))
            if before != after:
                found.append((middle, before, after))
    return [[mp.nstr(w, 30), before, after] for w, before, after in sorted(found)]


def main():
    random.seed(20250607)
    written = 0
    while written < 100:
        i = sorted(Fraction(random.randint(20, 200), 100) for _ in range(3))
        if i[0] + i[1] <= i[2] or len(set(i)) < 3:
            continue
        random.shuffle(i)
        mass, distance = Fraction(random.randint(5, 60), 10), Fraction(random.randint(5, 80), 100)
        axis = random.randrange(3)
        columns = rotation([Fraction(random.randint(-6, 6), random.randint(1, 5)) for _ in range(3)])
        turn = lambda d: [[sum(columns[p][k] * d[k] * columns[q][k] for k in range(3)) for q in range(3)] for p in range(3)]
        about_com = turn(i)
        if all(about_com[p][q] == 0 for p, q in ((0, 1), (0, 2), (1, 2))):
            continue
        about_pivot = turn([i[k] + (0 if k == axis else mass * distance ** 2) for k in range(3)])
        direction = [columns[p][axis] for p in range(3)]
        com = [distance * d for d in direction]
        number = lambda x: mpf(x.numerator) / x.denominator
        inertia = matrix([[number(x) for x in row] for row in about_pivot])
        r = matrix([number(mass * Fraction("9.80665") * x) for x in com])
        scale = max(number(i[k]) for k in range(3)) + number(mass * distance ** 2)
        fastest = 12 * sqrt(number(mass * distance) * 10 / scale) * scale / number(min(i))
        up = matrix([number(d) for d in direction])
        entries = [about_com[0][0], about_com[1][1], about_com[2][2], about_com[0][1], about_com[0][2], about_com[1][2]]
        print(json.dumps({
            "inertia_com": ",".join(map(str, entries)), "com": ",".join(map(str, com)), "mass": str(mass),
            "axis": ",".join(map(str, direction)), "fastest": mp.nstr(fastest, 12),
            "+axis": changes(inertia, r, -up, fastest), "-axis": changes(inertia, r, up, fastest),
        }), flush=True)
        written += 1


main()
