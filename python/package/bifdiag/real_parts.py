"""Real parts as bodies."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any, Literal, TypeVar

from . import _core, exact
from .errors import InputError
from .exact import Number
from .given import Given

AnyBody = TypeVar("AnyBody", bound="RealParts")


class RealParts(Given):
    """Bodies from tensors and files of parts."""

    __slots__ = ()

    @classmethod
    def _of(cls: type[AnyBody], inner: _core.Body) -> AnyBody:
        body = cls.__new__(cls)
        body._inner, body._given, body._source = inner, (), None
        return body

    @classmethod
    def from_inertia(
        cls: type[AnyBody],
        tensor: Iterable[Iterable[Number]],
        com: Iterable[Number],
        mass: Number,
        g: Number = "9.80665",
        about: Literal["fixed point", "centre of mass"] = "fixed point",
        *,
        units: str = "kg,m,s",
        unphysical: bool = False,
    ) -> AnyBody:
        """A real part from its tensor of inertia, which is kept exactly, without rounding.

        Parameters
        ----------
        tensor : 3 × 3 numbers
            The symmetric matrix itself, with Ixy = −∫ x y dm off the diagonal. Products of inertia printed as +∫ x y dm
            must change sign.
        com, mass : three numbers, and one
            Centre of mass, from the fixed point, in the axes of the tensor; mass.
        g : number
            Acceleration of gravity, in m/s² whatever the units are, or a text with its unit.
        about : {"fixed point", "centre of mass"}
            The reference point of the tensor.
        units : str
            Units of mass, length and time of all inputs and results, such as ``"g,mm,s"``. Any number may also be a text
            with its own unit, ``"250 g"``, and with what it is known to, ``"1.2±0.01"``, ``"1.2+-1%"``: `critical_spin`.
        unphysical : bool
            Accept an unphysical part, which no mass distribution can have.
        """
        if about not in ("fixed point", "centre of mass"):
            raise InputError(f'about = {about!r}: the points are "fixed point" and "centre of mass"')
        rows = [exact.triple(row, f"tensor[{place}]") for place, row in enumerate(tensor)]
        if len(rows) != 3:
            raise InputError(f"tensor needs three rows, {len(rows)} given")
        place, weight, gravity = exact.triple(com, "com"), exact.text(mass, "mass"), exact.text(g, "g")
        arguments = (rows, place, weight, gravity, about == "centre of mass", units, unphysical)
        upper = [_told_entry(rows[i][k], rows[k][i]) for i, k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        option = "--inertia-com" if about == "centre of mass" else "--inertia"
        moments, lengths = (_in_units(texts, of_length, units) for texts, of_length in ((upper, False), (place, True)))
        given = [f"{option}={moments}", "--products=tensor", f"--com={lengths}", f"--mass={weight}"]
        given += [f"--g={gravity}", f"--units={units}", *(["--unphysical"] if unphysical else [])]
        return cls._of_part(("body_of_tensor", arguments), tuple(given))

    @classmethod
    def from_part(
        cls: type[AnyBody],
        path: str | os.PathLike[str],
        *,
        density: Number | None = None,
        mass: Number | None = None,
        link: str | None = None,
        pivot: Iterable[Number] = (0, 0, 0),
        g: Number = "9.80665",
        units: str | None = None,
        unphysical: bool = False,
    ) -> AnyBody:
        """A real part from a file.

        Parameters
        ----------
        path : path
            A mesh (``.stl``, ``.obj``, ``.ply``) or an inertial block (``.urdf``, MJCF ``.xml``).
        density, mass : number, optional
            One of the two for a mesh, in `units`, or with its own: ``"2.7 g/cm3"``.
        link : str, optional
            Which link of a ``.urdf`` or ``.xml``.
        pivot : three numbers
            The fixed point, in the file's frame; ``"10±0.2 mm"`` is understood, too.
        units : str, optional
            Units of mass, length and time, such as ``"kg,mm,s"``: of a mesh and of all results.
        g, unphysical
            As in `from_inertia`.
        """
        with open(path, "rb"):
            pass
        weight = [
            None if value is None else exact.text(value, name) for name, value in (("density", density), ("mass", mass))
        ]
        place, gravity = exact.triple(pivot, "pivot"), exact.text(g, "g")
        absolute = os.path.abspath(path)
        arguments = (absolute, weight, link, place, gravity, units, unphysical)
        named = [("density", weight[0]), ("mass", weight[1]), ("link", link), ("units", units)]
        options = [f"--{name}={value}" for name, value in named if value is not None]
        given = [f"--part={absolute}", *options, f"--pivot={_in_units(place, True, units)}", f"--g={gravity}"]
        return cls._of_part(("body_of_file", arguments), (*given, *(["--unphysical"] if unphysical else [])))

    @classmethod
    def _of_part(cls: type[AnyBody], source: tuple[str, tuple[Any, ...]], given: tuple[str, ...]) -> AnyBody:
        make, arguments = source
        body = cls._of(getattr(_core, make)(*arguments))
        body._given, body._source = given, source if body.measured else None
        return body

    @classmethod
    def _of_document(cls: type[AnyBody], document: dict[str, Any]) -> AnyBody:
        """The body of the block ``body`` of a document."""
        part = document.get("part")
        if part is None:
            return cls._of(_core.Body(document["A"], document["r"]))
        return cls.from_inertia(
            part["inertia"], part["com"], part["mass"], part["g"], units=part["units"], unphysical=not part["physical"]
        )


def _in_units(texts: Iterable[str], of_length: bool, units: str | None) -> str:
    """Numbers of one option, in which a unit behind the last would be that of all."""
    given = [*texts]
    have_units = any(sign.isalpha() and sign not in "eE" for text in given for sign in text)
    return ",".join(_core.in_units(given, of_length, units) if have_units else given)


def _told_entry(above: str, below: str) -> str:
    """Of two equal entries of a tensor that with ±."""
    return below if any(sign in below for sign in ("±", "+-", "+/-")) else above
