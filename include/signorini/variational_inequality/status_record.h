// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_status_record_h
#define signorini_variational_inequality_status_record_h

#include <signorini/base/contact_status.h>
#include <signorini/base/types.h>

#include <cstdint>
#include <set>

namespace signorini
{
  /**
   * Remembers the sets of statuses that an active set method went through, over all processes, to
   * notice when it runs in circles.
   */
  class StatusRecord
  {
  public:
    /**
     * @param like a vector of the problem: its communicator, and numbers of entries that tell
     *             processes apart
     */
    explicit StatusRecord(const Vector &like)
      : like(like)
    {
    }

    /** Add a set. @return false if it was there before. Collective. */
    bool is_new(const ActiveSet &status) { return seen.insert(fingerprint(status)).second; }

    void forget() { seen.clear(); }

    /** Closed nodes on all processes. Collective. */
    unsigned int n_closed(const ActiveSet &status) const;

  private:
    const Vector           &like;
    std::set<std::uint64_t> seen;

    /** A number that tells sets apart, the same on all processes. */
    std::uint64_t fingerprint(const ActiveSet &status) const;
  };
} // namespace signorini

#endif
