// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/contact_fields.h>
#include <signorini/adaptivity/residual_estimate.h>
#include <signorini/base/expressions.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** What the scene says about a part of the boundary of a body. */
    template <int dim>
    struct Condition
    {
      std::array<bool, dim>                held{};
      std::unique_ptr<FunctionParser<dim>> traction;
    };

    template <int dim>
    std::map<types::boundary_id, Condition<dim>> conditions_of(const BodyDescription<dim> &body)
    {
      std::map<types::boundary_id, Condition<dim>> result;
      for (const auto &dirichlet : body.dirichlet)
        for (unsigned int c = 0; c < dim; ++c)
          if (!dirichlet.expressions[c].empty() && dirichlet.expressions[c] != "-")
            result[dirichlet.boundary_id].held[c] = true;
      for (const auto &traction : body.traction)
        result[traction.boundary_id].traction = make_function<dim, dim>(traction.expressions);
      return result;
    }

    template <int dim>
    class FaceResidual
    {
    public:
      FaceResidual(const Discretization<dim> &discretization, const ForceBalance &balance)
        : balance(balance)
        , fe_values(discretization.mapping,
                    discretization.fe,
                    QGauss<dim - 1>(discretization.n_quadrature_points()),
                    update_values | update_gradients | update_JxW_values | update_normal_vectors
                      | update_quadrature_points)
        , strains(fe_values.n_quadrature_points)
        , tractions(fe_values.n_quadrature_points)
        , normals(fe_values.n_quadrature_points)
        , open(fe_values.n_quadrature_points)
        , pressure(fe_values.n_quadrature_points)
        , gap(fe_values.n_quadrature_points)
      {
        for (const auto &body : discretization.scene.bodies)
          conditions.push_back(conditions_of(body));
      }

      /** int |sigma n - traction|^2 without held components, and without the normal parts of full-contact nodes on a slave surface. */
      double square(const typename DoFHandler<dim>::active_cell_iterator &cell,
                    const unsigned int                                    face,
                    const bool                                            is_slave,
                    const bool                                            is_master,
                    const Material                                       &material,
                    const Vector                                         &displacement,
                    const ContactFields<dim>                             &fields)
      {
        const auto &of_body   = conditions[cell->material_id()];
        const auto  found     = of_body.find(cell->face(face)->boundary_id());
        const auto *condition = found == of_body.end() ? nullptr : &found->second;
        fe_values.reinit(cell, face);
        fe_values[vector].get_function_symmetric_gradients(displacement, strains);
        fe_values[vector].get_function_values(fields.traction, tractions);
        fe_values[vector].get_function_values(fields.normal, normals);
        fe_values[first].get_function_values(fields.open, open);
        double result = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            Tensor<1, dim> residual = stress_of_strain<dim>(material, strains[q]) * fe_values.normal_vector(q);
            if (is_slave || is_master) // nodes at the edge of a contact surface belong to other faces, too
              residual -= tractions[q];
            if (condition != nullptr && condition->traction)
              residual -= mean_traction(*condition->traction, fe_values.quadrature_point(q));
            for (unsigned int c = 0; condition != nullptr && c < dim; ++c)
              if (condition->held[c])
                residual[c] = 0.;
            double square = 0.;
            if (is_slave && normals[q].norm_square() > 0.)
              {
                const Tensor<1, dim> nu            = normals[q] / normals[q].norm();
                const double         normal_stress = residual * nu;
                residual -= normal_stress * nu;
                square = open[q] * normal_stress * normal_stress;
              }
            square += residual.norm_square();
            result += square * fe_values.JxW(q);
          }
        return result;
      }

      /** int s gap of the face that square() looked at. */
      double energy_of_gap(const ContactFields<dim> &fields)
      {
        fe_values[first].get_function_values(fields.pressure, pressure);
        fe_values[first].get_function_values(fields.gap, gap);
        double result = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          result += pressure[q] * gap[q] * fe_values.JxW(q);
        return result;
      }

    private:
      const ForceBalance                                       &balance;
      std::vector<std::map<types::boundary_id, Condition<dim>>> conditions; ///< by body
      const FEValuesExtractors::Vector                          vector = FEValuesExtractors::Vector(0);
      const FEValuesExtractors::Scalar                          first  = FEValuesExtractors::Scalar(0);
      FEFaceValues<dim>                                         fe_values;
      std::vector<SymmetricTensor<2, dim>>                      strains;
      std::vector<Tensor<1, dim>>                               tractions, normals;
      std::vector<double>                                       open, pressure, gap;

      Tensor<1, dim> mean_traction(FunctionParser<dim> &function, const Point<dim> &point) const
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
    };
  } // namespace


  template <int dim>
  void add_boundary_residual(const Discretization<dim> &discretization,
                             const ContactSurface<dim> &surface,
                             const ForceBalance        &balance,
                             const Vector              &displacement,
                             const ContactFields<dim>  &fields,
                             const ResidualWeights     &weights,
                             dealii::Vector<double>    &squares)
  {
    FaceResidual<dim> residual(discretization, balance);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary())
            {
              const Material &material  = discretization.scene.bodies[cell->material_id()].material;
              const double    h         = cell->face(face)->diameter() / std::sqrt(dim - 1.);
              const bool      is_slave  = surface.contains(cell, face);
              const bool      is_master = is_master_face(discretization.scene, cell, face);
              double         &square    = squares(cell->active_cell_index());
              square += weights.face(material, h)
                        * residual.square(cell, face, is_slave, is_master, material, displacement, fields);
              if (is_slave)
                square += weights.complementarity() * residual.energy_of_gap(fields);
            }
  }


  template void add_boundary_residual(const Discretization<2> &,
                                      const ContactSurface<2> &,
                                      const ForceBalance &,
                                      const Vector &,
                                      const ContactFields<2> &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
  template void add_boundary_residual(const Discretization<3> &,
                                      const ContactSurface<3> &,
                                      const ForceBalance &,
                                      const Vector &,
                                      const ContactFields<3> &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
} // namespace signorini
