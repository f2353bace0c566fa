// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_mass_parameters_h
#define signorini_model_mass_parameters_h

#include <signorini/base/enum_names.h>

namespace signorini
{
  /** Mass matrix of the time discretisation. */
  enum class MassKind
  {
    consistent,
    lumped,
    redistributed,           ///< contact nodes have none; it goes to the nodes behind them
    zero_on_contact_boundary ///< contact nodes have none, and it is lost
  };

  template <>
  struct EnumNames<MassKind>
  {
    static constexpr EnumName<MassKind> table[] = {
      {MassKind::consistent, "consistent"},
      {MassKind::lumped, "lumped"},
      {MassKind::redistributed, "redistributed"},
      {MassKind::zero_on_contact_boundary, "zero on contact boundary"}};
  };

  /** How a redistributed mass is built. */
  enum class MassRedistribution
  {
    automatic, ///< until the scheme is known
    extrapolation,
    minimisation,
    macro_elements
  };

  template <>
  struct EnumNames<MassRedistribution>
  {
    static constexpr EnumName<MassRedistribution> table[] = {
      {MassRedistribution::automatic, "automatic"},
      {MassRedistribution::extrapolation, "extrapolation"},
      {MassRedistribution::minimisation, "minimisation"},
      {MassRedistribution::macro_elements, "macro-elements"}};
  };

  /** Mass of the L2 projection in the predictor of contact-stabilized. */
  enum class PredictorMass
  {
    consistent,
    lumped
  };

  template <>
  struct EnumNames<PredictorMass>
  {
    static constexpr EnumName<PredictorMass> table[] = {{PredictorMass::consistent, "consistent"},
                                                        {PredictorMass::lumped, "lumped"}};
  };

  /** Keys of section `Time` about the mass matrix. */
  struct MassParameters
  {
    MassKind           kind           = MassKind::consistent;
    MassRedistribution redistribution = MassRedistribution::extrapolation;
    PredictorMass      predictor      = PredictorMass::consistent;

    /** Whether the mass has no entries at contact nodes. */
    bool has_massless_contact_nodes() const
    {
      return kind == MassKind::redistributed || kind == MassKind::zero_on_contact_boundary;
    }
  };
} // namespace signorini

#endif
