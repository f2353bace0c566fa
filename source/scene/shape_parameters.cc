// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/mesh_files/mesh_file.h>
#include <signorini/model/body_shape.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/prm/unused_keys.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <tuple>

namespace signorini
{
  namespace
  {
    constexpr double smallest_radius = 1e-8; ///< of a ball or a cylinder

    // 12 refinements make 8^12 = 7e10 cells of one cell in 3d: a slip of the keyboard rather than
    // an intention.
    constexpr unsigned int max_refinements = 12;
    constexpr unsigned int max_repetitions = 1000000;

    template <int dim>
    std::string coordinates(const std::string &value)
    {
      return join(std::vector<std::string>(dim, value));
    }

    void declare_refinement(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      prm.declare_entry(
        "Refinements",
        "0",
        Integer(),
        "Uniform refinements of the coarse mesh; each halves the size of the cells. At most 12.");
      prm.declare_entry(
        "Local refinements",
        "0",
        Integer(),
        "Further refinements of the cells that `Refine where` selects. At most 12.");
      prm.declare_entry(
        "Refine where",
        "",
        Anything(),
        "Expression in x, y, z, the centre of a cell, and h, its size (its diameter over the root "
        "of the dimension, the edge of a cube): positive values select the cell for local "
        "refinement, for example 0.2 - z near the plane z = 0, or 3*h - sqrt(x^2 + y^2 + z^2) for "
        "cells that become smaller and smaller towards the origin.");
    }

    template <int dim>
    void parse_ball_or_cylinder(const SectionReader &in, BodyDescription<dim> &body)
    {
      body.centre = in.point<dim>("Centre");
      body.radius = in.positive_number("Radius", "it is a length");
      // The meshes of round bodies are made with an absolute tolerance of 1e-10.
      if (body.radius < smallest_radius)
        in.fail("Radius",
                "is smaller than 1e-8, for which no mesh can be made. Choose a larger unit of "
                "length, for the other quantities, too.");
      if (body.shape == BodyShape::ball)
        return;
      if (dim == 2)
        in.fail("Shape", "a cylinder exists in 3d only. In 2d use `ball` for a disc, or `box`.");
      body.length = in.positive_number("Length", "it is the distance between bottom and top");
      body.axis   = std::string("xyz").find(in.text("Axis"));
    }

    template <int dim>
    void parse_box(const SectionReader &in, BodyDescription<dim> &body)
    {
      const std::string directions                   = "xyz";
      std::tie(body.lower_corner, body.upper_corner) = in.corners<dim>();
      const dealii::Point<dim> repetitions           = in.point<dim>("Repetitions");
      for (unsigned int d = 0; d < dim; ++d)
        {
          if (repetitions[d] < 1 || repetitions[d] > max_repetitions)
            in.fail("Repetitions",
                    std::string("a box needs at least one cell in ") + directions[d]
                      + " direction and at most a million. Give positive integers.");
          body.repetitions[d] = static_cast<unsigned int>(repetitions[d]);
        }
    }

    template <int dim>
    void parse_file(const SectionReader &in, BodyDescription<dim> &body)
    {
      if (in.text("File").empty())
        in.fail("File", "a body with `Shape = file` needs a mesh. Give the name of a mesh file.");
      const double scale = in.positive_number("Scale", "it changes the unit of length");
      try
        {
          body.mesh_file = describe_mesh_file<dim>(in.path("File"), in.text("Part"), scale);
        }
      catch (const UnknownMeshPart &error)
        {
          in.fail("Part", error.what());
        }
      catch (const UserError &error)
        {
          in.fail("File", error.what());
        }
    }

    /** Refuse keys that only other shapes look at. */
    template <int dim>
    void check_unused_keys(const SectionReader &in, const BodyShape shape)
    {
      static const std::vector<std::pair<std::string, std::vector<BodyShape>>> owners = {
        {"Centre", {BodyShape::ball, BodyShape::cylinder}},
        {"Radius", {BodyShape::ball, BodyShape::cylinder}},
        {"Length", {BodyShape::cylinder}},
        {"Axis", {BodyShape::cylinder}},
        {"Lower corner", {BodyShape::box}},
        {"Upper corner", {BodyShape::box}},
        {"Repetitions", {BodyShape::box}},
        {"Part", {BodyShape::file}},
        {"Scale", {BodyShape::file}}};
      dealii::ParameterHandler declared;
      declare_shape<dim>(declared);
      for (const auto &[key, shapes] : owners)
        if (std::find(shapes.begin(), shapes.end(), shape) == shapes.end())
          refuse_without_effect(in,
                                key,
                                declared,
                                shapes.size() == 2             ? "balls and cylinders"
                                : shapes[0] == BodyShape::box  ? "boxes"
                                : shapes[0] == BodyShape::file ? "bodies from mesh files"
                                                               : "cylinders",
                                "Shape");
    }
  } // namespace

  template <int dim>
  void declare_shape(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const List point(Double(), dim, dim);
    prm.declare_entry(
      "Shape",
      name_of(BodyShape::ball),
      choices_of<BodyShape>(),
      "ball (in 2d: a disc; boundary id 0), box (boundary ids 0, 1: x-, x+; 2, 3: y-, y+; 4, 5: "
      "z-, z+), cylinder (3d; boundary ids 0 mantle, 1 bottom, 2 top), or file (a mesh; boundary "
      "ids of the file).");
    prm.declare_entry(
      "Centre", coordinates<dim>("0"), point, "Ball, cylinder: the centre (length).");
    prm.declare_entry("Radius", "1", Double(), "Ball, cylinder: the radius (length), > 0.");
    prm.declare_entry(
      "Length", "2", Double(), "Cylinder: distance between bottom and top (length), > 0.");
    prm.declare_entry("Axis", "z", Selection("x|y|z"), "Cylinder: direction of the axis.");
    prm.declare_entry(
      "Lower corner", coordinates<dim>("0"), point, "Box: smallest coordinates (length).");
    prm.declare_entry(
      "Upper corner", coordinates<dim>("1"), point, "Box: largest coordinates (length).");
    prm.declare_entry(
      "Repetitions",
      coordinates<dim>("1"),
      List(Integer(), dim, dim),
      "Box: number of coarse cells in each direction, at most a million together. Cells should be "
      "nearly cubes. Every process keeps all coarse cells: make fine meshes by Refinements.");
    prm.declare_entry(
      "File",
      "",
      Anything(),
      "File: a mesh, absolute or relative to the folder of the scene. Gmsh (.msh, version 2.2 or "
      "4.1; boundary ids: numbers of the physical groups), Abaqus (.inp; boundary ids: numbers in "
      "the names of the surfaces, such as SS3 or Surf-3, or else numbers that are free), UCD "
      "(.inp, "
      ".ucd), VTK (.vtk, legacy up to 4.2), and what meshio converts: VTU (.vtu), Exodus (.e, "
      ".exo), "
      "MED (.med), Nastran (.bdf), Medit (.mesh), XDMF. Faces in no group or surface have boundary "
      "id 0. Names of groups and surfaces can stand wherever boundary ids can. Each triangle is "
      "split into 3 quadrilaterals, each tetrahedron into 4 hexahedra. Second-order cells lose the "
      "nodes in the middle of edges, unless they are split; then these nodes are vertices. At most "
      "a million cells after that, which every process keeps.");
    prm.declare_entry(
      "Part",
      "",
      Anything(),
      "File: name or number of the cells that are this body, or several with commas between: "
      "physical groups of Gmsh, element sets of Abaqus. Empty: all cells of the file.");
    prm.declare_entry(
      "Scale",
      "1",
      Double(),
      "File: all coordinates of the file are multiplied by this number > 0, first of "
      "all: 0.001 for a mesh in millimetres and a scene in metres.");
    declare_cap<dim>(prm);
    declare_placement<dim>(prm);
    declare_refinement(prm);
  }

  template <int dim>
  void parse_shape(const SectionReader &in, BodyDescription<dim> &body)
  {
    body.shape = in.choice<BodyShape>("Shape");
    body.repetitions.fill(1);
    if (body.shape != BodyShape::file && !in.text("File").empty())
      in.fail("File",
              "this body has `Shape = " + name_of(body.shape)
                + "` and needs no mesh. Set `Shape = file`, or remove this key.");
    if (body.shape == BodyShape::file)
      parse_file(in, body);
    else if (body.shape == BodyShape::box)
      parse_box(in, body);
    else
      parse_ball_or_cylinder(in, body);
    check_unused_keys<dim>(in, body.shape);
    parse_cap(in, body);
    body.placement = parse_placement(in, body);

    body.refinements       = in.integer("Refinements", 0, max_refinements);
    body.local_refinements = in.integer("Local refinements", 0, max_refinements);
    body.refine_where      = in.text("Refine where");
    if (body.local_refinements > 0 && body.refine_where.empty())
      in.fail("Local refinements",
              "`Refine where` does not say which cells to refine. Give it an expression such as "
              "0.2 - z, or use `Refinements`.");
    if (!body.refine_where.empty())
      check_expression<dim>(in, "Refine where", body.refine_where, {centre_of(body)}, "h");
    if (!body.refine_where.empty() && !in.given("Local refinements"))
      in.fail("Refine where",
              "selects cells, but `Local refinements` does not say how often to refine them. Give "
              "it a number, or remove this key.");
  }

  template void declare_shape<2>(dealii::ParameterHandler &);
  template void declare_shape<3>(dealii::ParameterHandler &);
  template void parse_shape(const SectionReader &, BodyDescription<2> &);
  template void parse_shape(const SectionReader &, BodyDescription<3> &);
} // namespace signorini
