// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_scheme_table_h
#define signorini_schemes_scheme_table_h

#include <signorini/base/enum_names.h>
#include <signorini/time/time_scheme.h>

#include <algorithm>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace signorini
{
  /** Parameters of single schemes. */
  struct SchemeParameters
  {
    double hht_alpha = -0.1; ///< hht-alpha: in [-1/3, 0]
    /** Of infinite frequencies, in [0, 1]; nothing: what the scheme thinks best. */
    std::optional<double> spectral_radius;
    double                newmark_beta  = 0.5; ///< khenous-laborde-renard: at least 1/4
    double                newmark_gamma = 0.5; ///< khenous-laborde-renard: in [1/2, 2 beta]
    double reference_tolerance = 1e-8; ///< reference: relative error per step of the integrator
    bool   impulses_per_node = true; ///< laursen-love: each contact node gets back what it has lost
    /** Schemes with a predictor: sticking nodes have no tangential velocity. */
    bool stop_sticking_nodes = true;
  };

  /** What contact does to the energy of a scheme, whatever the mesh and the step size. */
  enum class EnergyLaw
  {
    dissipates, ///< never adds any
    conserves,  ///< takes none and adds none
    none        ///< may add some
  };

  template <>
  struct EnumNames<EnergyLaw>
  {
    static constexpr EnumName<EnergyLaw> table[] = {{EnergyLaw::dissipates, "dissipates"},
                                                    {EnergyLaw::conserves, "conserves"},
                                                    {EnergyLaw::none, "none"}};
  };

  /** Contact nodes without mass: what a scheme makes of them. */
  enum class MasslessNodesAre
  {
    refused,
    possible,
    needed
  };

  template <>
  struct EnumNames<MasslessNodesAre>
  {
    static constexpr EnumName<MasslessNodesAre> table[] = {{MasslessNodesAre::refused, "refused"},
                                                           {MasslessNodesAre::possible, "possible"},
                                                           {MasslessNodesAre::needed, "needed"}};
  };

  /** All that is known about a scheme without running it. */
  struct SchemeInfo
  {
    std::string      name;    ///< in the scene
    std::string      summary; ///< one sentence
    EnergyLaw        energy;
    bool             friction;    ///< knows friction
    MasslessNodesAre massless;    ///< contact nodes without mass
    std::string      why_refused; ///< massless nodes: the reason, a clause after a colon or comma
    bool             predictor;   ///< projects a predictor: `Predictor mass`, `Stop sticking nodes`
    bool             projects_velocity; ///< by that projection, too
    bool             impulses;          ///< gives impulses back: `Impulses`
    bool macro_elements; ///< the redistributed mass is that of macro-elements unless another one is
                         ///< asked for
    StepBalance balance;
    /**
     * How far before the end of a step the contact force belongs, as a part of the step: an
     * expression in p, the value of the key `parameter` of section Time. The force of a step acts
     * against the elastic forces of an instant, and it is that instant's: at its own instant its
     * error has order 1.3 to 1.8 on parameters/verification/manufactured_bar.prm (the kinks where
     * contact begins and ends limit it), at others order 1.
     */
    std::string force_before_end;
    /**
     * By which part of a step forces come too late, at their own instant: what the first order of
     * the scheme does to them. (That of the damping of TrapezoidalRule comes on top of it.)
     */
    double                   force_delay;
    std::string              parameter;
    std::vector<std::string> keys; ///< of section Time with numbers that only such schemes look at
    bool trapezoidal_rule;         ///< steps of TrapezoidalRule, `Spectral radius` is its damping
    /** Damps what the step cannot resolve unless a spectral radius is given: TrapezoidalRule. */
    bool        damps_unresolved;
    bool        damping;       ///< knows viscous damping of bodies
    bool        penetrates;    ///< nodes may end a step inside of what they touch, at any step size
    bool        mean_velocity; ///< velocities of contact nodes are means over the step
    bool        changing_mesh; ///< the mesh may change between steps
    bool        moving_dirichlet; ///< prescribed displacements may change in time
    bool        moving_contact;   ///< contact may follow the motion
    std::string why_linearised;   ///< it may not: the reason, a clause whose subject is the scheme
    bool        inertia;          ///< moves masses; else velocities, damping and waves mean nothing
    std::string own_tolerance; ///< the key with which a scheme controls its own error; then steps
                               ///< have equal sizes
    std::unique_ptr<TimeScheme> (*make)(const SchemeParameters &parameters);

    bool variable_step() const { return own_tolerance.empty() && inertia; }
    bool has_parameter(const std::string &key) const
    {
      return std::find(keys.begin(), keys.end(), key) != keys.end();
    }
  };

  /**
   * Whether one contact force, that of the step, changes the momentum of a step (for
   * StepBalance::both_ends, the mean with that of the step before); other schemes mix forces,
   * accelerations or impulses of several instants.
   */
  bool balances_momentum_by_one_force(const SchemeInfo &info);

  /** SchemeInfo::force_before_end as a number. */
  double force_before_end(const SchemeInfo &info, const SchemeParameters &parameters);

  /**
   * Every scheme there is, in the order of documents, then those of plug-ins; the first one is the
   * default. The one place where names of schemes are written.
   */
  const std::vector<SchemeInfo> &scheme_table();

  /** One more, from a plug-in. @throws UserError if its name is taken */
  void add_scheme(const SchemeInfo &info);

  /** The entry of a name. @throws UserError if there is none */
  const SchemeInfo &scheme_info(const std::string &name);

  /** The names of the schemes for which a condition holds. */
  template <typename Condition>
  std::vector<std::string> schemes_where(const Condition &condition)
  {
    std::vector<std::string> names;
    for (const SchemeInfo &info : scheme_table())
      if (condition(info))
        names.push_back(info.name);
    return names;
  }

  /** The names of all schemes. */
  std::vector<std::string> scheme_names();

  /** The scheme of a name. @throws UserError if there is none */
  std::unique_ptr<TimeScheme> make_time_scheme(const std::string      &name,
                                               const SchemeParameters &parameters = {});

  /** The table for people (a table of Markdown), and for programs (JSON). */
  void print_schemes(std::ostream &out);
  void print_schemes_as_json(std::ostream &out);
} // namespace signorini

#endif
