"""The heavy-top benchmark: 24 tops in SI units, where they are at 200 times with a proved bound, and a scorer of engines.

The truth is `Body.orbit` with ``proved=True``: no small step of an integrator is trusted. Gravity is 9.81 m/s² along −z of
the world; the body's frame has its origin at the fixed point and principal axes; quaternions w, x, y, z take vectors of the
body to the world; angular velocities are in the body's axes, rad/s. An engine is a function
``engine(model, q0, omega0, times, step)`` that returns a pair (q, omega) for each time; `Model` says of what.

Examples
--------
>>> from bifdiag import benchmark
>>> truth = benchmark.truth(benchmark.top("lagrange-nodding"))
>>> truth.q.shape, truth.bound < 1e-12
((201, 4), True)
"""

from .proof import Truth, truth
from .scorer import Engine, Score, order, score
from .table import Model, Top, top, tops

__all__ = ["Engine", "Model", "Score", "Top", "Truth", "order", "score", "top", "tops", "truth"]
