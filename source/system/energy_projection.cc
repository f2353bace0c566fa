// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/contact_status.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/preconditioners/preconditioner_choice.h>
#include <signorini/preconditioners/preconditioners.h>
#include <signorini/system/energy_projection.h>
#include <signorini/system/rigid_springs.h>
#include <signorini/system/scales.h>
#include <signorini/variational_inequality/primal_dual_active_set.h>

#include <limits>

namespace signorini
{
  namespace
  {
    /** Entries that Dirichlet conditions or closed nodes hold, or nodes that are closed here. */
    template <int dim>
    std::vector<unsigned int> held_entries(const ContactCoordinates<dim> &coordinates,
                                           const std::vector<double>     &bounds,
                                           const ActiveSet               &active,
                                           const double                   touching)
    {
      ActiveSet held = active;
      for (std::size_t k = 0; k < bounds.size(); ++k)
        if (bounds[k] <= touching)
          held[k] = contact_status::slip;
      return coordinates.held_entries(held);
    }


    /**
     * Each body has those of its own lowest frequency: they decide how far contact turns and shifts
     * it instead of straining it, so that other bodies must not matter.
     */
    template <int dim>
    Eigen::MatrixXd springs_of_bodies(const Mesh<dim>               &mesh,
                                      const ContactCoordinates<dim> &coordinates,
                                      const RigidModes<dim>         &rigid)
    {
      Eigen::MatrixXd  springs = rigid.free_amplitudes(coordinates.dirichlet_entries());
      constexpr size_t n       = RigidModes<dim>::n_motions;
      for (std::size_t k = 0; k < rigid.bodies().size(); ++k)
        springs.middleRows(k * n, n) *= mesh.lowest_frequency(rigid.bodies()[k]);
      return springs * springs.transpose();
    }


    /**
     * Minimise 1/2 c'A c - r'c + a little of c'M c, with springs at the free rigid motions: else a
     * body would turn far, at no cost, where two nodes side by side are in the way.
     * @return c, Cartesian
     */
    template <int dim>
    Vector minimise(const Discretization<dim>     &discretization,
                    const ContactCoordinates<dim> &coordinates,
                    const RigidModes<dim>         &rigid,
                    Vector                         right_hand_side,
                    const std::vector<double>     &bounds,
                    const double                   size,
                    const ActiveSetLimits         &limits,
                    ActiveSet                     &active)
    {
      // Far below the lowest frequency of any body that keeps its shape.
      const double            frequency   = discretization.mesh().lowest_frequency();
      const double            mass_factor = std::pow(1e-4 * frequency, 2);
      const StepOperator<dim> stiffness(discretization.matrices(), coordinates, {mass_factor, 1.});
      RigidSprings<dim>       matrix(stiffness, rigid);
      matrix.set(springs_of_bodies(discretization.mesh(), coordinates, rigid));
      coordinates.force_to_contact(right_hand_side);
      const std::vector<unsigned int> &prescribed = coordinates.dirichlet_entries();
      const std::vector<double>        nothing(prescribed.size(), 0.);
      // As small as what CG leaves of the moments: they are the round-off of their sums.
      if (rough_response_size(matrix, right_hand_side, prescribed, nothing) <= 1e-12 * size)
        return discretization.make_vector();

      // With all of the mass as stiff as the springs it differs from that of the problem by at most
      // a factor of two but for motions that are slower than any that keep a body's shape.
      const auto preconditioner = make_static_preconditioner(
        PreconditionerKind::automatic,
        discretization,
        coordinates,
        std::vector<double>(discretization.mesh().bodies().size(), frequency * frequency),
        needs_double_precision(discretization, 2. / frequency));
      PrimalDualActiveSet solver(limits);
      Vector              correction = discretization.make_vector(), residual = correction;
      // Of a body without deformation both sizes are round-off; then the larger one is the measure.
      const double response =
        response_size(matrix, *preconditioner, right_hand_side, prescribed, nothing);
      const double tolerance =
        std::max({1e-11 * size, 1e-8 * response, std::numeric_limits<double>::min()});
      solver.solve({matrix,
                    *preconditioner,
                    right_hand_side,
                    coordinates.normal_entries(),
                    bounds,
                    prescribed,
                    nothing,
                    tolerance,
                    1e-14 * discretization.mesh().body_size()},
                   active,
                   correction,
                   residual);
      coordinates.displacement_to_cartesian(correction);
      return correction;
    }
  } // namespace


  template <int dim>
  Vector project_in_energy(const Discretization<dim>     &discretization,
                           const ContactCoordinates<dim> &coordinates,
                           const Vector                  &energy_moments,
                           const Vector                  &mass_moments,
                           const std::vector<double>     &bounds,
                           const double                   size,
                           const ActiveSetLimits         &limits)
  {
    AssertDimension(bounds.size(), coordinates.normal_entries().size());
    AssertDimension(energy_moments.locally_owned_size(), mass_moments.locally_owned_size());
    Assert(size >= 0., dealii::ExcMessage("The size of a displacement is a norm."));
    const RigidModes<dim> rigid(discretization, coordinates);
    const double          touching = touching_distance(discretization.mesh().body_size());
    ActiveSet             active(bounds.size(), contact_status::open);

    Vector shift = discretization.make_vector();
    for (const Motion &mode : rigid.free_of(held_entries(coordinates, bounds, active, touching)))
      shift.add(dot(mode.displacement, mass_moments), mode.displacement);
    Vector shift_of_nodes = shift;
    coordinates.displacement_to_contact(shift_of_nodes);
    std::vector<double> left = bounds;
    for (std::size_t k = 0; k < left.size(); ++k)
      left[k] -= shift_of_nodes.local_element(coordinates.normal_entries()[k]);

    // What the moments have of forces on free bodies is round-off. The little mass of the problem
    // would let it move them far.
    Vector moments = energy_moments;
    for (const Motion &mode : rigid.free_of(coordinates.dirichlet_entries()))
      moments.add(-dot(mode.displacement, moments), mode.momentum);
    Vector correction =
      minimise(discretization, coordinates, rigid, std::move(moments), left, size, limits, active);
    for (const Motion &mode : rigid.free_of(held_entries(coordinates, bounds, active, touching)))
      correction.add(-dot(mode.momentum, correction), mode.displacement);
    correction += shift;
    return correction;
  }


#define INSTANTIATE(dim)                                                                           \
  template Vector project_in_energy(const Discretization<dim> &,                                   \
                                    const ContactCoordinates<dim> &,                               \
                                    const Vector &,                                                \
                                    const Vector &,                                                \
                                    const std::vector<double> &,                                   \
                                    double,                                                        \
                                    const ActiveSetLimits &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
