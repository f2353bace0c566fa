// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <limits>
#include <sstream>

namespace signorini
{
  namespace
  {
    constexpr double max_tolerance = 1e-2;

    std::string as_text(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }
  } // namespace

  void declare_solver(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const SolverParameters defaults;
    prm.declare_entry("Inequality",
                      name_of(defaults.inequality),
                      choices_of<InequalityMethod>(),
                      "Method for the inequality of a step: active-set (primal-dual; each set of "
                      "closed nodes is solved for) or truncated-newton-multigrid (sets change in "
                      "every iteration, the energy falls in each; without friction only).");
    prm.declare_entry("Preconditioner",
                      name_of(defaults.preconditioner),
                      choices_of<PreconditionerKind>(),
                      "Preconditioner of the conjugate gradients: jacobi, symmetric-gauss-seidel "
                      "(solves in single precision, refined), incomplete-cholesky, "
                      "multigrid (geometric), ml (algebraic multigrid), or automatic (chosen from "
                      "Courant number and mesh; multigrid for static problems).");
    prm.declare_entry("Condensation",
                      name_of(defaults.condensation),
                      choices_of<CondensationKind>(),
                      "Whether steps are solved for the contact nodes alone, with a direct factor "
                      "of the rest: automatic (where that is faster: in the plane, unless a "
                      "preconditioner is asked for), always, or never. On one process; runs on "
                      "several ones do without.");
    prm.declare_entry("Tolerance",
                      as_text(defaults.tolerance),
                      Double(),
                      "Accuracy of each step: error in the energy norm divided by the root of the "
                      "largest energy of the run (no unit), between 0 and 0.01. The energy ledger "
                      "closes to this accuracy. Where bodies hardly deform, errors are kept "
                      "smaller, so that their small forces are right as well.");
    prm.declare_entry("Maximum active set iterations",
                      std::to_string(defaults.limits.maximum_iterations),
                      Integer(),
                      "Active sets tried in a step before the guaranteed fallback takes over.");
    prm.declare_entry("Maximum linear iterations",
                      std::to_string(defaults.limits.maximum_linear_iterations),
                      Integer(),
                      "Conjugate gradient iterations of one linear solve before the active set "
                      "method gives way to truncated-newton-multigrid, and the most of that.");
  }

  SolverParameters parse_solver(const SectionReader &in, const bool with_friction)
  {
    SolverParameters solver;
    solver.inequality = in.choice<InequalityMethod>("Inequality");
    if (with_friction && solver.inequality != InequalityMethod::active_set)
      in.fail("Inequality",
              "knows no friction, which is no minimisation. Remove the key, or set the `Friction "
              "coefficient` of all pairs to 0.");
    solver.preconditioner = in.choice<PreconditionerKind>("Preconditioner");
    solver.condensation   = in.choice<CondensationKind>("Condensation");
    solver.tolerance =
      in.positive_number("Tolerance", "it bounds an error; give for example 2e-11");
    if (solver.tolerance > max_tolerance)
      in.fail("Tolerance",
              "a step solved so roughly is useless, its error appears as energy. Give at most "
                + as_text(max_tolerance) + ", for example 2e-11.");
    solver.limits.maximum_iterations =
      in.integer("Maximum active set iterations", 1, SectionReader::unlimited);
    solver.limits.maximum_linear_iterations =
      in.integer("Maximum linear iterations", 1, SectionReader::unlimited);
    return solver;
  }
} // namespace signorini
