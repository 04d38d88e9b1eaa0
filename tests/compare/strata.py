"""Bodies of all strata, written as texts. The same seed gives the same bodies."""

import random
from fractions import Fraction
from math import cos, exp, log, pi, sin, sqrt

PRESETS = (
    "paper kovalevskaya goryachev-chaplygin lagrange euler katok:1 katok:2 katok:3 katok:4 katok:5 katok:6 katok:7 projpm "
    "projections12 isotropic plate rod ten"
).split()


def text(rng, value):
    """A value in one of the ways in which a user writes numbers."""
    way = rng.randrange(4)
    if value == 0 or way == 0:
        return repr(value)
    if way == 1:
        return f"{value:.{rng.randint(2, 6)}g}"
    if way == 2:
        return f"{value:.{rng.randint(2, 17)}e}"
    fraction = Fraction(f"{value:.4g}").limit_denominator(10 ** rng.randint(2, 6))
    return str(fraction) if fraction != 0 else repr(value)


def log_uniform(rng, low, high):
    return exp(rng.uniform(log(low), log(high)))


def direction(rng):
    z, angle = rng.uniform(-1, 1), rng.uniform(0, 2 * pi)
    s = sqrt(1 - z * z)
    return [s * cos(angle), s * sin(angle), z]


def existing(rng):
    """Moments of a body that exists: A_i = 1 - m_i, the second moments m uniform on a simplex."""
    cuts = sorted([rng.random(), rng.random()])
    masses = [cuts[0], cuts[1] - cuts[0], 1 - cuts[1]]
    return [1 - m + 1e-9 for m in masses]


def texts(rng, values):
    return [text(rng, value) for value in values]


def shuffled(rng, moments, center):
    order = rng.sample(range(3), 3)
    return [moments[k] for k in order], [center[k] for k in order]


def near(rng, values, width):
    return [repr(value * (1 + width * rng.uniform(-1, 1))) for value in values]


def generic(rng):
    scale = log_uniform(rng, 0.1, 10)
    return texts(rng, existing(rng)), texts(rng, [scale * c for c in direction(rng)])


def plane(rng):
    moments, center = generic(rng)
    center[rng.randrange(3)] = rng.choice(["0", "0.0", "-0", "0/7"])
    return moments, center


def axis(rng):
    moments, center = generic(rng)
    kept = rng.randrange(3)
    return moments, [c if k == kept else "0" for k, c in enumerate(center)]


def equal_moments(rng):
    moments, center = generic(rng)
    moments[1] = moments[0]
    return shuffled(rng, moments, center)


def lagrange(rng):
    """Two equal moments with r on the third axis, or in their plane (Kovalevskaya's among them)."""
    pair, single = text(rng, rng.uniform(0.5, 2)), text(rng, rng.uniform(0.1, 2))
    length = text(rng, log_uniform(rng, 0.1, 10))
    if rng.random() < 0.5:
        return shuffled(rng, [pair, pair, single], ["0", "0", length])
    if rng.random() < 0.5:
        pair, single = "2", "1"
    return shuffled(rng, [pair, pair, single], [length, rng.choice(["0", length]), "0"])


def isotropic(rng):
    """Three equal moments, or r = 0."""
    moments, center = generic(rng)
    if rng.random() < 0.5:
        return [moments[0]] * 3, center
    return rng.choice([moments, [moments[0], moments[0], moments[2]]]), ["0", "0", "0"]


def nearly_equal(rng):
    """Two moments that differ by 1e-3 ... 1e-16 of themselves, exactly as written."""
    moments, center = generic(rng)
    first = Fraction(moments[0])
    moments[1] = str(first * (1 + Fraction(f"1e-{rng.randint(3, 16)}")))
    if rng.random() < 0.2:
        moments[2] = str(first * (1 - Fraction(f"1e-{rng.randint(3, 16)}")))
    return shuffled(rng, moments, center)


def tiny_components(rng):
    moments, center = generic(rng)
    for k in rng.sample(range(3), rng.randint(1, 2)):
        center[k] = f"{rng.uniform(1, 9):.3g}e-{rng.choice([3, 5, 7, 9, 12, 16, 20, 40])}"
    return moments, center


def rods(rng):
    """One small moment, the other two equal or nearly so."""
    thin = f"{rng.uniform(1, 9):.3g}e-{rng.randint(2, 9)}"
    center = [rng.choice(["0", text(rng, rng.uniform(-1, 1))]) for _ in range(3)]
    if all(Fraction(c) == 0 for c in center):
        center = ["1", "0", "0"]
    other = "1" if rng.random() < 0.5 else str(1 + Fraction(thin) / rng.randint(2, 9))
    return shuffled(rng, [thin, "1", other], center)


def plates(rng):
    """A1 = A2 + A3 exactly; the centre of mass in the plane, or, which no plate has, beside it."""
    second, third = (Fraction(text(rng, rng.uniform(0.1, 2))) for _ in range(2))
    center = texts(rng, direction(rng))
    center[0] = "0" if rng.random() < 0.7 else center[0]
    return [str(second + third), str(second), str(third)], center


def impossible(rng):
    """Any positive moments."""
    return texts(rng, [log_uniform(rng, 0.01, 1) for _ in range(3)]), texts(rng, direction(rng))


def scales(rng):
    """Very small and very large, up to the limits of what is accepted."""
    moments, center = generic(rng)
    up, down = rng.choice([-145, -60, -12, -5, 5, 12, 60, 145]), rng.choice([-145, -60, -12, -5, 5, 12, 60, 145])
    if abs(up) > 100 or abs(down) > 100:
        down = up
    return [scaled(t, up) for t in moments], [scaled(t, down) for t in center]


def scaled(number, power):
    mantissa, exponent = f"{float(Fraction(number)):.12e}".split("e")
    return f"{mantissa}e{int(exponent) + power}"


def katok(rng):
    """r on a principal axis, and moments at or near the borders between Katok's classes."""
    border = rng.choice([Fraction(1), Fraction(3, 4)])
    beside = border * (1 + rng.choice([-1, 1]) * Fraction(f"1e-{rng.randint(1, 15)}"))
    other = Fraction(f"{rng.uniform(0.3, 1.7):.3f}")
    moments = ["1", *(str(x) for x in rng.sample([beside, other], 2))]
    return shuffled(rng, moments, ["1", "0", "0"])


def paper(rng):
    """Near the paper's body and near that with ten relative equilibria."""
    if rng.random() < 0.7:
        moments, center = [2, 1.1, 1], [0.94868, 0, 0.61623]
    else:
        moments, center = [0.57847392, 0.53739099, 1], [0.00595273, 0.00176367, -0.99998073]
    width = 10 ** rng.uniform(-8, -1)
    return near(rng, moments, width), near(rng, center, width)


def four_circles(rng):
    """Around bodies with components of three and four boundary circles."""
    if rng.random() < 0.5:
        return near(rng, [1, 1.08, 2.06], 1e-3), near(rng, [0.0002, 0.101, 1], 0.1)
    return near(rng, [0.094, 0.056, 0.56], 0.2), near(rng, [0.51, 0.01, 1], 0.2)


def rational(rng):
    """Everything rational, |r| and J_r too: points on pole lines can be written exactly."""
    triple = rng.choice([(3, 4, 0, 5), (1, 2, 2, 3), (2, 3, 6, 7), (1, 4, 8, 9), (4, 4, 7, 9), (0, 5, 12, 13), (0, 0, 1, 1)])
    unit = Fraction(rng.randint(1, 60), rng.randint(1, 60))
    center = rng.sample([str(rng.choice([-1, 1]) * unit * c) for c in triple[:3]], 3)
    moments = [str(Fraction(rng.randint(40, 80), rng.randint(20, 60))) for _ in range(3)]
    return moments, center


STRATA = {
    "generic": generic,
    "plane": plane,
    "axis": axis,
    "equal moments": equal_moments,
    "Lagrange": lagrange,
    "isotropic, r = 0": isotropic,
    "nearly equal": nearly_equal,
    "tiny r_i": tiny_components,
    "rods": rods,
    "plates": plates,
    "impossible": impossible,
    "scales": scales,
    "Katok": katok,
    "paper, ten": paper,
    "four circles": four_circles,
    "rational": rational,
}


def generator(seed, name):
    return random.Random(f"{seed}/{name}")


def bodies(seed, stratum, count):
    rng = generator(seed, stratum)
    return [STRATA[stratum](rng) for _ in range(count)]
