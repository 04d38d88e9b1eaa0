"""The explorer in a notebook: the built page, served to this machine only."""

import html
from functools import cache
from pathlib import Path

from . import _core
from .errors import BifdiagError

PAGE = Path(__file__).parent / "page"
"""The built page; wheels carry it."""


@cache
def _address() -> str:
    """Serves the page until the process ends, on a port that is free."""
    if not (PAGE / "index.html").exists():
        raise BifdiagError(
            "this installation was built without the explorer's page; install a wheel, or in a clone run "
            "`npm ci && npm run build` in web/ and `python/page.sh`, and install again"
        )
    return f"http://127.0.0.1:{_core.serve(PAGE)}/"


class Explorer:
    """The explorer's page, displayed by notebooks.

    Attributes
    ----------
    url : str
        Its address, for a browser on this machine.
    height : int
        Height of the cell in pixels.
    """

    def __init__(self, state: str, height: int) -> None:
        self.url = f"{_address()}#{state}"
        self.height = height

    def _repr_html_(self) -> str:
        return f'<iframe src="{html.escape(self.url)}" width="100%" height="{self.height}" style="border: 0"></iframe>'

    def __repr__(self) -> str:
        return f"Explorer at {self.url}"
