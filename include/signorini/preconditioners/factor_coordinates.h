// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_factor_coordinates_h
#define signorini_preconditioners_factor_coordinates_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/contact/node_frames.h>
#include <signorini/linear_algebra/slip_rows.h>

#include <optional>

namespace signorini
{
  /**
   * Whether blocks make up T'K T: not where partners come and go, as there is no matrix in relative
   * coordinates then.
   */
  template <int dim>
  bool sweeps_know_all(const ContactCoordinates<dim> &coordinates)
  {
    return !coordinates.coupling().any() || !coordinates.coupling().changes();
  }


  /**
   * The matrix of a step as a factor of its blocks sees it, and the way between its coordinates and
   * contact coordinates. With two bodies in contact M + s A is seen in relative coordinates,
   * without the rotations: there relative entries can be held within sweeps. The mass is so well
   * conditioned that the separate bodies do; relative entries are then held around them only.
   */
  template <int dim>
  class FactorCoordinates
  {
  public:
    FactorCoordinates(const ElasticMatrices<dim>    &matrices,
                      const ContactCoordinates<dim> &coordinates,
                      const MatrixSum               &sum,
                      bool                           follows_partners);

    /** The matrix is sum() of these. */
    const ElasticMatrices<dim> &matrices() const { return is_relative ? relative : of_bodies; }
    MatrixSum                   sum() const { return is_relative ? MatrixSum{0., 1.} : of_step; }
    /** Whether it is T'K T of the step, all of it, and not only close to it. */
    bool is_exact() const;
    /** The blocks are not needed any more, only the pattern. */
    void forget_blocks() { decltype(relative.stiffness)().swap(relative.stiffness); }

    const std::vector<unsigned int> &contact_nodes() const { return frames.contact_nodes(); }

    /** @return what is held within sweeps. Collective */
    HeldNodes<dim> set_mask(const Mask &mask);

    /**
     * The rows of slipping nodes in the coordinates of the factor. None where the frame of a node
     * is oblique, so that forces have other components than displacements. Collective
     */
    std::optional<std::vector<NodeSlip<dim>>> node_slip(const std::vector<SlipRows> &rows) const;

    /** Of a force: held entries become zero. */
    void to_factor(Vector &force) const;
    /**
     * Of a displacement. Rotated entries are held to single precision only; a multiplier must not
     * leak through, so they become exact zeros.
     */
    void from_factor(Vector &displacement) const;

  private:
    const ElasticMatrices<dim>    &of_bodies;
    const ContactCoordinates<dim> &coordinates;
    const MatrixSum                of_step;
    ElasticMatrices<dim>           relative;
    const bool                     is_relative;
    unsigned int                   n_turns;
    NodeFrames<dim>                frames;
    std::vector<unsigned int>      held_entries;

    NodeFrames<dim> frames_now() const;
    void            hold(Vector &vector) const;
  };
} // namespace signorini

#endif
