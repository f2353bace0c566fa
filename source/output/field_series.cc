// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/output/field_series.h>
#include <signorini/output/whole_file.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace signorini
{
  using namespace dealii;

  FieldSeries::FieldSeries(const std::string &directory,
                           const std::string &name,
                           const MPI_Comm     communicator)
    : directory(directory)
    , name(name)
    , communicator(communicator)
    , this_process(Utilities::MPI::this_mpi_process(communicator))
    , n_processes(Utilities::MPI::n_mpi_processes(communicator))
  {
    succeed_together(communicator, [&] {
      if (this_process != 0)
        return;
      std::error_code   error;
      const std::string folder = directory + "/fields";
      std::filesystem::create_directories(folder, error);
      if (error)
        throw_write_error(folder, error.value());
      std::filesystem::remove(directory + "/" + name + ".pvd", error);
    });
  }


  std::string FieldSeries::moment(const unsigned int step) const
  {
    return name + "_" + Utilities::int_to_string(step, 6);
  }


  std::string FieldSeries::piece(const unsigned int step, const unsigned int process) const
  {
    return moment(step) + "." + std::to_string(process) + ".vtu";
  }


  template <int dim, int spacedim>
  void FieldSeries::write_piece(DataOutInterface<dim, spacedim> &data,
                                const unsigned int               step,
                                const double                     time) const
  {
    DataOutBase::VtkFlags flags(time, step);
    flags.compression_level = decltype(flags.compression_level)::best_speed;
    data.set_flags(flags);
    write_whole_file(directory + "/fields/" + piece(step, this_process),
                     [&](std::ostream &out) { data.write_vtu(out); });
  }


  template <int dim, int spacedim>
  void FieldSeries::name_moment(const DataOutInterface<dim, spacedim> &data,
                                const unsigned int                     step,
                                const double                           time)
  {
    const std::string record = "fields/" + moment(step) + ".pvtu";
    auto              known  = moments;
    if (known.empty() || known.back().second != record) // as after a failure of another series
      known.emplace_back(time, record);
    succeed_together(communicator, [&] {
      if (this_process != 0)
        return;
      std::vector<std::string> pieces;
      for (unsigned int p = 0; p < n_processes; ++p)
        pieces.push_back(piece(step, p));
      write_whole_file(directory + "/" + record,
                       [&](std::ostream &out) { data.write_pvtu_record(out, pieces); });
      write_record(known);
    });
    moments = std::move(known); // what could not be named may be tried once more
  }


  void FieldSeries::write_record(const std::vector<std::pair<double, std::string>> &known) const
  {
    write_whole_file(directory + "/" + name + ".pvd",
                     [&](std::ostream &out) { DataOutBase::write_pvd_record(out, known); });
  }


  void FieldSeries::archive(Archive &archive)
  {
    archive(moments);
    if (archive.reads())
      succeed_together(communicator, [&] {
        if (this_process != 0)
          return;
        forget_missing_moments();
        remove_later_moments();
        if (!moments.empty())
          write_record(moments);
      });
  }


  void FieldSeries::forget_missing_moments()
  {
    const auto is_missing = [&](const std::pair<double, std::string> &moment) {
      return !std::filesystem::exists(directory + "/" + moment.second);
    };
    moments.erase(std::remove_if(moments.begin(), moments.end(), is_missing), moments.end());
  }


  void FieldSeries::remove_later_moments() const
  {
    std::set<std::string> known;
    for (const auto &[time, record] : moments)
      known.insert(std::filesystem::path(record).stem());
    std::vector<std::filesystem::path> later;
    for (const auto &entry : std::filesystem::directory_iterator(directory + "/fields"))
      {
        const std::string file = entry.path().filename(), moment = file.substr(0, file.find('.'));
        if (moment.rfind(name + "_", 0) == 0 && known.count(moment) == 0)
          later.push_back(entry.path());
      }
    for (const auto &path : later)
      std::filesystem::remove(path);
  }


#define INSTANTIATE(dim, spacedim)                                                                 \
  template void FieldSeries::write_piece(DataOutInterface<dim, spacedim> &, unsigned int, double)  \
    const;                                                                                         \
  template void FieldSeries::name_moment(                                                          \
    const DataOutInterface<dim, spacedim> &, unsigned int, double);
  INSTANTIATE(1, 2)
  INSTANTIATE(2, 2)
  INSTANTIATE(2, 3)
  INSTANTIATE(3, 3)
#undef INSTANTIATE
} // namespace signorini
