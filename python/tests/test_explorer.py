"""The page in a notebook."""

import re
import signal
import subprocess
import sys
from urllib.request import Request, urlopen

import pytest

import bifdiag
from bifdiag import explorer


def test_the_page_is_served_with_the_body(atlas):
    shown = atlas.explore(height=500)
    assert shown.url.endswith("#A=2,11/10,1&r=0.94868,0,0.61623")
    assert 'height="500"' in shown._repr_html_() and "&amp;r=" in shown._repr_html_()
    address = shown.url.partition("#")[0]
    with urlopen(address) as page:
        text = page.read().decode()
    script = re.search(r'src="\./(assets/[^"]+\.js)"', text).group(1)
    with urlopen(address + script) as answer:
        assert answer.headers["Content-Type"] == "text/javascript"
        plain = answer.read()
    # Browsers that take it get the packed file, which the wheel carries in place of the plain one.
    with urlopen(Request(address + script, headers={"Accept-Encoding": "gzip, br"})) as answer:
        assert answer.headers["Content-Encoding"] == "br"
        assert answer.headers["Content-Type"] == "text/javascript"
        packed = answer.read()
    assert packed == (explorer.PAGE / f"{script}.br").read_bytes()
    assert len(packed) < len(plain) / 2 and b"function" in plain
    assert not (explorer.PAGE / script).exists()
    assert atlas.explore(3.8, "13/4").url == shown.url + "&h=3.8&l=13/4"
    with pytest.raises(bifdiag.InputError, match="both h and l"):
        atlas.explore(3.8)
    for wrong in ("x", float("nan"), "1/0"):
        with pytest.raises(bifdiag.InputError):
            atlas.explore(wrong, 1)


def test_the_command_of_the_wheel_serves_its_page():
    line = [sys.executable, "-m", "bifdiag", "explore", "--no-open", "--body=kovalevskaya", "--h=1/2", "--l=1"]
    with subprocess.Popen(line, stdout=subprocess.PIPE, text=True) as served:
        try:
            url = served.stdout.readline().strip()
            assert url.endswith("#A=2,2,1&r=1,0,0&h=1/2&l=1")
            with urlopen(url.partition("#")[0]) as page:
                assert page.read() == (explorer.PAGE / "index.html").read_bytes()
        finally:
            served.send_signal(signal.SIGINT)
        # The status of a process that was interrupted.
        assert served.wait(timeout=5) != 0


def test_an_installation_without_the_page_says_how_to_get_it(atlas, monkeypatch, tmp_path):
    monkeypatch.setattr(explorer, "PAGE", tmp_path)
    explorer._address.cache_clear()
    with pytest.raises(bifdiag.BifdiagError, match="npm run build"):
        atlas.explore()
