"""The compiled part: exact texts and arrays in, arrays and texts of documents out."""

import os
from collections.abc import Sequence
from typing import Any, final

import numpy as np
import numpy.typing as npt

__all__ = [
    "SCHEMA_VERSION",
    "Atlas",
    "Body",
    "__version__",
    "body_of_file",
    "body_of_tensor",
    "find",
    "motion",
    "run",
    "section",
    "verify",
]

SCHEMA_VERSION: str
__version__: str

@final
class Body:
    def __new__(cls, moments: Sequence[str], center: Sequence[str]) -> Body: ...
    @staticmethod
    def preset(name: str) -> Body: ...
    @property
    def moments(self) -> list[str]: ...
    @property
    def center(self) -> list[str]: ...
    def values(self) -> list[str]: ...
    def part(self) -> str | None: ...
    def atlas(self, level: str) -> Atlas: ...
    def classify(self, h: str, l: str, level: str) -> str: ...
    def critical(self, l: str) -> str: ...

@final
class Atlas:
    def regions(self) -> str: ...
    def events(self) -> str: ...
    def to_json(self) -> str: ...
    def svg(self) -> str: ...
    def classify(self, h: str, l: str) -> str: ...
    def places(self, h: npt.NDArray[np.float64], l: npt.NDArray[np.float64], threads: int) -> npt.NDArray[np.int64]: ...
    def place(self, h: str, l: str) -> int: ...

def body_of_tensor(
    tensor: Sequence[Sequence[str]],
    com: Sequence[str],
    mass: str,
    gravity: str,
    about_com: bool,
    units: str,
    unphysical: bool,
) -> Body: ...
def body_of_file(
    path: str | os.PathLike[str],
    weight: Sequence[str | None],
    link: str | None,
    pivot: Sequence[str],
    gravity: str,
    units: str | None,
    unphysical: bool,
) -> Body: ...
def section(body: Body, h: str, l: str, request: dict[str, Any], threads: int) -> dict[str, Any]: ...
def motion(body: Body, request: dict[str, Any]) -> dict[str, Any]: ...
def find(
    wanted: dict[str, Any],
    physical: bool,
    samples: int,
    seed: int | None,
    level: str,
    threads: int,
) -> str: ...
def verify(text: str, name: str) -> int: ...
def run(arguments: Sequence[str]) -> int: ...
