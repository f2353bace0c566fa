// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/contact_fields.h>
#include <signorini/adaptivity/mark_cells.h>
#include <signorini/adaptivity/marking.h>
#include <signorini/base/contact_status.h>
#include <signorini/contact/own_forces.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * The part of the squared estimate that cells with squares >= a threshold make which may be
     * refined.
     */
    template <int dim>
    double refinable_part(const parallel::distributed::Triangulation<dim> &triangulation,
                          const dealii::Vector<double>                    &squares,
                          const std::vector<bool>                         &refinable,
                          const double                                     threshold)
    {
      double part = 0.;
      for (unsigned int cell = 0; cell < squares.size(); ++cell)
        if (refinable[cell] && squares(cell) >= threshold)
          part += squares(cell);
      return Utilities::MPI::sum(part, triangulation.get_communicator());
    }

    /**
     * Let all processes know which of their ghost cells are going to be refined: by
     * active_cell_index.
     */
    template <int dim>
    std::vector<char>
    refine_flags_with_ghosts(const parallel::distributed::Triangulation<dim> &triangulation)
    {
      using Cell = typename Triangulation<dim>::active_cell_iterator;
      std::vector<char> flags(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        flags[cell->active_cell_index()] = cell->is_locally_owned() && cell->refine_flag_set();
      GridTools::exchange_cell_data_to_ghosts<char, parallel::distributed::Triangulation<dim>>(
        triangulation,
        [&](const Cell &cell) { return std::optional<char>(flags[cell->active_cell_index()]); },
        [&](const Cell &cell, const char flag) { flags[cell->active_cell_index()] = flag; });
      return flags;
    }


    /**
     * Coarsen no family beside cells that are finer or become so. If the finer ones are coarsened,
     * too, the family is next. The triangulation would allow both at once, but only where it sees
     * the flags, not across processes.
     */
    template <int dim>
    void keep_families_beside_finer_cells(parallel::distributed::Triangulation<dim> &triangulation)
    {
      const std::vector<char> refined = refine_flags_with_ghosts(triangulation);
      std::vector<int>        finest(triangulation.n_vertices(), 0);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            finest[cell->vertex_index(v)] = std::max(
              finest[cell->vertex_index(v)], cell->level() + refined[cell->active_cell_index()]);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->coarsen_flag_set())
          for (const unsigned int v : cell->vertex_indices())
            if (finest[cell->vertex_index(v)] > cell->level())
              cell->clear_coarsen_flag();
    }


    template <int dim>
    void count_flags(const parallel::distributed::Triangulation<dim> &triangulation,
                     MeshChange                                      &change)
    {
      change.n_to_refine = change.n_to_coarsen = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            change.n_to_refine +=
              cell->refine_flag_set() ? 1 : 0; // the flag is a set of directions
            change.n_to_coarsen += cell->coarsen_flag_set() ? 1 : 0;
          }
      change.n_to_refine =
        Utilities::MPI::sum(change.n_to_refine, triangulation.get_communicator());
      change.n_to_coarsen =
        Utilities::MPI::sum(change.n_to_coarsen, triangulation.get_communicator());
    }


    /**
     * Refinement alone needs no projection of the state. What the estimate of the energy wants is
     * coarsened layer by layer, and must not wait; equal shares of a target leave less to coarsen.
     */
    template <int dim>
    void drop_little_coarsening(parallel::distributed::Triangulation<dim> &triangulation,
                                const AdaptivityParameters                &parameters,
                                MeshChange                                &change)
    {
      if (change.n_to_coarsen == 0 || (change.refines() && !parameters.has_target())
          || change.n_to_coarsen >= parameters.hysteresis * triangulation.n_global_active_cells())
        return;
      for (const auto &cell : triangulation.active_cell_iterators())
        cell->clear_coarsen_flag();
      change.n_to_coarsen = 0;
    }


    /** What may and what must be done with each cell of this process, by active_cell_index. */
    struct CellWishes
    {
      dealii::Vector<double> squares; ///< of the indicators
      std::vector<bool>      refinable, coarsenable, wanted;
    };

    template <int dim>
    CellWishes collect_wishes(const Mesh<dim>              &mesh,
                              const AdaptivityParameters   &parameters,
                              const dealii::Vector<double> &indicator,
                              const std::vector<bool>      &not_to_coarsen,
                              const std::vector<bool>      &to_refine)
    {
      const unsigned int n = indicator.size();
      CellWishes         wishes{
        indicator, std::vector<bool>(n), std::vector<bool>(n), std::vector<bool>(n)};
      for (double &value : wishes.squares)
        value *= value;
      for (const auto &cell : mesh.active_cells())
        if (cell->is_locally_owned())
          {
            const unsigned int index = cell->active_cell_index(), level = cell->level();
            const unsigned int lowest =
              std::max(parameters.minimum_level, mesh.bodies()[cell->material_id()].refinements);
            wishes.refinable[index] = level < parameters.maximum_level;
            wishes.coarsenable[index] =
              level > lowest && (not_to_coarsen.empty() || !not_to_coarsen[index]);
            wishes.wanted[index] =
              wishes.refinable[index] && !to_refine.empty() && to_refine[index];
          }
      return wishes;
    }


    /** The thresholds within the limit of cells; wishes that are beyond it are dropped. */
    template <int dim>
    MarkingThresholds choose_thresholds(const Mesh<dim>             &mesh,
                                        const AdaptivityParameters  &parameters,
                                        const IndicatorDistribution &distribution,
                                        CellWishes                  &wishes,
                                        MeshChange                  &change)
    {
      const auto        marking   = make_marking<dim>(parameters);
      MarkingThresholds threshold = marking->thresholds(distribution);
      double            n_wanted  = Utilities::MPI::sum(
        std::count(wishes.wanted.begin(), wishes.wanted.end(), true), mesh.communicator());
      if (parameters.maximum_cells > 0)
        {
          const double room = room_to_refine(mesh, parameters);
          if (n_wanted > room) // all or none, lest contact be fine in parts
            {
              wishes.wanted.assign(wishes.wanted.size(), false);
              n_wanted = 0.;
            }
          threshold.refine =
            std::max(threshold.refine, distribution.threshold_of_number(room - n_wanted));
        }
      change.is_urgent = n_wanted > 0. || !marking->weighs_parts();
      if (marking->weighs_parts() && distribution.total() > 0.)
        {
          change.error_part =
            refinable_part(mesh.triangulation(), wishes.squares, wishes.refinable, threshold.refine)
            / distribution.total();
          if (change.error_part < parameters.hysteresis)
            threshold.refine = std::numeric_limits<double>::infinity();
        }
      return threshold;
    }


    template <int dim>
    void set_flags(parallel::distributed::Triangulation<dim> &triangulation,
                   const CellWishes                          &wishes,
                   const MarkingThresholds                   &threshold)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const unsigned int index  = cell->active_cell_index();
            const double       square = wishes.squares(index);
            if (wishes.wanted[index] || (wishes.refinable[index] && square >= threshold.refine))
              cell->set_refine_flag();
            else if (wishes.coarsenable[index] && square < threshold.coarsen)
              cell->set_coarsen_flag();
          }
    }
  } // namespace


  template <int dim>
  double room_to_refine(const Mesh<dim> &mesh, const AdaptivityParameters &parameters)
  {
    if (parameters.maximum_cells == 0)
      return std::numeric_limits<double>::infinity();
    constexpr double more = (1 << dim) - 1; // cells by one refinement
    return (double(parameters.maximum_cells) - mesh.triangulation().n_global_active_cells()) / more;
  }


  template <int dim>
  void clear_flags(Mesh<dim> &mesh)
  {
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
      }
  }


  template <int dim>
  MeshChange mark_cells(Mesh<dim>                    &mesh,
                        const AdaptivityParameters   &parameters,
                        const dealii::Vector<double> &indicator,
                        const std::vector<bool>      &not_to_coarsen,
                        const std::vector<bool>      &to_refine)
  {
    auto &triangulation = mesh.triangulation();
    clear_flags(mesh);
    MeshChange change;
    CellWishes wishes = collect_wishes(mesh, parameters, indicator, not_to_coarsen, to_refine);
    const IndicatorDistribution distribution(triangulation, wishes.squares, wishes.refinable);
    const MarkingThresholds     threshold =
      choose_thresholds(mesh, parameters, distribution, wishes, change);
    set_flags(triangulation, wishes, threshold);
    change.estimate = std::sqrt(distribution.total());
    count_flags(triangulation, change);
    // Before the smoothing of flags, which is most of the price of marking, and after it, as it
    // takes some away.
    drop_little_coarsening(triangulation, parameters, change);
    if (!change.any())
      return change;
    keep_families_beside_finer_cells(triangulation);
    triangulation.prepare_coarsening_and_refinement(); // may add flags and remove some
    count_flags(triangulation, change);
    drop_little_coarsening(triangulation, parameters, change);
    constexpr double of_a_family = 1. - 1. / (1 << dim);
    change.spared_part           = of_a_family * change.n_to_coarsen / distribution.n_cells();
    return change;
  }


  template <int dim>
  std::vector<bool> cells_in_contact(const Discretization<dim> &discretization,
                                     const ContactSurface<dim> &surface,
                                     const Vector              &contact_force)
  {
    // Contact pushes exactly the nodes that it closes, on both sides.
    Vector                  force   = discretization.make_vector();
    const std::vector<bool> closed  = closed_nodes(surface, contact_force);
    double                  largest = contact_force.linfty_norm();
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (std::abs(contact_force.local_element(dim * node + c)) > negligible_force * largest)
          force.local_element(dim * node) = 1.;
    // Of a contact node by its own force, which is not negligible where it is closed; that it is
    // open takes nothing from what others press on it.
    const Vector own = own_forces(surface, contact_force);
    for (std::size_t k = 0; k < closed.size(); ++k)
      {
        const unsigned int first   = dim * surface.nodes()[k].node;
        bool               is_only = true; // nothing is handed on to it
        for (unsigned int i = first; i < first + dim; ++i)
          is_only = is_only
                    && std::abs(contact_force.local_element(i) - own.local_element(i))
                         <= negligible_force * largest;
        if (is_only || closed[k])
          force.local_element(first) = closed[k];
      }
    force = discretization.interpolate_hanging_nodes(force);
    std::vector<bool> result(discretization.mesh().triangulation().n_active_cells());
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (force(cell->vertex_dof_index(v, 0)) > 0.)
            result[cell->active_cell_index()] = true;
    return result;
  }


#define INSTANTIATE(dim)                                                                           \
  template double            room_to_refine(const Mesh<dim> &, const AdaptivityParameters &);      \
  template void              clear_flags(Mesh<dim> &);                                             \
  template MeshChange        mark_cells(Mesh<dim> &,                                               \
                                        const AdaptivityParameters &,                              \
                                        const dealii::Vector<double> &,                            \
                                        const std::vector<bool> &,                                 \
                                        const std::vector<bool> &);                                \
  template std::vector<bool> cells_in_contact(                                                     \
    const Discretization<dim> &, const ContactSurface<dim> &, const Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
