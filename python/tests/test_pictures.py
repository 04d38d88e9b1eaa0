"""Pictures: on the axes that are given, with names where they belong."""

import itertools
import re
from xml.etree import ElementTree

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
    named = [text.get_gid() for text in ax.texts]
    assert all(name in text.get_text() for name, text in zip(named, ax.texts, strict=True))
    assert len(named) == len(set(named)) > 0
    for text, region in zip(ax.texts, named, strict=True):
        assert atlas.region(*text.xy) == numbers[region]
    boxes = [text.get_window_extent() for text in ax.texts]
    inside = ax.get_window_extent()
    for place, box in enumerate(boxes):
        assert inside.x0 <= box.x0 and box.x1 <= inside.x1 and inside.y0 <= box.y0 and box.y1 <= inside.y1
        assert not any(box.overlaps(other) for other in boxes[:place])
    assert {patch.get_gid() for patch in ax.patches} == set(numbers)
    drawn = {line.get_gid() for line in ax.lines}
    # Of curves upon each other that look the same there is one line.
    assert all(curve.id in drawn or drawn & set(curve.coincides_with) for curve in atlas.curves)


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
            assert line.get_linestyle() == "--"
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
        dark = [atlas.plot(regions=False, labels=False), atlas.plot(), atlas.plot(view="straight")]
    light = [atlas.plot(regions=False), atlas.plot(), atlas.plot(view="straight")]

    def contrast(one, other):
        def luminance(color):
            values = np.array(matplotlib.colors.to_rgb(color))
            return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4) @ [0.2126, 0.7152, 0.0722]

        low, high = sorted([luminance(one), luminance(other)])
        return (high + 0.05) / (low + 0.05)

    for ax in [*dark, *light]:
        grounds = [patch.get_facecolor() for patch in ax.patches if patch.get_gid() in atlas.regions]
        # The faintest is yellow on pale grounds.
        for ground in [ax.get_facecolor(), *grounds]:
            assert all(contrast(line.get_color(), ground) > 1.25 for line in ax.lines if line.get_gid() != "level")
            assert all(contrast(text.get_color(), ground) > 5.5 for text in ax.texts)


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
    told = [text.get_text() for text in panels[-1].get_legend().get_texts()]
    assert told == [name for name in pictures.VERDICTS if name in found.verdict]
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
    assert any(np.allclose(np.ravel(marks._offsets3d), 1.01 * least["gamma"]) for marks in ax.collections[1:])
    # Marks of every relative equilibrium, and the poles.
    found = paper.critical(3.25)
    kinds = ("minimum", "saddle", "maximum")
    at = {kind: [np.ravel(m._offsets3d) / 1.01 for m in ax.collections[1:] if m.get_gid() == kind] for kind in kinds}
    assert sum(map(len, at.values())) == len(found)
    assert all(min(np.linalg.norm(one - row["gamma"]) for one in at[kinds[row["index"]]]) < 1e-9 for row in found)
    assert sum("hat" in str(marks.get_gid()) for marks in ax.collections) == 2
    with pytest.raises(bifdiag.InputError, match=r"lowest energy at l = 1 is -\d"):
        paper.plot_sphere(-5, 1)


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
    assert np.allclose(-z[::8], motion.gamma @ center)


def test_the_energy_of_a_motion_is_kept(paper):
    motion = paper.orbit(gamma=[0.6, 0, 0.8], omega=[1, 0.3, 1], t=5)
    assert np.ptp(motion.energy) < 1e-12 and motion.energy[0] == pytest.approx(motion.meta["energy"])


ASYMMETRIC = bifdiag.Body([3, 2.5, 1.7], [0.3, -0.4, 0.8])


def grounds(svg):
    """The colours of the ground of each region in the command's picture."""
    stripes = dict(re.findall('<pattern id="(stripes-[0-9]+)"[^>]*>(.*?)</pattern>', svg, re.DOTALL))
    found = {}
    for name, fill in re.findall('id="main-(R[0-9]+)" fill="([^"]*)"', svg):
        pattern = stripes.get(fill.removeprefix("url(#").removesuffix(")"))
        found[name] = (
            [fill] if pattern is None else re.findall('x="[^"]*" width="[^"]*" height="[^"]*" fill="([^"]*)"', pattern)
        )
    return found


@pytest.mark.parametrize("body", [ASYMMETRIC, bifdiag.Body.preset("paper"), bifdiag.Body.preset("katok:7")])
@pytest.mark.parametrize("view", ["plane", "straight"])
def test_grounds_and_lines_have_the_colours_of_the_command(body, view, command, tmp_path):
    line = (f"--A={','.join(body.A)}", f"--r={','.join(body.r)}", f"--view={view}", "--out", tmp_path)
    command("atlas", *line)
    svg = (tmp_path / "diagram.svg").read_text(encoding="utf-8")
    atlas = body.atlas()
    ax = atlas.plot(plt.subplots()[1], view=view)
    told, known = grounds(svg), {region.id: region for region in atlas.regions}
    shown = {patch.get_gid(): [matplotlib.colors.to_hex(patch.get_facecolor()).upper()] for patch in ax.patches}
    for bands in ax.collections:
        if bands.get_gid().endswith("-stripes"):
            shown[bands.get_gid().removesuffix("-stripes")].append(
                matplotlib.colors.to_hex(bands.get_facecolor()[0]).upper()
            )
    assert told and all(shown[name] == colors for name, colors in told.items())
    # One tint for each type of component, by U and P.
    types = {(part.boundary_circles, part.genus): shown[name][0] for name in known for part in known[name].components[:1]}
    assert len(set(types.values())) == len(types)
    colors = {line.get_color().upper() for line in ax.lines if line.get_gid() != "level"}
    assert colors <= set(re.findall('stroke="(#[0-9A-F]{6})"', svg))


def test_every_region_that_is_seen_has_a_name():
    atlas = ASYMMETRIC.atlas()
    ax = atlas.plot()
    named = {text.get_gid() for panel in ax.figure.axes for text in panel.texts}
    assert named >= set(atlas.regions.ids)
    with pytest.raises(bifdiag.InputError, match="insets are axes of their own"):
        atlas.plot(ax, insets=True)


def test_a_new_figure_is_the_commands_picture(atlas, command, tmp_path):
    command("atlas", "--body=paper", "--view=plane", "--out", tmp_path)
    svg = (tmp_path / "diagram.svg").read_text(encoding="utf-8")
    ax = atlas.plot()
    letters = re.findall('id="([a-z])-regions"', svg)
    insets = ax.figure.axes[1:]
    assert [panel.get_title(loc="left") for panel in insets] == [f"({letter})" for letter in letters]
    frames = [patch for patch in ax.patches if patch.get_gid().startswith("frame")]
    assert [patch.get_bbox().intervalx.tolist() for patch in frames] == [list(panel.get_xlim()) for panel in insets]
    (legend,) = ax.figure.legends
    texts = [text.get_text() for text in legend.get_texts()]
    assert {"from +r̂", "pole −r̂ enters U", "dashed: unstable", "cusp", "pitchfork", "crossing"} <= set(texts)
    assert all(
        text in svg for text in texts if ":" not in text and "r̂" not in text
    ) and "A = (2, 11/10, 1)" in ax.get_title(loc="left")
    bare = atlas.plot(insets=False, legend=False)
    assert len(bare.figure.axes) == 1 and not bare.figure.legends


def test_events_are_marked_with_their_ids(atlas):
    for view in ("plane", "straight"):
        ax = atlas.plot(plt.subplots()[1], view=view, events="ids")
        marks = {marks.get_gid(): marks.get_offsets()[0] for marks in ax.collections if marks.get_gid().startswith("E")}
        assert (
            set(marks) == set(atlas.events.ids) == {text.get_text() for text in ax.texts if text.get_gid().startswith("E")}
        )
        if view == "plane":
            assert all(np.allclose(at, (atlas.events[name].h, atlas.events[name].l)) for name, at in marks.items())
    assert not [
        marks for marks in atlas.plot(plt.subplots()[1], events=False).collections if marks.get_gid().startswith("E")
    ]
    with pytest.raises(bifdiag.InputError, match='"ids" to name them'):
        atlas.plot(events="all")


def test_stripes_stay_in_their_region():
    # A region outside the window has an empty outline, which would not clip.
    atlas = ASYMMETRIC.atlas()
    ax = atlas.plot(h=(16, 18), l=(7.5, 7.6))
    inside = set(np.unique(atlas.region(np.linspace(16, 18, 200)[:, None], np.linspace(7.5, 7.6, 50))).tolist())
    striped = {bands.get_gid().removesuffix("-stripes") for bands in ax.collections if bands.get_gid().endswith("-stripes")}
    assert striped <= {atlas.regions[place].id for place in inside if place >= 0}


def test_dashes_are_those_of_the_pattern():
    from bifdiag.pictures.lines import styles

    red, blue = styles([("red", 9.0), (None, 2.0), ("blue", 4.0), (None, 5.0)], 2.0)
    assert red["linestyle"] == (10.0, (4.5, 5.5)) and blue["linestyle"] == (4.5, (2.0, 8.0))
    (both,) = styles([(None, 3.0), ("red", 9.0), (None, 2.7), ("red", 1.8), (None, 2.7)], 1.0)
    assert [both["linestyle"][0], *both["linestyle"][1]] == pytest.approx([16.2, 9.0, 2.7, 1.8, 5.7])


def test_many_motions_are_many_lines(paper):
    motion = paper.orbit(gamma=np.eye(3), omega=[1, 0.3, 1], t=3)
    ax = motion.plot(lw=2)
    long = [line for line in ax.lines if len(line.get_data_3d()[0]) > 2]
    assert len(long) == 3 and {line.get_linewidth() for line in long} == {2}
    # No corner is seen, and the samples are on the path.
    for line, part in zip(long, motion._parts(), strict=True):
        points = np.array(line.get_data_3d()).T
        steps = np.diff(points, axis=0)
        cosines = (
            (steps[1:] * steps[:-1]).sum(axis=1) / np.linalg.norm(steps[1:], axis=1) / np.linalg.norm(steps[:-1], axis=1)
        )
        assert cosines.min() > np.cos(np.radians(2)) and len(points) == 8 * (len(part) - 1) + 1
    # Between, the path is the motion's.
    fine, coarse = (paper.orbit([1, 0, 0], omega=[1, 0.3, 1], t=np.linspace(0, 2, count)) for count in (81, 11))
    height = -fine.gamma @ paper.com / np.linalg.norm(paper.com)
    assert np.allclose(coarse.plot().lines[0].get_data_3d()[2], height, atol=1e-4)
    # Through wide steps nothing is made up.
    wide = paper.orbit(gamma=[1, 0, 0], omega=[1, 0.3, 1], t=[0, 5, 10])
    assert len(wide.plot().lines[0].get_data_3d()[0]) == 3


def test_numbers_of_spheres_do_not_overlap(paper):
    motion = paper.orbit([0.6, 0, 0.8], omega=[1, 0.3, 1], t=3)
    for ax in (motion.plot(), paper.plot_sphere(3.8, 3.25)):
        ax.figure.draw_without_rendering()
        for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
            boxes = [label.get_window_extent() for label in axis.get_ticklabels()]
            assert len(boxes) == 3
            assert not any(box.overlaps(other) for place, box in enumerate(boxes) for other in boxes[:place])


def test_an_unknown_option_is_told(atlas):
    with pytest.raises(bifdiag.InputError, match=r"^vieww is an option neither"):
        atlas.plot(vieww="straight")
    atlas.plot(lw=2, solid_capstyle="round")


def test_a_notebook_shows_the_points_of_a_section(section):
    shown = section._repr_html_()
    picture = ElementTree.fromstring(shown[: shown.index("</svg>") + 6])
    paths = [element for element in picture if element.tag == "path"]
    assert sum(element.get("d").count("M") for element in paths) == len(section)
    drawn = [part for element in paths for part in element.get("d").split("M")[1:]]
    places = np.array([part.split("h")[0].split() for part in drawn], dtype=float)
    assert (places >= 0).all() and (places[:, 1] <= 120).all() and ((places[:, 0] <= 240) | (places[:, 0] >= 256)).all()
    assert (places[:, 0] > 250).sum() == (section.sheet == -1).sum()


def test_a_legend_stands_below_the_axes_that_are_given(atlas):
    figure, panels = plt.subplots(1, 2, layout="constrained", figsize=(12, 5))
    for panel, view in zip(panels, ("plane", "straight"), strict=True):
        atlas.plot(panel, view=view, legend=True)
    figure.canvas.draw()
    assert not figure.legends
    told = [panel.get_legend().get_window_extent() for panel in panels]
    for panel, box in zip(panels, told, strict=True):
        assert panel.get_window_extent().x0 <= box.x0 and box.y1 < panel.xaxis.label.get_window_extent().y0
    assert told[0].x1 < told[1].x0 and told[1].x1 < figure.bbox.x1


def test_numbers_and_names_of_a_straightened_plane_have_room():
    for body, width in ((ASYMMETRIC, 6.4), (bifdiag.Body(["3.4", 2.9, "1.3"], [0.2, -0.7, 0.45]), 4.5)):
        ax = body.atlas().plot(view="straight", figsize=(width, 4.8))
        ax.figure.canvas.draw()
        boxes = sorted((text.get_window_extent() for text in ax.get_xticklabels()), key=lambda box: box.x0)
        assert len(boxes) > 4 and all(one.x1 < other.x0 for one, other in itertools.pairwise(boxes))
        boxes = sorted((text.get_window_extent() for text in ax.get_yticklabels()), key=lambda box: box.y0)
        assert len(boxes) > 4 and all(one.y1 <= other.y0 + 3 for one, other in itertools.pairwise(boxes))
        own = ax.get_window_extent()
        assert all(own.x0 - 1 <= box.x0 and box.x1 <= own.x1 + 1 for box in (text.get_window_extent() for text in ax.texts))
