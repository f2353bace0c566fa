# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Scenes whose problems are written for FCLIB, and what is in the files.

Only h5py and numpy; the layout is that of fclib.h (version 3.1), written down a second time.
"""

import pathlib
import sys

import check_history

SKIPPED = 77

try:
    import h5py
    import numpy
except ImportError as error:
    print(f"skipped: {error}; on Debian: apt-get install python3-h5py")
    sys.exit(SKIPPED)

#: Errors of forces are errors of the solver.
ACCURATE = "Solver/Tolerance=1e-15"

BOX_ON_TABLE = """
set Dimension = 3
subsection Time
  set Scheme    = contact-stabilized
  set Step size = 0.004
  set End time  = 0.06
end
subsection Bodies
  set Names = box, table
  subsection box
    set Shape            = box
    set Lower corner     = -0.3, 0.05, 0.001
    set Upper corner     = 0.3, 0.45, 0.3
    set Repetitions      = 4, 3, 2
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0.3
    set Density          = 10
    set Initial velocity = 0.5 - 2*(y - 0.25); 0.3 + 2*x; -0.2
    set Body force       = 0; 0; -100
    set Damping          = 0.5, 1e-4
  end
  subsection table
    set Shape            = box
    set Lower corner     = -0.7, 0, -0.2
    set Upper corner     = 0.7, 0.7, 0
    set Repetitions      = 5, 3, 1
    set Young's modulus  = 3e4
    set Poisson's ratio  = 0.3
    set Density          = 20
    set Dirichlet        = 4: 0.01*sin(100*t); 0.005*sin(70*t); 0 | 2: -; 0.005*sin(70*t); -
  end
end
subsection Contact
  set Motion = linearised
  set Pairs  = {pair}
  subsection {pair}
    set Friction coefficient = 0.3 + 0.1*x
  end
end
"""


#: A block that slides over a floor into a wall: its lower corner has two contacts.
BLOCK_IN_CORNER = """
set Dimension = 2
subsection Time
  set Scheme    = contact-stabilized
  set Step size = 0.005
  set End time  = 0.2
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Lower corner     = -0.4, 0
    set Upper corner     = -0.02, 0.3
    set Repetitions      = 5, 4
    set Young's modulus  = 2e4
    set Poisson's ratio  = 0.3
    set Density          = 10
    set Initial velocity = 0.8; -0.1
    set Body force       = 20; -100
  end
end
subsection Obstacles
  set Names = floor, wall
  subsection floor
    set Normal = 0, 1
  end
  subsection wall
    set Normal = -1, 0
  end
end
subsection Contact
  set Motion = follow
  set Pairs  = block : floor, block : wall
  subsection block : floor
    set Friction coefficient = 0.3
  end
  subsection block : wall
    set Friction coefficient = 0.2
  end
end
"""


def box_on_table(pair):
    """A spinning box that comes down obliquely on a table whose nodes lie elsewhere: mortar
    coupling in 3d, with friction in two directions. The table is shaken by its lower side and by
    the one in front, where directions are prescribed in nodes of the contact surface.
    """
    return BOX_ON_TABLE.replace("{pair}", pair)


class Problem:
    """A file of FCLIB."""

    def __init__(self, path):
        with h5py.File(path) as file:
            self.attributes = dict(file.attrs)
            problem = file["fclib_global"]
            self.dim = int(problem["spacedim"][0])
            self.M, self.H = Matrix(problem["M"]), Matrix(problem["H"])
            self.f, self.w, self.mu = (problem["vectors"][name][:] for name in ("f", "w", "mu"))
            self.v, self.u, self.r = (file["solution"][name][:] for name in ("v", "u", "r"))
            self.has_local_form = "fclib_local" in file
            if self.has_local_form:
                local = file["fclib_local"]
                self.W, self.q = Matrix(local["W"]).dense(), local["vectors"]["q"][:]

    def by_contact(self, vector):
        """A row for each contact: the normal component, then the tangential ones."""
        return vector.reshape(len(self.mu), self.dim)


class Matrix:
    """Of compressed columns."""

    def __init__(self, group):
        m, n, nz, nzmax = (int(group[name][0]) for name in ("m", "n", "nz", "nzmax"))
        starts, self.rows, self.values = group["p"][:], group["i"][:], group["x"][:]
        assert nz == -1 and len(starts) == n + 1
        assert len(self.rows) == len(self.values) == nzmax == starts[-1]
        self.shape = (m, n)
        self.columns = numpy.repeat(numpy.arange(n), numpy.diff(starts))

    def times(self, vector):
        return numpy.bincount(self.rows, self.values * vector[self.columns], self.shape[0])

    def transposed_times(self, vector):
        return numpy.bincount(self.columns, self.values * vector[self.rows], self.shape[1])

    def dense(self):
        result = numpy.zeros(self.shape)
        result[self.rows, self.columns] = self.values
        return result


def run(scene, name, *overrides):
    """The run of a scene and the problems of its steps, by their number."""
    done = check_history.Run(scene, f"fclib-{name}", (ACCURATE, *overrides))
    files = sorted(pathlib.Path(done.folder / "output" / "fclib").glob("step_*.hdf5"))
    return done, {int(path.stem[len("step_") :]): Problem(path) for path in files}
