"""Exceptions and warnings."""


class BifdiagError(Exception):
    """Base class of the exceptions of this package."""


class InputError(BifdiagError, ValueError):
    """Invalid input. The message names it and, where it is not plain, says what is valid."""


class BodyError(InputError):
    """Moments and centre of mass that do not define a body."""


class RangeError(BifdiagError, ArithmeticError):
    """A valid question that cannot be answered."""


class VerifyError(BifdiagError):
    """A document with an item that is wrong or could not be confirmed."""


class BodyWarning(UserWarning):
    """No distribution of mass can have these moments and this centre of mass. Answers are those of the equations.

    It needs A_i + A_j > A_k, or equality and r_k = 0.
    """
