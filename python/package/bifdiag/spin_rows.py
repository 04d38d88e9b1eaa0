"""The rows of tables of critical spins, out of the document of the command."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

Document = dict[str, Any]

STABLE = {"stable": True, "unstable": False}
"""Verdicts; every other one is open."""

SURVIVES = {"survives": True, "lost": False}
"""What friction leaves."""


@dataclass
class Range:
    """A range of spins of one type; what `SpinRanges` has of it."""

    up: str
    family: int
    branch: str
    axis: list[float]
    start: Document | None
    rpm: tuple[float, float]
    stability: str
    stable: bool | None
    stable_by: str
    survives: bool | None
    isolated: list[Document] | None
    # What begins the range: "fold", "fork", or of eigenvalues; nothing where `changes` say it.
    event: str
    # The axis changes with the spin.
    moves: bool
    # The type below.
    below: "Range | None"

    def row(self) -> Document:
        count = -1 if self.isolated is None else len(self.isolated)
        row: Document = {"up": self.up, "family": self.family, "branch": self.branch, "axis_up": self.axis}
        row |= {"rpm_from": self.rpm[0], "rpm_to": self.rpm[1]}
        row |= {"stability": self.stability, "stable": self.stable, "stable_by": self.stable_by}
        return row | {"survives_friction": self.survives, "isolated": count}


def ranges(document: Document) -> Iterator[Range]:
    """The ranges of a given axis that is permanent, else of families."""
    for one in document.get("stretches", ()):
        ends = (one["from"] or {"rpm": 0.0})["rpm"], (one["to"] or {"rpm": np.inf})["rpm"]
        nonlinear, axis = one["nonlinear"], _end(document["axis"], one["up"])
        stable, survives = STABLE.get(nonlinear["verdict"]), SURVIVES.get(one["friction"]["conserving_l"])
        known = one["stability"], stable, nonlinear["why"], survives, one["isolated"]
        yield Range(one["up"], -1, "", axis, None, ends, *known, "", False, None)
    is_told = isinstance(document.get("permanent"), list)
    for number, family in enumerate(document.get("families", ())):
        up = ""
        if "axis" in document:
            up = "+axis" if float(np.dot(document["axis"], family["fast_axis"])) > 0 else "-axis"
        before = None
        parts = family["stretches"]
        for place, one in enumerate(parts):
            start = one["from"]
            axis = family["slow_axis"] if start is None else start["axis"]
            after = parts[place + 1]["from"]["spin"]["rpm"] if place + 1 < len(parts) else np.inf
            ends = 0.0 if start is None else start["spin"]["rpm"], after
            # A word says what makes it stable, and "spectrum" that only its eigenvalues are known.
            told = one["stable"] if isinstance(one["stable"], str) else ""
            stable = False if one["stable"] is False else (None if told in ("", "spectrum") else True)
            event = one["change"] or family["start"]
            known = one["stability"], stable, told, None, one["isolated"]
            # What changes along a permanent axis is told with it, where all of them are listed.
            event = "" if family["permanent"] and is_told else event
            before = Range(up, number, family["branch"], axis, start, ends, *known, event, not family["permanent"], before)
            yield before


def changes(document: Document, known: list[Range]) -> Iterator[Document]:
    """The changes of permanent axes."""
    axes = document.get("permanent") if isinstance(document.get("permanent"), list) else [document]
    for permanent in axes or ():
        for up in ("+axis", "-axis"):
            axis = _end(permanent["axis"], up)
            theirs = [change for change in permanent["changes"] if change["up"] == up]
            own = [one for one in known if not one.event and np.dot(one.axis, axis) > 1 - 1e-9]
            # The ranges end where the type changes, and both are by rising spin.
            verdicts = [one.stable for one in own]
            if len(own) != 1 + sum(change["kind"] != "region" for change in theirs):
                verdicts = [None] * (len(theirs) + 1)
            place = 0
            for change in theirs:
                before = verdicts[place]
                place += change["kind"] != "region"
                row: Document = {"up": up if "axis" in document else "", "axis_up": axis}
                row |= {"family": own[0].family if own else -1, "branch": own[0].branch if own else ""}
                row |= change["spin"] | {"l": change["l"], "h": change["h"], "kind": change["kind"]}
                row |= {"event": change["event"] or "", "below": change["from"], "above": change["to"]}
                row |= {"stable_below": before, "stable_above": verdicts[place]}
                yield row | {"verdict": "", "error_bound": change["error_bound"]}


def starts(known: Iterable[Range]) -> Iterator[Document]:
    """Where ranges of families that move begin, but at rest."""
    for one in known:
        if one.start is None or not one.event:
            continue
        below = one.below
        row: Document = {"up": one.up, "family": one.family, "branch": one.branch, "axis_up": one.axis, **one.start["spin"]}
        row |= {"l": one.start["l"], "h": one.start["h"], "kind": "stability" if below else "start", "event": one.event}
        row |= {"below": below.stability if below else "", "above": one.stability}
        row |= {"stable_below": below.stable if below else None, "stable_above": one.stable}
        yield row | {"verdict": "", "error_bound": one.start["error_bound"]}


def isolated(known: Iterable[Range]) -> Iterator[Document]:
    """Spins at which alone the usual conditions of Arnold's theorem fail."""
    nan = float("nan")
    for one in known:
        # Where the axis does not move, its end is that of every spin.
        axis = [nan] * 3 if one.moves else one.axis
        for spin in one.isolated or ():
            row = {
                "up": one.up,
                "family": one.family,
                "branch": one.branch,
                "axis_up": axis,
                **spin["spin"],
                "l": nan,
                "h": nan,
            }
            row |= {"kind": "isolated", "event": spin["kind"], "below": one.stability, "above": one.stability}
            row |= {"stable_below": one.stable, "stable_above": one.stable, "verdict": spin["verdict"]}
            yield row | {"error_bound": nan}


def bounds(ranges: Iterable[Document]) -> Iterator[Document]:
    """What the tolerance does."""
    for one in ranges:
        low, high = one["rpm"]
        row = {"up": one["up"], "below": one["from"], "above": one["to"], "rpm_from": low or 0.0}
        row |= {"rpm_to": np.inf if high is None else high, "between": ", ".join(one["between"])}
        by, widest = one.get("most"), one.get("most_rpm")
        if widest is None:
            widest = np.nan if by is None else np.inf
        yield row | {"widest_by": by, "widest_rpm": widest}


def _end(axis: list[float], up: str) -> list[float]:
    """The end of an axis that is up, without the sign of 0."""
    sign = 1.0 if up == "+axis" else -1.0
    return [sign * x + 0.0 for x in axis]
