"""Pictures: on the axes that are given, with names where they belong."""

import numpy as np
import pytest

import bifdiag

pytest.importorskip("matplotlib")

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from bifdiag import pictures


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


@pytest.mark.parametrize("name", ["paper", "kovalevskaya", "katok:7", "euler"])
def test_names_stand_in_their_regions(name):
    atlas = bifdiag.Body.preset(name).atlas()
    _, ax = plt.subplots(figsize=(8, 6))
    assert atlas.plot(ax) is ax
    numbers = {region.id: number for number, region in enumerate(atlas.regions)}
    named = [text.get_text().splitlines()[0] for text in ax.texts]
    assert len(named) == len(set(named)) > 0
    for text, region in zip(ax.texts, named, strict=True):
        assert atlas.region(*text.xy) == numbers[region]
    boxes = [text.get_window_extent() for text in ax.texts]
    inside = ax.get_window_extent()
    for place, box in enumerate(boxes):
        assert inside.x0 <= box.x0 and box.x1 <= inside.x1 and inside.y0 <= box.y0 and box.y1 <= inside.y1
        assert not any(box.overlaps(other) for other in boxes[:place])
    assert {patch.get_gid() for patch in ax.patches} == set(numbers)
    assert {line.get_gid() for line in ax.lines} == {curve.id for curve in atlas.curves}


def test_a_diagram_takes_what_it_is_told(atlas):
    ax = atlas.plot(h=(2, 5), l=(2, 4), labels=False, regions=False, color="red")
    assert (ax.get_xlim(), ax.get_ylim()) == ((2, 5), (2, 4)) and not ax.texts and not ax.patches
    assert {line.get_color() for line in ax.lines} == {"red"}


def test_a_section_is_drawn_on_both_sheets(section):
    for projection in ("torus", "sphere"):
        panels = section.plot(projection=projection)
        drawn = [len(panel.collections[0].get_offsets()) for panel in panels]
        assert drawn == [(section.sheet == sheet).sum() for sheet in (1, -1)]
    with pytest.raises(bifdiag.InputError, match="torus"):
        section.plot(projection="cube")


def test_colours_of_verdicts_are_told(paper):
    found = paper.section(6, 2, orbits=12, crossings=300)
    panels = found.plot(color="verdict")
    assert [text.get_text() for text in panels[-1].get_legend().get_texts()] == list(pictures.VERDICTS)
    values = panels[0].collections[0].get_array()
    words = np.array(list(pictures.VERDICTS))[np.asarray(values, dtype=int)]
    assert words.tolist() == np.array(found.verdict)[found.orbit[found.sheet == 1]].tolist()


def test_a_body_and_its_sphere_are_drawn(paper):
    ax = paper.plot()
    assert {text.get_text() for text in ax.texts} == {"$A_1$", "$A_2$", "$A_3$"}
    com = np.array(ax.lines[-1].get_data_3d())[:, -1]
    assert np.allclose(np.cross(com, [0.94868, 0, 0.61623]), 0)
    assert len(bifdiag.Body.preset("euler").plot().lines) == 3
    assert paper.plot_sphere(3.8, 3.25).collections


def test_a_plane_of_bodies_is_drawn():
    places = np.array([0.5, 0.9, 1.5])

    def body_at(x, y):
        return bifdiag.Body([1, x, y], [1, 0, 0]) if x != y else None

    ax = pictures.plane(body_at, places, places)
    counts = ax.collections[0].get_array()
    assert np.ma.getmaskarray(counts).diagonal().all()
    assert counts[0, 2] == len(body_at(1.5, 0.5).atlas().regions)
    named = pictures.plane(body_at, places, places, value=lambda atlas: atlas.regions[-1].signature)
    labels = [text.get_text() for text in named.figure.axes[1].get_yticklabels()]
    assert labels[int(named.collections[0].get_array()[0, 2])] == body_at(1.5, 0.5).atlas().regions[-1].signature


def test_notebooks_show_objects_by_themselves(paper, atlas, section):
    assert "2, 11/10, 1" in paper._repr_html_()
    assert atlas._repr_svg_().startswith("<svg")
    assert "R5" in atlas.regions[4]._repr_html_()
    shown = section._repr_html_()
    assert "(3.8, 3.25)" in shown and "6 orbits" in shown and "regular" in shown
