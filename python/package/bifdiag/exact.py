"""Numbers as they are meant: texts that name them exactly, and arrays of doubles where those suffice."""

import numbers
import operator
from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np

from .errors import InputError

Number: TypeAlias = int | str | Fraction | Decimal | float
"""What may stand for a number: an int, a str, a Fraction and a Decimal are taken as they are, a float as its shortest
decimal, so that ``0.1`` is one tenth."""

LARGEST_WHOLE = 2**53
"""Whole numbers up to this are doubles."""


LARGEST = 1e150
"""Numbers beyond this, and below its inverse, are refused."""


def text(value: Any, name: str) -> str:
    """The exact text of a number.

    Raises
    ------
    InputError
        For what is no number, and for NaN and infinities.
    """
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise InputError(f"{name} is masked; a number is needed")
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item() if value.dtype != np.float32 else value[()]
    match value:
        case bool() | np.bool_():
            raise InputError(f"{name} = {value} is a bool; a number is needed")
        case str():
            if not value.strip():
                raise InputError(f"{name} is an empty text; a number is needed")
            return value
        case np.floating() if not isinstance(value, float):
            out = str(value)
        case float():
            out = float.__repr__(value)
        case Decimal():
            out = str(value)
        case numbers.Rational():
            out = (
                f"{int(value.numerator)}" if value.denominator == 1 else f"{int(value.numerator)}/{int(value.denominator)}"
            )
        case _:
            raise InputError(
                f"{name} = {value!r} is a {type(value).__name__}; give an int, a float, a Fraction, a Decimal or a str "
                'such as "11/10"'
            )
    if not any(digit in out for digit in "0123456789"):
        raise InputError(f"{name} = {value} is not finite; a finite number is needed")
    return out


def value(text: str) -> Fraction:
    """The value of a text that the core has read, such as ``"1.1/2"``."""
    numerator, _, denominator = text.partition("/")
    return Fraction(numerator) / Fraction(denominator or 1)


def triple(values: Any, name: str) -> tuple[str, str, str]:
    """The exact texts of three numbers."""
    if isinstance(values, (str, set, frozenset, dict)) or not isinstance(values, Iterable):
        raise InputError(f"{name} = {values!r}: three numbers are needed, such as [2, 1.1, 1]")
    texts = [text(value, f"{name}{place}") for place, value in enumerate(values, 1)]
    if len(texts) != 3:
        raise InputError(f"{name} needs three numbers, {len(texts)} given")
    return texts[0], texts[1], texts[2]


def doubles(values: Any, name: str, *, check: bool = True) -> np.ndarray | None:
    """An array of doubles each of which means the number that was given, by its shortest decimal; None if some number is
    no such double.

    Raises
    ------
    InputError
        For what is no number, and, if they are to be checked, for numbers that are not finite or out of range.
    """
    masked = np.ma.getmaskarray(values) if check and isinstance(values, np.ma.MaskedArray) else None
    if masked is not None and masked.any():
        first = ", ".join(str(place) for place in np.argwhere(masked)[0])
        raise InputError(f"{name}[{first}] is masked; leave masked numbers out: {name}.compressed()")
    array = np.asarray(values)
    match array.dtype.kind:
        case "f" if array.dtype.itemsize > 8:
            raise InputError(f"{name} has the dtype {array.dtype}; give float64, or an array of str or Fraction")
        case "f" if array.dtype.itemsize < 8:
            # The shortest decimal of a shorter float.
            array = array.astype("U").astype(np.float64)
        case "i" | "u":
            if array.size and (array.max() > LARGEST_WHOLE or array.min() < -LARGEST_WHOLE):
                return None
            array = array.astype(np.float64)
        case "O" | "U" | "T":
            return None
        case "f":
            pass
        case _:
            raise InputError(f"{name} has the dtype {array.dtype}; numbers are needed")
    if check and not usable(array).all():
        where = tuple(int(place) for place in np.argwhere(~usable(array))[0])
        entry = f"{name}[{', '.join(map(str, where))}]" if where else name
        if not np.isfinite(array[where]):
            raise InputError(f"{entry} = {array[where]} is not finite; finite numbers are needed")
        raise InputError(f"{entry} = {array[where]} is out of range; use units in which it lies between 1e-150 and 1e150")
    return array


def usable(array: np.ndarray) -> np.ndarray:
    """Which doubles are finite and in range."""
    size = np.abs(array)
    found: np.ndarray = (size == 0) | ((size >= 1 / LARGEST) & (size <= LARGEST))
    return found


def threads(count: int | None) -> int:
    """The number of threads: None means one, 0 as many as there are cores."""
    if count is None:
        return 1
    return whole(count, "threads", 0)


def whole(value: Any, name: str, least: int, most: int = 2**53) -> int:
    """A whole number in a range."""
    try:
        number = operator.index(value)
    except TypeError:
        number = None
    if number is None or isinstance(value, bool) or not least <= number <= most:
        raise InputError(f"{name} = {value!r}: a whole number from {least} to {most} is needed")
    return number


def real(value: Any, name: str) -> float:
    """A finite float."""
    found = vector([value], name, 1)
    return float(found[0])


def span(values: Any, name: str) -> tuple[float, float]:
    """A range of finite floats whose ends differ."""
    low, high = map(float, vector(values, name, 2))
    if not low < high:
        raise InputError(f"{name} = {values!r}: a range (from, to) with from < to is needed")
    return low, high


def unmasked(values: Any, name: str) -> None:
    """Refuses what is masked, whose number means nothing.

    Raises
    ------
    InputError
        If an entry is masked: the message says which.
    """
    if isinstance(values, np.ma.MaskedArray):
        mask = np.ma.getmaskarray(values)
    elif isinstance(values, list | tuple):
        mask = np.array([isinstance(entry, np.ma.MaskedArray) and np.ma.is_masked(entry) for entry in values])
    else:
        return
    if mask.any():
        where = ", ".join(str(place) for place in np.argwhere(mask)[0])
        raise InputError(f"{name}{f'[{where}]' if where else ''} is masked; a number is needed")


def floats(values: Any, name: str) -> np.ndarray:
    """Numbers as floats; a text such as ``"1/3"`` is rounded."""
    unmasked(values, name)
    try:
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        pass
    try:
        given = np.asarray(values, dtype=object)
    except ValueError as error:
        raise InputError(f"{name} = {values!r}: {error}") from error
    rounded = []
    for entry in given.flat:
        told = text(entry, name)
        try:
            rounded.append(float(value(told)))
        except (ValueError, ArithmeticError) as error:
            raise InputError(f"{name}: {entry!r} is not a number") from error
    return np.array(rounded, dtype=np.float64).reshape(given.shape)


def vector(values: Any, name: str, length: int) -> np.ndarray:
    """So many finite floats."""
    array = floats(values, name)
    if array.shape != (length,):
        raise InputError(f"{name} has the shape {array.shape}; {length} numbers are needed")
    if not np.isfinite(array).all():
        raise InputError(f"{name} = {values!r} is not finite")
    return array
