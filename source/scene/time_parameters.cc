// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    constexpr double max_steps = 1e8;
  }

  unsigned int TimeParameters::n_steps() const
  {
    return static_cast<unsigned int>(std::max(1., std::round(end_time / step_size)));
  }

  void declare_time(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry(
      "Scheme",
      "contact-stabilized",
      Selection("newmark|laursen-chawla|laursen-love|khenous-laborde-renard|hager-hueeber-wohlmuth|contact-implicit|"
                "contact-stabilized|contact-stabilized-projected|hht-alpha|generalized-alpha|"
                "nonsmooth-generalized-alpha|backward-euler|moreau-jean|reference"),
      "Time discretisation. contact-stabilized: Newmark with a predictor that respects the contact "
      "condition; dissipative, smooth contact forces. contact-stabilized-projected: the same, and the "
      "projection acts on the velocity, too; nodes that stay in contact have no normal velocity. contact-implicit: "
      "without a predictor; dissipative, contact forces oscillate. laursen-chawla: conserves energy, "
      "allows penetration. laursen-love: conserves energy by impulses, without penetration. "
      "khenous-laborde-renard: contact nodes have no mass; smooth contact forces. hager-hueeber-wohlmuth: "
      "laursen-chawla with contact nodes without mass. newmark: the "
      "classical scheme with contact; gains energy at impact. hht-alpha, generalized-alpha, "
      "nonsmooth-generalized-alpha, backward-euler, moreau-jean: widely used, for comparison. reference: the "
      "mass-redistributed problem integrated with error control; "
      "slow, to measure the error of others in time.");
    prm.declare_entry(
      "HHT alpha", "-0.1", Double(), "Damping of hht-alpha, between -1/3 (most) and 0 (none; no unit).");
    prm.declare_entry("Spectral radius",
                      "0.8",
                      Double(),
                      "Of generalized-alpha and nonsmooth-generalized-alpha at infinite frequency, between 0 (most "
                      "damping) and 1 (none; no unit).");
    prm.declare_entry("Reference tolerance",
                      "1e-8",
                      Double(),
                      "Of reference: accepted relative error per step of the integrator, between 1e-12 and 1e-2.");
    prm.declare_entry(
      "Mass",
      name_of(MassKind::consistent),
      choices_of<MassKind>(),
      "Mass matrix of the time discretisation: consistent (integrated exactly), lumped "
      "(diagonal), redistributed (contact nodes have none; it goes to the nodes behind them, and "
      "total "
      "mass, centre of gravity and inertia stay) or zero on contact boundary (contact nodes have "
      "none, "
      "and it is lost). khenous-laborde-renard, hager-hueeber-wohlmuth and reference take the "
      "redistributed mass "
      "instead of the consistent one.");
    prm.declare_entry(
      "Mass redistribution",
      name_of(MassRedistribution::automatic),
      choices_of<MassRedistribution>(),
      "How the redistributed mass is built. extrapolation: contact nodes follow the nodes behind "
      "them; "
      "positive definite on every mesh. minimisation: smallest relative change of all entries. "
      "macro-elements: quadrature with points away from the contact boundary. automatic: "
      "macro-elements "
      "for hager-hueeber-wohlmuth, else extrapolation.");
    prm.declare_entry(
      "Newmark beta",
      "0.5",
      Double(),
      "Of khenous-laborde-renard, at least 1/4 (no unit). 1/2 is the value of the literature; with 1/4 the "
      "energy of free motion is conserved.");
    prm.declare_entry("Newmark gamma",
                      "0.5",
                      Double(),
                      "Of khenous-laborde-renard, between 1/2 (second order) and 2 Newmark beta (no unit).");
    prm.declare_entry("Predictor mass",
                      name_of(PredictorMass::consistent),
                      choices_of<PredictorMass>(),
                      "Mass matrix of the projection in the predictor of contact-stabilized and "
                      "contact-stabilized-projected. lumped "
                      "is cheaper "
                      "(node by node); with the consistent mass the scheme then loses more energy "
                      "and is no longer sure "
                      "never to gain any. No other scheme uses it.");
    prm.declare_entry("Impulses",
                      name_of(ImpulseKind::common),
                      choices_of<ImpulseKind>(),
                      "How laursen-love shares the impulses that give lost energy back. common: "
                      "along the contact forces, "
                      "from one equation. per node: each contact node gets back what it has lost, "
                      "from coupled equations; "
                      "takes more time. No other scheme uses it.");
    prm.declare_entry(
      "Stop sticking nodes",
      "true",
      Bool(),
      "With friction, contact-stabilized and contact-stabilized-projected: whether nodes that stick and "
      "stay in contact lose their tangential velocity at the end of a step. Without that it alternates "
      "in sign from step to step. No other scheme uses it.");
    prm.declare_entry("Start",
                      name_of(StartKind::given),
                      choices_of<StartKind>(),
                      "How the run begins. given: with the initial displacement of the bodies. "
                      "equilibrium: with the static "
                      "equilibrium under the loads and the contact of time 0; rigid motions that "
                      "nothing holds stay "
                      "free. The initial velocity counts in both.");
    prm.declare_entry("Step size", "0", Double(), "Length of a time step, in units of time. Must be given.");
    prm.declare_entry(
      "End time",
      "0",
      Double(),
      "The run ends here, in units of time; with fixed steps after End time / Step size of them (rounded "
      "to the nearest integer). Must be given.");
    declare_step_sizes(prm);
  }

  namespace
  {
    /** Refuse combinations of scheme and mass that make no sense, and settle what is automatic. */
    void check_mass(const SectionReader &in, TimeParameters &time)
    {
      MassParameters &mass = time.mass;
      const bool made_for_massless = time.scheme == "khenous-laborde-renard" || time.scheme == "hager-hueeber-wohlmuth"
                                     || time.scheme == "reference";
      if (made_for_massless && mass.kind == MassKind::lumped)
        in.fail("Mass",
                "does not fit Scheme = " + time.scheme
                  + ", which needs contact nodes without mass. Remove this key, or set `Mass = redistributed`.");
      if (made_for_massless && mass.kind == MassKind::consistent)
        mass.kind = MassKind::redistributed;
      if (mass.redistribution != MassRedistribution::automatic
          && mass.kind != MassKind::redistributed)
        in.fail("Mass redistribution",
                "says how the redistributed mass is built, but Mass = " + name_of(mass.kind)
                  + ". Remove this key or set `Mass = redistributed`.");
      if (mass.redistribution == MassRedistribution::automatic)
        mass.redistribution = time.scheme == "hager-hueeber-wohlmuth"
                                ? MassRedistribution::macro_elements
                                : MassRedistribution::extrapolation;
      if (!mass.has_massless_contact_nodes())
        return;
      const std::string remedy = " Take contact-implicit, khenous-laborde-renard or hager-hueeber-wohlmuth, or "
                                 "`Mass = consistent`.";
      if (time.scheme == "contact-stabilized" || time.scheme == "contact-stabilized-projected")
        in.fail("Mass",
                "makes no sense with Scheme = " + time.scheme
                  + ": its predictor stops the mass of contact nodes, and they have none." + remedy);
      if (time.scheme == "laursen-love")
        in.fail("Mass",
                "makes no sense with Scheme = laursen-love: impulses on contact nodes without mass have no effect "
                "that is finite."
                  + remedy);
      if (time.scheme == "hht-alpha" || time.scheme == "generalized-alpha"
          || time.scheme == "nonsmooth-generalized-alpha" || time.scheme == "moreau-jean")
        in.fail("Mass",
                "makes no sense with Scheme = " + time.scheme
                  + ", which needs accelerations or velocities of contact nodes that follow from forces." + remedy);
    }


    void check_newmark(const SectionReader &in, const TimeParameters &time)
    {
      if (!(time.newmark_beta >= 0.25 && time.newmark_beta <= 1.))
        in.fail("Newmark beta", "must lie between 0.25 and 1. Below, the method is not stable for every step size.");
      if (!(time.newmark_gamma >= 0.5 && time.newmark_gamma <= 2. * time.newmark_beta + 1e-12))
        in.fail("Newmark gamma",
                "must lie between 0.5 and twice `Newmark beta` = " + in.text("Newmark beta")
                  + ". Outside, the method is not stable for every step size.");
    }
  } // namespace


  TimeParameters parse_time(const SectionReader &in)
  {
    TimeParameters time;
    time.scheme              = in.text("Scheme");
    time.mass.kind           = in.choice<MassKind>("Mass");
    time.mass.redistribution = in.choice<MassRedistribution>("Mass redistribution");
    time.mass.predictor      = in.choice<PredictorMass>("Predictor mass");
    time.reference_tolerance = in.number("Reference tolerance");
    if (!(time.reference_tolerance >= 1e-12 && time.reference_tolerance <= 1e-2))
      in.fail("Reference tolerance", "must lie between 1e-12 and 1e-2.");
    time.newmark_beta        = in.number("Newmark beta");
    time.newmark_gamma       = in.number("Newmark gamma");
    time.hht_alpha           = in.number("HHT alpha");
    time.spectral_radius     = in.number("Spectral radius");
    time.impulses            = in.choice<ImpulseKind>("Impulses");
    time.start               = in.choice<StartKind>("Start");
    time.stop_sticking_nodes = in.flag("Stop sticking nodes");
    if (!(time.hht_alpha >= -1. / 3. && time.hht_alpha <= 0.))
      in.fail("HHT alpha", "must lie between -1/3 and 0. Beyond, the method is not stable or not of second order.");
    if (!(time.spectral_radius >= 0. && time.spectral_radius <= 1.))
      in.fail("Spectral radius", "must lie between 0 and 1. Above 1 the method is not stable.");
    check_mass(in, time);
    check_newmark(in, time);
    for (const std::string key : {"Step size", "End time"})
      if (!in.given(key))
        in.fail(key, "is missing. Give a positive number, in units of time.");
    time.step_size = in.positive_number("Step size", "the run goes forward in time; give a number > 0");
    time.end_time  = in.positive_number("End time", "the run starts at time 0; give a number > 0");

    if (time.step_size > time.end_time)
      in.fail("Step size",
              "is larger than the end time " + in.text("End time") + ". Reduce the step size or increase `End time`.");
    if (time.end_time / time.step_size > max_steps)
      in.fail("Step size",
              "needs more than a hundred million steps until the end time " + in.text("End time")
                + ". Increase the step size or reduce `End time`.");
    if (time.mass.predictor != PredictorMass::consistent && time.scheme != "contact-stabilized"
        && time.scheme != "contact-stabilized-projected")
      in.fail("Predictor mass",
              "only contact-stabilized and contact-stabilized-projected have a predictor with a mass of its own, but "
              "Scheme = "
                + time.scheme + ". Remove this key or set `Scheme = contact-stabilized`.");
    if (!time.stop_sticking_nodes && time.scheme != "contact-stabilized"
        && time.scheme != "contact-stabilized-projected")
      in.fail("Stop sticking nodes",
              "only contact-stabilized and contact-stabilized-projected stop nodes that stick, but Scheme = "
                + time.scheme + ". Remove this key or set `Scheme = contact-stabilized`.");
    if (time.impulses != ImpulseKind::common && time.scheme != "laursen-love")
      in.fail("Impulses",
              "only the scheme laursen-love gives impulses, but Scheme = " + time.scheme
                + ". Remove this key or set `Scheme = laursen-love`.");
    return time;
  }
} // namespace signorini
