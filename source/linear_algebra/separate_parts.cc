// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/separate_parts.h>
#include <signorini/linear_algebra/vector_kernels.h>

#include <deal.II/base/mpi.h>

#include <numeric>
#include <set>

namespace signorini
{
  namespace
  {
    /** Sets of local nodes that are coupled on this process: a forest whose roots name them. */
    class CoupledNodes
    {
    public:
      explicit CoupledNodes(const NodePattern &pattern)
        : parent(pattern.n_local)
        , is_coupled(pattern.n_local, 0)
      {
        std::iota(parent.begin(), parent.end(), 0u);
        for (unsigned int node = 0; node < pattern.n_local; ++node)
          for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
            if (const unsigned int other = pattern.columns[k]; other != node)
              {
                parent[root(other)] = root(node);
                is_coupled[node] = is_coupled[other] = 1;
              }
      }

      unsigned int root(unsigned int node)
      {
        while (parent[node] != node)
          node = parent[node] = parent[parent[node]];
        return node;
      }

      std::vector<unsigned int> parent;
      std::vector<char>         is_coupled;
    };


    /** Per local node the smallest number of a node that it is coupled with, by whatever way. */
    template <int dim>
    std::vector<double> common_names(const NodePattern &pattern, CoupledNodes &coupled)
    {
      std::vector<double> name(pattern.n_local);
      for (unsigned int node = 0; node < pattern.n_local; ++node)
        name[node] = static_cast<double>(pattern.partitioner->local_to_global(dim * node));
      const MPI_Comm communicator = pattern.partitioner->get_mpi_communicator();
      for (bool any_change = true; any_change;)
        {
          any_change = false;
          for (unsigned int node = 0; node < pattern.n_local; ++node)
            name[coupled.root(node)] = std::min(name[coupled.root(node)], name[node]);
          for (unsigned int node = 0; node < pattern.n_owned; ++node)
            {
              any_change = any_change || name[node] > name[coupled.root(node)];
              name[node] = name[coupled.root(node)];
            }
          tell_ghosts<dim>(name, pattern);
          any_change =
            dealii::Utilities::MPI::max(static_cast<unsigned int>(any_change), communicator) > 0;
        }
      return name;
    }
  } // namespace


  template <int dim>
  SeparateParts SeparateParts::of(const NodePattern &pattern)
  {
    CoupledNodes              coupled(pattern);
    const std::vector<double> names = common_names<dim>(pattern, coupled);
    std::set<double>          own;
    for (unsigned int node = 0; node < pattern.n_owned && own.size() <= most; ++node)
      if (coupled.is_coupled[node])
        own.insert(names[node]);
    std::set<double> all;
    for (const auto &of_process :
         dealii::Utilities::MPI::all_gather(pattern.partitioner->get_mpi_communicator(),
                                            std::vector<double>(own.begin(), own.end())))
      all.insert(of_process.begin(), of_process.end());

    SeparateParts result;
    result.part_of.assign(pattern.n_owned, 0);
    if (all.size() < 2 || all.size() > most)
      return result;
    result.n = all.size();
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (coupled.is_coupled[node])
        result.part_of[node] = std::distance(all.begin(), all.find(names[node]));
    return result;
  }


  std::vector<double> SeparateParts::products(const Vector &x, const Vector &y) const
  {
    if (n == 1)
      return {dot(x, y)};
    std::vector<double> result(n, 0.);
    for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
      result[part_of_entry(i, x)] += x.local_element(i) * y.local_element(i);
    dealii::Utilities::MPI::sum(result, x.get_mpi_communicator(), result);
    return result;
  }


  void SeparateParts::add(Vector &target, const std::vector<double> &factors, const Vector &x) const
  {
    AssertDimension(factors.size(), n);
    if (n == 1)
      target.add(factors[0], x);
    else
      for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
        target.local_element(i) += factors[part_of_entry(i, x)] * x.local_element(i);
  }


  template SeparateParts SeparateParts::of<2>(const NodePattern &);
  template SeparateParts SeparateParts::of<3>(const NodePattern &);
} // namespace signorini
