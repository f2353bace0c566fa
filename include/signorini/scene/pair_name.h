// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_pair_name_h
#define signorini_scene_pair_name_h

#include <string>
#include <vector>

namespace signorini
{
  class SectionReader;

  /**
   * `slave : partner`, taken apart; both may have boundary ids, or names of groups in their mesh
   * files: `slave[2,face] : partner[top]`.
   */
  struct PairName
  {
    std::string              slave;
    std::vector<std::string> ids; ///< empty: the whole boundary
    std::string              partner;
    std::vector<std::string> partner_ids; ///< of a body; empty: the whole boundary

    /** The normal form, `ball[2,3] : box[0]`. */
    std::string text() const;
  };

  /** Whether two pairs describe contact of the same surfaces, perhaps the other way round. */
  bool overlap(const PairName &first, const PairName &second);

  /** A name with the white space of the normal form; it need not be a correct name. */
  std::string with_normal_blanks(const std::string &name);

  /**
   * The list `Contact/Pairs`; @p in is the section Contact.
   * @throws UserError for what is not a pair, for unknown names, and for contact of a body with
   * itself.
   */
  std::vector<PairName> parse_pair_names(const SectionReader            &in,
                                         const std::string              &list,
                                         const std::vector<std::string> &bodies,
                                         const std::vector<std::string> &obstacles);
} // namespace signorini

#endif
