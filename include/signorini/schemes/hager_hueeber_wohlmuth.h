// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_hager_hueeber_wohlmuth_h
#define signorini_schemes_hager_hueeber_wohlmuth_h

#include <signorini/schemes/laursen_chawla.h>

namespace signorini
{
  /**
   * The scheme of Laursen and Chawla with contact nodes without mass
   * (@cite hager_hueeber_wohlmuth_2008; @cite krause_walloth_2012, Algorithm 4); the mass is that
   * of the system, by quadrature on macro-elements if nothing else is asked for.
   *
   * Contact forces do no work, and so the energy of the redistributed mass is exact. That of the
   * consistent mass is not: the rows of massless nodes balance mean forces, which leaves an
   * undamped alternation of their displacement and velocity after release. Penetration as in
   * LaursenChawla; smooth contact forces.
   */
  class HagerHueeberWohlmuth : public LaursenChawla
  {
  public:
    using LaursenChawla::LaursenChawla;
  };
} // namespace signorini

#endif
