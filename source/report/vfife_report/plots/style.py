# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""How plots and pictures look: one place for fonts, colours and sizes."""
import re

import matplotlib
import numpy as np

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import Collection  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap, to_rgb  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Patch  # noqa: E402
from matplotlib.text import Text  # noqa: E402
from matplotlib.ticker import AutoLocator, LogLocator, MaxNLocator, NullFormatter, ScalarFormatter  # noqa: E402
from matplotlib.transforms import ScaledTranslation  # noqa: E402

# Okabe and Ito's colours, told apart by colour-blind readers too; black first.
COLOURS = ["#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
GREY = "#8c8c8c"
PALE = "#e6eef5"
EDGE = "#303030"  # of elements
# From the grey of unloaded steel, on which mesh edges and shading are seen, by blue to orange and red.
STRESS_MAP = LinearSegmentedColormap.from_list(
    "stress", ["#e6e9ed", "#b5cde3", "#6f9fd0", "#f0c04a", "#df7a20", "#9c1a1c"])
PRESSURE_MAP = LinearSegmentedColormap.from_list(
    "pressure", ["#e6e9ed", "#f0c04a", "#d6531d", "#5b0f20"])
SIGNED_MAP = plt.get_cmap("RdBu_r")

plt.rcParams.update({
    "figure.figsize": (8.0, 5.0),
    "figure.constrained_layout.use": True,
    "font.size": 10,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e4e4e4",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.1,
    "axes.prop_cycle": matplotlib.cycler(color=COLOURS),
    "svg.hashsalt": "vfife",  # the same run gives the same file
    "savefig.dpi": 100,
})

TITLE_ROOM = 0.28  # height of a title's line [inches]

# Of pictures so wide that they are shown smaller than they are.
WIDE = {"font.size": 15, "axes.titlesize": 15}


def round_ticks(axes):
    """Ticks in steps of 1, 2 or 5: matplotlib takes 2.5 as well, whose ticks have digits that are not round."""
    for axis in (axes.xaxis, axes.yaxis):
        if type(axis.get_major_locator()) is AutoLocator:
            axis.set_major_locator(MaxNLocator(nbins="auto", steps=[1, 2, 5, 10]))
    for inner in axes.child_axes:
        round_ticks(inner)


def name_decades(axes):
    """An axis of ordinates by logarithms with numbers also between the decades, where there are few of these."""
    low, high = axes.get_ylim()
    if high < 30 * low:
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter(ScalarFormatter())
        axes.yaxis.set_minor_formatter(NullFormatter())


# What matplotlib calls curves without names. All other names with an underscore in front are a user's, though
# matplotlib leaves them out of legends.
NO_NAME = re.compile(r"_(child|line|collection|patch|image|container|nolegend)\d*_?")
OF_LOGARITHMS = re.compile(r"\\math(default|regular)")  # formulas of matplotlib's own, at ticks


def is_name(label):
    return bool(label) and NO_NAME.fullmatch(label) is None


def list_named(axes):
    """Curves and areas that have names, and these."""
    drawn = [artist for artist in axes.get_children() if isinstance(artist, (Line2D, Patch, Collection))]
    named = [artist for artist in [*drawn, *axes.containers] if is_name(artist.get_label())]
    return named, [artist.get_label() for artist in named]


def has_dollar(text):
    return "$" in text and OF_LOGARITHMS.search(text) is None


def without_formulas(text):
    """As matplotlib writes a text in which a dollar sign is a letter and begins no formula."""
    return re.sub(r"(?<!\\)\$", r"\\$", text)


def take_texts_literally(plot):
    """Names of users in titles, legends and at ticks are no formulas."""
    for axes in plot.axes:
        for axis in (axes.xaxis, axes.yaxis):
            names = [text.get_text() for text in axis.get_ticklabels()]
            if any(has_dollar(name) for name in names):
                axis.set_ticks(axis.get_ticklocs(), [without_formulas(name) for name in names])
    for text in plot.findobj(lambda artist: isinstance(artist, Text) and has_dollar(artist.get_text())):
        text.set_text(without_formulas(text.get_text()))


def save(plot, path):
    """Writes the plot or picture beside its place and renames it, so that nobody meets half a file."""
    for axes in plot.axes:
        round_ticks(axes)
    take_texts_literally(plot)
    temporary = path.with_name("." + path.name)
    metadata = {"Date": None} if path.suffix == ".svg" else None
    plot.savefig(temporary, format=path.suffix[1:], metadata=metadata)
    temporary.replace(path)
    plt.close(plot)


def add_legend(axes, beside=True, **options):
    """A frameless legend of the curves that have names, where there are any and no curve is: beside the axes, above them
    where others stand there or `beside` is false."""
    named, names = list_named(axes)
    if not named:
        return
    place = axes.get_subplotspec()
    if beside and (place is None or place.is_last_col()):
        options = {**options, "loc": "upper left", "bbox_to_anchor": (1.01, 1), "ncol": 1}
    else:
        # Above the title, where the axes have one.
        above = ScaledTranslation(0, TITLE_ROOM if axes.get_title(loc="left") else 0.03, axes.figure.dpi_scale_trans)
        options = {"fontsize": 8, **options, "loc": "lower left", "bbox_to_anchor": (0, 1),
                   "bbox_transform": axes.transAxes + above}
    # With a blank, or matplotlib leaves out names with an underscore in front.
    legend = axes.legend(named, [" " + name for name in names], frameon=False, borderaxespad=0, **options)
    for text, name in zip(legend.get_texts(), names):
        text.set_text(name)


def label_orders(axes, orders, end, top, word="mesh order"):
    """Lines of orders through the origin, (order, slope) each, up to the abscissa `end` and the ordinate `top`, named where
    they leave the axes: above or to the right, where no curve is."""
    for order, slope in orders:
        reach = min(end, top / slope)
        name = f"{word} {order:.0f}"
        axes.plot([0, end], [0, slope * end], color=GREY, linewidth=0.7, gid=name)
        place = {"xytext": (3, 0), "va": "center"} if reach == end else {"xytext": (0, 3), "ha": "center"}
        axes.annotate(name, (reach, slope * reach), textcoords="offset points", fontsize=7, color=GREY, annotation_clip=False,
                      **place)


def darken_edges(colour, edge):
    """Colours (n, 3) with those at mesh edges drawn towards the edges' colour."""
    return np.where(edge[:, None], 0.5 * colour + 0.5 * np.array(to_rgb(EDGE)), colour)


def label_ends(axes, curves):
    """Names curves at their last points instead of in a legend: (x, y, text, colour) each. To be
    called when the axes have their limits; names that would overlap are moved apart."""
    low, high = axes.get_ylim()
    points = axes.get_position().height * axes.figure.get_figheight() * 72
    previous = -np.inf
    for x, y, text, colour in sorted(curves, key=lambda curve: curve[1]):
        place = max((y - low) / (high - low) * points, previous + 11)
        previous = place
        axes.annotate(text, (x, y), xytext=(4, place - (y - low) / (high - low) * points),
                      textcoords="offset points", color=colour, va="center",
                      annotation_clip=False, fontsize=9)
