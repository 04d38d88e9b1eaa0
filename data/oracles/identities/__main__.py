"""Checks the identities of docs/mathematics.md and docs/algorithms.md: pip install sympy mpmath; python3 identities

One line for each statement; exit status 1 if one fails. Identities between rational functions are checked symbolically
(sympy), those on the 6×6 matrix of 13.1 in exact arithmetic at random rational points, at which a wrong one would hold
with a probability below 1e-50. Square roots are avoided by taking the critical point as given, γ rational on the sphere,
and r = s(μ − A)γ. What is no identity is checked in 40 digits to 1e-25 (limits: to their order); what is a count of real
roots, is exact isolation in rational arithmetic. Lemma 11.6 is sampled besides.
"""
import sys
import time
import traceback

# Their checks enter the list in this order.
import critical_set  # noqa: F401
import curves  # noqa: F401
import events  # noqa: F401
import topology  # noqa: F401
import tenth_type  # noqa: F401
import sections  # noqa: F401
import linear  # noqa: F401
import determinant  # noqa: F401
import examples  # noqa: F401
from common import CHECKS


def main():
    failed = 0
    for statements, function in CHECKS:
        begin = time.monotonic()
        try:
            function()
            verdict = "ok"
        except Exception:
            traceback.print_exc()
            failed += 1
            verdict = "FAILED"
        for statement in statements:
            print(f"{statement}: {verdict} ({time.monotonic() - begin:.1f} s)", flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
