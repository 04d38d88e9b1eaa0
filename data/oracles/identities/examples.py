"""Worked examples: section 15."""
import mpmath as mp
import sympy as sp
from sympy import Rational as Q

from common import EPS, check, mu, polynomials, zero


@check("Example 15.1")
def _():
    X = lambda y: y * (1 + y**-2) ** 2 / 2
    H = lambda y: y / 2 + 3 / (2 * y)
    root3 = mp.sqrt(3)
    assert abs(2 * X(root3) - 16 * root3 / 9) < EPS and abs(H(root3) - root3) < EPS and abs(mp.diff(X, root3)) < EPS
    assert H(mp.mpf(1)) == 2 and 2 * X(mp.mpf(1)) == 4
    meeting = mp.findroot(lambda y: H(y) - X(y) / 2 - 1, 2.4)
    assert abs(H(meeting) - (2 * mp.sqrt(2) - 1)) < EPS and abs(2 * X(meeting) - (8 * mp.sqrt(2) - 8)) < EPS
    level = mp.mpf("1.84") ** 2 / 2
    heights = [level / 2 - 1, level / 2 + 1] + [H(mp.findroot(lambda y: X(y) - level, y)) for y in (1.3, 2.2)]
    assert [mp.nstr(y, 6, strip_zeros=False) for y in sorted(heights)] == ["-0.153600", "1.83216", "1.84640", "1.85933"]


@check("Example 15.2")
def _():
    k, g = sp.symbols("k g", positive=True)
    S = 1 / (g * k)
    J = 1 - k * (1 - g**2)
    zero((S * J**2 - 4 * g).subs(k, 1 / (1 + g) ** 2))
    # Pitchfork s = 1/k with J = 1; cusp s² = 3/(k(1 − k)), γ₁² = 1/(sk)².
    zero((1 - k - (-1 / k) / (1 / k) ** 2) - 1)
    zero(1 / (3 / (k * (1 - k)) * k**2) - (1 - k) / (3 * k))
    zero((3 / (k * (1 - k)) - 1 / k**2) * k**2 * (1 - k) - (4 * k - 1))  # beyond the pitchfork iff k > 1/4


@check("Example 15.3")
def _():
    a, r = [mp.mpf(2), mp.mpf("1.1"), mp.mpf(1)], [mp.mpf("0.94868"), mp.mpf(0), mp.mpf("0.61623")]
    table = {
        "3.25": "1.639699408 3.484722441 4.645784644 4.710720314 5.938010083 1.969406501 4.231912328",
        "2.72": "0.834362766 2.626872219 3.147234789 3.150875439 4.372315146 1.040573700 3.303079528",
        "7.2": "11.997681739 13.892893972 23.531034271 25.312557985 26.544811288 14.086563327 16.349069155",
    }
    norm = mp.sqrt(r[0] ** 2 + r[2] ** 2)
    j_r = (a[0] * r[0] ** 2 + a[2] * r[2] ** 2) / norm**2
    D, p, q, _ = polynomials([Q(2), Q(1)], [Q(94868, 10**5), Q(61623, 10**5)])
    hat = r[0] ** 2 / (a[1] - a[0]) + r[2] ** 2 / (a[1] - a[2])
    pitchfork = mp.sqrt((r[0] / (a[1] - a[0])) ** 2 + (r[2] / (a[1] - a[2])) ** 2)
    for l, row in table.items():
        X = Q(l) ** 2 / 2
        heights = []
        for root in sp.Poly(sp.expand(q**4 - 4 * X**2 * p**3 * D**2), mu).real_roots():
            m = mp.mpf(str(root.evalf(45)))
            g = [r[0] / (m - 2), r[2] / (m - 1)]
            S = mp.sqrt(g[0] ** 2 + g[1] ** 2)
            J = (2 * g[0] ** 2 + g[1] ** 2) / S**2
            heights.append(S * J / 2 - (r[0] * g[0] + r[2] * g[1]) / S)
        pair = mp.findroot(lambda y: y * (a[1] - hat / y**2) ** 2 / 2 - mp.mpf(X.p) / X.q, 2 * mp.mpf(X.p) / X.q / a[1] ** 2)
        assert pair > pitchfork
        heights.append(pair * a[1] / 2 - 3 * hat / (2 * pair))
        heights.sort()
        level = mp.mpf(X.p) / X.q
        heights += [level / j_r - norm, level / j_r + norm]
        assert [mp.nstr(y, 25) for y in heights] and len(heights) == 7
        for found, told in zip(heights, row.split()):
            assert abs(found - mp.mpf(told)) <= mp.mpf("0.5000001e-9"), (l, found, told)
