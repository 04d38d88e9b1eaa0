"""What the command's picture shows, drawn with matplotlib: lines in patterns, grounds in stripes, marks, the legend."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..optional import needed
from .axes import Array

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from matplotlib.axes import Axes

Pattern = list[tuple[str | None, float]]
"""Lengths in pixels, each in a colour or empty, in turn."""

POINT = 0.75
"""Points in a pixel of the command's picture."""

STRIPE = 5 / 96
"""Width of a stripe in inches."""

REACH = 40.0
"""How far stripes reach, in inches."""

COLUMN = 2.1
"""Width of a column of the legend in inches."""

BELOW = 5.5
"""How far the legend of given axes stands below them, in heights of its letters: numbers and a name are between."""

SHAPES = {"diamond": "D", "triangle": "^", "ring": "o", "dot": "."}
"""Marks by the names of their shapes."""

EVENTS = {"cusp": "diamond", "pitchfork": "triangle", "crossing": "ring"}
"""Shapes of the marks of events."""


def is_dark(ax: "Axes") -> bool:
    """Whether the ground of axes is nearer to black than to white."""
    red, green, blue = needed("matplotlib.colors", "plot").to_rgb(ax.get_facecolor())
    return bool(0.3 * red + 0.59 * green + 0.11 * blue < 0.5)


def styles(pattern: Pattern, width: float) -> "Iterator[dict[str, Any]]":
    """The lines of one colour that make a pattern when they are drawn upon each other."""
    drawn = {"linewidth": width * POINT}
    if len(pattern) == 1:
        yield drawn | {"color": pattern[0][0], "linestyle": "-"}
        return
    for color in dict.fromkeys(color for color, _ in pattern if color is not None):
        # Dashes begin with what is drawn, and are told in widths of the line.
        first = next(place for place, (own, _) in enumerate(pattern) if own == color)
        turned = [*pattern[first:], *pattern[:first]]
        lengths: list[float] = []
        for place, (own, length) in enumerate(turned):
            starts = place == 0 or (own == color) != (turned[place - 1][0] == color)
            lengths = [*lengths, length / width] if starts else [*lengths[:-1], lengths[-1] + length / width]
        if len(lengths) % 2:
            lengths.append(0.0)
        before = sum(length for _, length in pattern[:first]) / width
        yield drawn | {"color": color, "linestyle": (sum(lengths) - before, tuple(lengths))}


def ground(ax: "Axes", path: Any, colors: "Sequence[str]", region: str) -> None:
    """Fills a region, with stripes if it has several colours."""
    from matplotlib.collections import PathCollection
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    patch = PathPatch(path, facecolor=colors[0], edgecolor="none", zorder=0, gid=region)
    ax.add_patch(patch)
    # An empty path would not clip anything.
    for place, color in enumerate(colors[1:], 1) if len(path.vertices) else ():
        # Bands that rise to the right, from the corner of the figure on.
        left = np.arange(-REACH, REACH, STRIPE * len(colors) * np.sqrt(2)) + place * STRIPE * np.sqrt(2)
        wide = STRIPE * np.sqrt(2)
        corners = [[[x, 0], [x + wide, 0], [x + wide + REACH, REACH], [x + REACH, REACH], [x, 0]] for x in left.tolist()]
        bands = Path.make_compound_path(*(Path(corner, closed=True) for corner in corners))
        drawn = PathCollection([bands], facecolors=[color], linewidths=0, zorder=0.1, gid=f"{region}-stripes")
        drawn.set_transform(ax.figure.dpi_scale_trans)
        ax.add_collection(drawn, autolim=False)
        drawn.set_clip_path(patch)


def mark(shape: str, ink: str, paper: str) -> dict[str, Any]:
    """How a mark of a shape is drawn by ``Axes.plot``."""
    fill = "none" if shape == "ring" else ink
    edge = ink if shape == "ring" else paper
    return {
        "marker": SHAPES[shape],
        "linestyle": "none",
        "markersize": 4.5,
        "markerfacecolor": fill,
        "markeredgecolor": edge,
        "markeredgewidth": 0.8,
    }


def event(ax: "Axes", kind: str, at: "Sequence[float]", name: str, drawn: dict[str, Any], *, named: bool) -> None:
    """Marks an event, and writes its id beside it if that is wanted."""
    style = mark(EVENTS[kind], drawn["ink"], drawn["paper"])
    ax.scatter(
        [at[0]],
        [at[1]],
        marker=style["marker"],
        s=style["markersize"] ** 2,
        facecolors=style["markerfacecolor"],
        edgecolors=style["markeredgecolor"],
        linewidths=style["markeredgewidth"],
        zorder=3,
        gid=name,
    )
    if named:
        near: dict[str, Any] = {"textcoords": "offset points", "xytext": (4, 4), "fontsize": "x-small", "gid": name}
        ax.annotate(name, (at[0], at[1]), color=drawn["ink"], annotation_clip=True, clip_on=True, **near)


def label(ax: "Axes", found: tuple[Any, ...], region: str, drawn: dict[str, Any], scale: float = 1.0) -> None:
    """Writes the label of a region, with an arrow if it stands beside it."""
    _, lines, size, at, tip = found
    text = "\n".join(filter(None, lines))
    # In the command's picture the second line has smaller letters.
    size *= 0.88 if len(lines) > 1 and len(lines[1]) > len(lines[0]) + 2 else 1.0
    arrow: dict[str, Any] = {}
    if tip is not None:
        box = {"boxstyle": "square,pad=0.15", "facecolor": drawn["paper"], "edgecolor": "0.5", "linewidth": 0.4}
        arrow = {"arrowprops": {"arrowstyle": "->", "linewidth": 0.6, "color": drawn["ink"]}, "bbox": box}
    style: dict[str, Any] = {"ha": "center", "va": "center", "color": drawn["ink"], "gid": region}
    ax.annotate(
        text, tip or at, at, fontsize=size * POINT * scale, linespacing=1.0, clip_on=True, zorder=4, **style, **arrow
    )


def legend(ax: "Axes", drawn: dict[str, Any], *, of_figure: bool) -> None:
    """Says what lines, marks and grounds mean: below all of a figure, or below these axes."""
    from matplotlib.legend_handler import HandlerTuple
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    handles: list[Any] = []
    for shape, colors, line, _ in drawn["legend"]:
        if shape is not None:
            handles.append(Line2D([], [], **mark(shape, drawn["ink"], drawn["paper"])))
        elif colors is not None:
            handles.append(tuple(Patch(facecolor=color, edgecolor="none") for color in colors))
        else:
            handles.append(tuple(Line2D([], [], **style) for style in styles(*line)))
    figure: Any = ax.figure
    texts = [text for *_, text in drawn["legend"]]
    style: dict[str, Any] = {"fontsize": "x-small", "frameon": False, "handlelength": 2.6}
    style["handler_map"] = {tuple: HandlerTuple(ndivide=1, pad=0)}
    inches = figure.get_size_inches()[0] if of_figure else ax.get_window_extent().width / figure.dpi
    style["ncols"] = max(1, int(inches // COLUMN))
    if of_figure:
        figure.legend(handles, texts, loc="outside lower left", **style)
    else:
        ax.legend(handles, texts, loc="upper left", bbox_to_anchor=(0, 0), borderaxespad=BELOW, **style)


def closed(outline: Array) -> Array:
    """The first point again at the end."""
    return outline if len(outline) and (outline[0] == outline[-1]).all() else np.concatenate([outline, outline[:1]])
