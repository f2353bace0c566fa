// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include "parts.h"

#include <signorini/shapes/place.h>
#include <signorini/shapes/round_shapes.h>
#include <signorini/shapes/shape_table.h>

#include <deal.II/base/parameter_handler.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>

namespace
{
  using namespace signorini;

  /** A disc, in 3d a ball, with a hole in its middle. Boundary ids: 0, `inner`, and 1, `outer`. */
  template <int dim>
  class Ring : public BodyShape<dim>
  {
  public:
    Ring(const dealii::Point<dim> &centre, const double inner, const double outer)
      : centre(centre)
      , inner(inner)
      , outer(outer)
    {
    }

    dealii::Point<dim>                      midpoint() const override { return centre; }
    std::vector<dealii::types::boundary_id> boundary_ids() const override { return {0, 1}; }
    BoundaryNames boundary_names() const override { return {{"inner", {0}}, {"outer", {1}}}; }

    std::vector<dealii::Point<dim>>
    boundary_points(const dealii::types::boundary_id id) const override
    {
      return poles(centre, id == 0 ? inner : outer, dealii::numbers::invalid_unsigned_int);
    }

    void make_coarse_mesh(const Placement<dim>       &placement,
                          dealii::Triangulation<dim> &mesh) const override
    {
      dealii::GridGenerator::hyper_shell(
        mesh, centre, inner, outer, static_cast<unsigned int>(n_coarse_cells()), true);
      place(placement, mesh);
      mesh.set_manifold(0, dealii::SphericalManifold<dim>(placement.place(centre)));
    }

    /** In 2d one layer of cells that are nearly squares. */
    double n_coarse_cells() const override
    {
      return dim == 2 ? std::ceil(dealii::numbers::PI * (outer + inner) / (outer - inner)) : 6.;
    }

    bool is_round() const override { return true; }

  private:
    const dealii::Point<dim> centre;
    const double             inner, outer;
  };


  /** The keys of balls are declared. */
  void declare(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Hole radius",
                      "0.5",
                      dealii::Patterns::Double(),
                      "Ring: radius of its hole (length), > 0 and smaller than `Radius`.");
  }


  template <int dim>
  std::shared_ptr<const BodyShape<dim>> parse(const SectionReader &in)
  {
    const double outer = parse_radius(in),
                 inner = in.positive_number("Hole radius", "it is a length");
    if (inner >= outer)
      in.fail("Hole radius", "must be smaller than `Radius`. Make the hole smaller.");
    return std::make_shared<Ring<dim>>(in.point<dim>("Centre"), inner, outer);
  }


  template <int dim>
  void add()
  {
    add_body_shape<dim>({"ring",
                         "rings",
                         "ring (in 3d: a hollow ball; boundary ids 0 inner, 1 outer)",
                         declare,
                         {"Centre", "Radius", "Hole radius"},
                         parse<dim>});
  }
} // namespace


void add_ring()
{
  add<2>();
  add<3>();
}
