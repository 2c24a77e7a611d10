"""Zones of a mesh as polygons of a picture, however many they are."""

import numpy as np
from matplotlib.artist import allow_rasterization
from matplotlib.collections import PolyCollection
from matplotlib.transforms import Bbox

MOST_VECTORS = 20_000    # zones drawn one by one in files that keep lines as lines


def polygons(corners: np.ndarray, **style) -> PolyCollection:
    """Polygons of equal numbers of corners (n, corner, 2); of very many, in a file of lines, an image."""
    return PolyCollection(corners, **style) if len(corners) <= MOST_VECTORS else _ManyPolygons(corners, **style)


class _ManyPolygons(PolyCollection):
    """Polygons of which a part at a time is turned into paths: a path takes a thousand bytes."""

    def __init__(self, corners: np.ndarray, **style):
        super().__init__([], rasterized=True, **style)
        self._corners = corners

    def get_datalim(self, transData):
        """The box of all of them."""
        return Bbox([self._corners.min(axis=(0, 1)), self._corners.max(axis=(0, 1))])

    @allow_rasterization
    def draw(self, renderer):
        """Draw the parts one after the other."""
        values = self.get_array()
        for first in range(0, len(self._corners), MOST_VECTORS):
            part = slice(first, first + MOST_VECTORS)
            self.set_verts(self._corners[part])
            if values is not None:
                self.set_array(values[part])
            super().draw(renderer)
        self.set_verts([])
        self.set_array(values)
