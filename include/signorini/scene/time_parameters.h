// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_time_parameters_h
#define signorini_scene_time_parameters_h

#include <string>

namespace signorini
{
  /** Section `Time`: which scheme, which mass matrix, which steps. */
  struct TimeParameters
  {
    std::string scheme         = "contact-stabilized"; ///< see declare_time()
    std::string mass           = "consistent";    ///< consistent | lumped | redistributed | zero on contact boundary
    std::string redistribution = "extrapolation"; ///< extrapolation | minimisation | macro-elements
    std::string predictor      = "consistent"; ///< mass of the L2 projection of contact-stabilized: consistent | lumped
    double      hht_alpha      = -0.1;         ///< parameter of hht-alpha
    double      spectral_radius     = 0.8;     ///< parameter of generalized-alpha
    double      newmark_beta        = 0.5;     ///< parameters of khenous-laborde-renard
    double      newmark_gamma       = 0.5;
    double      reference_tolerance = 1e-8;     ///< parameter of reference
    std::string impulses            = "common"; ///< of laursen-love: common | per node
    bool        stop_sticking_nodes = true;     ///< of contact-stabilized(-projected): see doc/friction.md
    std::string start               = "given";  ///< given | equilibrium
    double      step_size           = 0.;       ///< tau > 0
    double      end_time            = 0.;       ///< T > 0; the number of steps is T/tau rounded to the nearest integer
    /** Whether the mass has no entries at contact nodes. */
    bool has_massless_contact_nodes() const;
    /** Number of steps, at least one. */
    unsigned int n_steps() const;
  };
} // namespace signorini

#endif
