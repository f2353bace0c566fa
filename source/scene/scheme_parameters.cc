// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/prm/unused_keys.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  namespace
  {
    constexpr const char *automatic = "automatic";

    /** "Of a and b": the schemes for which a condition holds. */
    template <typename Condition>
    std::string names(const Condition &condition)
    {
      return join(schemes_where(condition), ", ");
    }

    std::string with_parameter(const std::string &key)
    {
      return names([&](const SchemeInfo &info) { return info.has_parameter(key); });
    }

    std::string with_predictor()
    {
      return names([](const SchemeInfo &info) { return info.predictor; });
    }

    std::string with_impulses()
    {
      return names([](const SchemeInfo &info) { return info.impulses; });
    }

    std::string with_massless_nodes()
    {
      return names(
        [](const SchemeInfo &info) { return info.massless == MasslessNodesAre::needed; });
    }


    void declare_mass(dealii::ParameterHandler &prm)
    {
      prm.declare_entry(
        "Mass",
        name_of(MassKind::consistent),
        choices_of<MassKind>(),
        "Mass matrix of the time discretisation: consistent (integrated exactly), lumped "
        "(diagonal), redistributed (contact nodes have none; it goes to the nodes behind them, and "
        "total mass, centre of gravity and inertia stay) or zero on contact boundary (contact "
        "nodes have none, and it is lost). These take the redistributed mass instead of the "
        "consistent one: "
          + with_massless_nodes() + ".");
      prm.declare_entry(
        "Mass redistribution",
        name_of(MassRedistribution::automatic),
        choices_of<MassRedistribution>(),
        "How the redistributed mass is built. extrapolation: contact nodes follow the nodes behind "
        "them; positive definite on every mesh. minimisation: smallest relative change of all "
        "entries. macro-elements: quadrature with points away from the contact boundary. "
        "automatic: macro-elements for "
          + names([](const SchemeInfo &info) { return info.macro_elements; })
          + ", else extrapolation.");
      prm.declare_entry("Predictor mass",
                        name_of(PredictorMass::consistent),
                        choices_of<PredictorMass>(),
                        "Mass matrix of the projection in the predictor of " + with_predictor()
                          + ". lumped is cheaper (node by node); with the consistent mass the "
                            "scheme then loses more energy and is no longer sure never to gain "
                            "any. No other scheme uses it.");
    }


    /** Refuse combinations of scheme and mass that make no sense, and settle what is automatic. */
    void check_mass(const SectionReader &in, TimeParameters &time)
    {
      const SchemeInfo &scheme = scheme_info(time.scheme);
      MassParameters   &mass   = time.mass;
      const bool        needed = scheme.massless == MasslessNodesAre::needed;
      if (!scheme.inertia && mass.kind == MassKind::lumped)
        in.fail("Mass",
                "has no effect with Scheme = " + time.scheme + scheme.why_refused
                  + ". Remove this key.");
      if (needed && mass.kind == MassKind::lumped)
        in.fail("Mass",
                "does not fit Scheme = " + time.scheme
                  + ", which needs contact nodes without mass. Remove this key, or set `Mass = "
                    "redistributed`.");
      if (needed && mass.kind == MassKind::consistent)
        mass.kind = MassKind::redistributed;
      if (mass.redistribution != MassRedistribution::automatic
          && mass.kind != MassKind::redistributed)
        in.fail("Mass redistribution",
                "says how the redistributed mass is built, but Mass = " + name_of(mass.kind)
                  + ". Remove this key or set `Mass = redistributed`.");
      if (mass.redistribution == MassRedistribution::automatic)
        mass.redistribution = scheme.macro_elements ? MassRedistribution::macro_elements
                                                    : MassRedistribution::extrapolation;
      if (mass.has_massless_contact_nodes() && scheme.massless == MasslessNodesAre::refused)
        in.fail("Mass",
                "makes no sense with Scheme = " + time.scheme + scheme.why_refused
                  + ". Set `Mass = consistent`, or take one of "
                  + names([](const SchemeInfo &info) {
                      return info.massless != MasslessNodesAre::refused;
                    })
                  + ".");
    }


    /** Refuse keys that only other schemes look at. */
    void check_unused_keys(const SectionReader &in, const TimeParameters &time)
    {
      const SchemeInfo &scheme = scheme_info(time.scheme);
      const auto        refuse = [&](const std::string &key, const std::string &users) {
        in.fail(key,
                "is only for " + users + ", but Scheme = " + time.scheme
                  + ". Remove this key, or take one of these schemes.");
      };
      if (time.mass.predictor != PredictorMass::consistent && !scheme.predictor)
        refuse("Predictor mass", with_predictor());
      if (time.mass.predictor == PredictorMass::lumped && scheme.projects_velocity
          && time.mass.kind != MassKind::lumped)
        in.fail("Predictor mass",
                "= lumped does not fit Scheme = " + time.scheme
                  + ", which changes the velocity by its projection: momentum would go to nodes "
                    "that are not in contact, and the contact force would not account for it. "
                    "Remove this key, set `Mass = lumped`, or take "
                  + names([](const SchemeInfo &info) {
                      return info.predictor && !info.projects_velocity;
                    })
                  + ".");
      if (!time.parameters.stop_sticking_nodes && !scheme.predictor)
        refuse("Stop sticking nodes", with_predictor());
      if (!time.parameters.impulses_per_node && !scheme.impulses)
        refuse("Impulses", with_impulses());
      dealii::ParameterHandler declared;
      declare_scheme_parameters(declared);
      for (const std::string key :
           {"HHT alpha", "Spectral radius", "Reference tolerance", "Newmark beta", "Newmark gamma"})
        if (!scheme.has_parameter(key))
          refuse_without_effect(in, key, declared, with_parameter(key), "Scheme");
    }


    void check_ranges(const SectionReader &in, const SchemeParameters &parameters)
    {
      const double beta = parameters.newmark_beta, gamma = parameters.newmark_gamma;
      if (!(parameters.hht_alpha >= -1. / 3. && parameters.hht_alpha <= 0.))
        in.fail("HHT alpha",
                "must lie between -1/3 and 0. Beyond, the method is not stable or not of second "
                "order.");
      const double rho = parameters.spectral_radius.value_or(1.);
      if (!(rho >= 0. && rho <= 1.))
        in.fail("Spectral radius", "must lie between 0 and 1. Above 1 the method is not stable.");
      if (!(parameters.reference_tolerance >= 1e-12 && parameters.reference_tolerance <= 1e-2))
        in.fail("Reference tolerance", "must lie between 1e-12 and 1e-2.");
      if (!(beta >= 0.25 && beta <= 1.))
        in.fail(
          "Newmark beta",
          "must lie between 0.25 and 1. Below, the method is not stable for every step size.");
      if (!(gamma >= 0.5 && gamma <= 2. * beta + 1e-12))
        in.fail("Newmark gamma",
                "must lie between 0.5 and twice `Newmark beta` = " + in.text("Newmark beta")
                  + ". Outside, the method is not stable for every step size.");
    }
  } // namespace


  void declare_scheme_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const auto declare =
      [&](const std::string &key, const std::string &value, const std::string &text) {
        prm.declare_entry(key, value, Double(), "Of " + with_parameter(key) + ": " + text);
      };
    declare("HHT alpha", "-0.1", "damping, between -1/3 (most) and 0 (none; no unit).");
    prm.declare_entry(
      "Spectral radius",
      automatic,
      Anything(),
      "Of " + with_parameter("Spectral radius")
        + ": the factor by which displacements that are much faster than a step change in each, "
          "between 0 (most damping) and 1 (none; no unit). automatic: 0.8 for "
        + names([](const SchemeInfo &info) {
            return info.has_parameter("Spectral radius") && !info.damping;
          })
        + "; for " + names([](const SchemeInfo &info) { return info.damps_unresolved; })
        + " 1 up to Courant number 40 of the smallest cells of the present mesh and 0.6 from 80 "
          "on, with the first step size; else 1.");
    declare("Reference tolerance",
            "1e-8",
            "accepted relative error per step of the integrator, between 1e-12 and 1e-2.");
    declare("Newmark beta",
            "0.5",
            "at least 1/4 (no unit). 1/2 is the value of the literature; with 1/4 the energy of "
            "free motion is conserved.");
    declare("Newmark gamma", "0.5", "between 1/2 (second order) and 2 Newmark beta (no unit).");
    declare_mass(prm);
    prm.declare_entry("Impulses",
                      name_of(ImpulseKind::per_node),
                      choices_of<ImpulseKind>(),
                      "How " + with_impulses()
                        + " shares the impulses that give lost energy back. per node: each contact "
                          "node gets back what it has lost, from coupled equations. common: along "
                          "the contact forces, from one equation; takes less time, but what one "
                          "contact loses is given to all of them, however far away. No other "
                          "scheme uses it.");
    prm.declare_entry("Stop sticking nodes",
                      "true",
                      Bool(),
                      "With friction, " + with_predictor()
                        + ": whether nodes that stick and stay in contact lose their tangential "
                          "velocity at the end of a step. Without that it alternates in sign from "
                          "step to step. No other scheme uses it.");
  }


  void parse_scheme_parameters(const SectionReader &in, TimeParameters &time)
  {
    SchemeParameters &parameters = time.parameters;
    parameters.hht_alpha         = in.number("HHT alpha");
    if (in.text("Spectral radius") != automatic
        && !dealii::Patterns::Double().match(in.text("Spectral radius")))
      in.fail("Spectral radius", "must be a number between 0 and 1, or `automatic`.");
    if (in.text("Spectral radius") != automatic)
      parameters.spectral_radius = in.number("Spectral radius");
    parameters.reference_tolerance = in.number("Reference tolerance");
    parameters.newmark_beta        = in.number("Newmark beta");
    parameters.newmark_gamma       = in.number("Newmark gamma");
    parameters.impulses_per_node   = in.choice<ImpulseKind>("Impulses") == ImpulseKind::per_node;
    parameters.stop_sticking_nodes = in.flag("Stop sticking nodes");
    time.mass.kind                 = in.choice<MassKind>("Mass");
    time.mass.redistribution       = in.choice<MassRedistribution>("Mass redistribution");
    time.mass.predictor            = in.choice<PredictorMass>("Predictor mass");
    check_ranges(in, parameters);
    check_mass(in, time);
    check_unused_keys(in, time);
  }
} // namespace signorini
