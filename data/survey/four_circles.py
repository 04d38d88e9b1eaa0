"""The widest room for four boundary circles among bodies that exist: python3 four_circles.py SEED STEPS | limit ROUNDS

U has the critical points gamma = (mu - A)^-1 r / s, s = sqrt(P), at x = s J^2 / 2 (docs/mathematics.md); they are found here by
sign changes on a grid in mu and bisection, their kinds by the second derivative of U on the sphere: nothing is shared
with the program. A component with four boundary circles and n poles is there for h between the highest of all that must lie below
(every saddle and minimum, and n of the energies of the poles) and the lowest of all that must lie above (four maxima,
and the other energies of poles). The room is the length of that interval over |r|. An evolution strategy (one parent, one child, the 1/5 rule)
makes it as large as it can over A, r and x; each line is one run. The runs go to plates with r in the principal plane of axes 2 and 3:
"limit" stays there (r1 = 1e-9 r3, A1 + A2 - A3 = 1e-12; the room is less than its supremum by about 0.3 r1) and goes on from the best of them with the simplex method of Nelder
and Mead over A2, r2 and x, with a new simplex in each round.
"""

import math
import random
import sys


def state(a, r, mu):
    u = [mu - x for x in a]
    p = sum((x / y) ** 2 for x, y in zip(r, u))
    phi = sum(x * x / y for x, y in zip(r, u))
    j = sum(z * (x / y) ** 2 for x, y, z in zip(r, u, a)) / p
    s = math.sqrt(p)
    return s * j * j / 2, j, phi / s, [x / y / s for x, y in zip(r, u)]


def grid(a, n=130):
    """mu on the four intervals, dense at their ends, where the roots are for a small component of r."""
    for k in range(n):
        yield 0, a[0] - math.exp(-24 + 29 * k / (n - 1))
    for i in (0, 1):
        for k in range(n):
            t = 1 / (1 + math.exp(23 - 46 * k / (n - 1)))
            yield 1 + i, a[i] + t * (a[i + 1] - a[i])
    for k in range(n):
        yield 3, a[2] + math.exp(-24 + 29 * k / (n - 1))


def is_maximum(a, x, gamma, j, r):
    """Both eigenvalues of the Hessian of U on the sphere are negative."""
    g = [2 * x * z * y / (j * j) for z, y in zip(a, gamma)]  # minus the gradient of x/J
    radial = -sum(y * (p + q) for y, p, q in zip(gamma, g, r))

    def second(u, v):
        ag_u = sum(z * y * w for z, y, w in zip(a, gamma, u))
        ag_v = sum(z * y * w for z, y, w in zip(a, gamma, v))
        straight = sum(z * p * q for z, p, q in zip(a, u, v))
        return -2 * x * straight / j**2 + 8 * x * ag_u * ag_v / j**3 - radial * sum(p * q for p, q in zip(u, v))

    k = min(range(3), key=lambda i: abs(gamma[i]))
    e = [float(i == k) - gamma[k] * gamma[i] for i in range(3)]
    n = math.sqrt(sum(y * y for y in e))
    e = [y / n for y in e]
    f = [gamma[1] * e[2] - gamma[2] * e[1], gamma[2] * e[0] - gamma[0] * e[2], gamma[0] * e[1] - gamma[1] * e[0]]
    p, q, m = second(e, e), second(f, f), second(e, f)
    return p + q < 0 and p * q > m * m


def room(a, r, x, poles):
    """The room over |r|, and the number of maxima; a negative room is what is missing."""
    size = math.sqrt(sum(y * y for y in r))
    maxima, others, last = [], [], None
    for interval, mu in grid(a):
        value = state(a, r, mu)[0] - x
        if last and last[0] == interval and (last[2] > 0) != (value > 0):
            low, high, rising = last[1], mu, value > 0
            for _ in range(60):
                middle = (low + high) / 2
                if (state(a, r, middle)[0] > x) == rising:
                    high = middle
                else:
                    low = middle
            _, j, l, gamma = state(a, r, (low + high) / 2)
            (maxima if is_maximum(a, x, gamma, j, r) else others).append(x / j - l)
        last = (interval, mu, value)
    j_r = sum(z * y * y for z, y in zip(a, r)) / size**2
    below, above = [x / j_r - size], []
    (below if poles == 2 else above).append(x / j_r + size)
    maxima.sort(reverse=True)
    if len(maxima) < 4:
        return -1.0, len(maxima), None
    top, bottom = min(above + [maxima[3]]), max(below + others + maxima[4:])
    return (top - bottom) / size, len(maxima), (top + bottom) / 2


# Plates, with r almost in the principal plane: where runs from the published witnesses, the first lines of the results, led to, and a
# scan over r2 and x.
START = {
    1: ((1, 1.0513317953821117, 2.0513317899191503), (9.8e-8, 0.06846931395568527, 1.0), 1.5743802190901117),
    2: ((1, 1.082, 2.0819999), (1e-6, 0.104, 1.0), 1.5898199951136627),
}


def body(v):
    """Coordinates: logarithms of A2/A1 - 1, of what A3 lacks to A1 + A2, of r1/r3 and r2/r3."""
    a2 = 1 + math.exp(v[0])
    return (1.0, a2, 1 + a2 - math.exp(v[1])), (math.exp(v[2]), math.exp(v[3]), 1.0)


def best_x(a, r, x, poles):
    """The room at the best x near the one given, by halving steps."""
    best = room(a, r, x, poles)
    step = 2e-4 * x
    while step > 1e-9 * x:
        for trial in (x + step, x - step):
            found = room(a, r, trial, poles)
            if found[0] > best[0]:
                best, x = found, trial
                break
        else:
            step /= 3
    return best, x


def main(seed, steps):
    rng = random.Random(seed)
    for poles, (a, r, x) in START.items():
        v = [math.log(a[1] - 1), math.log(1 + a[1] - a[2]), math.log(r[0]), math.log(r[1])]
        best, x = best_x(*body(v), x, poles)
        sigma = 0.05
        for _ in range(steps):
            # Each coordinate alone, or all together; the first three may run away towards a limit.
            one = rng.randrange(6)
            trial = [y + sigma * s * rng.gauss(0, 1) * (one in (k, 4, 5)) for k, (y, s) in enumerate(zip(v, (1, 4, 4, 1)))]
            a, r = body(trial)
            # x goes with the square of J and the size of r, so that its best value moves with the body.
            guess = x * (math.hypot(*r) * (a[2] / body(v)[0][2]) ** 2) / math.hypot(*body(v)[1])
            found, x_found = max((best_x(a, r, y, poles) for y in (x, guess)), key=lambda b: b[0][0])
            if found[0] > best[0]:
                best, v, x, sigma = found, trial, x_found, min(sigma * 1.5, 1.0)
            else:
                sigma = max(sigma * 0.95, 1e-5)
        a, r = body(v)
        print(
            f"k4n{poles} seed {seed}: room {best[0]:.6e}, A = {a}, r = {r}, x = {x!r}, l = {math.sqrt(2 * x)!r}, "
            f"h = {best[2]!r}, A1 + A2 - A3 = {math.exp(v[1]):.3e}",
            flush=True,
        )


# The best runs: A2, r2, x.
PLATES = {1: (1.0525556806703666, 0.0699685627104626, 1.5750924380578566), 2: (1.0818243825741174, 0.10411563032301861, 1.5894812417595834)}


def plate(v):
    a2 = 1 + math.exp(v[0])
    return (1.0, a2, 1 + a2 - 1e-12), (1e-9, math.exp(v[1]), 1.0)


def simplex(value, start, sizes, steps, rng):
    """The highest value met, and its place."""
    corners = [start] + [[y + s * rng.uniform(-1, 1) for y, s in zip(start, sizes)] for _ in start]
    found = sorted(((value(y), y) for y in corners), reverse=True)
    for _ in range(steps):
        centre = [sum(y[k] for _, y in found[:-1]) / len(start) for k in range(len(start))]
        worst = found[-1][1]

        def along(t):
            y = [c + t * (w - c) for c, w in zip(centre, worst)]
            return value(y), y

        trial = along(-1)
        if trial > found[0]:
            trial = max(trial, along(-2))
        elif trial <= found[-2]:
            trial = along(0.5)
        if trial > found[-1]:
            found[-1] = trial
        else:
            best = found[0][1]
            halfway = [[(p + q) / 2 for p, q in zip(y, best)] for _, y in found[1:]]
            found = found[:1] + [(value(y), y) for y in halfway]
        found.sort(reverse=True)
    return found[0]


def limit(rounds):
    rng = random.Random(1)
    for poles, (a2, r2, x) in PLATES.items():
        value = lambda v: room(*plate(v), v[2], poles)[0]
        best = [math.log(a2 - 1), math.log(r2), x]
        most = value(best)
        for k in range(rounds):
            size = 10.0 ** -(2 + k % 3)
            most, best = max((most, best), simplex(value, best, (size, size, 0.1 * size), 110, rng))
        a, r = plate(best)
        h = room(a, r, best[2], poles)[2]
        print(f"k4n{poles} plates: room {most:.6e}, A = {a}, r = {r}, x = {best[2]!r}, l = {math.sqrt(2 * best[2])!r}, h = {h!r}", flush=True)


if sys.argv[1] == "limit":
    limit(int(sys.argv[2]))
else:
    main(int(sys.argv[1]), int(sys.argv[2]))
