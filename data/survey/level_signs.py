"""Changes of sign in the polynomial of one height on G0: python3 level_signs.py SEED BODIES

With d_i = A_i - mu and q_i = r_i^2, the rotations of energy h or -h with y = d_1 = A_1 - mu > 0 are the positive zeros of

    (sum_i q_i (A_i + 2 d_i) prod_{j != i} d_j^2)^2 - 4 h^2 prod_j d_j^2 sum_i q_i prod_{j != i} d_j^2,

of degree 10 (Proposition 11.8). By Descartes' rule they are at most as many as its coefficients change their sign. Printed: how many
bodies have how many changes at that h at which there are most, for bodies that exist and for all A > 0. In exact arithmetic.
"""

import random
import sys
from collections import Counter
from fractions import Fraction

from fold_signs import body, product


def changes(a, square):
    """At the height with most changes: the coefficients of both polynomials are positive, so that their ratios tell the signs."""
    d = [[x - a[0], 1] for x in a]
    rest = [product(*[d[j]] * 2, *[d[k]] * 2) for j, k in ((1, 2), (0, 2), (0, 1))]
    lines = [[3 * x - 2 * a[0], 2] for x in a]
    root = [sum(square[i] * product(lines[i], rest[i])[n] for i in range(3)) for n in range(6)]
    weight = [sum(square[i] * rest[i][n] for i in range(3)) for n in range(5)]
    ratios = [p / q for p, q in zip(product(root, root)[2:], product(*[d[0]] * 2, *[d[1]] * 2, *[d[2]] * 2, weight)[2:])]
    levels = sorted(set(ratios))
    most = 0
    for low, high in zip(levels, levels[1:]):
        # The first two coefficients are positive at every h.
        signs = [True, *(ratio > (low + high) / 2 for ratio in ratios)]
        most = max(most, sum(p != q for p, q in zip(signs, signs[1:])))
    return most


if __name__ == "__main__":
    # The body of docs/types.md with six changes in the polynomial of the folds.
    known = [[Fraction(x) for x in row.split()] for row in ("0.029187 0.03228 0.0614668", "4.14e-9 6.506e-6 2.293e-4")]
    print("the body with six changes in fold_signs.py:", changes(*known))
    random.seed(int(sys.argv[1]))
    for exists in (True, False):
        counts = Counter()
        for _ in range(int(sys.argv[2])):
            counts[changes(*([Fraction(x).limit_denominator(10**12) for x in row] for row in body(exists)))] += 1
        print("bodies that exist" if exists else "all A > 0", sorted(counts.items()))
