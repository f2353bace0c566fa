# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The film of ./dev plot DIR --animation has a picture for each moment of the run, and they differ
where the body moves; without fields, or without ffmpeg for mp4, the message says what to do.

test_animation.py EXECUTABLE FOLDER
"""

import os
import shutil
import subprocess
import sys
import unittest

import numpy
from PIL import Image, ImageSequence
from small_runs import SOURCE, Runs

from plotting import fields  # noqa: E402  (small_runs knows where)

EXECUTABLE, FOLDER = sys.argv[1:3]
RUNS = Runs(EXECUTABLE, FOLDER)


def plot(folder, *options, path=None):
    """The answer of plot.py."""
    return subprocess.run(
        [sys.executable, "-B", SOURCE / "tools" / "plot.py", folder, "--animation", *options],
        capture_output=True,
        text=True,
        check=False,
        env=os.environ if path is None else {**os.environ, "PATH": path},
    )


class Animation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = RUNS.run("disc")

    def test_gif(self):
        answer = plot(self.folder, "gif")
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        moments = len(fields.read_series(self.folder / "volume.pvd"))
        with Image.open(self.folder / "pictures" / "bodies.gif") as film:
            frames = [
                numpy.asarray(frame.convert("L"), dtype=float)
                for frame in ImageSequence.Iterator(film)
            ]
        self.assertEqual(len(frames), moments)
        for before, after in zip(frames, frames[1:]):
            self.assertGreater(abs(after - before).max(), 50)

    @unittest.skipUnless(shutil.which("ffmpeg"), "no ffmpeg: apt-get install ffmpeg")
    def test_mp4(self):
        answer = plot(self.folder)
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        probe = subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames"]
            + ["-of", "csv=p=0", self.folder / "pictures" / "bodies.mp4"],
            capture_output=True,
            text=True,
            check=True,
        )
        self.assertEqual(int(probe.stdout), len(fields.read_series(self.folder / "volume.pvd")))

    def test_what_is_missing_is_named(self):
        answer = plot(self.folder, "mp4", path="/nowhere")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("apt-get install ffmpeg", answer.stderr)
        answer = plot(RUNS.run("implicit", fields=False), "gif")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("volume.pvd", answer.stderr)
        self.assertNotIn("Traceback", answer.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
