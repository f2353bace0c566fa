# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Series of fields as pyvista meshes."""

import pathlib
import xml.etree.ElementTree as ElementTree


def _pyvista():
    try:
        import pyvista  # pylint: disable=import-outside-toplevel
    except ImportError:
        raise ImportError(
            "fields need pyvista, which is not installed. Install it with: pip install pyvista"
            " (or `signorini[fields]`). Tables are read without it."
        ) from None
    return pyvista


class Series:
    """The meshes of a .pvd, one for each time at which fields were written.

    series[-1] is the last mesh; for time, mesh in series: ... goes through all of them. Points are
    those of the reference configuration.
    """

    def __init__(self, path):
        self.path = pathlib.Path(path)
        if not self.path.is_file():
            raise FileNotFoundError(
                f"{path}: there are no fields. Run the scene with `Output/VTU = true`."
            )
        entries = list(ElementTree.parse(self.path).iter("DataSet"))
        self.times = [float(entry.get("timestep")) for entry in entries]
        self.files = [self.path.parent / entry.get("file") for entry in entries]

    def __len__(self):
        return len(self.files)

    def __getitem__(self, position):
        """The mesh at a position of times. Raises ImportError without pyvista."""
        return _pyvista().read(self.files[position])

    def __iter__(self):
        return ((time, self[position]) for position, time in enumerate(self.times))

    def at(self, time):
        """The mesh whose time is nearest."""
        return self[min(range(len(self)), key=lambda i: abs(self.times[i] - time))]

    def deformed(self, position, factor=1.0):
        """The mesh at a position of times, its points moved by factor times the displacement."""
        return self[position].warp_by_vector("displacement", factor=factor)
