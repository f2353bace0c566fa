// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/fclib/problem_of_step.h>
#include <signorini/fclib/problem_series.h>
#include <signorini/fclib/write_problem.h>

#include <filesystem>
#include <iomanip>
#include <sstream>

namespace signorini
{
  template <int dim>
  ProblemSeries<dim>::ProblemSeries(const std::string &output_directory,
                                    const unsigned int every,
                                    const MPI_Comm     communicator)
    : folder(output_directory + "/fclib")
    , every(every)
  {
    Assert(every > 0, dealii::ExcMessage("Without a series there is nothing to write."));
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      throw UserError("Output/FCLIB every = " + std::to_string(every)
                      + " needs a run on one process: the files hold whole matrices. Run without "
                        "mpirun, or set it to 0.");
  }


  template <int dim>
  void ProblemSeries<dim>::expect(const unsigned int             step,
                                  const Discretization<dim>     &discretization,
                                  const ContactCoordinates<dim> &coordinates,
                                  ElasticContactSystem<dim>     &system)
  {
    latest.reset();
    if (step % every != 0)
      return system.show_problems_to({});
    system.show_problems_to(
      [&, step](const IncrementProblem &problem, const IncrementSolution &solution) {
        if (is_trial(system))
          return;
        latest =
          problem_of_step(discretization, coordinates, problem, solution, obstacle_motion(system));
        latest->step = step;
      });
  }


  template <int dim>
  void ProblemSeries<dim>::write()
  {
    if (!latest || !latest->any_contact())
      return;
    std::filesystem::create_directories(folder);
    std::ostringstream name;
    name << folder << "/step_" << std::setw(6) << std::setfill('0') << latest->step << ".hdf5";
    write_problem(name.str(), *latest);
    latest.reset();
  }


  template class ProblemSeries<2>;
  template class ProblemSeries<3>;
} // namespace signorini
