// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_turning_normals_h
#define signorini_diagnostics_turning_normals_h

#include <signorini/base/archive.h>
#include <signorini/contact/contact_surface.h>

#include <map>

namespace signorini
{
  /**
   * Watches by what angles normals turn at nodes that stay in contact, where contact follows the
   * motion. A predictor that does not project velocities leaves such a node the velocity with which
   * it approached, along a normal that is no longer that of contact.
   */
  template <int dim>
  class TurningNormals
  {
  public:
    /**
     * @param contact_force of the step that has just been made
     * @return per body the largest angle, in radians, between the normal of a node that is under
     * pressure now and its normal when that began. Collective.
     */
    std::vector<double> add(const ContactSurface<dim> &surface,
                            const Vector              &contact_force,
                            unsigned int               n_bodies,
                            MPI_Comm                   communicator);

    /** Since when nodes are in contact. Collective. */
    void archive(Archive &archive, MPI_Comm communicator);

  private:
    struct Before
    {
      bool operator()(const dealii::Point<dim> &a, const dealii::Point<dim> &b) const
      {
        return std::lexicographical_compare(a.begin_raw(), a.end_raw(), b.begin_raw(), b.end_raw());
      }
    };
    /** By the place of the node in the reference configuration, which a new mesh does not change.
     */
    std::map<dealii::Point<dim>, dealii::Tensor<1, dim>, Before> when_it_began;
  };
} // namespace signorini

#endif
