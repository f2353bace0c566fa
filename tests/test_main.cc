// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/start_of_mpi.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

// Every test runs under MPI with one thread; a failure on any rank fails the test. A broken
// assertion is an exception, as in the program: deal.II asserts what a mesh file contains.
int main(int argc, char **argv)
{
  testing::InitGoogleTest(&argc, argv);
  signorini::make_mpi_start_quickly();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const int failed = RUN_ALL_TESTS();
  return dealii::Utilities::MPI::max(failed, MPI_COMM_WORLD);
}
