"""Searches for bodies and points with a given property."""

import json
from dataclasses import dataclass, field

from . import _core, exact
from .behaviour import Document
from .body import Body
from .diagrams import Accuracy
from .errors import InputError
from .records import Component, Margin
from .units import ExactPoint


@dataclass(frozen=True, slots=True)
class Witness:
    """The result of a search.

    Attributes
    ----------
    found : bool
        Whether a body with the property was found.
    exists : bool or None
        False if a theorem excludes it; `why` names the theorem.
    why : str or None
        The theorem.
    body : Body or None
        The body.
    h, l : float or None
        The point, rounded.
    exact : ExactPoint or None
        The point as texts that have it exactly: ``witness.exact.h``.
    components : tuple of Component
        The components of U there.
    margin : Margin or None
        The distance to the nearest curve.
    tried : int
        Number of bodies tried; 0 also if the answer was known.
    document : dict
        Everything that the command line prints with ``--json``.
    """

    found: bool
    exists: bool | None
    why: str | None
    body: Body | None
    h: float | None
    l: float | None
    exact: ExactPoint | None
    components: tuple[Component, ...]
    margin: Margin | None
    tried: int
    document: Document = field(repr=False)

    @classmethod
    def _of(cls, document: Document) -> "Witness":
        there = document.get("witness") or document
        found = document["found"]
        return cls(
            found,
            document.get("exists"),
            document.get("why"),
            Body._of_document(there) if found else None,
            float(exact.value(there["h"])) if found else None,
            float(exact.value(there["l"])) if found else None,
            ExactPoint(there["h"], there["l"]) if found else None,
            tuple(map(Component._of, there["components"])) if found else (),
            Margin._of(there["margin"]) if found else None,
            document["tried"],
            document,
        )

    def __bool__(self) -> bool:
        return self.found


def find(
    kind: str | None = None,
    *,
    circles: int | None = None,
    poles: int | None = None,
    signature: str | None = None,
    critical_points: int | None = None,
    physical: bool = False,
    samples: int = 20_000,
    seed: int | None = None,
    accuracy: Accuracy = "exact",
    threads: int | None = None,
) -> Witness:
    """Searches for a body and a point with a given property.

    Parameters
    ----------
    kind : str, optional
        A component by its section, such as ``"M4"``, or by circles and poles, such as ``"k3n1"``.
    circles, poles : int, optional
        Boundary circles and poles of a component of U.
    signature : str, optional
        The sections of a region, such as ``"S2+T2"``, in any order.
    critical_points : int, optional
        At least this number of isolated relative equilibria at one l, from 3 on.
    physical : bool
        Only physical bodies: A_i + A_j > A_k, or equality and r_k = 0 (see `Body.physical`).
    samples : int
        Largest number of bodies tried.
    seed : int, optional
        Seed of the sequence of bodies; searches even if an answer is known.
    accuracy : {"exact", "fast"}
        Accuracy of the answer.
    threads : int, optional
        None: one; 0: one per core. The answer does not depend on it.

    Returns
    -------
    Witness
        True if found.

    Raises
    ------
    InputError
        If no property, or an unknown one, is given.

    Examples
    --------
    >>> import bifdiag
    >>> witness = bifdiag.find("M4")
    >>> witness.body.classify(*witness.exact).status
    'regular'
    >>> bifdiag.find("k0n1").exists
    False
    """
    given = [kind is not None, circles is not None or poles is not None, signature is not None]
    given.append(critical_points is not None)
    if sum(given) != 1:
        raise InputError("say what is sought by one of kind, circles and poles, signature, critical_points")
    wanted = {
        "kind": kind,
        "circles": None if circles is None else exact.whole(circles, "circles", 0, 2**32 - 1),
        "poles": None if poles is None else exact.whole(poles, "poles", 0, 2),
        "signature": signature,
        "critical_points": None if critical_points is None else exact.whole(critical_points, "critical_points", 3, 99),
    }
    found = _core.find(
        wanted,
        bool(physical),
        exact.whole(samples, "samples", 1),
        None if seed is None else exact.whole(seed, "seed", 0),
        accuracy,
        exact.threads(threads),
    )
    return Witness._of(json.loads(found))
