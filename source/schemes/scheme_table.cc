// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/table_of_kinds.h>
#include <signorini/base/user_error.h>
#include <signorini/schemes/backward_euler.h>
#include <signorini/schemes/contact_implicit_newmark.h>
#include <signorini/schemes/contact_stabilized_newmark.h>
#include <signorini/schemes/generalized_alpha.h>
#include <signorini/schemes/hager_hueeber_wohlmuth.h>
#include <signorini/schemes/khenous_laborde_renard.h>
#include <signorini/schemes/laursen_chawla.h>
#include <signorini/schemes/laursen_love.h>
#include <signorini/schemes/load_steps.h>
#include <signorini/schemes/moreau_jean.h>
#include <signorini/schemes/newmark.h>
#include <signorini/schemes/nonsmooth_generalized_alpha.h>
#include <signorini/schemes/projected_contact_stabilized.h>
#include <signorini/schemes/reference_integration.h>
#include <signorini/schemes/scheme_table.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    using Made = std::unique_ptr<TimeScheme>;

    /**
     * Most schemes: trapezoidal rule, one contact force against the elastic forces of the middle,
     * no friction.
     */
    SchemeInfo common(const std::string &name, const EnergyLaw energy, const std::string &summary)
    {
      SchemeInfo info{};
      info.name             = name;
      info.summary          = summary;
      info.energy           = energy;
      info.massless         = MasslessNodesAre::possible;
      info.balance          = StepBalance::middle;
      info.force_before_end = "0.5";
      info.changing_mesh    = true;
      info.moving_dirichlet = true;
      info.inertia          = true;
      info.moving_contact   = true;
      return info;
    }

    TrapezoidalRule trapezoidal_rule(const SchemeParameters &parameters)
    {
      return TrapezoidalRule(parameters.spectral_radius.value_or(1.));
    }

    template <typename Scheme>
    Made make_with_rule(const SchemeParameters &parameters)
    {
      return std::make_unique<Scheme>(trapezoidal_rule(parameters));
    }

    AlphaRule alpha_rule(const SchemeParameters &parameters)
    {
      return AlphaRule::with_spectral_radius(
        parameters.spectral_radius.value_or(AlphaRule::usual_radius));
    }

    /** The schemes of TrapezoidalRule. */
    SchemeInfo with_trapezoidal_rule(const std::string &name,
                                     const EnergyLaw    energy,
                                     const std::string &summary)
    {
      SchemeInfo info = common(name, energy, summary);
      info.damping = info.trapezoidal_rule = true;
      info.damps_unresolved                = energy == EnergyLaw::dissipates;
      info.keys                            = {"Spectral radius"};
      return info;
    }

    void refuse_massless_nodes(SchemeInfo &info, const std::string &why)
    {
      info.massless    = MasslessNodesAre::refused;
      info.why_refused = why;
    }

    /** Contact nodes without mass have no acceleration that could be carried to another mesh. */
    void need_massless_nodes(SchemeInfo &info)
    {
      info.massless      = MasslessNodesAre::needed;
      info.changing_mesh = false;
    }

    void refuse_moving_contact(SchemeInfo &info, const std::string &why)
    {
      info.moving_contact = false;
      info.why_linearised = why;
    }

    constexpr const char *needs_accelerations =
      ", which needs accelerations or velocities of contact nodes that follow from forces";
    constexpr const char *keeps_old_forces =
      "takes forces of the last step along, whose normals have turned since: they bring energy in "
      "proportion to the step size";
    constexpr const char *drifts =
      "lets nodes that slide along curved obstacles drift into them, deeper with every step, and "
      "asks how deep they are, where contact that follows takes any depth for touching";


    SchemeInfo contact_stabilized()
    {
      SchemeInfo info = with_trapezoidal_rule(
        "contact-stabilized",
        EnergyLaw::dissipates,
        "Newmark with a predictor that respects the contact condition; smooth contact forces");
      info.friction = info.predictor = true;
      refuse_massless_nodes(info,
                            ": its predictor stops the mass of contact nodes, and they have none");
      info.make = [](const SchemeParameters &parameters) -> Made {
        return std::make_unique<ContactStabilizedNewmark>(parameters.stop_sticking_nodes,
                                                          trapezoidal_rule(parameters));
      };
      return info;
    }


    SchemeInfo contact_stabilized_projected()
    {
      SchemeInfo info        = contact_stabilized();
      info.name              = "contact-stabilized-projected";
      info.projects_velocity = true;
      info.summary = "contact-stabilized whose projection acts on the velocity, too: nodes that "
                     "stay in contact have no normal velocity";
      info.make    = [](const SchemeParameters &parameters) -> Made {
        return std::make_unique<ProjectedContactStabilized>(parameters.stop_sticking_nodes,
                                                            trapezoidal_rule(parameters));
      };
      return info;
    }


    SchemeInfo contact_implicit()
    {
      SchemeInfo info =
        with_trapezoidal_rule("contact-implicit",
                              EnergyLaw::dissipates,
                              "Newmark without a predictor; contact forces oscillate");
      info.friction = true;
      info.make     = make_with_rule<ContactImplicitNewmark>;
      return info;
    }


    SchemeInfo laursen_chawla()
    {
      SchemeInfo info =
        with_trapezoidal_rule("laursen-chawla",
                              EnergyLaw::conserves,
                              "contact as a condition of persistency; allows penetration");
      info.friction = info.penetrates = true;
      info.make                       = make_with_rule<LaursenChawla>;
      return info;
    }


    SchemeInfo laursen_love()
    {
      SchemeInfo info = with_trapezoidal_rule(
        "laursen-love", EnergyLaw::conserves, "gives lost energy back by impulses; no penetration");
      info.friction = info.impulses = true;
      refuse_massless_nodes(
        info, ": impulses on contact nodes without mass have no effect that is finite");
      info.make = [](const SchemeParameters &parameters) -> Made {
        return std::make_unique<LaursenLove>(parameters.impulses_per_node,
                                             trapezoidal_rule(parameters));
      };
      return info;
    }


    SchemeInfo khenous_laborde_renard()
    {
      SchemeInfo info = common("khenous-laborde-renard",
                               EnergyLaw::none,
                               "contact nodes have no mass; smooth contact forces");
      need_massless_nodes(info);
      info.balance          = StepBalance::end;
      info.force_before_end = "0"; // in equilibrium at the end
      info.mean_velocity    = true;
      info.keys             = {"Newmark beta", "Newmark gamma"};
      info.make             = [](const SchemeParameters &parameters) -> Made {
        return std::make_unique<KhenousLabordeRenard>(parameters.newmark_beta,
                                                      parameters.newmark_gamma);
      };
      refuse_moving_contact(info, keeps_old_forces);
      return info;
    }


    SchemeInfo hager_hueeber_wohlmuth()
    {
      SchemeInfo info = with_trapezoidal_rule("hager-hueeber-wohlmuth",
                                              EnergyLaw::conserves,
                                              "laursen-chawla with contact nodes without mass");
      need_massless_nodes(info);
      info.friction = info.macro_elements = info.penetrates = true;
      info.make                                             = make_with_rule<HagerHueeberWohlmuth>;
      return info;
    }


    SchemeInfo newmark()
    {
      SchemeInfo info = with_trapezoidal_rule(
        "newmark", EnergyLaw::none, "the classical scheme with contact; gains energy at impact");
      info.friction         = true;
      info.balance          = StepBalance::both_ends;
      info.force_before_end = "0"; // forces of both ends act, each with its own elastic forces
      info.make             = make_with_rule<Newmark>;
      refuse_moving_contact(info, keeps_old_forces);
      return info;
    }


    SchemeInfo hht_alpha()
    {
      SchemeInfo info =
        common("hht-alpha", EnergyLaw::none, "numerical damping by `HHT alpha`; for comparison");
      refuse_massless_nodes(info, needs_accelerations);
      info.force_before_end = "-p"; // alpha_f
      info.parameter        = "HHT alpha";
      info.keys             = {info.parameter};
      info.make             = [](const SchemeParameters &parameters) -> Made {
        return std::make_unique<GeneralizedAlpha>(GeneralizedAlpha::hht(parameters.hht_alpha));
      };
      refuse_moving_contact(info, keeps_old_forces);
      return info;
    }


    SchemeInfo generalized_alpha()
    {
      SchemeInfo info = common("generalized-alpha",
                               EnergyLaw::none,
                               "numerical damping by `Spectral radius`; for comparison");
      refuse_massless_nodes(info, needs_accelerations);
      info.force_before_end = "p/(1+p)"; // alpha_f
      info.parameter        = "Spectral radius";
      info.keys             = {info.parameter};
      info.make             = [](const SchemeParameters &parameters) -> Made {
        return std::make_unique<GeneralizedAlpha>(alpha_rule(parameters));
      };
      refuse_moving_contact(info, keeps_old_forces);
      return info;
    }


    void see_contact_in_velocities(SchemeInfo &info)
    {
      refuse_massless_nodes(info, needs_accelerations);
      refuse_moving_contact(info, drifts);
      info.penetrates  = true;
      info.force_delay = 0.5;
    }


    SchemeInfo nonsmooth_generalized_alpha()
    {
      SchemeInfo info =
        common("nonsmooth-generalized-alpha",
               EnergyLaw::none,
               "generalized-alpha with contact as jumps of the velocity; for comparison");
      see_contact_in_velocities(info);
      info.keys = {"Spectral radius"};
      info.make = [](const SchemeParameters &parameters) -> Made {
        return std::make_unique<NonsmoothGeneralizedAlpha>(alpha_rule(parameters));
      };
      return info;
    }


    SchemeInfo backward_euler()
    {
      SchemeInfo info =
        common("backward-euler", EnergyLaw::dissipates, "damps all that moves; for comparison");
      info.friction = info.damping = true;
      info.balance                 = StepBalance::end;
      info.force_before_end        = "0";
      info.force_delay             = 1.;
      info.make                    = [](const SchemeParameters &) -> Made {
        return std::make_unique<BackwardEuler>();
      };
      return info;
    }


    SchemeInfo load_steps()
    {
      SchemeInfo info =
        common("static", EnergyLaw::none, "no inertia: load steps from equilibrium to equilibrium");
      info.friction         = true;
      info.balance          = StepBalance::end;
      info.force_before_end = "0";
      info.inertia          = false;
      info.make = [](const SchemeParameters &) -> Made { return std::make_unique<LoadSteps>(); };
      refuse_massless_nodes(info, ", which moves no mass");
      return info;
    }


    SchemeInfo moreau_jean()
    {
      SchemeInfo info =
        with_trapezoidal_rule("moreau-jean",
                              EnergyLaw::none,
                              "contact as a condition of velocities; penetrates; for comparison");
      see_contact_in_velocities(info);
      info.make = make_with_rule<MoreauJean>;
      return info;
    }


    SchemeInfo reference()
    {
      SchemeInfo info = common("reference",
                               EnergyLaw::none,
                               "the mass-redistributed problem integrated with error control; "
                               "slow, measures the error of others in time");
      need_massless_nodes(info);
      info.balance          = StepBalance::end;
      info.force_before_end = "0";
      info.mean_velocity    = true;
      info.own_tolerance    = "Reference tolerance";
      info.moving_dirichlet = false;
      info.keys             = {info.own_tolerance};
      info.make             = [](const SchemeParameters &parameters) -> Made {
        return std::make_unique<ReferenceIntegration>(parameters.reference_tolerance);
      };
      refuse_moving_contact(
        info,
        "measures errors of the integration in time, and normals of whole steps "
        "would add one of the step size to its own");
      return info;
    }

    std::vector<SchemeInfo> &table()
    {
      static std::vector<SchemeInfo> schemes = {contact_stabilized_projected(),
                                                contact_stabilized(),
                                                contact_implicit(),
                                                laursen_chawla(),
                                                laursen_love(),
                                                khenous_laborde_renard(),
                                                hager_hueeber_wohlmuth(),
                                                newmark(),
                                                hht_alpha(),
                                                generalized_alpha(),
                                                nonsmooth_generalized_alpha(),
                                                backward_euler(),
                                                moreau_jean(),
                                                reference(),
                                                load_steps()};
      return schemes;
    }
  } // namespace


  const std::vector<SchemeInfo> &scheme_table()
  {
    return table();
  }


  void add_scheme(const SchemeInfo &info)
  {
    add_kind(table(), info, "scheme");
  }


  const SchemeInfo &scheme_info(const std::string &name)
  {
    for (const SchemeInfo &info : scheme_table())
      if (info.name == name)
        return info;
    throw UserError("Time/Scheme = " + name + " is not known. " + suggestion(name, scheme_names()));
  }


  std::vector<std::string> scheme_names()
  {
    return schemes_where([](const SchemeInfo &) { return true; });
  }


  std::unique_ptr<TimeScheme> make_time_scheme(const std::string      &name,
                                               const SchemeParameters &parameters)
  {
    return scheme_info(name).make(parameters);
  }
} // namespace signorini
