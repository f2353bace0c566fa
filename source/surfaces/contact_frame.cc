// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/contact_frame.h>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::array<double, dim * dim> frame_of(const Tensor<1, dim> &normal,
                                           const Tensor<1, dim> &tangent)
    {
      std::array<double, dim * dim> frame;
      for (unsigned int c = 0; c < dim; ++c)
        {
          frame[c]       = normal[c];
          frame[dim + c] = tangent[c];
        }
      if constexpr (dim == 3)
        {
          const Tensor<1, dim> second = cross_product_3d(normal, tangent);
          for (unsigned int c = 0; c < dim; ++c)
            frame[2 * dim + c] = second[c];
        }
      return frame;
    }


    template <int dim>
    Tensor<1, dim> axis(const unsigned int direction)
    {
      Tensor<1, dim> result;
      result[direction] = 1.;
      return result;
    }
  } // namespace


  template <int dim>
  std::array<double, dim * dim> contact_frame(const Tensor<1, dim> &normal)
  {
    if constexpr (dim == 2)
      return frame_of<dim>(normal, Tensor<1, dim>({-normal[1], normal[0]}));
    else
      {
        // The axis that is closest to the tangential plane gives a well-defined first tangent.
        unsigned int flattest = 0;
        for (unsigned int c = 1; c < dim; ++c)
          if (std::abs(normal[c]) < std::abs(normal[flattest]))
            flattest = c;
        Tensor<1, dim> tangent = axis<dim>(flattest) - normal[flattest] * normal;
        return frame_of<dim>(normal, tangent / tangent.norm());
      }
  }


  template <int dim>
  bool contact_frame_with_dirichlet(const Tensor<1, dim>          &normal,
                                    const std::array<bool, dim>   &held,
                                    std::array<double, dim * dim> &frame)
  {
    unsigned int first_held = dim;
    for (unsigned int c = dim; c-- > 0;)
      if (held[c])
        {
          if (std::abs(normal[c]) > 1e-12)
            return false;
          first_held = c;
        }
    if (first_held < dim)
      frame = frame_of<dim>(normal, axis<dim>(first_held));
    return true;
  }


  template <int dim>
  std::array<double, dim * dim> orthonormal_frame(const std::array<double, dim * dim> &frame,
                                                  const std::array<bool, dim>         &held)
  {
    std::array<double, dim *dim>        result = frame;
    std::vector<const Tensor<1, dim> *> done;
    std::array<Tensor<1, dim>, dim>     rows;
    for (const bool wanted : {true, false})
      for (unsigned int k = 0; k < dim; ++k)
        if (held[k] == wanted)
          {
            for (unsigned int c = 0; c < dim; ++c)
              rows[k][c] = frame[dim * k + c];
            bool is_oblique = false;
            for (const Tensor<1, dim> *other : done)
              if (const double part = rows[k] * *other; std::abs(part) > 1e-14)
                {
                  rows[k] -= part * *other;
                  is_oblique = true;
                }
            if (is_oblique)
              rows[k] /= rows[k].norm();
            done.push_back(&rows[k]);
            for (unsigned int c = 0; c < dim; ++c)
              result[dim * k + c] = rows[k][c];
          }
    return result;
  }


  template <int dim>
  std::array<double, dim * dim> oblique_frame(const std::vector<Tensor<1, dim>> &normals)
  {
    std::array<double, dim *dim> frame = contact_frame(normals[0]);
    if (normals.size() > 1)
      {
        if constexpr (dim == 3)
          {
            const Tensor<1, dim> edge = cross_product_3d(normals[0], normals[1]);
            for (unsigned int c = 0; c < dim; ++c)
              frame[2 * dim + c] = edge[c] / edge.norm();
          }
        for (unsigned int k = 1; k < normals.size(); ++k)
          for (unsigned int c = 0; c < dim; ++c)
            frame[dim * k + c] = normals[k][c];
      }
    return frame;
  }


  template <int dim>
  std::array<double, dim * dim> dual_frame(const std::array<double, dim * dim> &frame)
  {
    Tensor<2, dim> rows;
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int c = 0; c < dim; ++c)
        rows[k][c] = frame[dim * k + c];
    rows = transpose(invert(rows));
    std::array<double, dim * dim> result;
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int c = 0; c < dim; ++c)
        result[dim * k + c] = rows[k][c];
    return result;
  }


  template <int dim>
  std::array<unsigned int, dim> rows_along_axes(const std::array<double, dim * dim> &frame)
  {
    std::array<unsigned int, dim> rows;
    rows.fill(dim);
    for (unsigned int row = 0; row < dim; ++row)
      for (unsigned int c = 0; c < dim; ++c)
        if (std::abs(frame[dim * row + c]) == 1.)
          rows[c] = row;
    return rows;
  }


  template std::array<double, 4>       contact_frame(const Tensor<1, 2> &);
  template bool                        contact_frame_with_dirichlet<2>(const Tensor<1, 2> &,
                                                const std::array<bool, 2> &,
                                                std::array<double, 4> &);
  template std::array<double, 4>       orthonormal_frame<2>(const std::array<double, 4> &,
                                                      const std::array<bool, 2> &);
  template std::array<double, 4>       oblique_frame(const std::vector<Tensor<1, 2>> &);
  template std::array<double, 4>       dual_frame<2>(const std::array<double, 4> &);
  template std::array<unsigned int, 2> rows_along_axes<2>(const std::array<double, 4> &);
  template std::array<double, 9>       contact_frame(const Tensor<1, 3> &);
  template bool                        contact_frame_with_dirichlet<3>(const Tensor<1, 3> &,
                                                const std::array<bool, 3> &,
                                                std::array<double, 9> &);
  template std::array<double, 9>       orthonormal_frame<3>(const std::array<double, 9> &,
                                                      const std::array<bool, 3> &);
  template std::array<double, 9>       oblique_frame(const std::vector<Tensor<1, 3>> &);
  template std::array<double, 9>       dual_frame<3>(const std::array<double, 9> &);
  template std::array<unsigned int, 3> rows_along_axes<3>(const std::array<double, 9> &);
} // namespace signorini
