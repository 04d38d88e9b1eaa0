"""The explorer in a notebook: the built page, served to this machine only."""

import html
from functools import cache, partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

from .errors import BifdiagError

PAGE = Path(__file__).parent / "page"
"""The built page; wheels carry it."""


class _Files(SimpleHTTPRequestHandler):
    # What the system believes of these suffixes does not matter: a browser refuses modules of another type.
    extensions_map = {**SimpleHTTPRequestHandler.extensions_map, ".js": "text/javascript", ".wasm": "application/wasm"}  # noqa: RUF012

    def log_message(self, format: str, *args: Any) -> None:
        """Nothing is printed into the notebook."""


class _Server(ThreadingHTTPServer):
    def handle_error(self, request: Any, client_address: Any) -> None:
        """A browser that left before it had everything is no error of the notebook."""


@cache
def _address() -> str:
    """Serves the page until the process ends, on a port that is free."""
    if not (PAGE / "index.html").exists():
        raise BifdiagError(
            "this installation was built without the explorer's page; install a wheel, or in a clone run "
            "`npm ci && npm run build` in web/ and `cp -r web/dist python/package/bifdiag/page`, and install again"
        )
    server = _Server(("127.0.0.1", 0), partial(_Files, directory=str(PAGE)))
    Thread(target=server.serve_forever, name="bifdiag explorer", daemon=True).start()
    return f"http://127.0.0.1:{server.server_port}/"


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
