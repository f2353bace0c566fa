// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_box_tree_h
#define signorini_obstacles_box_tree_h

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace signorini
{
  /** The box around the corners of something. */
  template <int dim, std::size_t n>
  dealii::BoundingBox<dim> box_around(const std::array<dealii::Point<dim>, n> &corners)
  {
    return dealii::BoundingBox<dim>(
      std::vector<dealii::Point<dim>>(corners.begin(), corners.end()));
  }


  /**
   * Things in boxes, to be searched by branch and bound: the nearest one to a point, or those near
   * to it. The R-tree of Boost has such a search only by the distance of boxes, one after the
   * other, and sorts all that it has seen for each: a run at 700 triangles took ten times as long.
   */
  template <int dim>
  class BoxTree
  {
  public:
    /** @param boxes of the things 0, 1, ... */
    explicit BoxTree(const std::vector<dealii::BoundingBox<dim>> &boxes);

    bool empty() const { return branches.empty(); }

    /**
     * The square of the least distance of a point to a thing, infinity if there is none.
     * @param square_distance of the point to a thing, called for those that may be the nearest
     */
    template <typename Distance>
    double least_square_distance(const dealii::Point<dim> &p, const Distance &square_distance) const
    {
      double least = std::numeric_limits<double>::infinity();
      if (!empty())
        descend(0, p, least, square_distance);
      return least;
    }

    /**
     * Call an action for the things whose boxes are not farther from a point than a distance, and
     * for some others near to them.
     */
    template <typename Action>
    void for_each_near(const dealii::Point<dim> &p, const double reach, const Action &action) const
    {
      double fixed = reach * reach;
      if (!empty())
        descend(0, p, fixed, [&](const unsigned int thing) {
          action(thing);
          return std::numeric_limits<double>::infinity();
        });
    }

  private:
    struct Branch
    {
      dealii::Point<dim> lower, upper;
      unsigned int       first, end; ///< things
      unsigned int       second;     ///< branch; the first one is the next; 0: a leaf
    };

    std::vector<Branch>       branches;
    std::vector<unsigned int> things;

    void
    grow(const std::vector<dealii::BoundingBox<dim>> &boxes, unsigned int first, unsigned int end);

    static double square_distance_to(const Branch &branch, const dealii::Point<dim> &p)
    {
      double square = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double out = std::max({0., branch.lower[c] - p[c], p[c] - branch.upper[c]});
          square += out * out;
        }
      return square;
    }

    template <typename Distance>
    void descend(const unsigned int        at,
                 const dealii::Point<dim> &p,
                 double                   &least,
                 const Distance           &square_distance) const
    {
      const Branch &branch = branches[at];
      if (branch.second == 0)
        {
          for (unsigned int k = branch.first; k < branch.end; ++k)
            least = std::min(least, square_distance(things[k]));
          return;
        }
      unsigned int near = at + 1, far = branch.second;
      double       to_near = square_distance_to(branches[near], p),
             to_far        = square_distance_to(branches[far], p);
      if (to_far < to_near)
        {
          std::swap(near, far);
          std::swap(to_near, to_far);
        }
      if (to_near <= least)
        descend(near, p, least, square_distance);
      if (to_far <= least)
        descend(far, p, least, square_distance);
    }
  };
} // namespace signorini

#endif
