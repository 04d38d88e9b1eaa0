"""The straightened diagram."""

import re

import numpy as np
import pytest

import bifdiag

figure = pytest.importorskip("matplotlib.figure")


def drawn(body, **options):
    atlas = bifdiag.Body.preset(body).atlas()
    return atlas, atlas.plot(figure.Figure().subplots(), **options)


def test_the_view_is_the_commands(command, tmp_path):
    for body in ("paper", "ten", "kovalevskaya", "lagrange"):
        command("atlas", f"--body={body}", "--out", tmp_path / body)
        straight = "main-levels" in (tmp_path / body / "diagram.svg").read_text(encoding="utf-8")
        _, auto = drawn(body, view="auto")
        assert (auto.get_ylabel() != "$l$") is straight


def test_places_are_those_of_the_commands_picture(command, tmp_path):
    command("atlas", "--body=paper", "--view=straight", "--out", tmp_path)
    svg = (tmp_path / "diagram.svg").read_text(encoding="utf-8")
    atlas, ax = drawn("paper", view="straight")
    assert ax.get_xlim() == ax.get_ylim() == (0, 1)
    # Every region is a patch, as it is a path there, and every curve a line.
    assert [patch.get_gid() for patch in ax.patches] == [region.id for region in atlas.regions]
    assert all(f'id="main-{region.id}"' in svg for region in atlas.regions)
    assert {line.get_gid() for line in ax.lines} >= set(atlas.curves.ids)
    labels = [text.get_text() for text in ax.texts]
    assert len(labels) == len(re.findall('id="main-label-R[0-9]+"', svg)) >= len(atlas.regions)
    assert len([line for line in ax.lines if line.get_gid() == "level"]) == len(atlas._straightened.drawing()["levels"]) > 3


def test_points_lie_in_their_regions(paper):
    atlas = paper.atlas()
    ax = atlas.plot(figure.Figure().subplots(), view="straight")
    h, l = (np.array([getattr(region.sample, name) for region in atlas.regions]) for name in "hl")
    places = atlas.straightened(h, l)
    assert places.shape == (len(h), 2)
    seen = np.isfinite(places).all(axis=1)
    assert seen.sum() >= len(h) - 1
    for patch, place, is_seen in zip(ax.patches, places, seen, strict=True):
        inside = [patch.get_path().contains_point(place) for patch in ax.patches]
        assert not is_seen or inside[list(ax.patches).index(patch)]
    # l alone decides the column, and h rises in it.
    column = atlas.straightened(np.linspace(2, 9, 50), 1.0)
    assert np.ptp(column[:, 0]) == 0 and (np.diff(column[:, 1]) > 0).all()
    assert (
        np.isnan(atlas.straightened(-100, 1.0)).all()
        and atlas.straightened(4, -1.0).tolist() == atlas.straightened(4, 1).tolist()
    )


def test_wrong_views_are_refused(paper):
    atlas = paper.atlas()
    with pytest.raises(bifdiag.InputError, match="the views are"):
        atlas.plot(view="curved")
    with pytest.raises(bifdiag.InputError, match="drawn as a whole"):
        atlas.plot(view="straight", h=(0, 1))
    assert atlas.plot(figure.Figure().subplots(), view="auto", h=(0, 1)).get_xlim() == (0, 1)
    assert atlas.plot(figure.Figure().subplots()).get_ylabel() == "$l$"
