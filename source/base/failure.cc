// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/failure.h>
#include <signorini/base/interruption.h>
#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>

#include <deal.II/base/exceptions.h>

#include <cctype>
#include <chrono>
#include <iostream>
#include <new>
#include <sstream>
#include <thread>

namespace signorini
{
  namespace
  {
    constexpr double patience_in_seconds = 3.;

    /** What a deal.II exception has to say, without location, violated condition and stack. */
    std::string useful_part(const dealii::ExceptionBase &exception)
    {
      std::ostringstream info;
      exception.print_info(info);
      const std::string text = trim(info.str());
      return text.empty() || text == "(none)" ? exception.get_exc_name() : text;
    }

    /**
     * A message quotes the input, which may be as long as it likes and contain what would move the
     * cursor of a terminal: its beginning says where the mistake is, its end what to do.
     */
    std::string printable(std::string message)
    {
      constexpr std::size_t longest = 2000;
      if (message.size() > longest)
        message =
          message.substr(0, longest / 2) + " [...] " + message.substr(message.size() - longest / 2);
      for (char &c : message)
        if (std::iscntrl(static_cast<unsigned char>(c)))
          c = ' ';
      return message;
    }

  } // namespace

  void report(const Failure &failure)
  {
    std::cerr << "signorini: " + printable(failure.message) + '\n' << std::flush;
  }

  Failure attempt(const std::function<void()> &action)
  {
    try
      {
        action();
        return {};
      }
    catch (const UserError &error)
      {
        return {2, error.what()};
      }
    catch (const Interrupted &interruption)
      {
        return {interruption.exit_status(), interruption.what()};
      }
    catch (const dealii::ExceptionBase &exception)
      {
        return {1, "the run failed: " + useful_part(exception)};
      }
    catch (const std::bad_alloc &)
      {
        return {1, "the run failed: out of memory. Use fewer refinements, or more processes."};
      }
    catch (const std::exception &exception)
      {
        return {1, std::string("the run failed: ") + exception.what()};
      }
    catch (...)
      {
        return {1, "the run failed for an unknown reason."};
      }
  }

  FailureReporter::FailureReporter(const MPI_Comm comm)
  {
    MPI_Comm_dup(comm, &this->comm);
  }

  FailureReporter::~FailureReporter()
  {
    MPI_Comm_free(&comm);
  }

  int FailureReporter::separately(const std::function<void()> &action) const
  {
    namespace Communication    = dealii::Utilities::MPI;
    const Failure      failure = attempt(action);
    const unsigned int rank    = Communication::this_mpi_process(comm);
    const unsigned int reporter =
      Communication::min(failure.status == 0 ? Communication::n_mpi_processes(comm) : rank, comm);
    if (rank == reporter)
      report(failure);
    return Communication::max(failure.status, comm);
  }

  bool FailureReporter::all_fail() const
  {
    MPI_Request request;
    MPI_Ibarrier(comm, &request);
    int          all_are_here = 0;
    const double start        = MPI_Wtime();
    while (!all_are_here && MPI_Wtime() - start < patience_in_seconds)
      {
        MPI_Test(&request, &all_are_here, MPI_STATUS_IGNORE);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    return all_are_here != 0;
  }


  int FailureReporter::together(const std::function<void()> &action) const
  {
    const Failure failure = attempt(action);
    if (failure.status == 0)
      return 0;
    const bool alike = all_fail();
    if (!alike || dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      report(failure);
    if (!alike)
      MPI_Abort(comm, failure.status);
    return failure.status;
  }
} // namespace signorini
