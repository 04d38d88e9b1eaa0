"""A program of schema version 1 beside one of version 2: both are asked the same, and compared in what both tell.

What version 2 says in other words, or better, stands here with the reason; everything else must be equal.
"""

import json
import subprocess

OPTIONS = {"--seed": "--rng-seed", "--starts": "--seeds"}  # of `section`, in version 1

# Answers in prose, of the format itself, or of another shape: not compared.
OTHER_SHAPES = {"text", "pages", "schema", "help", "command line", "batch", "picture", "scan border"}

# Fields that version 2 words otherwise, or that only one of the two has.
OTHER_WORDS = {
    "schema_version",
    "accuracy",  # other levels
    "certificate",  # only with --certificate
    "inertia",  # is `part` now
    "columns",  # tables have more of them
    "note",
    "rng_seed",  # is `seed` now
    "sha256",  # of a file of the other version
    "work",
}


def version(program):
    """The schema version of the documents that a program writes."""
    words = ["classify", "--body", "paper", "--h=1", "--l=1", "--json"]
    return json.loads(subprocess.run([program, *words], capture_output=True, check=True).stdout)["schema_version"]


def command(words, lines):
    """A command of version 2 in the words of version 1; `lines` tells that it is a batch."""
    said = [OPTIONS.get(word, word) if words[0] == "section" else word for word in words if word != "--certificate"]
    if "--certificate" in words or ("exact" in words and lines):
        said += ["--accuracy", "certified"]
    for word in ("--accuracy", "exact", "fast"):
        if word in words:
            said.remove(word)
    return said


def common(old, new):
    """Documents of version 1 and 2, each reduced to what both tell in the same words."""
    if isinstance(old, list) and isinstance(new, list):
        if len(old) == len(new):
            pairs = [common(a, b) for a, b in zip(old, new)]
            return [a for a, _ in pairs], [b for _, b in pairs]
        return old, new
    if not (isinstance(old, dict) and isinstance(new, dict)):
        return old, new
    old, new = ({key: value for key, value in side.items() if key not in OTHER_WORDS} for side in (old, new))
    if "error" in old or "error" in new:
        # A line that is refused: the words are not compared, but that only one of the two answers is told.
        return {"answer": old.get("status", "refused")}, {"answer": new.get("status", "refused")}
    if "error_bound" in old and "error_bound" in new and "nearest" in old and abs(old["h"] - new["h"]) <= old["error_bound"]:
        # A margin within the error that version 1 gave it, which of two curves is nearer included.
        return old, old
    if old.get("summary", {}).get("undecided") and not new.get("summary", {}).get("undecided"):
        # An atlas that version 1 left open, with what it could tell of its curves.
        return {}, {}
    if "status" in old and "status" in new and "A" in old:
        old, new = classification(old, new)
    if new.get("condition") == "angular-momentum":
        # The signature is that of the paper's section; version 1 gave it to this one too.
        old, new = ({key: value for key, value in side.items() if key != "signature"} for side in (old, new))
    if "found" in old and "found" in new:
        # Version 2 answers from the witnesses that come with it.
        return ({"found": side["found"]} for side in (old, new))
    for key in set(old) & set(new):
        old[key], new[key] = field(key, old[key], new[key])
    return old, new


def field(key, old, new):
    if key == "stability":
        return stability(old, new)
    if key == "energy_surface":
        return energy_surface(old), energy_surface(new)
    return common(old, new)


def energy_surface(name):
    """`(S1xS2)#(S1xS2)#(S1xS2)` is `#3(S1xS2)` in version 2."""
    count = name.count("(S1xS2)")
    return f"#{count}(S1xS2)" if count > 2 else name


def stability(old, new):
    """`degenerate` was a zero eigenvalue or a double pair; version 2 says which, and sees every double pair."""
    if old == "degenerate" or (old, new) == ("elliptic", "double-elliptic"):
        return new, new
    if isinstance(old, list):
        spans = [[span["stability"] for span in side] for side in (old, new)]
        return (new, new) if "degenerate" in spans[0] else (old, new)
    return old, new


def classes(candidates):
    """The classes that meet at a point, each once: in version 1 lists of components, in version 2 with the region."""
    lists = [entry["components"] if isinstance(entry, dict) else entry for entry in candidates or []]
    named = [[{**c, "energy_surface": energy_surface(c["energy_surface"])} for c in components] for components in lists]
    return sorted({json.dumps(components, sort_keys=True) for components in named})


def classification(old, new):
    before, after = classes(old.get("candidates")), classes(new.get("candidates"))
    if old["status"] == "undecided" and new["status"] != "undecided":
        # Decided now: the truth must be one of the candidates of before, or they be those that meet there.
        truth = after if new["status"] == "critical" else classes([new["components"] or []])
        missing = [text for text in truth if before and text not in before]
        return {"candidates": before}, {"candidates": missing or before}
    return {**old, "candidates": before}, {**new, "candidates": after}
