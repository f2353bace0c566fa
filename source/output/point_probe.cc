// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/discretization/common_boxes.h>
#include <signorini/output/cell_stress.h>
#include <signorini/output/point_probe.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double on_the_cell = 1e-10; ///< distances in cells that are round-off
    constexpr double at_a_facet  = 0.25;  ///< as far out may a point of a round body be, in cells
                                          ///< of its first mesh: facets stay when cells are refined
    constexpr double at_a_face = 1e-6;    ///< and one of another body
    constexpr double nowhere   = std::numeric_limits<double>::max();


    /** Where in the reference cell a point is; far away if the map cannot be inverted there. */
    template <int dim>
    Point<dim> reference_point(const Mapping<dim>                                   &mapping,
                               const typename DoFHandler<dim>::active_cell_iterator &cell,
                               const Point<dim>                                     &point)
    {
      try
        {
          return mapping.transform_real_to_unit_cell(cell, point);
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          Point<dim> far;
          far[0] = nowhere;
          return far;
        }
    }


    /** How often the cell has been halved in each direction since the first mesh. */
    template <int dim>
    int halvings_since_the_start(const Mesh<dim>                                      &mesh,
                                 const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      const int first = static_cast<int>(mesh.bodies()[cell->material_id()].refinements);
      return std::max(0, cell->level() - first);
    }


    /** Around all vertices of a body; in a round one they reach beyond the coarse mesh. Collective.
     */
    template <int dim>
    BoundingBox<dim> box_of_vertices(const Mesh<dim> &mesh, const unsigned int body)
    {
      CommonBoxes<dim> box;
      for (const auto &cell : mesh.active_cells())
        if (cell->is_locally_owned() && cell->material_id() == body)
          for (const unsigned int v : cell->vertex_indices())
            box.add(cell->vertex(v));
      return box.around_all(mesh.communicator()).front();
    }


    template <int dim>
    [[noreturn]] void refuse(const PointProbeDescription<dim> &probe, const Mesh<dim> &mesh)
    {
      const BoundingBox<dim> box     = box_of_vertices(mesh, probe.body);
      const auto            &corners = box.get_boundary_points();
      std::ostringstream     message;
      message << "Probes/" << probe.name << "/Point: (" << probe.point
              << ") is not in the undeformed body `" << probe.body_name << "`, which lies between ("
              << corners.first << ") and (" << corners.second
              << "). Choose a point in it or on its surface, or another `Body`.";
      throw UserError(message.str());
    }
  } // namespace


  template <int dim>
  PointProbe<dim>::PointProbe(const PointProbeDescription<dim> &description,
                              const Discretization<dim>        &discretization)
    : discretization(discretization)
  {
    const MPI_Comm communicator = discretization.communicator();
    const double   here         = find_cell(description);
    const double   distance     = Utilities::MPI::min(here, communicator);
    const bool     round = discretization.mesh().bodies()[description.body].shape->is_round();
    if (distance > (round ? at_a_facet : at_a_face))
      refuse(description, discretization.mesh());
    const auto candidates = Utilities::MPI::all_gather(
      communicator, here <= distance + on_the_cell ? cell->id().to_string() : std::string());
    for (unsigned int process = 0; process < candidates.size(); ++process)
      if (!candidates[process].empty()
          && (candidates[owner].empty() || candidates[process] < candidates[owner]))
        owner = process;
    place = GeometryInfo<dim>::project_to_unit_cell(place);
  }


  template <int dim>
  double PointProbe<dim>::find_cell(const PointProbeDescription<dim> &description)
  {
    double nearest = nowhere;
    for (const auto &candidate : discretization.cells())
      {
        if (!candidate->is_locally_owned() || candidate->material_id() != description.body)
          continue;
        const double unit =
          std::exp2(-halvings_since_the_start<dim>(discretization.mesh(), candidate));
        BoundingBox<dim> box = candidate->bounding_box();
        box.extend(2. * at_a_facet * candidate->diameter() / unit);
        if (!box.point_inside(description.point))
          continue;
        const Point<dim> inside =
          reference_point<dim>(discretization.mesh().mapping(), candidate, description.point);
        const double distance = unit * GeometryInfo<dim>::distance_to_unit_cell(inside);
        if (distance > std::min(at_a_facet, nearest + on_the_cell))
          continue;
        if (distance < nearest - on_the_cell
            || candidate->id().to_string() < cell->id().to_string())
          {
            cell    = candidate;
            place   = inside;
            nearest = distance;
          }
      }
    return nearest;
  }


  template <int dim>
  SymmetricTensor<2, dim> PointProbe<dim>::strain(const Vector &displacement) const
  {
    const Mesh<dim> &mesh = discretization.mesh();
    FEValues<dim>    fe_values(mesh.mapping(),
                            discretization.fe(),
                            Quadrature<dim>(place),
                            update_gradients | update_JxW_values);
    fe_values.reinit(cell);
    std::vector<Tensor<2, dim>> gradient(1);
    fe_values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement, gradient);

    std::vector<double> values;
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int c = 0; c < dim; ++c)
        values.push_back(displacement(cell->vertex_dof_index(v, c)));
    const auto matrix = mesh.cell_matrices().of(cell);
    if (matrix.has_modes())
      {
        const FE_Q<dim>         vertex_functions(1);
        const ModeGradient<dim> modes  = matrix.mode_gradient(values.data());
        const double            volume = fe_values.JxW(0); // the weight of the point is 1
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int i = 0; i < dim; ++i)
              gradient[0][c][i] +=
                vertex_functions.shape_value(v, place) * modes[c][dim * v + i] / volume;
      }
    return symmetrize(gradient[0]);
  }


  template <int dim>
  PointReading PointProbe<dim>::read(const Vector &displacement, const Vector &velocity) const
  {
    const MPI_Comm communicator = discretization.communicator();
    PointReading   reading;
    if (Utilities::MPI::this_mpi_process(communicator) == owner)
      {
        const Mesh<dim> &mesh  = discretization.mesh();
        const Point<dim> point = mesh.mapping().transform_unit_to_real_cell(cell, place);
        const FE_Q<dim>  vertex_functions(1);
        for (unsigned int c = 0; c < dim; ++c)
          {
            for (const unsigned int v : cell->vertex_indices())
              {
                const double weight = vertex_functions.shape_value(v, place);
                reading.displacement[c] += weight * displacement(cell->vertex_dof_index(v, c));
                reading.velocity[c] += weight * velocity(cell->vertex_dof_index(v, c));
              }
            reading.position[c] = point[c] + reading.displacement[c];
          }
        const Stress stress =
          stress_of<dim>(mesh.bodies()[cell->material_id()].material, strain(displacement));
        reading.stress = {
          {stress[0][0], stress[1][1], stress[2][2], stress[0][1], stress[0][2], stress[1][2]}};
        reading.von_mises = von_mises(stress);
      }
    return Utilities::MPI::broadcast(communicator, reading, owner);
  }


  template class PointProbe<2>;
  template class PointProbe<3>;
} // namespace signorini
