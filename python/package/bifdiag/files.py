"""What a file is, so that a message can say what reads it."""

import json
import os
import zipfile
from pathlib import Path

from .errors import InputError

READERS = {
    "atlas": ("an atlas (JSON)", "bifdiag.Atlas.load reads it"),
    "section": ("a section (NPZ)", "bifdiag.Section.load reads it"),
    "motion": ("a motion (NPZ)", "bifdiag.Motion.load reads it"),
    "proved motion": ("a proved motion (NPZ)", "bifdiag.ProvedMotion.load reads it"),
    "chaos map": ("a map of the chaotic share (NPZ)", "bifdiag.ChaosMap.load reads it"),
    "list of periodic orbits": ("a list of periodic orbits (NPZ)", "bifdiag.PeriodicOrbits.load reads it"),
    "family of periodic orbits": ("a family of periodic orbits (NPZ)", "bifdiag.PeriodicFamily.load reads it"),
    "archive": ("an archive of other arrays (NPZ)", "numpy.load reads it"),
    "array": ("a single array (NPY)", "numpy.load reads it"),
    "scan": ("a scan (CSV)", "pandas.read_csv reads it"),
    "lines": ("a scan (JSON Lines)", "pandas.read_json with lines=True reads it"),
    "table": ("a Parquet file", "pandas.read_parquet reads it"),
    "document": ("another document (JSON)", "json.load reads it"),
    "nothing": ("empty", "nothing was written there"),
}
"""What files are that are known by how they begin or what they hold, in words, with advice."""

SOURCES = {
    "atlas": "an atlas.json of `bifdiag --json` or Atlas.save",
    "section": "an archive of `bifdiag section --data FILE.npz` or Section.save",
    "motion": "an archive of `bifdiag orbit --data FILE.npz` or Motion.save",
    "proved motion": "an archive of `bifdiag orbit --proved --data FILE.npz` or ProvedMotion.save",
    "chaos map": "an archive of `bifdiag chaos --out FILE.npz` or ChaosMap.save",
    "list of periodic orbits": "an archive of PeriodicOrbits.save",
    "family of periodic orbits": "an archive of PeriodicFamily.save",
}
"""Where files that can be loaded come from."""


ARCHIVES = {
    "quaternion": "motion",
    "attitude": "motion",
    "attitude_lo": "proved motion",
    "fraction": "chaos map",
    "continuum": "list of periodic orbits",
    "multipliers": "family of periodic orbits",
    "orbit": "section",
}
"""Arrays by which archives are known."""


BEGINNINGS = {"scan": b"index,A1,A2,A3,r1,r2,r3,", "lines": b'{"index":0,"A1":'}
"""How texts begin that are known by it."""


def require(path: str | os.PathLike[str], wanted: str) -> None:
    """Looks whether a file is what is wanted, one of `SOURCES`.

    Raises
    ------
    InputError
        If it is something else: the message says what, if that is known.
    OSError
        If it cannot be read.
    """
    found = _kind(Path(path))
    if found != wanted:
        needed, known = f"{SOURCES[wanted]} is needed here", READERS.get(found)
        told = f"no {wanted}: {needed}" if known is None else f"{known[0]}, no {wanted}: {known[1]}; {needed}"
        raise InputError(f"{os.fspath(path)} is {told}")


def _kind(path: Path) -> str:
    """One of `READERS`, or ``"other"``."""
    with path.open("rb") as file:
        head = file.read(6)
    if not head:
        return "nothing"
    if head[:4] == b"PK\x03\x04" and zipfile.is_zipfile(path):
        with zipfile.ZipFile(path) as archive:
            names = set(archive.namelist())
        return next((kind for name, kind in ARCHIVES.items() if f"{name}.npy" in names), "archive")
    if head == b"\x93NUMPY":
        return "array"
    if head[:4] == b"PAR1":
        return "table"
    begin = path.read_bytes()[:32]
    for kind, words in BEGINNINGS.items():
        if begin.startswith(words):
            return kind
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        return "other"
    return "atlas" if isinstance(document, dict) and "curves" in document and "body" in document else "document"
