"""The page in a notebook."""

import re
from urllib.request import urlopen

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
    assert atlas.explore(3.8, "13/4").url == shown.url + "&h=3.8&l=13/4"


def test_an_installation_without_the_page_says_how_to_get_it(atlas, monkeypatch, tmp_path):
    monkeypatch.setattr(explorer, "PAGE", tmp_path)
    explorer._address.cache_clear()
    with pytest.raises(bifdiag.BifdiagError, match="npm run build"):
        atlas.explore()
