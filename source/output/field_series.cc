// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/output/field_series.h>
#include <signorini/output/whole_file.h>

#include <deal.II/base/utilities.h>

#include <filesystem>

namespace signorini
{
  using namespace dealii;

  FieldSeries::FieldSeries(const std::string &directory,
                           const std::string &name,
                           const MPI_Comm     communicator)
    : directory(directory)
    , name(name)
    , communicator(communicator)
  {
    succeed_together(communicator, [&] {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      std::error_code   error;
      const std::string folder = directory + "/fields";
      std::filesystem::create_directories(folder, error);
      if (error)
        throw_write_error(folder, error.value());
      std::filesystem::remove(directory + "/" + name + ".pvd", error);
    });
  }


  template <int dim, int spacedim>
  void FieldSeries::write(DataOutInterface<dim, spacedim> &data,
                          const unsigned int               step,
                          const double                     time)
  {
    DataOutBase::VtkFlags flags(time, step);
    flags.compression_level = decltype(flags.compression_level)::best_speed;
    data.set_flags(flags);

    const std::string moment = name + "_" + Utilities::int_to_string(step, 6);
    const auto        piece  = [&](const unsigned int process) {
      return moment + "." + std::to_string(process) + ".vtu";
    };
    const unsigned int this_process = Utilities::MPI::this_mpi_process(communicator);
    succeed_together(communicator, [&] {
      write_whole_file(directory + "/fields/" + piece(this_process),
                       [&](std::ostream &out) { data.write_vtu(out); });
    });

    // Only now all pieces are there for the files that name them.
    moments.emplace_back(time, "fields/" + moment + ".pvtu");
    succeed_together(communicator, [&] {
      if (this_process != 0)
        return;
      std::vector<std::string> pieces;
      for (unsigned int p = 0; p < Utilities::MPI::n_mpi_processes(communicator); ++p)
        pieces.push_back(piece(p));
      write_whole_file(directory + "/" + moments.back().second,
                       [&](std::ostream &out) { data.write_pvtu_record(out, pieces); });
      write_whole_file(directory + "/" + name + ".pvd",
                       [&](std::ostream &out) { DataOutBase::write_pvd_record(out, moments); });
    });
  }


  template void FieldSeries::write<1, 2>(DataOutInterface<1, 2> &, unsigned int, double);
  template void FieldSeries::write<2, 2>(DataOutInterface<2, 2> &, unsigned int, double);
  template void FieldSeries::write<2, 3>(DataOutInterface<2, 3> &, unsigned int, double);
  template void FieldSeries::write<3, 3>(DataOutInterface<3, 3> &, unsigned int, double);
} // namespace signorini
