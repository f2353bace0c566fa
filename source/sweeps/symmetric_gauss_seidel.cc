// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/flush_denormals.h>
#include <signorini/sweeps/symmetric_gauss_seidel.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini
{
  template <int dim, int block_size>
  SymmetricGaussSeidel<dim, block_size>::SymmetricGaussSeidel(const ElasticMatrices<dim> &matrices,
                                                              const MatrixSum            &sum)
    : SymmetricGaussSeidel(matrices, sum, SweepOrder::of<dim>(matrices.pattern))
  {
  }


  template <int dim, int block_size>
  SymmetricGaussSeidel<dim, block_size>::SymmetricGaussSeidel(const ElasticMatrices<dim> &matrices,
                                                              const MatrixSum            &sum,
                                                              SweepOrder                  order)
    : sweeps(matrices, sum, std::move(order))
    , solution(sweeps.p)
    , residual(sweeps.p)
  {
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::vmult(Vector &destination, const Vector &source) const
  {
    const FlushDenormals flush;
    scale = sweeps.set_direction(source);
    sweeps.clear_t();
    sweeps.sweep_forth(residual);
    std::swap(sweeps.p, sweeps.y);
    std::fill(sweeps.y.begin(), sweeps.y.end(), 0.f);
    sweeps.sweep_back();
    sweeps.read(destination, sweeps.t, scale);
  }


  template <int dim, int block_size>
  double SymmetricGaussSeidel<dim, block_size>::start(const Vector &right_hand_side) const
  {
    const FlushDenormals flush;
    scale = sweeps.set_direction(right_hand_side);
    sweeps.clear_t();
    const double square = sweeps.sweep_forth(residual)[2];
    residual            = sweeps.y;
    std::fill(sweeps.y.begin(), sweeps.y.end(), 0.f);
    return scale * std::sqrt(square);
  }


  template <int dim, int block_size>
  RoughSolver::Report
  SymmetricGaussSeidel<dim, block_size>::solve(Vector            &correction,
                                               const double       reduction,
                                               const unsigned int maximum_iterations) const
  {
    const FlushDenormals flush;
    Report               report;
    if (sweeps.any_slip())
      {
        report = gmres.solve(
          [this](std::vector<float> &p, std::vector<float> &q) {
            std::swap(sweeps.p, p);
            sweeps.sweep_back();
            sweeps.sweep_forth(sweeps.p);
            std::swap(sweeps.p, p);
            for (std::size_t i = 0; i < q.size(); ++i)
              {
                q[i]        = sweeps.t[i] + sweeps.y[i];
                sweeps.y[i] = 0.f;
              }
          },
          residual,
          solution,
          reduction,
          maximum_iterations,
          sweeps.communicator());
        std::swap(sweeps.p, solution);
        sweeps.sweep_back();
        std::swap(sweeps.t, solution);
      }
    else
      report = conjugate_gradients(reduction, maximum_iterations);
    sweeps.read(correction, solution, scale);
    return report;
  }


  template <int dim, int block_size>
  RoughSolver::Report SymmetricGaussSeidel<dim, block_size>::conjugate_gradients(
    const double       reduction,
    const unsigned int maximum_iterations) const
  {
    Report        report;
    LanczosMatrix lanczos;
    double        goal = -1.;
    sweeps.p           = residual;
    std::fill(solution.begin(), solution.end(), 0.f);
    while (report.iterations < maximum_iterations)
      {
        sweeps.sweep_back();
        const auto [pq, rq, qq, rr] = sweeps.sweep_forth(residual);
        ++report.iterations;
        if (goal < 0.)
          goal = reduction * reduction * rr;
        if (!(pq > 0.))
          {
            std::fill(sweeps.y.begin(), sweeps.y.end(), 0.f);
            break; // round-off: the caller judges what there is
          }
        const double step       = rr / pq;
        const double new_square = std::max(0., rr - 2. * step * rq + step * step * qq);
        const double kept       = new_square / rr;
        advance(static_cast<float>(step), static_cast<float>(kept));
        lanczos.add(step, kept);
        report.reached = new_square <= goal;
        if (report.reached)
          break;
      }
    report.smallest_eigenvalue = lanczos.smallest_eigenvalue();
    return report;
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::advance(const float step, const float kept) const
  {
    float *__restrict x = solution.data(), *__restrict r = residual.data(),
                      *__restrict p = sweeps.p.data(), *__restrict y = sweeps.y.data();
    const float *__restrict t = sweeps.t.data();
    const std::size_t n       = solution.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        x[i] += step * t[i];
        r[i] -= step * (t[i] + y[i]);
        p[i] = r[i] + kept * p[i];
        y[i] = 0.f;
      }
  }


  template class SymmetricGaussSeidel<2, 1>;
  template class SymmetricGaussSeidel<2, 2>;
  template class SymmetricGaussSeidel<3, 1>;
  template class SymmetricGaussSeidel<3, 3>;
} // namespace signorini
