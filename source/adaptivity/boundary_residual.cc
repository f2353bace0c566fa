// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_parts.h>
#include <signorini/finite_elements/cell_map.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Nodal fields at the points of one outer face. */
    template <int dim>
    class FieldsOnFace
    {
    public:
      FieldsOnFace(const LocalCell<dim> &cell, const unsigned int face)
        : vertex_functions(GaussTables<dim>::of_degree(1).vertex_functions)
      {
        for (unsigned int v = 0; v < nodes.size(); ++v)
          nodes[v] = cell.nodes[vertex_of_face<dim>(face, v)];
      }

      double
      scalar(const Vector &field, const unsigned int q, const unsigned int component = 0) const
      {
        double result = 0.;
        for (unsigned int v = 0; v < nodes.size(); ++v)
          result += vertex_functions[v][q] * field.local_element(dim * nodes[v] + component);
        return result;
      }

      Tensor<1, dim> vector(const Vector &field, const unsigned int q) const
      {
        Tensor<1, dim> result;
        for (unsigned int c = 0; c < dim; ++c)
          result[c] = scalar(field, q, c);
        return result;
      }

    private:
      const std::array<FourNumbers, GaussTables<dim>::n_face_points> &vertex_functions;
      std::array<unsigned int, GaussTables<dim>::n_face_points>       nodes;
    };


    /** The mean of a given traction at both ends of the step. */
    template <int dim>
    Tensor<1, dim> mean_traction(FunctionParser<dim> &function,
                                 const ForceBalance  &balance,
                                 const Point<dim>    &point)
    {
      Tensor<1, dim> result;
      for (const double time : {balance.start_time, balance.end_time})
        {
          function.set_time(time);
          for (unsigned int c = 0; c < dim; ++c)
            result[c] += 0.5 * function.value(point, c);
        }
      return result;
    }


    /** sigma n - traction at the points of a face, without held components. */
    template <int dim>
    std::array<Tensor<1, dim>, GaussTables<dim>::n_face_points>
    unbalanced_stress(const StressVectors<dim>    &stress,
                      const OuterFace<dim>        &outer,
                      const SurfaceCondition<dim> *condition,
                      const ForceBalance          &balance)
    {
      std::array<Tensor<1, dim>, GaussTables<dim>::n_face_points> result;
      const FourVectors<dim> &vector = stress.of_face(outer.cell, outer.face).vector;
      for (unsigned int q = 0; q < result.size(); ++q)
        for (unsigned int c = 0; c < dim; ++c)
          result[q][c] = vector[c][q];
      if (condition != nullptr && condition->traction)
        {
          const auto &mapping = stress.mesh.discretization.mesh().mapping();
          const auto  support = support_points(mapping, stress.mesh.cells[outer.cell].cell);
          const auto  points  = GaussTables<dim>::of_degree(mapping.get_degree())
                                .faces[outer.face]
                                .values(numbers(support));
          for (unsigned int q = 0; q < result.size(); ++q)
            {
              Point<dim> point;
              for (unsigned int c = 0; c < dim; ++c)
                point[c] = points[c][q];
              result[q] -= mean_traction(*condition->traction, balance, point);
            }
        }
      return result;
    }


    /**
     * int |sigma n - traction|^2 without held components, and without the normal parts of
     * full-contact nodes on a slave surface.
     */
    template <int dim>
    double squared_residual(const StressVectors<dim> &stress,
                            const OuterFace<dim>     &outer,
                            const SurfaceRole<dim>   &role,
                            const ForceBalance       &balance,
                            const ContactFields<dim> &fields)
    {
      const FieldsOnFace<dim> here(stress.mesh.cells[outer.cell], outer.face);
      const FourNumbers      &area     = stress.of_face(outer.cell, outer.face).area;
      auto                    residual = unbalanced_stress(stress, outer, role.condition, balance);
      double                  result   = 0.;
      for (unsigned int q = 0; q < residual.size(); ++q)
        {
          if (role.is_slave
              || role
                   .is_master) // nodes at the edge of a contact surface belong to other faces, too
            residual[q] -= here.vector(fields.traction, q);
          for (unsigned int c = 0; role.condition != nullptr && c < dim; ++c)
            if (role.condition->held[c])
              residual[q][c] = 0.;
          double square = 0.;
          if (role.is_slave)
            if (const Tensor<1, dim> normal = here.vector(fields.normal, q);
                normal.norm_square() > 0.)
              {
                const Tensor<1, dim> nu            = normal / normal.norm();
                const double         normal_stress = residual[q] * nu;
                residual[q] -= normal_stress * nu;
                square = here.scalar(fields.open, q) * normal_stress * normal_stress;
              }
          result += (square + residual[q].norm_square()) * area[q];
        }
      return result;
    }


    /** int s gap. */
    template <int dim>
    double energy_of_gap(const StressVectors<dim> &stress,
                         const OuterFace<dim>     &outer,
                         const ContactFields<dim> &fields)
    {
      const FieldsOnFace<dim> here(stress.mesh.cells[outer.cell], outer.face);
      const FourNumbers      &area   = stress.of_face(outer.cell, outer.face).area;
      double                  result = 0.;
      for (unsigned int q = 0; q < GaussTables<dim>::n_face_points; ++q)
        result += here.scalar(fields.pressure, q) * here.scalar(fields.gap, q) * area[q];
      return result;
    }
  } // namespace


  template <int dim>
  void add_boundary_residual(const StressVectors<dim> &stress,
                             const SurfaceRoles<dim>  &roles,
                             const ForceBalance       &balance,
                             const ContactFields<dim> &fields,
                             const ResidualWeights    &weights,
                             dealii::Vector<double>   &squares)
  {
    const CellNeighbors<dim> &mesh = stress.mesh;
    for (std::size_t i = 0; i < mesh.outer_faces.size(); ++i)
      {
        const OuterFace<dim> &outer    = mesh.outer_faces[i];
        const LocalCell<dim> &cell     = mesh.cells[outer.cell];
        const Material       &material = mesh.discretization.mesh().bodies()[cell.body].material;
        squares(cell.index) += weights.face(material, outer.size)
                               * squared_residual(stress, outer, roles[i], balance, fields);
        if (roles[i].is_slave)
          squares(cell.index) += weights.complementarity() * energy_of_gap(stress, outer, fields);
      }
  }


  template void add_boundary_residual(const StressVectors<2> &,
                                      const SurfaceRoles<2> &,
                                      const ForceBalance &,
                                      const ContactFields<2> &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
  template void add_boundary_residual(const StressVectors<3> &,
                                      const SurfaceRoles<3> &,
                                      const ForceBalance &,
                                      const ContactFields<3> &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
} // namespace signorini
