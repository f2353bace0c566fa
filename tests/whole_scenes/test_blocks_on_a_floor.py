# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Two blocks slide on a floor into each other. As boxes they are refused where contact is
linearised, because the nodes at their lower edges would have two partners; the message names what
helps, and with that the scene runs: the faces next to these edges have a boundary id that no pair
names. Where contact follows the motion (tests/moving_contact) nodes may have two partners."""

import pathlib
import subprocess

import check_history

SCENE = """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = 0.1
end
subsection Bodies
  set Names = left, right
  subsection left
    {left}
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 2; 0
  end
  subsection right
    {right}
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0.3
    set Density          = 1
  end
end
""" + check_history.on_floor("left[2]", "right[2]", more=", {pair}\n  set Motion = linearised")


def ucd(x):
    """A square [x, x+1] x [0, 1] of 4 by 4 cells, with the boundary ids of a box, but 9 at the
    lowest faces of its sides."""
    nodes = [(x + i / 4, j / 4) for j in range(5) for i in range(5)]

    def node(i, j):
        return 5 * j + i + 1

    cells = [
        f"0 quad {node(i, j)} {node(i + 1, j)} {node(i + 1, j + 1)} {node(i, j + 1)}"
        for j in range(4)
        for i in range(4)
    ]
    for k in range(4):
        cells.append(f"{0 if k else 9} line {node(0, k)} {node(0, k + 1)}")
        cells.append(f"{1 if k else 9} line {node(4, k)} {node(4, k + 1)}")
        cells.append(f"2 line {node(k, 0)} {node(k + 1, 0)}")
        cells.append(f"3 line {node(k, 4)} {node(k + 1, 4)}")
    lines = [f"{len(nodes)} {len(cells)} 0 0 0"]
    lines += [f"{k + 1} {a} {b} 0" for k, (a, b) in enumerate(nodes)]
    lines += [f"{k + 1} {cell}" for k, cell in enumerate(cells)]
    return "\n".join(lines) + "\n"


class BlocksOnAFloor(check_history.SceneTest):
    def test_boxes_are_refused_with_the_remedy(self):
        box = (
            "set Shape = box\nset Lower corner = {0}, 0\nset Upper corner = {1}, 1\n"
            "set Repetitions = 4, 4"
        )
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        for pair in ("left[1] : right[0]", "right[0] : left[1]"):
            text = SCENE.format(left=box.format(0, 1), right=box.format(1.05, 2.05), pair=pair)
            (folder / "boxes.prm").write_text(text, encoding="utf-8")
            result = subprocess.run(
                [check_history.settings["executable"], str(folder / "boxes.prm"), "--validate"],
                capture_output=True,
                text=True,
                timeout=300,
                check=False,
            )
            self.assertEqual(result.returncode, 2)
            self.assertIn(
                "give the faces next to the edge a boundary id that no pair names", result.stderr
            )

    def test_the_remedy_helps(self):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        for name, x in (("left", 0), ("right", 1.05)):
            (folder / f"{name}.ucd").write_text(ucd(x), encoding="utf-8")
        file = f"set Shape = file\nset File = {folder.resolve()}/"
        run = check_history.Run(
            SCENE.format(
                left=file + "left.ucd", right=file + "right.ucd", pair="left[1] : right[0]"
            ),
            "files",
        )
        self.expect_contact(run)
        self.expect_ledger_closes(run)
        # The right block has taken the momentum over, 2 in all.
        self.assertAlmostEqual(run["momentum_x"][-1], 2.0, places=8)


if __name__ == "__main__":
    check_history.main()
