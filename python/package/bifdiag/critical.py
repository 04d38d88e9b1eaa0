"""Relative equilibria as structured arrays."""

import json
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core, exact

FIELDS = [
    ("l", "f8"),
    ("h", "f8"),
    ("gamma", "f8", (3,)),
    ("omega", "f8"),
    ("index", "i1"),
    ("multiplicity", "U6"),
    ("stability", "U15"),
    ("stable", "?"),
    ("stable_by", "U13"),
    ("verdict", "U8"),
    ("survives_friction", "?"),
    ("eigenvalues", "c16", (2,)),
    ("eigenvalue_error", "f8"),
    ("branch", "U16"),
    ("branch_name", "U48"),
]


def equilibria(body: _core.Body, l: Any) -> npt.NDArray[np.void]:
    """The relative equilibria at one l, or at each of an array."""
    momenta = np.asarray(l, dtype=object)
    rows = [row for place, momentum in enumerate(momenta.flat) for row in _rows(body, place, momentum)]
    if momenta.ndim == 0:
        return np.array([row[1:] for row in rows], dtype=FIELDS)
    return np.array(rows, dtype=[("l_index", "i8"), *FIELDS])


def _rows(body: _core.Body, place: int, momentum: Any) -> list[tuple[Any, ...]]:
    text = exact.text(momentum, "l")
    return [
        (
            place,
            float(exact.value(text)),
            found["h"],
            found["gamma"],
            found["omega"],
            found["index"],
            str(found["multiplicity"]),
            found["stability"],
            found["nonlinear"]["verdict"] == "stable",
            found["nonlinear"]["why"],
            found["nonlinear"]["verdict"],
            found["friction"]["conserving_l"] == "survives",
            [complex(*value) for value in found["eigenvalues"]],
            found["eigenvalue_error"],
            found["branch"],
            found["branch_name"],
        )
        for found in json.loads(body.critical(text))["critical"]
    ]
