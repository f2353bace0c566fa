// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_time_parameters_h
#define signorini_scene_time_parameters_h

#include <signorini/model/mass_parameters.h>
#include <signorini/schemes/scheme_table.h>

#include <string>

namespace signorini
{
  /** How lost energy is given back, by schemes that do so. */
  enum class ImpulseKind
  {
    common,  ///< along the contact forces
    per_node ///< each contact node gets back what it has lost
  };

  template <>
  struct EnumNames<ImpulseKind>
  {
    static constexpr EnumName<ImpulseKind> table[] = {{ImpulseKind::common, "common"},
                                                      {ImpulseKind::per_node, "per node"}};
  };

  /** What the displacement is at time 0. */
  enum class StartKind
  {
    given,
    equilibrium ///< static, under the loads and the contact of that time
  };

  template <>
  struct EnumNames<StartKind>
  {
    static constexpr EnumName<StartKind> table[] = {{StartKind::given, "given"},
                                                    {StartKind::equilibrium, "equilibrium"}};
  };

  /** Section `Time`: which scheme, which mass matrix, which steps. */
  struct TimeParameters
  {
    std::string      scheme = scheme_table().front().name;
    SchemeParameters parameters; ///< of single schemes
    MassParameters   mass;
    StartKind        start           = StartKind::given;
    double           step_size       = 0.;    ///< tau > 0
    double           end_time        = 0.;    ///< T > 0
    bool             stop_on_warning = false; ///< end the run when its result begins to be doubtful

    /** T/tau rounded to the nearest integer, at least one. */
    unsigned int n_steps() const;
  };
} // namespace signorini

#endif
