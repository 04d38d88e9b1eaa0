"""What can go wrong."""


class BifdiagError(Exception):
    """Anything that this package raises on purpose."""


class InputError(BifdiagError, ValueError):
    """Something that the caller gave is wrong: the message names it and says what would be right."""


class BodyError(InputError):
    """Moments and centre of mass that are no body."""


class RangeError(BifdiagError, ArithmeticError):
    """A right question that cannot be answered."""


class VerifyError(BifdiagError):
    """A document that says something wrong, or something that could not be confirmed."""


class BodyWarning(UserWarning):
    """No distribution of mass has these moments and this centre of mass; the answers are those of the equations.

    It needs A_i + A_j > A_k, or equality and r_k = 0.
    """
