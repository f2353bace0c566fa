// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/model/body_shape.h>

#include <algorithm>
#include <set>

namespace signorini
{
  template <int dim>
  std::vector<dealii::types::boundary_id> boundary_ids_named(const BodyShape<dim> &shape,
                                                             const std::string    &word)
  {
    const BoundaryNames groups = shape.boundary_names();
    if (const auto exact = groups.find(word); exact != groups.end())
      return exact->second;
    std::set<dealii::types::boundary_id> ids;
    for (const auto &[name, ids_of_group] : groups)
      if (same_letters(name, word))
        ids.insert(ids_of_group.begin(), ids_of_group.end());
    for (const dealii::types::boundary_id id : shape.boundary_ids())
      if (std::to_string(id) == word)
        ids.insert(id);
    return {ids.begin(), ids.end()};
  }


  template <int dim>
  std::string list_of_boundaries(const BodyShape<dim> &shape)
  {
    const BoundaryNames      groups = shape.boundary_names();
    std::vector<std::string> list;
    for (const dealii::types::boundary_id id : shape.boundary_ids())
      {
        std::vector<std::string> names;
        for (const auto &[name, ids] : groups)
          if (std::find(ids.begin(), ids.end(), id) != ids.end()
              && !consists_of(name, "0123456789"))
            names.push_back(name);
        list.push_back(std::to_string(id) + (names.empty() ? "" : " (" + join(names) + ")"));
      }
    return join(list);
  }


#define INSTANTIATE(dim)                                                                           \
  template std::vector<dealii::types::boundary_id> boundary_ids_named(const BodyShape<dim> &,      \
                                                                      const std::string &);        \
  template std::string                             list_of_boundaries(const BodyShape<dim> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
