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
    assert {line.get_linewidth() for line in atlas.plot(lw=3).lines} == {3}


def test_unstable_stretches_are_dashed(atlas):
    ax = atlas.plot()
    words = {curve.id: curve for curve in atlas.curves}
    drawn = {"-": 0, "--": 0}
    for line in ax.lines:
        curve = words[line.get_gid()]
        if curve.kind.startswith("pole"):
            assert line.get_color() == "0.4"
            continue
        middle = line.get_ydata()[[0, -1]].mean()
        (word,) = {part.stability for part in curve.stability if part.l_from < middle < part.l_to}
        style = "-" if word in ("elliptic", "double-elliptic") else "--"
        assert line.get_linestyle() == style
        drawn[style] += 1
    assert min(drawn.values()) > 0


def test_a_magnified_picture_is_as_fine_as_its_axes(atlas):
    event = atlas.events[0]
    h, l = (event.h - 1e-4, event.h + 1e-4), (event.l - 1e-4, event.l + 1e-4)
    ax = atlas.plot(h=h, l=l)
    seen = [line for line in ax.lines if len(line.get_xdata()) > 1]
    assert seen
    for line in seen:
        assert l[0] <= line.get_ydata().min() and line.get_ydata().max() <= l[1]
    for patch in ax.patches:
        corners = patch.get_path().vertices
        assert not len(corners) or (corners[:, 0].min() >= h[0] and corners[:, 0].max() <= h[1])
    for wrong in ((3, 1), (1, 1), (1, np.nan), (1, 2, 3)):
        with pytest.raises(bifdiag.InputError, match="h"):
            atlas.plot(h=wrong)


def test_a_section_is_drawn_where_it_is_told(section):
    _, ax = plt.subplots()
    with pytest.raises(bifdiag.InputError, match="1 axes for 2 sheets"):
        section.plot(ax)
    for sheet in (1, -1):
        _, ax = plt.subplots()
        (panel,) = section.plot(ax, sheet=sheet)
        assert panel is ax and len(ax.collections[0].get_offsets()) == (section.sheet == sheet).sum()
    (panel,) = section.plot(sheet=1)
    assert panel.get_title() == "T⁺"
    with pytest.raises(bifdiag.InputError, match="sheets are 1 and -1"):
        section.plot(sheet=2)


def test_wrong_colours_name_the_right_ones(section, paper):
    for color, message in [
        ("nonsense", "lyapunov"),
        ("gamma", "columns"),
        ([1, 2], "shape"),
        (["a"] * len(section), "dtype"),
    ]:
        with pytest.raises(bifdiag.InputError, match=message):
            section.plot(color=color)
    assert len(section.plot(color=section.theta)) == 2
    # Orbits without a value are drawn all the same.
    short = paper.section(3.8, 3.25, orbits=2, crossings=5)
    assert np.isnan(short.rotation).all()
    panels = short.plot(color="rotation")
    assert sum(len(panel.collections[0].get_offsets()) for panel in panels) == len(short)


def test_curves_are_seen_in_every_style(atlas):
    with plt.style.context("dark_background"):
        bare = {line.get_color() for line in atlas.plot(regions=False, labels=False).lines}
        ax = atlas.plot()
    assert bare == {"white", "0.4"}
    assert {line.get_color() for line in ax.lines} == {"black", "0.4"} and {text.get_color() for text in ax.texts} == {
        "black"
    }


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
    with pytest.raises(bifdiag.InputError, match='projection="3d"'):
        paper.plot(plt.subplots()[1])
    ax = paper.plot()
    assert {text.get_text() for text in ax.texts} == {"$A_1$", "$A_2$", "$A_3$"}
    com = np.array(ax.lines[-1].get_data_3d())[:, -1]
    assert np.allclose(np.cross(com, [0.94868, 0, 0.61623]), 0)
    assert len(bifdiag.Body.preset("euler").plot().lines) == 3
    assert paper.plot_sphere(3.8, "3.25").collections
    with pytest.raises(bifdiag.InputError, match="forbidden"):
        paper.plot_sphere(-5, 1)
    # U may be smaller than the grid.
    least = paper.critical(3.25)[0]
    ax = paper.plot_sphere(float(least["h"]) + 1e-9, 3.25)
    assert np.allclose(np.array(ax.lines[0].get_data_3d())[:, 0], least["gamma"])


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


def test_a_plane_has_room_for_bodies_that_cannot_exist():
    # Any warning would be an error here.
    ax = pictures.plane(lambda x, y: bifdiag.Body([1, x, y], [1, 0, 0]), [0.2, 1], [0.3, 1.1])
    assert not np.ma.getmaskarray(ax.collections[0].get_array()).any()


def test_notebooks_show_objects_by_themselves(paper, atlas, section):
    assert "2, 11/10, 1" in paper._repr_html_()
    assert atlas._repr_svg_().startswith("<svg")
    assert "R5" in atlas.regions[4]._repr_html_()
    shown = section._repr_html_()
    assert "(3.8, 3.25)" in shown and "6 orbits" in shown and "regular" in shown


def test_figures_have_the_size_that_is_asked_for(paper, atlas, section):
    motion = paper.orbit(gamma=[0.6, 0, 0.8], omega=[1, 0.3, 1], t=5)
    draw = [
        atlas.plot,
        section.plot,
        paper.plot,
        motion.plot,
        lambda ax=None, **size: paper.plot_sphere(3.8, 3.25, ax, **size),
    ]
    for plot in draw:
        drawn = np.ravel(plot(figsize=(3, 2)))[0]
        assert drawn.figure.get_size_inches().tolist() == [3, 2]
    _, ax = plt.subplots()
    with pytest.raises(bifdiag.InputError, match="figsize is the size of a new figure"):
        atlas.plot(ax, figsize=(3, 2))


def test_a_motion_is_drawn_with_up_upwards(paper):
    motion = paper.orbit(gamma=[0.94868, 0, 0.61623], omega=[0.1, 0, 0.1], t=3)
    ax = motion.plot(color="red")
    x, y, z = ax.lines[0].get_data_3d()
    assert np.allclose(x**2 + y**2 + z**2, 1) and z[0] == pytest.approx(-1) and ax.lines[0].get_color() == "red"
    # The centre of mass hangs where gamma is r̂.
    center = paper.com / np.linalg.norm(paper.com)
    assert np.allclose(-z, motion.gamma @ center)


def test_the_energy_of_a_motion_is_kept(paper):
    motion = paper.orbit(gamma=[0.6, 0, 0.8], omega=[1, 0.3, 1], t=5)
    assert np.ptp(motion.energy) < 1e-12 and motion.energy[0] == pytest.approx(motion.meta["energy"])
