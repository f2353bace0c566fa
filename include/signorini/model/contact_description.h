// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_contact_description_h
#define signorini_model_contact_description_h

#include <signorini/base/enum_names.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <algorithm>
#include <string>
#include <vector>

namespace signorini
{
  /** Which configuration normals, gaps and partners belong to. */
  enum class ContactMotion
  {
    linearised, ///< to the initial one, once for all
    follow      ///< to the motion of each step
  };

  /** What the user of a scene with linearised contact has to do, as a clause of a message. */
  inline constexpr char set_motion_to_follow[] = "set `Contact/Motion = follow`";

  /** What the tangential stress can reach. */
  enum class FrictionKind
  {
    coulomb, ///< a part of the pressure
    tresca   ///< a given bound
  };

  template <>
  struct EnumNames<FrictionKind>
  {
    static constexpr EnumName<FrictionKind> table[] = {{FrictionKind::coulomb, "coulomb"},
                                                       {FrictionKind::tresca, "tresca"}};
  };

  /**
   * The law of friction of a pair, see FrictionLaw. Coefficient and bound are expressions in x, y,
   * z of the reference configuration.
   */
  struct FrictionDescription
  {
    FrictionKind law         = FrictionKind::coulomb;
    std::string  coefficient = "0"; ///< mu (coulomb)
    std::string  bound;             ///< largest tangential stress; empty: none (coulomb only)

    /**
     * Whether any node of the pair may bear tangential forces: false for coulomb with the
     * coefficient 0.
     */
    bool any = false;
  };

  /**
   * One entry of `Contact/Pairs`: `slave : obstacle` or `slave : master`, each body with boundary
   * ids in brackets or without.
   */
  struct PairDescription
  {
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    std::string  name;  ///< as written in the scene
    unsigned int slave; ///< index of a body
    std::vector<dealii::types::boundary_id>
                 slave_boundary_ids; ///< empty: the whole boundary of the body
    unsigned int obstacle = none;    ///< index of an obstacle, or
    unsigned int master   = none;    ///< index of a body
    std::vector<dealii::types::boundary_id>
                        master_boundary_ids; ///< empty: the whole boundary of the body
    FrictionDescription friction;

    bool of_two_bodies() const { return master != none; }
  };

  /** Whether contact nodes of any pair may bear tangential forces. */
  inline bool has_friction(const std::vector<PairDescription> &pairs)
  {
    return std::any_of(
      pairs.begin(), pairs.end(), [](const PairDescription &pair) { return pair.friction.any; });
  }

  /** Section `Probes/<name>`: history of the contact node that is closest to a point. */
  template <int dim>
  struct ProbeDescription
  {
    std::string        name;
    dealii::Point<dim> point; ///< in the reference configuration
  };
} // namespace signorini

#endif
