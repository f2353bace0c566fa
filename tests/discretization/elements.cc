// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What an element has to be, whatever it is good for (see locking.cc for that):
//
// - a cell of any shape resists everything but rigid motions (no more zero eigenvalues than those),
//   and near incompressibility only one eigenvalue grows with the stiffness against compression;
// - the patch test holds on cells that are distorted at random, and the mean strain of a cell is
//   that of its displacement (both because the modes have no mean value);
// - the stiffness is the integral of the energy of the strain that stress and indicators see.

#include "distorted.h"

#include <signorini/finite_elements/cell_strain.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  Eigen::MatrixXd stiffness_of(const ScaledCellMatrix<dim> &cell)
  {
    constexpr unsigned int n = 1u << dim;
    Eigen::MatrixXd        result(dim * n, dim * n);
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < n; ++b)
        {
          const auto block = cell.stiffness(a, b);
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              result(dim * a + c, dim * b + d) = block[dim * d + c];
        }
    return result;
  }

  /** Of one cell with the given edges, one corner of which is pulled out; E = 1. */
  template <int dim>
  Eigen::VectorXd eigenvalues(const ElementKind         element,
                              const double              poissons_ratio,
                              const dealii::Point<dim> &edges,
                              const double              distortion)
  {
    BodyDescription<dim> body = box_of<dim>(element, poissons_ratio);
    box_of(body).upper_corner = edges;
    box_of(body).repetitions.fill(1);
    body.material.youngs_modulus = 1.;
    Mesh<dim>  mesh({body}, MPI_COMM_SELF);
    const auto cell = mesh.triangulation().begin_active();
    for (unsigned int c = 0; c < dim; ++c)
      {
        cell->vertex((1u << dim) - 1)[c] += distortion * (1. + 0.2 * c) * edges[c];
        cell->vertex(1)[c] += 0.3 * distortion * edges[c];
      }
    mesh.update();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
             stiffness_of<dim>(mesh.cell_matrices().of(cell)))
      .eigenvalues();
  }

  template <int dim>
  void expect_rigid_motions_only()
  {
    constexpr unsigned int n_rigid = dim * (dim + 1) / 2;
    dealii::Point<dim>     cube, plate, needle;
    for (unsigned int c = 0; c < dim; ++c)
      {
        cube[c]   = 1.;
        plate[c]  = c + 1 < dim ? 1. : 0.01;
        needle[c] = c == 0 ? 1. : 0.01;
      }
    for (const ElementKind element : all_elements)
      for (const double nu : {0., 0.3, 0.4999})
        for (const dealii::Point<dim> &edges : {cube, plate, needle})
          for (const double distortion : {0., 0.3})
            {
              const auto values   = eigenvalues<dim>(element, nu, edges, distortion);
              const auto standard = eigenvalues<dim>(ElementKind::standard, nu, edges, distortion);
              const auto largest  = standard.size() - 1;
              // Plates and needles resist bending with a power of their thickness.
              const double smallest = edges == cube ? 0.03 : 1e-9;
              for (unsigned int i = 0; i < values.size(); ++i)
                EXPECT_LT(values[i], standard[i] + 1e-12 * standard[largest]);
              EXPECT_LT(values.head(n_rigid).cwiseAbs().maxCoeff(), 1e-13 * standard[largest]);
              EXPECT_GT(values[n_rigid], smallest) << name_of(element) << ' ' << nu;
              // Near incompressibility, E/(3 (1 - 2 nu)) is 1666, all other moduli are below 1.
              if (nu < 0.4 || edges != cube)
                continue;
              EXPECT_GT(values[largest], 100.);
              EXPECT_EQ(values[largest - 1] > 100., element == ElementKind::standard);
            }
  }

  template <int dim>
  void expect_patch_test(const Discretization<dim> &discretization)
  {
    std::array<std::string, dim> linear;
    linear[0] = "0.3*x - 0.1*y";
    linear[1] = "0.5*x + 0.2*y";
    if constexpr (dim == 3)
      linear[2] = "-0.4*z + 0.1*x + 0.6*y";
    const Vector forces = stiffness_times(discretization, field<dim>(discretization, linear));
    const double scale =
      stiffness_times(discretization, irregular_field(discretization, 3.)).linfty_norm();
    const double n_inside = sum_over_nodes(discretization, [&](const unsigned int node) {
      if (!inside_unit_box<dim>(discretization.node_positions()[node]))
        return 0.;
      for (unsigned int c = 0; c < dim; ++c)
        EXPECT_LT(std::abs(forces.local_element(dim * node + c)), 1e-12 * scale);
      return 1.;
    });
    EXPECT_EQ(n_inside, dim == 2 ? 9. : 27.);
  }

  /** Integrals over a cell: of the strain of the element, and of twice its energy. */
  template <int dim>
  std::pair<dealii::SymmetricTensor<2, dim>, double>
  integrals(const CellNeighbors<dim> &mesh, const LocalCell<dim> &cell, const Vector &displacement)
  {
    const CellStrain<dim> strain(mesh, cell, displacement);
    const auto           &tables = GaussTables<dim>::of_degree(1).interior;
    const auto           &of_map =
      GaussTables<dim>::of_degree(mesh.discretization.mesh().mapping().get_degree()).interior;
    dealii::SymmetricTensor<2, dim> integral;
    double                          energy = 0.;
    for (std::size_t t = 0; t < tables.size(); ++t)
      {
        const auto jacobian = strain.jacobian(of_map[t]);
        const auto cofactor = cofactors(jacobian);
        const auto volume   = determinant<dim>(jacobian, cofactor);
        const auto gradient = strain.gradient(tables[t], cofactor);
        for (unsigned int q = 0; q < PointTable<dim>::n_points; ++q)
          {
            dealii::Tensor<2, dim> here;
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int i = 0; i < dim; ++i)
                here[c][i] = gradient[c][i][q] / volume[q];
            const auto   eps = symmetrize(here);
            const double JxW = volume[q] / (1 << dim);
            integral += JxW * eps;
            energy += JxW
                      * (2. * strain.material.mu() * (eps * eps)
                         + strain.material.lambda() * trace(eps) * trace(eps));
          }
      }
    return {integral, energy};
  }

  /** The same of a standard element. */
  template <int dim>
  dealii::SymmetricTensor<2, dim> integral_of_displacement(const CellNeighbors<dim> &mesh,
                                                           const LocalCell<dim>     &cell,
                                                           const Vector             &displacement)
  {
    using namespace dealii;
    FEValues<dim> values(mesh.discretization.mesh().mapping(),
                         mesh.discretization.fe(),
                         QGauss<dim>(2),
                         update_gradients | update_JxW_values);
    values.reinit(cell.cell);
    std::vector<double> local(dim << dim);
    mesh.gather(cell, displacement, local.data());
    SymmetricTensor<2, dim> result;
    for (unsigned int i = 0; i < values.dofs_per_cell; ++i)
      for (const unsigned int q : values.quadrature_point_indices())
        result +=
          local[i] * values.JxW(q) * values[FEValuesExtractors::Vector(0)].symmetric_gradient(i, q);
    return result;
  }

  template <int dim>
  void expect_strain_and_stiffness_to_agree(const Discretization<dim> &discretization)
  {
    const CellNeighbors<dim> mesh(discretization);
    const Vector u = mesh.interpolate_hanging_nodes(irregular_field(discretization, 5.));
    for (const LocalCell<dim> &cell : mesh.cells)
      {
        std::vector<double> local(dim << dim);
        mesh.gather(cell, u, local.data());
        const Eigen::Map<const Eigen::VectorXd> values(local.data(), local.size());
        const auto [strain, energy] = integrals(mesh, cell, u);
        const double expected       = values.dot(
          stiffness_of<dim>(discretization.mesh().cell_matrices().of(cell.cell)) * values);
        EXPECT_NEAR(energy, expected, 1e-12 * expected);
        const auto of_u = integral_of_displacement(mesh, cell, u);
        EXPECT_LT((strain - of_u).norm(), 1e-13 * of_u.norm());
      }
  }

  template <int dim>
  BodyDescription<dim> refined_box_of(const ElementKind element)
  {
    BodyDescription<dim> body = box_of<dim>(element, 0.4);
    body.refinements          = 1;
    return body;
  }
} // namespace

TEST(Elements, ResistAllButRigidMotions)
{
  expect_rigid_motions_only<2>();
  expect_rigid_motions_only<3>();
}

TEST(Elements, PassThePatchTestOnDistortedCells)
{
  for (const ElementKind element : all_elements)
    {
      expect_patch_test(Distorted<2>(refined_box_of<2>(element), 0.25).discretization);
      expect_patch_test(Distorted<3>(refined_box_of<3>(element), 0.25).discretization);
    }
}

// Cells that share a matrix because they are congruent, cells that differ, and cells with quadratic
// maps; the latter have more points of quadrature, and are left to the other tests.
TEST(Elements, StrainIsWhatTheStiffnessIsMadeOf)
{
  for (const ElementKind element : all_elements)
    {
      BodyDescription<2> plane = box_with_hanging_nodes<2>();
      BodyDescription<3> space = box_with_hanging_nodes<3>();
      plane.element = space.element = element;
      box_of(plane).upper_corner[1] = box_of(space).upper_corner[2] = 0.3;
      expect_strain_and_stiffness_to_agree(Assembled<2>(plane).discretization);
      expect_strain_and_stiffness_to_agree(Assembled<3>(space).discretization);
      expect_strain_and_stiffness_to_agree(
        Distorted<2>(refined_box_of<2>(element), 0.25).discretization);
      expect_strain_and_stiffness_to_agree(
        Distorted<3>(refined_box_of<3>(element), 0.25).discretization);
    }
}
