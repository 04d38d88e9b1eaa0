"""Pictures with matplotlib; the user's style sheets apply."""

from .chaos import chaos
from .diagram import diagram
from .family import family
from .plane import plane
from .section import VERDICTS, section
from .space import body, motion, sphere

__all__ = ["VERDICTS", "body", "chaos", "diagram", "family", "motion", "plane", "section", "sphere"]
