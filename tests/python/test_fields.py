# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Fields by the Python package, and what is said where pyvista is not installed.

The deformed disc never enters the floor, falls with its velocity before it meets the floor, and is
pressed where it touches it. Files of fields have seven digits.
"""

import sys
import unittest
import unittest.mock

import running
import signorini

try:
    import pyvista
except ImportError:
    pyvista = None


def with_fields(processes):
    """A run with fields at each step."""
    scene = running.disc().changed({"Output/VTU": True, "Output/VTU every": 1})
    return signorini.run(scene, running.folder / f"fields_{processes}", processes=processes)


class Fields(unittest.TestCase):
    @unittest.skipIf(
        pyvista is None, "pyvista is not installed: ./dev test puts it into build/venv"
    )
    def test_meshes_over_time(self):
        for processes in (1, 2):
            result = with_fields(processes)
            volume, surface = result.volume, result.surface
            self.assertEqual(volume.times, list(result.history.time.round(12)))
            self.assertEqual(len(volume), 41)
            self.assertEqual(volume[-1].n_cells, result.history.cells.iloc[-1])
            self.assertEqual(volume.at(0.0121)["displacement"].shape[1], 3)
            fallen = volume.deformed(volume.times.index(0.015)).center[1] - volume[0].center[1]
            self.assertAlmostEqual(fallen, -0.015, delta=1e-6)
            lowest = [volume.deformed(n).bounds[2] for n in range(len(volume))]
            self.assertGreater(min(lowest), -1e-6)
            self.assertLess(min(lowest), 1e-6)
            self.assertEqual(len(list(surface)), 41)
            pressed = [mesh["CPRESS"].max() > 0 for _, mesh in surface]
            self.assertEqual(pressed, [force > 0 for force in result.history.contact_force])

    def test_without_pyvista(self):
        series = with_fields(1).volume
        with unittest.mock.patch.dict(sys.modules, pyvista=None):
            self.assertEqual(len(series), 41)
            with self.assertRaisesRegex(ImportError, "pip install pyvista"):
                print(series[0])

    def test_without_fields(self):
        result = signorini.run(running.disc(), running.folder / "none")
        with self.assertRaisesRegex(FileNotFoundError, "Output/VTU = true"):
            print(result.volume)


if __name__ == "__main__":
    running.main()
