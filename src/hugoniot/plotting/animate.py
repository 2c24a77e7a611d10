"""A two-dimensional run as a film: one map per snapshot, all on the same axes and with the same colours."""

import pathlib

import matplotlib
import numpy as np
from matplotlib import animation
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from hugoniot.errors import DeckError
from hugoniot.plotting.plane import map_, needs_map, needs_plane, places_of, plane_field, reach
from hugoniot.plotting.style import RC, length_scale
from hugoniot.plotting.xt import colours_of

WRITERS = {".gif": "pillow", ".mp4": "ffmpeg"}
COLOURS, GREYS = 216, 40      # of a .gif, which has 256 colours: the scale of the field, and text and lines
MOST_FRAMES = 300


def animate(run, field: str, path, frames_per_second: float = 12.0, every: int = 1, **options) -> int:
    """Write a film (.gif or .mp4) of a field; gives the number of frames. `options` are those of `plane.map_`.

    every   take each `every`-th snapshot
    Raises `DeckError` for a file of another kind, for too many frames, and for an .mp4 where ffmpeg is not installed.
    """
    needs_plane(run, "film")
    needs_map(run, field)
    path = pathlib.Path(path)
    writer = _writer(path, frames_per_second)
    rows = run.arrays("snapshots")
    taken = list(range(0, len(rows["time"]), every))
    if len(taken) > MOST_FRAMES:
        hint = f"use --every {-(-len(rows['time']) // MOST_FRAMES)} or more"
        raise DeckError.single("animate", None, "--every", f"{len(taken)} frames are too many", hint)
    values = np.concatenate([plane_field(run, field, k) for k in taken])
    colours, limits = colours_of(field, values, None)
    options = {"limits": limits, "mesh": False, **options}
    box = _window(run, taken, options.get("mirror", True))
    with matplotlib.rc_context({**RC, "savefig.dpi": 110}):
        figure = Figure(figsize=(6.4, 4.8))
        FigureCanvasAgg(figure)
        with writer.saving(figure, str(path), 110):
            for k in taken:
                figure.clear()
                ax, bar = figure.add_axes((0.12, 0.12, 0.68, 0.8)), figure.add_axes((0.84, 0.16, 0.025, 0.7))
                map_(run, field, rows["time"][k], ax=ax, colorbar=bar, **options)
                ax.set_xlim(box[0])
                ax.set_ylim(box[1])
                writer.grab_frame()
                if isinstance(writer, Gif):
                    writer.keep_colours(colours)
    return len(taken)


class Gif(animation.PillowWriter):
    """A .gif whose frames share one palette made of the colours of the field, so that equal values look equal in every frame."""

    def keep_colours(self, colours) -> None:
        """Replace the colours of the last frame by the nearest of the palette, as a palette of its own would alter those of the scale."""
        from PIL import Image

        scale = matplotlib.colormaps.get_cmap(colours)(np.linspace(0.0, 1.0, COLOURS))[:, :3]
        palette = Image.new("P", (1, 1))
        palette.putpalette(np.rint(255 * np.vstack([scale, np.linspace((0.0,) * 3, (1.0,) * 3, GREYS)])).astype(np.uint8).tobytes())
        self._frames[-1] = self._frames[-1].convert("RGB").quantize(palette=palette, dither=Image.Dither.NONE)


def _writer(path: pathlib.Path, frames_per_second: float):
    kind = WRITERS.get(path.suffix.lower())
    if kind is None:
        raise DeckError.single("animate", None, "--out", f"cannot write a film named '{path.name}'", "end its name with .gif or .mp4")
    if not animation.writers.is_available(kind):
        raise DeckError.single("animate", None, "--out", f"{path.suffix} needs the program ffmpeg, which is not installed",
                               "install ffmpeg, or write a .gif")
    return (Gif if kind == "pillow" else animation.writers[kind])(fps=frames_per_second)


def _window(run, taken, mirror: bool):
    """Limits of both axes, in the units of the pictures, that hold every frame."""
    fx = length_scale(max(reach(run)))[1]
    ends = np.array([[places.min(axis=0), places.max(axis=0)] for places in (places_of(run, k) for k in taken)]) * fx
    low, high = float(ends[:, 0, 0].min()), float(ends[:, 1, 0].max())
    if mirror and run.setup["geometry"] == "axisymmetric":
        low = -high
    bottom, top = float(ends[:, 0, 1].min()), float(ends[:, 1, 1].max())
    margin = 0.03 * max(high - low, top - bottom)
    return (low - margin, high + margin), (bottom - margin, top + margin)
