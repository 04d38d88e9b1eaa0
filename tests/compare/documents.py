"""Answers of two programs compared: JSON by structure, arrays and tables by value, everything else by bytes."""

import ast
import io
import json
import re
import struct
import zipfile
from collections.abc import Callable
from dataclasses import dataclass

MISSING = "(missing)"


@dataclass(frozen=True)
class Allowed:
    """Differences that are no change of an answer."""

    ignored: dict  # end of a path -> why
    tolerances: dict  # end of a path -> (relative tolerance, why)
    words: list  # (regular expression, replacement, why), for texts
    additions: bool  # fields that only the new program has
    common: Callable = lambda old, new: (old, new)  # two documents, reduced to what both tell

    def ignores(self, path):
        return any(ends(path, pattern) for pattern in self.ignored)

    def tolerance(self, path):
        return max((value for pattern, (value, _) in self.tolerances.items() if ends(path, pattern)), default=0.0)

    def normal(self, text):
        for expression, replacement, _ in self.words:
            text = re.sub(expression, replacement, text)
        return text


def ends(path, pattern):
    return path == pattern or path.endswith("." + pattern)


def short(value):
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 160 else text[:157] + "..."


def differences(old, new, allowed, path=""):
    """(path, old value, new value) of everything that differs and is not allowed to."""
    if allowed.ignores(path):
        return
    if isinstance(old, dict) and isinstance(new, dict):
        for key in [*old, *(key for key in new if key not in old)]:
            here = f"{path}.{key}" if path else key
            if key not in old:
                if not allowed.additions and not allowed.ignores(here):
                    yield here, MISSING, new[key]
            elif key not in new:
                if not allowed.ignores(here):
                    yield here, old[key], MISSING
            else:
                yield from differences(old[key], new[key], allowed, here)
    elif isinstance(old, list) and isinstance(new, list):
        if len(old) != len(new):
            yield f"{path}[]", f"{len(old)} entries", f"{len(new)} entries"
        for before, after in zip(old, new):
            yield from differences(before, after, allowed, f"{path}[]")
    elif is_number(old) and is_number(new):
        same = old == new or (old != old and new != new)  # NaN in tables and arrays
        if not same and not abs(old - new) <= allowed.tolerance(path) * max(abs(old), abs(new)):
            yield path, old, new
    elif isinstance(old, str) and isinstance(new, str):
        if old != new and allowed.normal(old) != allowed.normal(new):
            yield path, old, new
    elif type(old) is not type(new) or old != new:
        yield path, old, new


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def json_differences(old, new, allowed):
    """Of two texts that are equal, or JSON; `None` if they are not JSON."""
    if old == new:
        return []
    try:
        documents = [json.loads(text) for text in (old, new)]
    except ValueError:
        return None
    return list(differences(*allowed.common(*documents), allowed))


def text_differences(old, new, allowed, path):
    old, new = (allowed.normal(text.decode("utf-8", "replace")) for text in (old, new))
    if old == new:
        return []
    before, after = old.splitlines(), new.splitlines()
    for number, (first, second) in enumerate(zip(before, after), 1):
        if first != second:
            return [(f"{path} line {number}", first, second)]
    return [(f"{path}", f"{len(before)} lines", f"{len(after)} lines")]


def answer_differences(old, new, allowed, path):
    """Of what a command printed: one document, or a text."""
    if old == new:
        return []
    found = json_differences(old, new, allowed) if old[:1] in (b"{", b"[") else None
    return text_differences(old, new, allowed, path) if found is None else found


def file_differences(name, old, new, allowed):
    if old == new:
        return []
    if old is None or new is None:
        return [(name, "(no file)" if old is None else "a file", "(no file)" if new is None else "a file")]
    if name.endswith(".npz"):
        return list(differences(*allowed.common(arrays(old), arrays(new)), allowed))
    if name.endswith((".jsonl", ".csv")):
        return list(differences(*allowed.common(rows(name, old), rows(name, new)), allowed))
    if name.endswith(".parquet"):
        return [(name, f"{len(old)} bytes", f"{len(new)} other bytes")]
    return answer_differences(old, new, allowed, name)


def rows(name, content):
    """Lines of JSON, or a table as columns of numbers and texts; notes before its heading are left out."""
    lines = content.decode("utf-8").splitlines()
    if name.endswith(".jsonl"):
        return [json.loads(line) for line in lines]
    table = [line.split(",") for line in lines if not line.startswith("#")]
    return {"rows": [dict(zip(table[0], map(cell, row))) for row in table[1:]], "columns": table[0]}


def cell(text):
    try:
        return float(text)
    except ValueError:
        return text


FORMATS = {"f8": "d", "f4": "f", "i8": "q", "i4": "i", "i2": "h", "i1": "b", "u8": "Q", "u4": "I", "u1": "B", "b1": "?"}


def arrays(content):
    """The arrays of an NPZ archive as lists; an array of text, such as `meta`, as its document."""
    found = {}
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        for name in archive.namelist():
            data = archive.read(name)
            start = 10 + struct.unpack_from("<H", data, 8)[0]
            header = ast.literal_eval(data[10:start].decode("latin-1"))
            kind = header["descr"]
            if kind[1] == "U":
                text = data[start:].decode("utf-32-le" if kind[0] == "<" else "utf-32-be").rstrip("\0")
                found[name] = json.loads(text)
            elif kind[1] == "S":
                found[name] = json.loads(data[start:].rstrip(b"\0"))
            else:
                code = FORMATS[kind[1:]]
                order = ">" if kind[0] == ">" else "<"
                count = (len(data) - start) // struct.calcsize(order + code)
                values = struct.unpack_from(f"{order}{count}{code}", data, start)
                found[name] = {"shape": list(header["shape"]), "values": list(values)}
    return found
