"""Many bodies: scans and searches; checking atlases."""

import json
import os
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from . import _core, exact, files
from .atlas import Atlas
from .behaviour import Document
from .body import Body
from .errors import BifdiagError, InputError
from .records import Component, Margin


def scan(
    family: str = "general",
    samples: int | None = None,
    out: str | os.PathLike[str] = "scan.parquet",
    *,
    shard: tuple[int, int] | None = None,
    threads: int | None = None,
    seed: int = 0,
    vary: "str | Iterable[str]" = (),
    body: Body | None = None,
) -> Document:
    """Computes the diagrams of many bodies into a file, with the same bytes as the command line.

    The package's command line does the work in a separate process; after an interrupt the same call resumes where
    it stopped.

    Parameters
    ----------
    family : {"general", "positive", "katok"}
        Which bodies: ``"general"`` physical ones, up to units; ``"positive"`` all with A_i > 0; ``"katok"`` with r along
        the first axis.
    samples : int, optional
        Their number; required unless `vary` defines a grid.
    out : path
        The file; its suffix selects the format: ``.parquet``, ``.csv`` or ``.jsonl``.
    shard : (int, int), optional
        ``(i, n)``: only the i-th of n equal parts, i from 1.
    threads : int, optional
        None: one; 0: one per core. The file does not depend on it.
    seed : int
        Start of the sequence of bodies.
    vary : str or list of str
        Ranges of the parameters ``A1``, ``A2``, ``A3``, ``r1``, ``r2``, ``r3``: ``"A2=1:2:101"`` is a grid of 101 values,
        both ends included, ``"A2=1:2"`` is sampled. Of `body`, or of the family ``"katok"``.
    body : Body, optional
        The body whose parameters are varied, instead of a family.

    Returns
    -------
    dict
        The summary of the scan, which is also written to ``FILE.summary.json``. The page "Files" describes its fields
        and the columns of the file.

    Raises
    ------
    InputError
        If the command line refuses an argument.
    BifdiagError
        If the scan fails.

    Examples
    --------
    >>> import bifdiag, csv, os, tempfile
    >>> lagrange = bifdiag.Body.preset("lagrange")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = os.path.join(folder, "lagrange.csv")
    ...     summary = bifdiag.scan(body=lagrange, vary="A1=1:2:3", out=path)
    ...     with open(path) as file:
    ...         rows = list(csv.DictReader(file))
    >>> summary["rows"], [(row["A1"], row["regions"]) for row in rows]
    (3, [('1.0', '2'), ('1.5', '4'), ('2.0', '4')])
    """
    arguments = ["scan", "--json", "--out", os.fspath(out)]
    if body is None:
        arguments += ["--family", family]
    else:
        arguments += [f"--A={','.join(body.A)}", f"--r={','.join(body.r)}"]
    if samples is not None:
        arguments += ["--samples", str(exact.whole(samples, "samples", 1))]
    if shard is not None:
        part, of = shard
        arguments += ["--shard", f"{part}/{of}"]
    if seed:
        arguments += ["--seed", str(exact.whole(seed, "seed", 0))]
    for values in [vary] if isinstance(vary, str) else vary:
        arguments += ["--vary", values]
    count = exact.threads(threads)
    arguments += ["--threads", str(count or os.cpu_count() or 1)]
    document: Document = json.loads(command(*arguments))
    return document


def merge(shards: Iterable[str | os.PathLike[str]], out: str | os.PathLike[str], *, threads: int | None = None) -> Document:
    """Joins the shards of a scan into one file with the same bytes as an unsplit scan.

    Parameters
    ----------
    shards : list of paths
        The files of all shards, in any order, each beside its ``.summary.json``.
    out : path
        The file.
    threads : int, optional
        None: one; 0: as many as there are cores.

    Returns
    -------
    dict
        The summary of the scan.

    Raises
    ------
    InputError
        If the shards do not belong together, or one is missing.
    """
    count = exact.threads(threads) or os.cpu_count() or 1
    files = [os.fspath(shard) for shard in shards]
    document: Document = json.loads(
        command("scan", "merge", *files, "--out", os.fspath(out), "--json", "--threads", str(count))
    )
    return document


def command(*arguments: str) -> str:
    """Runs the package's command line in a separate process; returns its output.

    Raises
    ------
    InputError
        If its exit status is 2; carries its message.
    BifdiagError
        If its exit status is 1.
    """
    line = [sys.executable, "-m", "bifdiag", *arguments]
    with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8") as process:
        try:
            printed, told = process.communicate()
        except BaseException:
            process.terminate()
            raise
    message = told.partition("\n\nFor more information")[0].strip().removeprefix("error: ")
    if process.returncode == 2:
        raise InputError(message)
    if process.returncode != 0:
        raise BifdiagError(message)
    return printed


@dataclass(frozen=True, slots=True)
class Witness:
    """The result of a search.

    Attributes
    ----------
    found : bool
        Whether a body with the property was found.
    exists : bool or None
        False if a theorem excludes it; `why` names the theorem.
    why : str or None
        The theorem.
    body : Body or None
        The body.
    h, l : str or None
        The point, exact.
    components : tuple of Component
        The components of U there.
    margin : Margin or None
        The distance to the nearest curve.
    tried : int
        Number of bodies tried; 0 if the answer was known.
    document : dict
        Everything that the command line prints with ``--json``.
    """

    found: bool
    exists: bool | None
    why: str | None
    body: Body | None
    h: str | None
    l: str | None
    components: tuple[Component, ...]
    margin: Margin | None
    tried: int
    document: Document = field(repr=False)

    @classmethod
    def _of(cls, document: Document) -> "Witness":
        there = document.get("witness") or document
        found = document["found"]
        return cls(
            found,
            document.get("exists"),
            document.get("why"),
            Body._of_document(there) if found else None,
            there["h"] if found else None,
            there["l"] if found else None,
            tuple(map(Component._of, there["components"])) if found else (),
            Margin._of(there["margin"]) if found else None,
            document["tried"],
            document,
        )

    def __bool__(self) -> bool:
        return self.found


def find(
    kind: str | None = None,
    *,
    circles: int | None = None,
    poles: int | None = None,
    signature: str | None = None,
    critical_points: int | None = None,
    physical: bool = False,
    samples: int = 20_000,
    seed: int | None = None,
    accuracy: str = "exact",
    threads: int | None = None,
) -> Witness:
    """Searches for a body and a point with a given property.

    Parameters
    ----------
    kind : str, optional
        A component by its section, such as ``"M4"``, or by circles and poles, such as ``"k3n1"``.
    circles, poles : int, optional
        Boundary circles and poles of a component of U.
    signature : str, optional
        The sections of a region, such as ``"S2+T2"``, in any order.
    critical_points : int, optional
        At least this number of relative equilibria at one l.
    physical : bool
        Only physical bodies: A_i + A_j > A_k, or equality and r_k = 0 (see `Body.physical`).
    samples : int
        Largest number of bodies tried.
    seed : int, optional
        Where the sequence of bodies starts; searches even if an answer is known.
    accuracy : {"exact", "fast"}
        Accuracy of the answer.
    threads : int, optional
        None: one; 0: one per core. The answer does not depend on it.

    Returns
    -------
    Witness
        True if found.

    Raises
    ------
    InputError
        If no property, or an unknown one, is given.

    Examples
    --------
    >>> import bifdiag
    >>> witness = bifdiag.find("M4")
    >>> witness.body.classify(witness.h, witness.l).status
    'regular'
    >>> bifdiag.find("k0n1").exists
    False
    """
    given = [kind is not None, circles is not None or poles is not None, signature is not None]
    given.append(critical_points is not None)
    if sum(given) != 1:
        raise InputError("say what is sought by one of kind, circles and poles, signature, critical_points")
    wanted = {
        "kind": kind,
        "circles": None if circles is None else exact.whole(circles, "circles", 0, 2**32 - 1),
        "poles": None if poles is None else exact.whole(poles, "poles", 0, 2),
        "signature": signature,
        "critical_points": None if critical_points is None else exact.whole(critical_points, "critical_points", 0, 99),
    }
    found = _core.find(
        wanted,
        bool(physical),
        exact.whole(samples, "samples", 1),
        None if seed is None else exact.whole(seed, "seed", 0),
        accuracy,
        exact.threads(threads),
    )
    return Witness._of(json.loads(found))


def verify(atlas: str | os.PathLike[str] | Document | Atlas) -> int:
    """Checks an atlas with a certificate by independent code, like ``bifdiag verify``.

    Parameters
    ----------
    atlas : path, dict or Atlas
        A file, a document, or an atlas made with ``certificate=True``.

    Returns
    -------
    int
        The number of regions, all of which were confirmed.

    Raises
    ------
    VerifyError
        Names the first item that is wrong or could not be confirmed; also raised if there is no certificate. For a
        file every byte counts.
    InputError
        If it is not an atlas; the message says what it is.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> import bifdiag
    >>> atlas = bifdiag.Body.preset("paper").atlas(certificate=True)
    >>> bifdiag.verify(atlas)
    9
    """
    if isinstance(atlas, dict):
        try:
            text = json.dumps(atlas)
        except (TypeError, ValueError) as error:
            raise InputError(f"the document is no JSON: {error}") from error
        return _core.verify(text, "the document", False)
    if isinstance(atlas, Atlas):
        return _core.verify(atlas.to_json(), "the atlas", True)
    files.require(atlas, "atlas")
    return _core.verify(Path(atlas).read_text(encoding="utf-8"), os.fspath(atlas), True)
