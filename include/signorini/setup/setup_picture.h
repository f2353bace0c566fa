// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_setup_setup_picture_h
#define signorini_setup_setup_picture_h

#include <signorini/discretization/discretization.h>
#include <signorini/output/obstacle_surfaces.h>
#include <signorini/setup/setup_face.h>
#include <signorini/setup/svg_drawing.h>

#include <string>
#include <vector>

namespace signorini
{
  /**
   * Picture of the set-up, `setup.svg`: bodies with their cells, coloured by what is to happen at
   * their faces, numbers of boundaries, names, and obstacles. In 3d from the front, right and
   * above, without perspective; obstacles lie behind everything. Process 0 gathers the faces of all
   * processes, at most largest_picture of them.
   */
  template <int dim>
  class SetupPicture
  {
  public:
    /** With more faces (in 2d: cells) there is no picture. */
    static constexpr unsigned int largest_picture = 40000;

    /** Collective. */
    SetupPicture(const Discretization<dim>          &discretization,
                 const std::vector<PairDescription> &pairs);

    /** Whether there is one; the same on all processes. */
    bool exists() const { return n_polygons <= largest_picture; }

    /**
     * On process 0: the picture.
     * @param box       what of space is to be seen
     * @param surfaces  of the obstacles, null if there are none
     * @param obstacles their names
     */
    std::string draw(const dealii::BoundingBox<dim> &box,
                     const ObstacleSurfaces<dim>    *surfaces,
                     const std::vector<std::string> &obstacles) const;

  private:
    /** A face, in 2d a piece of the boundary or a whole cell (which belongs to no boundary). */
    struct Polygon
    {
      std::vector<dealii::Point<dim>> points; ///< around it
      dealii::Tensor<1, dim>          normal; ///< to the outside
      SetupFace                       face;
      bool                            is_cell = false;

      template <typename Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &points &normal &face.body &face.boundary_id &face.contact_side;
        archive &face.is_supported &face.is_loaded &is_cell;
      }
    };

    std::vector<std::string> names; ///< of the bodies
    unsigned int             n_polygons = 0;
    std::vector<Polygon>     polygons; ///< of all processes, on process 0, the nearest last

    void draw_obstacles(const ObstacleSurfaces<dim> &surfaces, SvgDrawing &drawing) const;
    void name_obstacles(const ObstacleSurfaces<dim>    &surfaces,
                        const std::vector<std::string> &obstacles,
                        const dealii::BoundingBox<dim> &box,
                        SvgDrawing                     &drawing) const;
    void draw_bodies(SvgDrawing &drawing) const;
  };
} // namespace signorini

#endif
