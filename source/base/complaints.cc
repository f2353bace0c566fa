// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/complaints.h>
#include <signorini/base/user_error.h>

#include <algorithm>
#include <sstream>

namespace signorini
{
  namespace
  {
    bool is_worse(const Complaint &a, const Complaint &b)
    {
      return a.first > b.first || (a.first == b.first && a.second < b.second);
    }
  } // namespace


  void throw_worst(const std::vector<Complaint> &complaints, const MPI_Comm communicator)
  {
    if (dealii::Utilities::MPI::max(complaints.empty() ? 0 : 1, communicator) == 0)
      return;
    std::vector<Complaint> own;
    if (!complaints.empty())
      own.push_back(*std::min_element(complaints.begin(), complaints.end(), is_worse));
    std::vector<Complaint> worst;
    for (const auto &of_process : dealii::Utilities::MPI::all_gather(communicator, own))
      worst.insert(worst.end(), of_process.begin(), of_process.end());
    throw UserError(std::min_element(worst.begin(), worst.end(), is_worse)->second);
  }


  void throw_if_any_is_no_number(const std::vector<std::string> &not_numbers,
                                 const double                    time,
                                 const MPI_Comm                  communicator)
  {
    if (dealii::Utilities::MPI::max(not_numbers.empty() ? 0 : 1, communicator) == 0)
      return;
    std::vector<std::string> all;
    for (const auto &of_process : dealii::Utilities::MPI::all_gather(communicator, not_numbers))
      all.insert(all.end(), of_process.begin(), of_process.end());
    std::ostringstream message;
    message << *std::min_element(all.begin(), all.end()) << " is not a finite number at the time "
            << time
            << ". Look for a division by zero, a root or a logarithm of what becomes negative, or "
               "let the run end before.";
    throw RunError(message.str());
  }
} // namespace signorini
