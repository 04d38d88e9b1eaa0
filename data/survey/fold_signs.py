"""Changes of sign in the polynomial of the folds on G0: python3 fold_signs.py SEED BODIES

With y = A1 - mu > 0, d_i = A_i - mu and t = -mu = y - A1 the folds of x(mu) for mu < A1 are the positive zeros y of
    (d1 d2 d3)^5 [ sum_i r_i^4 A_i / d_i^5 + sum_{i<j} r_i^2 r_j^2 (2 A_i A_j - 3 (A_i - A_j)^2 + t (A_i + A_j)) / (d_i d_j)^3 ],
of degree 10. By Descartes' rule they are at most as many as its coefficients change their sign. Printed: how many bodies have
how many changes, for bodies that exist and for all A > 0, and a body with the most.
"""

import math
import random
import sys
from collections import Counter


def product(*factors):
    found = [1]
    for factor in factors:
        longer = [0] * (len(found) + len(factor) - 1)
        for i, x in enumerate(found):
            for j, y in enumerate(factor):
                longer[i + j] += x * y
        found = longer
    return found


def changes(a, square):
    """`square` holds the r_i^2."""
    d = [[x - a[0], 1] for x in a]
    total = [0] * 11
    for i in range(3):
        j, k = (n for n in range(3) if n != i)
        for n, c in enumerate(product(*[d[j]] * 5, *[d[k]] * 5)):
            total[n] += square[i] ** 2 * a[i] * c
        line = [2 * a[j] * a[k] - 3 * (a[j] - a[k]) ** 2 - a[0] * (a[j] + a[k]), a[j] + a[k]]
        for n, c in enumerate(product(*[d[j]] * 2, *[d[k]] * 2, *[d[i]] * 5, line)):
            total[n] += square[j] * square[k] * c
    signs = [c > 0 for c in total if c != 0]
    return sum(p != q for p, q in zip(signs, signs[1:]))


def body(exists):
    while True:
        a = sorted(math.exp(random.uniform(-4, 0)) if random.random() < 0.5 else random.random() for _ in range(3))
        if random.random() < 0.4:
            a[1] = a[0] + (a[2] - a[0]) * math.exp(random.uniform(-8, 0))
        if exists and random.random() < 0.5:
            a[2] = a[0] + a[1]
        if 0 < a[0] < a[1] < a[2] and (not exists or a[2] <= a[0] + a[1]):
            return a, [math.exp(random.uniform(-20, 0)) for _ in range(3)]


if __name__ == "__main__":
    random.seed(int(sys.argv[1]))
    for exists in (True, False):
        counts, most = Counter(), (-1, None)
        for _ in range(int(sys.argv[2])):
            found = body(exists)
            number = changes(*found)
            counts[number] += 1
            most = max(most, (number, found))
        print("bodies that exist" if exists else "all A > 0", sorted(counts.items()), "most at A =", most[1][0], "r^2 =", most[1][1])
