// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_step_table_h
#define signorini_output_step_table_h

#include <signorini/contact/contact_surface.h>
#include <signorini/diagnostics/body_motion.h>
#include <signorini/output/csv_table.h>
#include <signorini/time/time_scheme.h>

#include <functional>

namespace signorini
{
  /** What tables observe, on one mesh. */
  template <int dim>
  struct ObservedMesh
  {
    const Discretization<dim>            &discretization;
    const DirichletConditions<dim>       &dirichlet;
    const ContactSurface<dim>            &surface;
    const BodyMotion<dim>                &motion;
    std::function<const Vector *(double)> load; ///< at a time; null without loads
  };

  /**
   * A table beside history.csv, with a row for the same steps; it begins with the number of the
   * step and the time. All functions are collective.
   */
  template <int dim>
  class StepTable
  {
  public:
    virtual ~StepTable() = default;

    /** Before the first row, and when the mesh has changed. @param state on the new mesh */
    virtual void use_mesh(const ObservedMesh<dim> &mesh, const State &state) = 0;

    /** Add a row for a step that has ended. @param is_due see CsvTable */
    virtual void write(const State &state, const StepReport &report, bool is_due) = 0;

    /** What it writes. */
    virtual std::vector<CsvTable *> files() = 0;
  };

  /** Names of columns for a vector: quantity_x, quantity_y, quantity_z. */
  inline void add_vector_columns(const std::string &quantity, std::vector<std::string> &names)
  {
    for (const char axis : {'x', 'y', 'z'})
      names.push_back(quantity + "_" + axis);
  }

  inline void add_values(const std::array<double, 3> &vector, std::vector<double> &values)
  {
    values.insert(values.end(), vector.begin(), vector.end());
  }
} // namespace signorini

#endif
