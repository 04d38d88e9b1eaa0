"""A program of schema version 2 beside one of version 3: both are asked the same, and compared in what both tell.

What version 3 says in other words, or better, stands here with the reason; everything else must be equal.
"""

import json
import subprocess
from fractions import Fraction
from itertools import permutations

# Answers in prose, of the format itself, or of pictures: of these only the exit status is compared.
PROSE = {"text", "pages", "schema", "help", "command line", "table", "verify", "scan merge", "picture"}

# Presets whose numbers are others in version 3: both programs get those of version 2.
PRESETS = {"lagrange": ["--A=2,1,1", "--r=1,0,0"]}

# Fields that only one of the two has, or words otherwise.
OTHER_WORDS = {
    "certificate",  # each program verifies its own
    "command",
    "lyapunov",  # orbits without a verdict are followed further
    "lyapunov.npy",
    "note",
    "schema_version",
    "sha256",  # of a file of the other version
    "version",
    "view",  # is part of `drawing` now
}

ROUNDINGS = 8 * 2.0**-52


def version(program):
    """The schema version of the documents that a program writes."""
    words = ["classify", "--body", "paper", "--h=1", "--l=1", "--json"]
    return json.loads(subprocess.run([program, *words], capture_output=True, check=True).stdout)["schema_version"]


def command(words):
    """The same command with presets as numbers where these are others now."""
    for name, numbers in PRESETS.items():
        if name in words:
            at = words.index(name)
            return [*words[: at - 1], *numbers, *words[at + 1 :]]
    return words


def common(old, new):
    """Documents of version 2 and 3, each reduced to what both tell in the same words."""
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        pairs = [common(a, b) for a, b in zip(old, new)]
        return [a for a, _ in pairs], [b for _, b in pairs]
    if not (isinstance(old, dict) and isinstance(new, dict)):
        return old, new
    if "error" in old and "error" in new:
        return {}, {}  # the words of a refusal
    if old.get("found") is True and new.get("found") is True:
        return {"found": True}, {"found": True}  # another witness; `README.md` says how these were compared
    if "curves" in old and "regions" in old:
        old, new = without_drawing(old), without_drawing(new)
    if "critical" in old and "critical" in new:
        bounds = old.get("error_bound", 0.0) + new.get("error_bound", 0.0)
        new = {**new, "critical": equilibria(old["critical"], new["critical"], bounds)}
        new["error_bound"] = near(old.get("error_bound"), new.get("error_bound"), ROUNDINGS)
    if "error_bound" in old and "error_bound" in new:
        new = {**new, "error_bound": narrower(old["error_bound"], new["error_bound"])}
    if "margin" in old and "margin" in new:
        new = {**new, "margin": margin(old["margin"], new["margin"])}
    if old.get("kind") == new.get("kind") == "crossing" and "curves" in old and "curves" in new:
        # Curves that cross are in the order of the list of curves now, at cusps and pitchforks too.
        old, new = ({**side, "curves": sorted(side["curves"])} for side in (old, new))
    if "chaos" in old and "chaos" in new:
        # The reason of a verdict names the rate of growth.
        old, new = ({key: value for key, value in side.items() if key != "reason"} for side in (old, new))
    if "plate" in old and "A" in old:
        new = {**new, **flags(old, new)}
    if "candidates" in old and is_free_at_rest(old) and all(entry in new["candidates"] for entry in old["candidates"]):
        # There all curves of a body without weight begin; version 2 left out regions that meet there.
        new = {**new, "candidates": old["candidates"]}
    old, new = ({key: value for key, value in side.items() if key not in OTHER_WORDS} for side in (old, new))
    for key in set(old) & set(new):
        old[key], new[key] = common(old[key], new[key])
    return old, new


def near(old, new, tolerance):
    """The old number if the new one is as near to it as that, relative to its size."""
    numbers = old is not None and new is not None
    return old if numbers and abs(old - new) <= tolerance * max(abs(old), abs(new)) else new


def within(old, new, bound):
    """Likewise, by an absolute bound."""
    return old if abs(old - new) <= bound else new


def narrower(old, new):
    """The old bound if the new one is at most as large."""
    return old if old is not None and new is not None and new <= old else new


def margin(old, new):
    """At l = 0 a pole line ends at a relative equilibrium, which is named now, with a smaller bound."""
    if not (isinstance(old, dict) and isinstance(new, dict)):
        return new
    bounds = old["error_bound"] + new["error_bound"]
    same_place = abs(old["h"] - new["h"]) <= bounds
    return old if same_place and new["error_bound"] <= old["error_bound"] else new


def without_drawing(document):
    """An atlas without outlines and points of its curves, with the widths of regions where version 2 has them."""
    drawing = document.get("drawing")
    widths = {} if drawing is None else {id: region["h_width"] for id, region in drawing["regions"].items()}
    curves = [{key: value for key, value in curve.items() if key != "polyline"} for curve in document["curves"]]
    regions = [
        {"h_width": widths.get(region["id"]), **{key: value for key, value in region.items() if key != "polygon"}}
        for region in document["regions"]
    ]
    rest = {key: value for key, value in document.items() if key != "drawing"}
    return {**rest, "curves": curves, "regions": regions}


def equilibria(old, new, bound):
    """The new entries, with the old values of those fields that agree within the errors that both programs state.

    Values of nearly degenerate bodies come from enclosures of more bits now, and some are rounded in another order.
    Of fast rotations h keeps no digit of what the weight adds, by which they are sorted now.
    """
    if len(old) != len(new):
        return new
    new = list(new)
    for place, entry in enumerate(old):
        # The entry that stands for the same point, of those whose h is not told apart from that of this place.
        same = (
            other
            for other in range(place, len(new))
            if abs(new[other]["h"] - entry["h"]) <= bound
            and new[other]["branch"] == entry["branch"]
            and all(abs(p - q) <= ROUNDINGS for p, q in zip(new[other]["gamma"], entry["gamma"]))
        )
        new.insert(place, new.pop(next(same, place)))
    return [equilibrium(*pair, bound) for pair in zip(old, new)]


def equilibrium(old, new, bound):
    errors = old["eigenvalue_error"] + new["eigenvalue_error"]
    pairs = zip(old["eigenvalues"], new["eigenvalues"])
    narrower = new["eigenvalue_error"] <= old["eigenvalue_error"]
    return {
        **new,
        "h": within(old["h"], new["h"], bound),
        "gamma": [within(*pair, ROUNDINGS) for pair in zip(old["gamma"], new["gamma"])],
        "omega": near(old["omega"], new["omega"], ROUNDINGS),
        "eigenvalues": [[within(*pair, errors) for pair in zip(*values)] for values in pairs],
        "eigenvalue_error": old["eigenvalue_error"] if narrower else new["eigenvalue_error"],
        "stable": stable(old["stable"], new),
    }


def stable(old, new):
    """What was left to the normal form, or at a degenerate point open, has a verdict now, with its reason."""
    why = new["nonlinear"]["why"]
    error = new["nonlinear"]["D4_error"]
    if old == "spectrum" and new["stable"] == "arnold" and why == "arnold":
        return old if abs(new["nonlinear"]["D4_over_s"]) > error else "arnold, but D4 may be 0"
    if old == "spectrum" and why.startswith("resonance") and new["stable"] in ("arnold", False):
        return old
    return new["stable"]


def is_free_at_rest(document):
    """r = 0, l = 0 and h = 0."""
    return all(Fraction(text) == 0 for text in [*document["r"], document["h"], document["l"]])


def flags(old, new):
    """Definition 1.1: if A_i + A_j = A_k, the mass lies in the plane across e_k, so that the body exists only with r_k = 0."""
    moments, center = ([Fraction(text) for text in old[key]] for key in ("A", "r"))
    exists = all(
        moments[i] + moments[j] > moments[k] or (moments[i] + moments[j] == moments[k] and center[k] == 0)
        for i, j, k in permutations(range(3))
    )
    flat = any(moments[i] + moments[j] == moments[k] for i, j, k in permutations(range(3)))
    right = (new["unphysical"], new["plate"]) == (not exists, exists and flat)
    return {"unphysical": old["unphysical"], "plate": old["plate"]} if right else {}
