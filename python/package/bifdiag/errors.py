"""What can go wrong."""


class BifdiagError(Exception):
    """Anything that this package raises on purpose."""


class InputError(BifdiagError, ValueError):
    """Something that the caller gave is wrong: the message says what would be right."""


class BodyError(InputError):
    """Moments and centre of mass that are not a body."""


class RangeError(BifdiagError, ArithmeticError):
    """A right question that cannot be answered."""
