// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_archive_h
#define signorini_base_archive_h

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/binary_object.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/set.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <iosfwd>
#include <optional>
#include <type_traits>
#include <vector>

namespace signorini
{
  /**
   * Where objects leave what they remember, and find it again: both in one function, so that what
   * is written and what is read cannot differ. Bits come back as they were. For the program that
   * has written it: of another version, or of another kind of processor, nothing can be read.
   */
  class Archive
  {
  public:
    explicit Archive(std::ostream &out) { this->out.emplace(out); }
    explicit Archive(std::istream &in) { this->in.emplace(in); }

    bool reads() const { return in.has_value(); }

    /** Write the values, or read them. Plain structures go as they lie in memory. */
    template <typename... Values>
    void operator()(Values &...values)
    {
      (pass(values), ...);
    }

  private:
    std::optional<boost::archive::binary_oarchive> out;
    std::optional<boost::archive::binary_iarchive> in;

    template <typename Value>
    void pass(Value &value)
    {
      static_assert(!std::is_pointer_v<Value>, "What it points to will have gone.");
      if constexpr (std::is_trivially_copyable_v<Value>)
        {
          auto bytes = boost::serialization::make_binary_object(&value, sizeof(Value));
          if (out)
            *out &bytes;
          else
            *in &bytes;
        }
      else if (out)
        *out &value;
      else
        *in &value;
    }

    /** Boost would ask each element how it is written. */
    template <typename Value>
    void pass(std::vector<Value> &values)
    {
      std::size_t n = values.size();
      pass(n);
      values.resize(n);
      for (std::size_t i = 0; i < n; ++i)
        pass(values[i]);
    }
  };
} // namespace signorini

#endif
