// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_unseen_overlap_h
#define signorini_diagnostics_unseen_overlap_h

#include <signorini/base/archive.h>
#include <signorini/contact/unseen_contact.h>
#include <signorini/time/state.h>

#include <string>

namespace signorini
{
  /**
   * Watches whether anything comes in between the nodes of a pair, where none of them bears
   * (UnseenContact): contact begins too late then, or never. Told once for each pair.
   */
  template <int dim>
  class UnseenOverlap
  {
  public:
    /** @param remedy of this scene: a clause in the imperative */
    UnseenOverlap(std::size_t n_pairs, const std::string &remedy);

    /** Whatever is asked for next is on another mesh. */
    void use_mesh(const Discretization<dim> &discretization, const ContactSurface<dim> &surface);

    /**
     * To be called after each step; most calls do nothing. Collective.
     * @param last whether it is the last step, which is always looked at
     * @return what has come in, a sentence each; the same on all processes
     */
    std::vector<std::string> judge(const State &state, bool last);

    /** What was told of, and when to look next. */
    void archive(Archive &archive) { archive(is_told, n_calls); }

  private:
    const std::string                 remedy;
    const Discretization<dim>        *discretization = nullptr;
    const ContactSurface<dim>        *surface        = nullptr;
    std::optional<UnseenContact<dim>> unseen; ///< made when it is first needed
    std::vector<char>                 is_told;
    unsigned int                      n_calls = 0;
  };
} // namespace signorini

#endif
