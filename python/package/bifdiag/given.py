"""A body as it was given: its numbers, exactly and as floats."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from . import _core, exact
from .behaviour import table
from .errors import InputError
from .units import Exact, Units

if TYPE_CHECKING:
    from .body import Body


class Concise(type):
    """Keeps ``help(Body)`` to two screens: the text of the class has a line for each question, their own help the rest.

    `help` describes what `dir` of a class lists. As that of an enum, it leaves out what only instances have; `dir` of a
    body is complete.
    """

    def __dir__(cls) -> list[str]:
        return [name for name in super().__dir__() if not cls._is_of_instances(name)]

    def _is_of_instances(cls, name: str) -> bool:
        if name == "__annotations__":
            return True
        found = inspect.getattr_static(cls, name)
        function = found.fget if isinstance(found, property) else found
        return inspect.isfunction(function) and function.__module__.startswith(f"{__package__}.")


class Given(metaclass=Concise):
    """The numbers of a body; `Body` asks questions of them."""

    __slots__ = ("_given", "_inner", "_source")
    _inner: _core.Body
    # The options of the command line for a part, as it was given.
    _given: tuple[str, ...]
    # What made a part with ±, to make it again: a function of the compiled part, and its arguments.
    _source: tuple[str, tuple[Any, ...]] | None
    # Makes the body of a document. The module of bodies sets it, which comes after all that has a body.
    _made_of: ClassVar[Callable[[dict[str, Any]], Body]]

    def _exactly(self) -> _core.Body:
        """The compiled body, unless its numbers are known to within so much only."""
        if self._inner.measured():
            raise InputError(
                "this part has numbers with ±, for which only critical_spin answers; leave out ± and the number after it"
            )
        return self._inner

    def _options(self) -> tuple[str, ...]:
        """The body as options of the command line."""
        return self._given or (f"--A={','.join(self.A)}", f"--r={','.join(self.r)}")

    @property
    def part(self) -> dict[str, Any] | None:
        """The real part as understood, in the form of the block ``part`` of the documents; None for other bodies."""
        text = self._inner.part()
        return None if text is None else json.loads(text)

    @property
    def physical(self) -> bool:
        """Whether a distribution of mass can have these moments and this centre of mass.

        It needs A_i + A_j > A_k, or equality and r_k = 0; for a part, about its centre of mass. If False, the
        equations hold all the same.
        """
        return self._inner.physical()

    @property
    def measured(self) -> bool:
        """Whether some number of the part is known to within so much only, as ``"1.2±0.01"``.

        `moments`, `com`, `part` are then those of the nominal numbers, and only `critical_spin` answers questions.
        """
        return self._inner.measured()

    @property
    def moments(self) -> npt.NDArray[np.float64]:
        """The principal moments of inertia A as floats."""
        return _floats(self.A)

    @property
    def com(self) -> npt.NDArray[np.float64]:
        """The centre of mass from the fixed point in principal axes, as floats: r/`weight`.

        Of a part in its unit of length, and 0 if g is 0 (`part` has its place then); of any other body r itself.
        """
        return _floats(self.r) / self.weight if self.weight else _floats(self.r)

    @property
    def weight(self) -> float:
        """M g of a part, in its units; of any other body 1, since r contains m g."""
        part, units = self.part, self.units
        if part is None or units is None:
            return 1.0
        return float(exact.value(part["mass"]) * exact.value(part["g"])) * units.time**2 / units.length

    @property
    def units(self) -> Units | None:
        """The units of a part and of its results, as factors to SI units; None for other bodies, whose units are free."""
        part, scales = self.part, self._inner.scales()
        return None if part is None or scales is None else Units(part["units"], *scales)

    @property
    def exact(self) -> Exact:
        """The texts of A and r, ``body.exact.A``: exact, but of a part rounded where ``part["exact"]`` is False."""
        return Exact(self.A, self.r)

    @property
    def A(self) -> tuple[str, str, str]:
        """The principal moments as given, exact texts; `moments` are floats."""
        first, second, third = self._inner.moments
        return first, second, third

    @property
    def r(self) -> tuple[str, str, str]:
        """The centre of mass times m g as given, exact texts."""
        first, second, third = self._inner.center
        return first, second, third

    # Equal bodies have equal numbers, whatever their texts; with ± they are those that are given alike.
    def _identity(self) -> tuple[Any, ...]:
        return tuple(self._inner.values()), self._given if self.measured else ()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Given) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def _told(self) -> tuple[str, str]:
        """A and r, to read: of a part, whose texts have many digits, as doubles; the rest loses nothing."""

        def told(texts: tuple[str, ...]) -> str:
            return ", ".join(texts if self.part is None else [repr(float(exact.value(text))) for text in texts])

        return told(self.A), told(self.r)

    def __repr__(self) -> str:
        moments, center = self._told()
        if self.part is None:
            return f"Body(A=[{moments}], r=[{center}])"
        if self.measured:
            return (
                f"Body of a part with ±, nominally in {self.part['units']}: A = [{moments}], r = [{center}] [critical_spin]"
            )
        return f"Body of a part in {self.part['units']}: A = [{moments}], r = [{center}] [A, r, part have all digits]"

    def _repr_html_(self) -> str:
        moments, center = self._told()
        return table([("A", moments), ("r", center), *([("units", self.part["units"])] if self.part else [])])


def body_of(document: dict[str, Any]) -> Body:
    """The body of a document."""
    return Given._made_of(document)


def _floats(texts: Iterable[str]) -> npt.NDArray[np.float64]:
    return np.array([float(exact.value(text)) for text in texts])
