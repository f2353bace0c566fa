// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/schemes/backward_euler.h>
#include <signorini/schemes/contact_implicit_newmark.h>
#include <signorini/schemes/contact_stabilized_newmark.h>
#include <signorini/schemes/generalized_alpha.h>
#include <signorini/schemes/hager_hueeber_wohlmuth.h>
#include <signorini/schemes/khenous_laborde_renard.h>
#include <signorini/schemes/laursen_chawla.h>
#include <signorini/schemes/laursen_love.h>
#include <signorini/schemes/moreau_jean.h>
#include <signorini/schemes/newmark.h>
#include <signorini/schemes/nonsmooth_generalized_alpha.h>
#include <signorini/schemes/projected_contact_stabilized.h>
#include <signorini/schemes/reference_integration.h>

namespace signorini
{
  SolveReport DynamicalSystem::equilibrate_massless(Vector &, const Vector &, Vector &contact_force)
  {
    contact_force = make_vector(); // nothing is massless
    return SolveReport();
  }


  std::unique_ptr<TimeScheme> make_time_scheme(const std::string &name, const SchemeParameters &parameters)
  {
    if (name == "newmark")
      return std::make_unique<Newmark>();
    if (name == "laursen-chawla")
      return std::make_unique<LaursenChawla>();
    if (name == "laursen-love")
      return std::make_unique<LaursenLove>(parameters.impulses_per_node);
    if (name == "khenous-laborde-renard")
      return std::make_unique<KhenousLabordeRenard>(parameters.newmark_beta, parameters.newmark_gamma);
    if (name == "hager-hueeber-wohlmuth")
      return std::make_unique<HagerHueeberWohlmuth>();
    if (name == "contact-implicit")
      return std::make_unique<ContactImplicitNewmark>();
    if (name == "contact-stabilized")
      return std::make_unique<ContactStabilizedNewmark>(parameters.stop_sticking_nodes);
    if (name == "contact-stabilized-projected")
      return std::make_unique<ProjectedContactStabilized>(parameters.stop_sticking_nodes);
    if (name == "hht-alpha")
      return std::make_unique<GeneralizedAlpha>(GeneralizedAlpha::hht(parameters.hht_alpha));
    if (name == "generalized-alpha")
      return std::make_unique<GeneralizedAlpha>(AlphaRule::with_spectral_radius(parameters.spectral_radius));
    if (name == "nonsmooth-generalized-alpha")
      return std::make_unique<NonsmoothGeneralizedAlpha>(AlphaRule::with_spectral_radius(parameters.spectral_radius));
    if (name == "backward-euler")
      return std::make_unique<BackwardEuler>();
    if (name == "moreau-jean")
      return std::make_unique<MoreauJean>();
    if (name == "reference")
      return std::make_unique<ReferenceIntegration>(parameters.reference_tolerance);
    throw UserError(
      "Time/Scheme = " + name
      + " is not known. Choose newmark, laursen-chawla, laursen-love, khenous-laborde-renard, hager-hueeber-wohlmuth, "
        "contact-implicit, contact-stabilized, contact-stabilized-projected, hht-alpha, generalized-alpha, "
        "nonsmooth-generalized-alpha, backward-euler, moreau-jean or reference.");
  }
} // namespace signorini
