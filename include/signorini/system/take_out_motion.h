// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_take_out_motion_h
#define signorini_system_take_out_motion_h

#include <signorini/base/contact_status.h>
#include <signorini/system/rigid_modes.h>
#include <signorini/time/dynamical_system.h>

namespace signorini
{
  /**
   * Takes rigid motion that nothing holds out of an increment of the displacement, as far as the
   * bounds allow: a body that tips over an edge keeps as much of its rotation as its bent face
   * needs to stay outside. Bodies that move together go back together; all start at once, and stop
   * where one of their open nodes arrives at its bound. Collective.
   * @param free      basis of the motions that nothing holds, see RigidModes::free_amplitudes
   * @param amplitudes of the rigid motions in the increment, free or not
   * @param status    closed nodes are not moved by free motions
   * @param bounds    of the normal increments
   * @param tolerance lengths up to here are round-off
   * @param increment in contact coordinates
   */
  template <int dim>
  void take_out_motion(const RigidModes<dim>         &rigid,
                       const Eigen::MatrixXd         &free,
                       const Eigen::VectorXd         &amplitudes,
                       const ContactCoordinates<dim> &coordinates,
                       const ActiveSet               &status,
                       const NormalGap               &bounds,
                       double                         tolerance,
                       Vector                        &increment);
} // namespace signorini

#endif
