#!/usr/bin/python3 -B
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Pictures of one run: plot.py DIR reads tables and fields in DIR, writes DIR/pictures/*.png, and
with --animation a film of the bodies, too."""

import argparse
import pathlib
import sys

try:
    from plotting import animation, pictures
except ImportError as error:
    sys.exit(
        f"{pathlib.Path(sys.argv[0]).name}: {error}. On Debian: apt-get install "
        "python3-matplotlib python3-meshio, which is for Debian's own /usr/bin/python3."
    )

from plotting.problem import Problem


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "directory", type=pathlib.Path, metavar="DIR", help="output directory of a run"
    )
    parser.add_argument(
        "--animation",
        choices=("mp4", "gif"),
        nargs="?",
        const="mp4",
        help="a film of the bodies as well, DIR/pictures/bodies.mp4 (by ffmpeg) or bodies.gif",
    )
    return parser.parse_args()


def main():
    arguments = read_arguments()
    directory = arguments.directory
    if not directory.is_dir():
        sys.exit(f"plot.py: {directory} is not a directory. Give the 'Output directory' of a run.")
    try:
        if arguments.animation:
            animation.require(arguments.animation)
        written, problems, history = pictures.draw_pictures(directory)
        if arguments.animation:
            written.append(animation.animate(directory, arguments.animation))
    except Problem as problem:
        sys.exit(f"plot.py: {problem}")
    print("Writing")
    for path in written:
        print(f"  {path}")
    for problem in problems:
        print(f"plot.py: left out: {problem}", file=sys.stderr)
    # A run without fields or probes is in order; one without a history has nothing to show.
    return 0 if history else 1


if __name__ == "__main__":
    sys.exit(main())
