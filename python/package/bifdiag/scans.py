"""Scans: the diagrams of many bodies, into a file or into arrays."""

import csv
import json
import os
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Literal, overload

import numpy as np

from . import exact
from .behaviour import Document
from .body import Body
from .command import command
from .errors import InputError
from .own_bodies import OwnBodies, labels
from .scan_rows import Scan, column


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
        Seed of the sequence of bodies.
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
    columns = {name: column(values) for name, values in zip(names, zip(*rows, strict=True), strict=True)}
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
