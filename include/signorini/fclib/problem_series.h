// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_fclib_problem_series_h
#define signorini_fclib_problem_series_h

#include <signorini/fclib/frictional_problem.h>
#include <signorini/system/elastic_contact_system.h>

#include <optional>
#include <string>

namespace signorini
{
  /**
   * The problems of every so many steps as files of FCLIB, `fclib/step_<number>.hdf5`, one for each
   * of these steps in which there is contact. Of a step that is made more than once, or in parts,
   * it is the problem that was solved last.
   */
  template <int dim>
  class ProblemSeries
  {
  public:
    /** @throws UserError with more than one process */
    ProblemSeries(const std::string &output_directory, unsigned int every, MPI_Comm communicator);

    /** Before a step is made, with all that is built on its mesh. */
    void expect(unsigned int                   step,
                const Discretization<dim>     &discretization,
                const ContactCoordinates<dim> &coordinates,
                ElasticContactSystem<dim>     &system);

    /** The step that was expected is made: write its problem. */
    void write();

  private:
    const std::string                folder;
    const unsigned int               every;
    std::optional<FrictionalProblem> latest;
  };
} // namespace signorini

#endif
