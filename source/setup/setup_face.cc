// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/setup/setup_face.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    bool is_among(const std::vector<types::boundary_id> &ids, const types::boundary_id id)
    {
      return ids.empty() || std::find(ids.begin(), ids.end(), id) != ids.end();
    }


    unsigned int side_in_pairs(const std::vector<PairDescription> &pairs,
                               const unsigned int                  body,
                               const types::boundary_id            id)
    {
      unsigned int side = 0;
      for (const PairDescription &pair : pairs)
        if (pair.slave == body && is_among(pair.slave_boundary_ids, id))
          return 1;
        else if (pair.master == body && is_among(pair.master_boundary_ids, id))
          side = 2;
      return side;
    }


    template <int dim>
    bool has_condition(const std::vector<BoundaryCondition<dim>> &conditions,
                       const types::boundary_id                   id)
    {
      return std::any_of(conditions.begin(), conditions.end(), [id](const auto &condition) {
        return condition.boundary_id == id;
      });
    }
  } // namespace


  template <int dim>
  SetupFace setup_face(const std::vector<BodyDescription<dim>> &bodies,
                       const std::vector<PairDescription>      &pairs,
                       const unsigned int                       body,
                       const types::boundary_id                 boundary_id)
  {
    return {body,
            boundary_id,
            side_in_pairs(pairs, body, boundary_id),
            has_condition(bodies[body].dirichlet, boundary_id),
            has_condition(bodies[body].traction, boundary_id)};
  }


#define INSTANTIATE(dim)                                                                           \
  template SetupFace setup_face(const std::vector<BodyDescription<dim>> &,                         \
                                const std::vector<PairDescription> &,                              \
                                unsigned int,                                                      \
                                types::boundary_id)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
