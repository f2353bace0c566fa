// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/assemble_matrices.h>
#include <signorini/discretization/cell_assembly.h>
#include <signorini/discretization/complete_rows.h>
#include <signorini/discretization/discretization.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * Fill, with room to grow: a mesh that becomes a little finer shall not have to ask the system
     * for memory.
     */
    template <typename T>
    void assign_with_room(std::vector<T> &values, const std::size_t size, const T &value)
    {
      if (values.capacity() < size && values.capacity() > 0)
        {
          values.clear();
          values.reserve(size + size / 2);
        }
      values.assign(size, value);
    }
  } // namespace


  template <int dim>
  void assemble_matrices(const Discretization<dim> &discretization,
                         ElasticMatrices<dim>      &matrices,
                         const MassChange          &change)
  {
    const MPI_Comm communicator = discretization.communicator();
    const bool     mass_changes = Utilities::MPI::logical_or(!change.empty(), communicator);
    const bool     is_alone     = Utilities::MPI::n_mpi_processes(communicator) == 1;
    const CellCouplings<dim> couplings(discretization);

    // What the cells of this process contribute is all, if nobody else contributes.
    ElasticMatrices<dim>  parts;
    ElasticMatrices<dim> &sum = is_alone && !mass_changes ? matrices : parts;
    sum.pattern               = couplings.pattern();
    assign_with_room(sum.mass, sum.pattern.columns.size(), 0.);
    assign_with_room(sum.stiffness, sum.pattern.columns.size() + 1, {}); // a spare block, see Lanes
    CellAssembly<dim> assembly(couplings, sum);
    unsigned int      index = 0;
    for (const auto &cell : discretization.mesh().active_cells())
      if (cell->is_locally_owned())
        assembly.add(index++, discretization.mesh().cell_matrices().of(cell));

    matrices.standard_mass.clear();
    matrices.massless_nodes.clear();
    if (&sum == &matrices)
      matrices.pattern.partitioner = make_partitioner<dim>(couplings.nodes(), communicator);
    else
      complete_rows<dim>(parts, couplings.nodes(), change, mass_changes, communicator, matrices);
  }


  template void
  assemble_matrices(const Discretization<2> &, ElasticMatrices<2> &, const MassChange &);
  template void
  assemble_matrices(const Discretization<3> &, ElasticMatrices<3> &, const MassChange &);
} // namespace signorini
