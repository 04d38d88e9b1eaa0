"""Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body.

A body is given by its principal moments A and its centre of mass r. All answers at energy h and vertical angular momentum l
are computed from exact numbers.

Examples
--------
>>> import bifdiag
>>> body = bifdiag.Body.preset("paper")
>>> atlas = body.atlas()
>>> [region.signature for region in atlas.regions][:3]
['S2', 'T2', 'M2']
"""

from ._core import __version__
from .atlas import Atlas
from .atlas_document import verify
from .body import Body, bodies
from .chaos import ChaosMap
from .critical import Equilibria
from .critical_spins import CriticalSpins, SpinBounds, SpinRanges
from .errors import BifdiagError, BodyError, BodyWarning, InputError, RangeError, VerifyError
from .motion import Motion
from .periodic import PeriodicFamily, PeriodicOrbits
from .points import Classifications
from .proved import ProvedMotion
from .records import (
    Candidate,
    Cell,
    ChaosPoint,
    ChaosShare,
    Classification,
    Component,
    Curve,
    Enclosure,
    Event,
    Friction,
    Margin,
    Neighbour,
    Nonlinear,
    Region,
    Resonances,
    Sample,
    StabilityChange,
    StabilitySpan,
    Tail,
    VerdictChange,
)
from .scan_rows import Scan
from .scans import merge, scan
from .search import Witness, find
from .section import Section
from .units import Units

__all__ = [
    "Atlas",
    "BifdiagError",
    "Body",
    "BodyError",
    "BodyWarning",
    "Candidate",
    "Cell",
    "ChaosMap",
    "ChaosPoint",
    "ChaosShare",
    "Classification",
    "Classifications",
    "Component",
    "CriticalSpins",
    "Curve",
    "Enclosure",
    "Equilibria",
    "Event",
    "Friction",
    "InputError",
    "Margin",
    "Motion",
    "Neighbour",
    "Nonlinear",
    "PeriodicFamily",
    "PeriodicOrbits",
    "ProvedMotion",
    "RangeError",
    "Region",
    "Resonances",
    "Sample",
    "Scan",
    "Section",
    "SpinBounds",
    "SpinRanges",
    "StabilityChange",
    "StabilitySpan",
    "Tail",
    "Units",
    "VerdictChange",
    "VerifyError",
    "Witness",
    "__version__",
    "bodies",
    "find",
    "merge",
    "scan",
    "verify",
]
