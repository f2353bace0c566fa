// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_motion_in_words_h
#define signorini_system_motion_in_words_h

#include <signorini/system/rigid_modes.h>

#include <string>

namespace signorini
{
  /**
   * A rigid motion of some bodies for people: "'block' moves along x; 'ball' moves along (0.6, 0.8)
   * and turns about z". Parts without a thousandth of the kinetic energy, by root, are left out.
   * @param names      of all bodies
   * @param amplitudes in the order of the modes, not all zero
   */
  template <int dim>
  std::string motion_in_words(const std::vector<std::string> &names,
                              const RigidModes<dim>          &rigid,
                              const Eigen::VectorXd          &amplitudes);
} // namespace signorini

#endif
