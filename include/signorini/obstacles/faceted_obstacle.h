// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_faceted_obstacle_h
#define signorini_obstacles_faceted_obstacle_h

#include <signorini/obstacles/faceted_surface.h>
#include <signorini/obstacles/rigid_obstacle.h>

#include <memory>
#include <set>

namespace signorini
{
  /**
   * What is inside of a surface of facets, or one side of that surface. Above a facet the gap is
   * the height above its plane; beside edges and corners it is the distance to them, with the sign
   * of their pseudonormal (Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005)
   * 243-253). A surface that is not closed is as thick as need be, and ends like a plane with an
   * extent. A side ends at its creases, but it goes on straight past inner corners: there it holds
   * points together with the side that it meets.
   */
  template <int dim>
  class FacetedObstacle : public RigidObstacle<dim>
  {
  public:
    using Surface = FacetedSurface<dim>;

    /** @param side of the surface; FacetedSurface::none: all of it */
    FacetedObstacle(std::shared_ptr<const Surface> surface, unsigned int side = Surface::none);
    ~FacetedObstacle();

    ObstacleProjection<dim> project(const dealii::Point<dim> &p) const override;

    bool has_end() const override { return side != Surface::none || surface->has_rim(); }

  protected:
    const std::shared_ptr<const Surface> surface;

    /** The side of the facet that is closest to a point. */
    unsigned int side_at(const dealii::Point<dim> &p) const;
    /** The sides of the facets whose boxes are not farther from a point than a distance. */
    std::set<unsigned int> sides_around(const dealii::Point<dim> &p, double reach) const;

  private:
    struct Trees;
    struct Foot;
    struct Star;

    const unsigned int           side;
    std::unique_ptr<const Trees> trees; ///< of the facets, and of the rim

    bool belongs(const unsigned int facet) const
    {
      return facet != Surface::none
             && (side == Surface::none || surface->facets()[facet].side == side);
    }
    Foot   find_foot(const dealii::Point<dim> &p) const;
    Star   star_of(const Foot &foot) const;
    void   look_at_ridge(unsigned int facet, unsigned int ridge, Star &star) const;
    double distance_to_rim(const dealii::Point<dim> &p) const;
  };
} // namespace signorini

#endif
