"""Bifurcation diagrams and energy-surface topology of any heavy rigid body."""

from ._core import Atlas, Body, Classification, Component, Equilibrium, Region, __version__
from .errors import BifdiagError, BodyError, InputError, RangeError

__all__ = [
    "Atlas",
    "BifdiagError",
    "Body",
    "BodyError",
    "Classification",
    "Component",
    "Equilibrium",
    "InputError",
    "RangeError",
    "Region",
    "__version__",
]
