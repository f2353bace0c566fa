// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/prm/section_reader.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>

namespace signorini
{
  namespace
  {
    /** Numbers may match their pattern and still be too small or too large for the type. */
    template <typename Convert>
    auto converted(const SectionReader &in, const std::string &key, const Convert &convert)
    {
      try
        {
          return convert();
        }
      catch (const dealii::ExceptionBase &)
        {
          in.fail(key,
                  "is too small or too large for a number of the computer. Correct the exponent.");
        }
    }
  } // namespace

  SectionReader::SectionReader(const dealii::ParameterHandler &prm, const SceneText &text)
    : prm(&prm)
    , scene_text(&text)
  {
  }

  SectionReader SectionReader::section(const std::string &name) const
  {
    SectionReader inner = *this;
    inner.names.push_back(name);
    return inner;
  }

  bool SectionReader::given(const std::string &key) const
  {
    return scene_text->find(names, key) != nullptr;
  }

  bool SectionReader::given() const
  {
    return std::any_of(scene_text->statements.begin(),
                       scene_text->statements.end(),
                       [&](const Statement &statement) { return statement.section == names; });
  }

  bool SectionReader::overridden(const std::string &key) const
  {
    const Statement *statement = scene_text->find(names, key);
    return statement != nullptr && statement->is_override;
  }

  std::string SectionReader::text(const std::string &key) const
  {
    return prm->get(names, key);
  }

  std::string SectionReader::path(const std::string &key) const
  {
    const auto folder = std::filesystem::path(scene_text->file_name).parent_path();
    return (folder / text(key)).lexically_normal().string();
  }

  double SectionReader::number(const std::string &key) const
  {
    return converted(*this, key, [&] { return prm->get_double(names, key); });
  }

  bool SectionReader::flag(const std::string &key) const
  {
    return prm->get_bool(names, key);
  }

  double SectionReader::positive_number(const std::string &key, const std::string &meaning) const
  {
    const double value = number(key);
    if (!(value > 0.))
      fail(key, "must be positive: " + meaning + ".");
    return value;
  }

  unsigned int SectionReader::integer(const std::string &key,
                                      const unsigned int min,
                                      const unsigned int max) const
  {
    const long int value = converted(*this, key, [&] { return prm->get_integer(names, key); });
    if (value < static_cast<long int>(min) || value > static_cast<long int>(max))
      fail(key,
           "must be an integer between " + std::to_string(min) + " and " + std::to_string(max)
             + ".");
    return static_cast<unsigned int>(value);
  }

  template <int dim>
  dealii::Point<dim> SectionReader::point(const std::string &key) const
  {
    const auto coordinates = converted(
      *this, key, [&] { return dealii::Utilities::string_to_double(split(text(key), ',')); });
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = coordinates[d];
    return result;
  }

  template <int dim>
  std::pair<dealii::Point<dim>, dealii::Point<dim>> SectionReader::corners() const
  {
    const dealii::Point<dim> lower = point<dim>("Lower corner"), upper = point<dim>("Upper corner");
    for (unsigned int c = 0; c < dim; ++c)
      if (!(lower[c] < upper[c]))
        fail("Upper corner",
             std::string("its ") + "xyz"[c]
               + " coordinate must be larger than that of `Lower corner` = " + text("Lower corner")
               + ". Exchange or correct the corners.");
    return {lower, upper};
  }

  template <int dim>
  std::array<double, dim == 2 ? 1 : 3> SectionReader::angles(const std::string &key) const
  {
    if constexpr (dim == 2)
      return {{number(key)}};
    else
      {
        const dealii::Point<dim> degrees = point<dim>(key);
        return {{degrees[0], degrees[1], degrees[2]}};
      }
  }

  template <int dim>
  dealii::Tensor<1, dim> SectionReader::direction(const std::string &key) const
  {
    const dealii::Tensor<1, dim> vector = point<dim>(key);
    if (!(vector.norm() > 0.))
      fail(key, "a zero vector has no direction. Make at least one component different from zero.");
    return vector;
  }

  void SectionReader::fail(const std::string &key, const std::string &message) const
  {
    const Statement  *statement = scene_text->find(names, key);
    const std::string where = (statement == nullptr ? scene_text->file_name : statement->origin);
    std::vector<std::string> all_names = names;
    if (!key.empty())
      all_names.push_back(key);
    std::string what = join(all_names, "/");
    if (!key.empty() && statement != nullptr)
      what += " = " + statement->value;
    else if (!key.empty())
      what += " (not given)";
    throw UserError(where + ": " + what + ": " + message);
  }

  template dealii::Point<2> SectionReader::point<2>(const std::string &) const;
  template dealii::Point<3> SectionReader::point<3>(const std::string &) const;
  template std::pair<dealii::Point<2>, dealii::Point<2>> SectionReader::corners<2>() const;
  template std::pair<dealii::Point<3>, dealii::Point<3>> SectionReader::corners<3>() const;
  template std::array<double, 1> SectionReader::angles<2>(const std::string &) const;
  template std::array<double, 3> SectionReader::angles<3>(const std::string &) const;
  template dealii::Tensor<1, 2>  SectionReader::direction<2>(const std::string &) const;
  template dealii::Tensor<1, 3>  SectionReader::direction<3>(const std::string &) const;
} // namespace signorini
