// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_setup_setup_face_h
#define signorini_setup_setup_face_h

#include <signorini/model/body_description.h>
#include <signorini/model/contact_description.h>

namespace signorini
{
  /** What a scene means to do with a face of a body. */
  struct SetupFace
  {
    unsigned int               body        = 0; ///< its index
    dealii::types::boundary_id boundary_id = 0;
    /** 0: in no pair, 1: of a slave, 2: of a master; of both: a slave. */
    unsigned int contact_side = 0;
    bool         is_supported = false; ///< `Dirichlet` prescribes a displacement
    bool         is_loaded    = false; ///< there is a `Traction`
  };

  template <int dim>
  SetupFace setup_face(const std::vector<BodyDescription<dim>> &bodies,
                       const std::vector<PairDescription>      &pairs,
                       unsigned int                             body,
                       dealii::types::boundary_id               boundary_id);
} // namespace signorini

#endif
