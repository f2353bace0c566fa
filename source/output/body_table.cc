// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/body_table.h>

namespace signorini
{
  namespace
  {
    template <int dim>
    std::vector<std::string> columns_of_bodies(const std::vector<BodyDescription<dim>> &bodies)
    {
      std::vector<std::string> names = {"step", "time"};
      for (const BodyDescription<dim> &description : bodies)
        {
          const std::string body = "body_" + description.name + "_";
          names.push_back(body + "kinetic_energy");
          names.push_back(body + "elastic_energy");
          for (const char *quantity : {"momentum", "angular_momentum", "centroid", "velocity"})
            add_vector_columns(body + quantity, names);
        }
      return names;
    }
  } // namespace


  template <int dim>
  BodyTable<dim>::BodyTable(const std::string                       &directory,
                            const std::vector<BodyDescription<dim>> &bodies,
                            const MPI_Comm                           communicator)
    : table(directory + "/bodies.csv", columns_of_bodies(bodies), communicator)
  {
  }


  template <int dim>
  void BodyTable<dim>::use_mesh(const ObservedMesh<dim> &mesh, const State & /*state*/)
  {
    motion = &mesh.motion;
  }


  template <int dim>
  void BodyTable<dim>::write(const State &state, const StepReport & /*report*/, const bool is_due)
  {
    std::vector<double> values = {static_cast<double>(state.step), state.time};
    for (const BodyReading &body : motion->read(state))
      {
        values.push_back(body.kinetic_energy);
        values.push_back(body.elastic_energy);
        for (const auto &vector :
             {body.momentum, body.angular_momentum, body.centroid, body.velocity})
          add_values(vector, values);
      }
    table.write_row(values, is_due);
  }


  template <int dim>
  std::vector<CsvTable *> BodyTable<dim>::files()
  {
    return {&table};
  }


  template class BodyTable<2>;
  template class BodyTable<3>;
} // namespace signorini
