// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/time/time_scheme.h>

namespace signorini
{
  void check_capabilities(const TimeScheme &scheme, DynamicalSystem &system)
  {
    const Needs        needs   = scheme.needs();
    const Capabilities offered = system.capabilities();
    const auto         check   = [](const bool needed, const void *offer, const std::string &what) {
      if (needed && offer == nullptr)
        throw UserError("Time/Scheme needs " + what
                        + ", which the bodies of this scene do not offer. Take another scheme.");
    };
    check(needs.projections, offered.projections, "projections in the norm of the mass");
    check(needs.impulses, offered.impulses, "impulses at single contact nodes");
    check(needs.massless_nodes, offered.massless_nodes, "contact nodes without mass");
    check(needs.statics, offered.statics, "equilibria under loads");
  }
} // namespace signorini
