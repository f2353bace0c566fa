// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/geometric_multigrid.h>
#include <signorini/preconditioners/multilevel.h>
#include <signorini/preconditioners/preconditioners.h>
#include <signorini/preconditioners/relative_matrix.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

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


    /**
     * An incomplete factor seen from contact coordinates. With two bodies in contact the factor of
     * M + s A is that of the matrix in relative coordinates, without the rotations: there relative
     * entries can be held within the sweeps. The mass is so well conditioned that the factor of the
     * separate bodies does; relative entries are then held around it only.
     */
    template <int dim, int block_size>
    class ContactIncompleteCholesky : public MaskedPreconditioner
    {
    public:
      ContactIncompleteCholesky(const ElasticMatrices<dim>    &matrices,
                                const ContactCoordinates<dim> &coordinates,
                                const MatrixSum               &sum)
        : coordinates(coordinates)
        , relative(block_size == dim && coordinates.coupling().any()
                     ? relative_matrix(matrices, coordinates, sum)
                     : ElasticMatrices<dim>())
        , is_relative(relative.pattern.partitioner != nullptr)
        , frames(coordinates.node_frames(),
                 coordinates.contact_nodes(),
                 (is_relative ? relative : matrices).pattern.partitioner)
        , factor(is_relative ? relative : matrices,
                 is_relative ? MatrixSum{0., 1.} : sum,
                 frames.contact_nodes())
        , turned(matrices.pattern.partitioner)
      {
        decltype(relative.stiffness)().swap(
          relative.stiffness); // only the pattern is needed from now on
      }

      void set_mask(const Mask &mask) override
      {
        AssertDimension(mask.size(), turned.locally_owned_size());
        held_entries.clear();
        for (unsigned int i = 0; i < mask.size(); ++i)
          if (mask[i])
            held_entries.push_back(i);
        Mask mask_of_factor = mask;
        if (!is_relative)
          for (const unsigned int i : coordinates.relative_entries())
            mask_of_factor[i] = 0;
        factor.set_held_nodes(frames.held_nodes(mask_of_factor));
      }

      void vmult(Vector &destination, const Vector &source) const override
      {
        turned.copy_locally_owned_data_from(source);
        hold(turned);
        if (is_relative)
          coordinates.rotate_from_frames(turned);
        else
          coordinates.force_to_cartesian(turned);
        factor.vmult(destination, turned);
        if (is_relative)
          coordinates.rotate_to_frames(destination);
        else
          coordinates.displacement_to_contact(destination);
        hold(destination);
      }

    private:
      const ContactCoordinates<dim>      &coordinates;
      ElasticMatrices<dim>                relative;
      const bool                          is_relative;
      const NodeFrames<dim>               frames;
      IncompleteCholesky<dim, block_size> factor;
      mutable Vector                      turned;
      std::vector<unsigned int>           held_entries;

      /**
       * The factor holds rotated entries only to single precision; a multiplier must not leak
       * through, so they become exact zeros.
       */
      void hold(Vector &vector) const
      {
        for (const unsigned int i : held_entries)
          vector.local_element(i) = 0.;
      }
    };


    /** Beyond it the coarse levels keep more of what is held than a soft body has. */
    constexpr double most_for_multigrid = 1e6;

    /** Of the stiffest node and the softest. Collective. */
    template <int dim>
    double ratio_of_stiffness(const ElasticMatrices<dim> &matrices)
    {
      const NodePattern &pattern = matrices.pattern;
      double             largest = 0., smallest = std::numeric_limits<double>::max();
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        if (!pattern.is_empty(node))
          {
            const double stiffness = matrices.stiffness[pattern.row_start[node]][0];
            largest                = std::max(largest, stiffness);
            smallest               = std::min(smallest, stiffness);
          }
      const MPI_Comm communicator = pattern.partitioner->get_mpi_communicator();
      return dealii::Utilities::MPI::max(largest, communicator)
             / dealii::Utilities::MPI::min(smallest, communicator);
    }
  } // namespace


  PreconditionerKind choose_preconditioner(const double                          courant_number,
                                           const dealii::types::global_dof_index n_dofs,
                                           const unsigned int                    matrix_life_time)
  {
    // A factor costs about as much as it saves in 40 steps at Courant number 1, in 8 at 5. Where
    // the stiffness rules the diagonal is too poor in any case: the accuracy of a solution is
    // judged in its norm.
    if (courant_number < 0.3 || (courant_number < 10. && matrix_life_time * courant_number < 40.))
      return PreconditionerKind::jacobi;
    // With the incomplete factor iterations grow with the Courant number, with multigrid they do
    // not, but each is dearer, and most on small meshes.
    const double multigrid_pays = std::min(100., 12. * (1. + 30000. / n_dofs));
    return courant_number > multigrid_pays ? PreconditionerKind::multigrid
                                           : PreconditionerKind::incomplete_cholesky;
  }


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
                             const std::vector<double>     &mass_factors)
  {
    const double largest = *std::max_element(mass_factors.begin(), mass_factors.end());
    if (kind == PreconditionerKind::ml
        || (kind == PreconditionerKind::automatic
            && ratio_of_stiffness(discretization.matrices()) > most_for_multigrid))
      return std::make_unique<Multilevel<dim>>(discretization, coordinates, mass_factors);
    if (kind == PreconditionerKind::multigrid || kind == PreconditionerKind::automatic)
      return make_geometric_multigrid(std::make_shared<const LevelHierarchy<dim>>(discretization),
                                      coordinates,
                                      MatrixSum{largest, 1.},
                                      true);
    return make_preconditioner(kind, discretization.matrices(), coordinates, {largest, 1.});
  }


  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_mass_preconditioner(const ElasticMatrices<dim>    &matrices,
                           const ContactCoordinates<dim> &coordinates)
  {
    return std::make_unique<ContactIncompleteCholesky<dim, 1>>(
      matrices, coordinates, MatrixSum{1., 0.});
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
    const std::vector<double> &);                                                                  \
  template std::unique_ptr<MaskedPreconditioner> make_mass_preconditioner(                         \
    const ElasticMatrices<dim> &, const ContactCoordinates<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
