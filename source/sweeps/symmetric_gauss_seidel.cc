// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/interruption.h>
#include <signorini/linear_algebra/flush_denormals.h>
#include <signorini/sweeps/symmetric_gauss_seidel.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace signorini
{
  namespace
  {
    /** SymmetricGaussSeidel::advance() of numbers that follow each other. */
    void advance_entries(const std::size_t begin,
                         const std::size_t end,
                         const float       step,
                         const float       kept,
                         const float *__restrict t,
                         float *__restrict x,
                         float *__restrict r,
                         float *__restrict p,
                         float *__restrict y)
    {
      for (std::size_t i = begin; i < end; ++i)
        {
          x[i] += step * t[i];
          r[i] -= step * (t[i] + y[i]);
          p[i] = r[i] + kept * p[i];
          y[i] = 0.f;
        }
    }
  } // namespace


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
    sweeps.activate_all();
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
    sweeps.activate_all();
    sweeps.clear_t();
    squares.clear();
    for (const auto &sums : sweeps.sweep_forth(residual))
      squares.push_back(sums[2]);
    residual = sweeps.y;
    std::fill(sweeps.y.begin(), sweeps.y.end(), 0.f);
    const double square = std::accumulate(squares.begin(), squares.end(), 0.);
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
    Report                     report;
    std::vector<LanczosMatrix> lanczos(sweeps.n_parts());
    const auto   left = [&] { return std::accumulate(squares.begin(), squares.end(), 0.); };
    const double goal = reduction * reduction * left();
    sweeps.p          = residual;
    std::fill(solution.begin(), solution.end(), 0.f);
    while (!report.reached && report.iterations < maximum_iterations)
      {
        heed_interruption(sweeps.communicator());
        if (goal < left())
          leave_out(goal / sweeps.n_parts());
        sweeps.sweep_back();
        const auto &sums = sweeps.sweep_forth(residual);
        ++report.iterations;
        bool any_progress = false;
        for (unsigned int part = 0; part < sweeps.n_parts(); ++part)
          if (const auto &[pq, rq, qq, rr] = sums[part]; !sweeps.is_active(part))
            report.saved_iterations += sweeps.share(part);
          else if (!(pq > 0.))
            sweeps.deactivate(part); // round-off: the caller judges what there is
          else
            {
              const double step = rr / pq;
              squares[part]     = std::max(0., rr - 2. * step * rq + step * step * qq);
              const double kept = squares[part] / rr;
              advance(part, static_cast<float>(step), static_cast<float>(kept));
              lanczos[part].add(step, kept);
              any_progress = true;
            }
        report.reached = left() <= goal;
        if (!any_progress)
          break;
      }
    for (const LanczosMatrix &matrix : lanczos)
      report.smallest_eigenvalue =
        std::min(report.smallest_eigenvalue, matrix.smallest_eigenvalue());
    return report;
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::leave_out(const double accepted) const
  {
    for (unsigned int part = 0; part < sweeps.n_parts(); ++part)
      if (sweeps.is_active(part) && squares[part] <= accepted)
        sweeps.deactivate(part);
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::advance(const unsigned int part,
                                                      const float        step,
                                                      const float        kept) const
  {
    sweeps.for_each_range(part, [&](const std::size_t begin, const std::size_t end) {
      advance_entries(4 * begin,
                      4 * end,
                      step,
                      kept,
                      sweeps.t.data(),
                      solution.data(),
                      residual.data(),
                      sweeps.p.data(),
                      sweeps.y.data());
    });
  }


  template class SymmetricGaussSeidel<2, 1>;
  template class SymmetricGaussSeidel<2, 2>;
  template class SymmetricGaussSeidel<3, 1>;
  template class SymmetricGaussSeidel<3, 3>;
} // namespace signorini
