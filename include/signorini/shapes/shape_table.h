// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_shape_table_h
#define signorini_shapes_shape_table_h

#include <signorini/model/body_shape.h>
#include <signorini/prm/section_reader.h>

#include <memory>
#include <vector>

namespace signorini
{
  /** A shape that a scene can give to a body: `set Shape = <name>`. */
  template <int dim>
  struct BodyShapeKind
  {
    const char *name;
    const char *plural;  ///< bodies of this shape, for messages about keys of other shapes
    const char *summary; ///< what it is, with its boundary ids, for the list of all keys

    /** Declares its keys, but for those of caps. Shapes may share keys. */
    void (*declare)(dealii::ParameterHandler &prm);

    std::vector<std::string> keys; ///< all that it looks at

    /** @throws UserError for values that make no body */
    std::shared_ptr<const BodyShape<dim>> (*parse)(const SectionReader &in);
  };

  /** All shapes; the first one is the default. */
  template <int dim>
  const std::vector<BodyShapeKind<dim>> &body_shapes();

  /** One more, from a plug-in. @throws UserError if its name is taken */
  template <int dim>
  void add_body_shape(const BodyShapeKind<dim> &shape);
} // namespace signorini

#endif
