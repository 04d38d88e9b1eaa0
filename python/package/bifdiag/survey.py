"""Many bodies: scans and searches; checking atlases."""

import csv
import json
import os
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
import numpy.typing as npt

from . import _core, exact, files
from .atlas import Atlas
from .behaviour import Document
from .body import Body
from .command import command
from .diagrams import Accuracy
from .errors import InputError
from .own_bodies import OwnBodies, labels
from .records import Component, Margin
from .tables import Table
from .units import ExactPoint

if TYPE_CHECKING:
    import pandas
    import xarray


class Scan(Table):
    """The rows of a scan, one for each body, as arrays; the page "Files" describes the columns.

    Of a DataFrame or Dataset of bodies `to_pandas` and `to_xarray` have the index, so that
    ``frame[["name"]].join(scan.to_pandas())`` brings the answers beside its own columns.

    Attributes
    ----------
    status : array (n,) of str
        ``"classified"``, ``"undecided"``, ``"failed"``, or ``"invalid"`` where a number of the body is missing; ``error``
        says why. Counts are NaN where there is no answer, and of an invalid body bools are masked.
    meta : dict
        The summary of the scan; ``invalid``: the places of own bodies that could not be scanned.
    """

    A1: npt.NDArray[np.float64]
    A2: npt.NDArray[np.float64]
    A3: npt.NDArray[np.float64]
    r1: npt.NDArray[np.float64]
    r2: npt.NDArray[np.float64]
    r3: npt.NDArray[np.float64]
    status: npt.NDArray[np.object_]
    regions: npt.NDArray[Any]
    critical_points: npt.NDArray[Any]

    def __init__(self, columns: dict[str, npt.NDArray[Any]], meta: str, labels: Any = None) -> None:
        super().__init__(columns, meta)
        self._labels = labels

    def _selected(self, kept: Any) -> "Scan":
        return Scan({name: column[kept] for name, column in self._columns.items()}, self._meta, self._labels)

    def counts(self, name: Literal["signatures", "types"] = "signatures") -> dict[str, npt.NDArray[np.int64]]:
        """How many regions of each body have a signature, or show a type of component: an array for each that occurs.

        ``pandas.DataFrame(scan.counts())`` has a column for each.
        """
        if name not in ("signatures", "types"):
            raise InputError(f'name = {name!r}: the columns with counts are "signatures" and "types"')
        found: list[dict[str, int]] = []
        for told in self[name].tolist():
            parts = [word.rpartition(":") for word in str(told or "").split()]
            found.append({word: int(count) for word, _, count in parts})
        every = sorted({word for one in found for word in one})
        return {word: np.array([one.get(word, 0) for one in found], dtype=np.int64) for word in every}

    def to_pandas(self) -> "pandas.DataFrame":
        """A DataFrame, with the index of that of the bodies if there was one; ``bifdiag[tables]`` installs pandas."""
        frame = super().to_pandas()
        return frame if self._labels is None else frame.set_index(self._labels.take(self["index"]))

    def to_xarray(self) -> "xarray.Dataset":
        """A Dataset over ``row``, with the index of the bodies as a coordinate; ``bifdiag[tables]`` installs xarray."""
        data = super().to_xarray()
        if self._labels is None or self._labels.nlevels > 1:
            return data
        return data.assign_coords({str(self._labels.name or "label"): ("row", self._labels.take(self["index"]).to_numpy())})

    def __reduce__(self) -> tuple[Any, ...]:
        return Scan, (self._columns, self._meta, self._labels)

    def __repr__(self) -> str:
        return f"Scan of {len(self)} bodies [{', '.join(self.columns)}, meta]"


@overload
def scan(
    family: "Literal['general', 'positive', 'katok'] | None" = None,
    samples: int | None = None,
    out: None = None,
    *,
    bodies: Any = None,
    shard: tuple[int, int] | None = None,
    threads: int | None = None,
    seed: int = 0,
    vary: "str | Iterable[str]" = (),
    body: Body | None = None,
    overwrite: bool = False,
    invalid: Literal["mark", "raise"] = "mark",
) -> Scan: ...
@overload
def scan(
    family: "Literal['general', 'positive', 'katok'] | None" = None,
    samples: int | None = None,
    *,
    out: str | os.PathLike[str],
    bodies: Any = None,
    shard: tuple[int, int] | None = None,
    threads: int | None = None,
    seed: int = 0,
    vary: "str | Iterable[str]" = (),
    body: Body | None = None,
    overwrite: bool = False,
    invalid: Literal["mark", "raise"] = "mark",
) -> Document: ...


def scan(
    family: str | None = None,
    samples: int | None = None,
    out: str | os.PathLike[str] | None = None,
    *,
    bodies: Any = None,
    shard: tuple[int, int] | None = None,
    threads: int | None = None,
    seed: int = 0,
    vary: "str | Iterable[str]" = (),
    body: Body | None = None,
    overwrite: bool = False,
    invalid: Literal["mark", "raise"] = "mark",
) -> Document | Scan:
    """Computes the diagrams of many bodies, into a file with the same bytes as the command line or into arrays.

    The package's command line does the work in a separate process; after an interrupt the same call with `out` resumes
    where it stopped, and if that very scan is finished already, its summary is returned.

    Parameters
    ----------
    family : {"general", "positive", "katok"}, optional
        Which bodies: ``"general"`` (the default) physical ones, up to units; ``"positive"`` all with A_i > 0; ``"katok"``
        with r along the first axis.
    samples : int, optional
        Their number; required unless `vary` defines a grid.
    out : path, optional
        The file; its suffix selects the format: ``.parquet``, ``.csv`` or ``.jsonl``. Without it no file is written.
    bodies : table, array (n, 6), pair of arrays (n, 3) or list of Body, optional
        Your own bodies, instead of a family: a DataFrame, Dataset or dict with the columns ``A1``, ``A2``, ``A3``, ``r1``,
        ``r2``, ``r3``, an array with these columns, A and r, or bodies. The numbers are taken as doubles.
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
    overwrite : bool
        Replace a file that another scan has finished; without it, that is refused.
    invalid : {"mark", "raise"}
        What becomes of one of `bodies` with a number that is NaN, masked or infinite: its row has the status ``"invalid"``,
        and ``meta["invalid"]`` its place; or an error names it. A file has no row for it, so `out` always refuses it.

    Returns
    -------
    dict or Scan
        With `out` the summary of the scan, which is also written to ``FILE.summary.json``, else the rows as arrays. The
        page "Files" describes the fields of the one and the columns of the other.

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
    >>> found = bifdiag.scan(bodies=[[2, 1.5, 1, 1, 0, 0], [1, 1, 1, 0, 0, 1]])
    >>> found.regions.tolist(), found.meta["rows"]
    ([5, 2], 2)
    """
    given = {"family": family, "bodies": bodies, "body": body}
    if sum(value is not None for value in given.values()) > 1:
        raise InputError("family, bodies and body all say which bodies to scan; give one of them")
    if bodies is not None and (samples is not None or vary):
        raise InputError("bodies are taken as they are; leave out samples and vary")
    if samples is None and bodies is None and not vary:
        raise InputError(
            'samples is missing; give samples=100000, or ranges with numbers of grid values: vary="A2=1:2:101"'
        )
    own = None
    with tempfile.TemporaryDirectory(prefix="bifdiag-") as folder:
        path = Path(folder) / "scan.csv" if out is None else Path(out)
        arguments = ["scan", "--json", f"--out={path}", *([] if overwrite else ["--keep"])]
        if bodies is not None:
            own = OwnBodies(bodies, invalid)
            if out is not None or shard is not None:
                own.require("files and shards have no row for it, so leave it out")
            table = Path(folder) / "bodies.csv"
            own.write(table)
            arguments += [f"--bodies={table}"]
        elif body is not None:
            arguments += [f"--A={','.join(body.A)}", f"--r={','.join(body.r)}"]
        else:
            arguments += ["--family", family or "general"]
        arguments += _details(samples, shard, threads, seed, vary)
        summary = command(*arguments)
        if out is not None:
            document: Document = json.loads(summary)
            return document
        with path.open(newline="", encoding="utf-8") as file:
            names, *rows = csv.reader(file)
    columns = {name: _column(values) for name, values in zip(names, zip(*rows, strict=True), strict=True)}
    if own is None:
        return Scan(columns, summary)
    summary = json.dumps(json.loads(summary) | {"invalid": np.flatnonzero(~own.valid).tolist()})
    return Scan(own.spread(columns), summary, labels(bodies))


def _details(
    samples: int | None,
    shard: tuple[int, int] | None,
    threads: int | None,
    seed: int,
    vary: "str | Iterable[str]",
) -> list[str]:
    """The options that every scan may have."""
    arguments = []
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
    return [*arguments, "--threads", str(count or os.cpu_count() or 1)]


def _column(values: tuple[str, ...]) -> npt.NDArray[Any]:
    """A column of a table of texts: whole numbers, floats, bools or texts."""
    for kind in (np.int64, np.float64):
        try:
            told = [value or "nan" for value in values] if kind is np.float64 else values
            return np.array(told, dtype=object).astype(kind)
        except ValueError:
            continue
    if set(values) <= {"true", "false"}:
        return np.array([value == "true" for value in values])
    return np.array([value or None for value in values], dtype=object)


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
    h, l : float or None
        The point, rounded.
    exact : ExactPoint or None
        The point as texts that have it exactly: ``witness.exact.h``.
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
    h: float | None
    l: float | None
    exact: ExactPoint | None
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
            float(exact.value(there["h"])) if found else None,
            float(exact.value(there["l"])) if found else None,
            ExactPoint(there["h"], there["l"]) if found else None,
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
    accuracy: Accuracy = "exact",
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
    >>> witness.body.classify(*witness.exact).status
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
