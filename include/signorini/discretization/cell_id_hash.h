// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_cell_id_hash_h
#define signorini_discretization_cell_id_hash_h

#include <deal.II/grid/cell_id.h>

#include <boost/functional/hash.hpp>

namespace signorini
{
  /** Lets the name of a cell be the key of an unordered container. */
  template <int dim>
  struct CellIdHash
  {
    std::size_t operator()(const dealii::CellId &id) const
    {
      const auto data = id.template to_binary<dim>();
      return boost::hash_range(data.begin(), data.end());
    }
  };
} // namespace signorini

#endif
