// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/incomplete_cholesky.h>
#include <signorini/multigrid/geometric_multigrid.h>
#include <signorini/preconditioners/factor_coordinates.h>
#include <signorini/preconditioners/multilevel.h>
#include <signorini/preconditioners/preconditioner_choice.h>
#include <signorini/preconditioners/preconditioners.h>
#include <signorini/sweeps/symmetric_gauss_seidel.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** The diagonal of the masked matrix. */
    class Jacobi : public MaskedPreconditioner
    {
    public:
      explicit Jacobi(const LinearOperator &matrix, const Vector &like)
      {
        inverse.reinit(like, true);
        matrix.diagonal(inverse);
        for (unsigned int i = 0; i < inverse.locally_owned_size(); ++i)
          inverse.local_element(i) = 1. / inverse.local_element(i);
        masked_inverse = inverse;
      }

      void set_mask(const Mask &mask) override
      {
        AssertDimension(mask.size(), inverse.locally_owned_size());
        for (unsigned int i = 0; i < mask.size(); ++i)
          masked_inverse.local_element(i) = mask[i] ? 0. : inverse.local_element(i);
      }

      void vmult(Vector &destination, const Vector &source) const override
      {
        for (unsigned int i = 0; i < source.locally_owned_size(); ++i)
          destination.local_element(i) = masked_inverse.local_element(i) * source.local_element(i);
      }

    private:
      Vector inverse, masked_inverse;
    };


    /** An incomplete factor seen from contact coordinates. */
    template <int dim, int block_size>
    class ContactIncompleteCholesky : public MaskedPreconditioner
    {
    public:
      ContactIncompleteCholesky(const ElasticMatrices<dim>    &matrices,
                                const ContactCoordinates<dim> &coordinates,
                                const MatrixSum               &sum)
        : inner(matrices, coordinates, sum, block_size == dim)
        , factor(inner.matrices(), inner.sum(), inner.contact_nodes())
        , turned(matrices.pattern.partitioner)
      {
        inner.forget_blocks();
      }

      void set_mask(const Mask &mask) override { factor.set_held_nodes(inner.set_mask(mask)); }

      void vmult(Vector &destination, const Vector &source) const override
      {
        turned.copy_locally_owned_data_from(source);
        inner.to_factor(turned);
        factor.vmult(destination, turned);
        inner.from_factor(destination);
      }

    private:
      FactorCoordinates<dim>              inner;
      IncompleteCholesky<dim, block_size> factor;
      mutable Vector                      turned;
    };


    /** Symmetric Gauss-Seidel seen from contact coordinates, which solves by itself. */
    template <int dim, int block_size>
    class ContactGaussSeidel : public MaskedPreconditioner, public RoughSolver
    {
    public:
      ContactGaussSeidel(const ElasticMatrices<dim>    &matrices,
                         const ContactCoordinates<dim> &coordinates,
                         const MatrixSum               &sum,
                         std::optional<SweepOrder>      order = {})
        : inner(matrices, coordinates, sum, block_size == dim)
        , sweeps(inner.matrices(),
                 inner.sum(),
                 order ? std::move(*order) : SweepOrder::of<dim>(inner.matrices().pattern))
        , turned(matrices.pattern.partitioner)
        , is_exact(inner.is_exact())
      {
        inner.forget_blocks();
      }

      void set_mask(const Mask &mask) override { sweeps.set_held_nodes(inner.set_mask(mask)); }

      void vmult(Vector &destination, const Vector &source) const override
      {
        turn(source);
        sweeps.vmult(destination, turned);
        inner.from_factor(destination);
      }

      const RoughSolver *rough_solver() const override { return is_exact ? this : nullptr; }

      const RoughSolver *rough_solver_with(const std::vector<SlipRows> &rows) override
      {
        if (!is_exact)
          return nullptr;
        const auto slipping = inner.node_slip(rows);
        if (slipping)
          sweeps.set_slip(*slipping);
        return slipping ? this : nullptr;
      }

      double start(const Vector &residual) const override
      {
        turn(residual);
        return sweeps.start(turned);
      }

      Report solve(Vector            &correction,
                   const double       reduction,
                   const unsigned int maximum_iterations) const override
      {
        const Report report = sweeps.solve(correction, reduction, maximum_iterations);
        inner.from_factor(correction);
        return report;
      }

    private:
      FactorCoordinates<dim>                inner;
      SymmetricGaussSeidel<dim, block_size> sweeps;
      mutable Vector                        turned;
      const bool                            is_exact;

      void turn(const Vector &force) const
      {
        turned.copy_locally_owned_data_from(force);
        inner.to_factor(turned);
      }
    };
  } // namespace


  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_preconditioner(const PreconditionerKind       kind,
                      const ElasticMatrices<dim>    &matrices,
                      const ContactCoordinates<dim> &coordinates,
                      const MatrixSum               &sum)
  {
    if (kind == PreconditionerKind::jacobi)
      return std::make_unique<Jacobi>(StepOperator<dim>(matrices, coordinates, sum),
                                      Vector(matrices.pattern.partitioner));
    if (kind == PreconditionerKind::ml)
      return std::make_unique<Multilevel<dim>>(matrices, coordinates, sum);
    if (kind == PreconditionerKind::symmetric_gauss_seidel)
      return std::make_unique<ContactGaussSeidel<dim, dim>>(matrices, coordinates, sum);
    Assert(kind == PreconditionerKind::incomplete_cholesky,
           dealii::ExcMessage("`automatic` is to be decided before: choose_preconditioner(); "
                              "multigrid needs a mesh."));
    return std::make_unique<ContactIncompleteCholesky<dim, dim>>(matrices, coordinates, sum);
  }


  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_static_preconditioner(const PreconditionerKind       kind,
                             const Discretization<dim>     &discretization,
                             const ContactCoordinates<dim> &coordinates,
                             const std::vector<double>     &mass_factors,
                             const bool                     in_double_precision)
  {
    const double largest = *std::max_element(mass_factors.begin(), mass_factors.end());
    if (kind == PreconditionerKind::ml
        || (kind == PreconditionerKind::automatic
            && ratio_of_stiffness(discretization.matrices()) > most_for_multigrid))
      return std::make_unique<Multilevel<dim>>(discretization, coordinates, mass_factors);
    if (kind == PreconditionerKind::multigrid || kind == PreconditionerKind::automatic)
      return make_geometric_multigrid(
        std::make_shared<const LevelHierarchy<dim>>(discretization, coordinates.clamped_nodes()),
        coordinates,
        MatrixSum{largest, 1.},
        in_double_precision);
    return make_preconditioner(kind, discretization.matrices(), coordinates, {largest, 1.});
  }


  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_mass_preconditioner(const ElasticMatrices<dim>    &matrices,
                           const ContactCoordinates<dim> &coordinates)
  {
    const MatrixSum mass{1., 0.};
    if (coordinates.coupling().any()) // sweeps of the separate bodies do not solve by themselves
      return std::make_unique<ContactIncompleteCholesky<dim, 1>>(matrices, coordinates, mass);
    return std::make_unique<ContactGaussSeidel<dim, 1>>(matrices, coordinates, mass);
  }


  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_mass_preconditioner(const ElasticMatrices<dim>    &matrices,
                           const ContactCoordinates<dim> &coordinates,
                           SweepOrder                     order)
  {
    Assert(!coordinates.coupling().any(), dealii::ExcMessage("Bodies meet across the order."));
    return std::make_unique<ContactGaussSeidel<dim, 1>>(
      matrices, coordinates, MatrixSum{1., 0.}, std::move(order));
  }


#define INSTANTIATE(dim)                                                                           \
  template std::unique_ptr<MaskedPreconditioner> make_preconditioner(                              \
    PreconditionerKind,                                                                            \
    const ElasticMatrices<dim> &,                                                                  \
    const ContactCoordinates<dim> &,                                                               \
    const MatrixSum &);                                                                            \
  template std::unique_ptr<MaskedPreconditioner> make_static_preconditioner(                       \
    PreconditionerKind,                                                                            \
    const Discretization<dim> &,                                                                   \
    const ContactCoordinates<dim> &,                                                               \
    const std::vector<double> &,                                                                   \
    bool);                                                                                         \
  template std::unique_ptr<MaskedPreconditioner> make_mass_preconditioner(                         \
    const ElasticMatrices<dim> &, const ContactCoordinates<dim> &);                                \
  template std::unique_ptr<MaskedPreconditioner> make_mass_preconditioner(                         \
    const ElasticMatrices<dim> &, const ContactCoordinates<dim> &, SweepOrder);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
