// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_sweep_h
#define signorini_surfaces_sweep_h

#include <signorini/surfaces/surface_face.h>

#include <deal.II/numerics/rtree.h>

namespace signorini
{
  /**
   * Where the master may be that a slave face sees: the face, swept along its normal, by default
   * from a quarter of both bodies behind it to the far side of the master.
   */
  template <int dim>
  class Sweep
  {
  public:
    /** Of indices of boxes, which have to live as long. */
    using Tree = decltype(dealii::pack_rtree_of_indices(
      std::declval<const std::vector<dealii::BoundingBox<dim>> &>()));

    Sweep(const SurfaceFace<dim>         &face,
          const dealii::BoundingBox<dim> &slave_body,
          const dealii::BoundingBox<dim> &master_body);

    /** Between two distances: lengths, both positive. */
    Sweep(const SurfaceFace<dim> &face, double behind, double ahead);

    /** Around all of it. */
    dealii::BoundingBox<dim> box() const { return box(-behind, ahead); }

    /** How deep in the slave body the master still counts. */
    double depth() const { return behind; }

    /** False if all of a face is too far behind or in front. */
    bool reaches(const SurfaceFace<dim> &master) const;

    /** How far in front of the face the master still counts. */
    double height() const { return ahead; }

    /**
     * The boxes of a tree that it meets, and some that it misses by less than about the diameter of
     * the face; ascending.
     */
    void                     find(const Tree &tree, std::vector<std::size_t> &found) const;
    std::vector<std::size_t> meets(const Tree &tree) const
    {
      std::vector<std::size_t> found;
      find(tree, found);
      return found;
    }

  private:
    const dealii::Tensor<1, dim>   normal;
    const dealii::Point<dim>       centre;
    const dealii::BoundingBox<dim> box_of_face;
    const double                   diameter;
    double                         behind = 0., ahead = 0.;
    double                         obliquity; ///< how far aside it goes, per length
    double                         warp = 0.; ///< by which the face is not flat

    void measure(const SurfaceFace<dim> &face);

    dealii::BoundingBox<dim> box(double from, double to) const;

    /** The box around a long oblique sweep would meet nearly all: halve it until it is slender. */
    void search(const Tree &tree, double from, double to, std::vector<std::size_t> &found) const;
  };
} // namespace signorini

#endif
