# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Memory does not grow with the number of steps.

A block with friction rides on a floor that shakes for ever, and below a roller that runs to and fro
without touching it: fine cells follow the roller, so the mesh changes all the time. The memory of
the process (VmRSS) is observed as long as it runs: its median in the second third and in the last
one may differ by what an allocator scatters, and by nothing per step. What it keeps once for all
steps it has taken by the end of the first third, if this has some hundred changes of the mesh.

    ./dev check --memory [--steps 10000]
"""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

STEP = 0.01
#: Bytes per step, between the middles of the two thirds, and what an allocator scatters.
LEAST_LEAK, SCATTER = 200, 1 << 20
INTERVAL = 0.05
SCENE = """
set Dimension = 2
subsection Time
  set Step size = %(step)r
  set End time  = %(end)r
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Lower corner     = -1, 0.01
    set Upper corner     = 1, 1.01
    set Repetitions      = 4, 2
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Damping          = 0.1, 0
    set Body force       = 0; -1
  end
end
subsection Obstacles
  set Names = floor, roller
  subsection floor
    set Shape  = plane
    set Normal = 0, 1
    set Motion = 0.02*sin(3*t); 0
  end
  subsection roller
    set Shape  = sphere
    set Centre = 0, 1.26
    set Radius = 0.2
    set Motion = 0.8*sin(40*t); 0
  end
end
subsection Contact
  set Pairs  = block : floor, block : roller
  set Motion = follow
  subsection block : floor
    set Friction coefficient = 0.3
  end
end
subsection Adaptivity
  set Indicator     = distance
  set Maximum level = 2
  set Distance      = 0.1
end
subsection Probes
  set Names = middle
  subsection middle
    set Point = 0, 0.01
  end
end
subsection Output
  set VTU = false
end
"""


def resident(process):
    """VmRSS in bytes; nothing once the process has ended."""
    try:
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
    except OSError:
        return None
    found = re.search(r"VmRSS:\s+(\d+) kB", status)
    return 1024 * int(found[1]) if found else None


def observe(command):
    """@return the exit status, and the memory in equal intervals"""
    samples = []
    environment = dict(
        os.environ,
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMP_NUM_THREADS="1",
    )
    with subprocess.Popen(command, env=environment) as process:
        while process.poll() is None:
            if (bytes_now := resident(process)) is not None:
                samples.append(bytes_now)
            time.sleep(INTERVAL)
    return process.returncode, samples


def n_meshes(history):
    """How often the number of cells differs from that of the row before: changes of the mesh that
    keep it are not seen."""
    header, *rows = [line.split(",") for line in history.read_text().splitlines()]
    cells = [row[header.index("cells")] for row in rows]
    return sum(a != b for a, b in zip(cells, cells[1:]))


def main():
    """@return 0 if the memory does not grow"""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("executable")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--steps", type=int, default=10000)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    scene, output = arguments.folder / "scene.prm", arguments.folder / "output"
    scene.write_text(SCENE % {"step": STEP, "end": STEP * arguments.steps}, encoding="utf-8")
    status, samples = observe(
        [arguments.executable, str(scene), "--quiet", "--set", f"Output directory={output}"]
    )
    if status != 0 or len(samples) < 20:
        print(f"exit status {status}, {len(samples)} observations: nothing can be judged")
        return 1
    third = len(samples) // 3
    early = statistics.median(samples[third : 2 * third])
    late = statistics.median(samples[2 * third :])
    changes, growth = n_meshes(output / "history.csv"), late - early
    most = SCATTER + LEAST_LEAK * arguments.steps / 3
    print(
        f"{arguments.steps} steps, {changes} of them changed the number of cells, "
        f"{len(samples)} observations: {early / 1e6:.2f} MB early, {late / 1e6:.2f} MB late, "
        f"{growth / 1e3:+.0f} kB; at most {most / 1e3:.0f} kB"
    )
    return 1 if growth > most or 10 * changes < arguments.steps else 0


if __name__ == "__main__":
    sys.exit(main())
