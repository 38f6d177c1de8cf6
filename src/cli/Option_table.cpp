// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Option_table.h"
#include "cli/text.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// The value of an option that is a number, as a double and as a text of some digits.
struct Number
{
  double value;
  std::string text;
  bool is_whole;
};

std::optional<Number> number_of(const Option& option)
{
  return std::visit(
      [](const auto& field) -> std::optional<Number> {
        using Value = Value_of<decltype(field)>;
        if constexpr (std::is_same_v<Value, double>)
          return Number{*field, short_number(*field), false};
        else if constexpr (is_number<Value>)
          return Number{double(*field), std::to_string(*field), true};
        else if constexpr (std::is_same_v<Value, std::optional<double>>)
          return *field ? std::optional(Number{**field, short_number(**field), false}) : std::nullopt;
        else
          return std::nullopt;
      },
      option.field);
}

} // namespace

Option& Option::in_python(const char* other_name)
{
  keyword = *other_name ? other_name : name;
  std::replace(keyword.begin(), keyword.end(), '-', '_');
  return *this;
}

std::string Option::text() const
{
  if (const std::optional<Number> number = number_of(*this)) return number->text;
  if (const auto* text = std::get_if<std::string*>(&field)) return **text;
  if (const auto* text = std::get_if<Text_field>(&field)) return text->get ? text->get() : "";
  return "";
}

bool Option::has_default() const { return shows_default && !is_required && !text().empty(); }

void Option::set_text(const std::string& label, const std::string& text)
{
  const Text_field& texts = std::get<Text_field>(field);
  if (text.empty()) throw Usage_error(label + " is empty");
  texts.set(label, text);
  given_text = text;
}

void Option::check(const std::string& label) const
{
  if (const auto* text = std::get_if<std::string*>(&field)) {
    if ((*text)->empty()) throw Usage_error(label + " is empty");
    if (!known.empty()) check_word(label, **text, known);
  }
  if (const auto* count = std::get_if<std::size_t*>(&field))
    if (**count > std::numeric_limits<std::size_t>::max() / 2) // a negative one
      throw Usage_error(label + " must not be negative");
  const std::optional<Number> number = number_of(*this);
  if (!number) return;
  const bool is_low = excludes_ends ? !(number->value > least) : !(number->value >= least),
             is_high = excludes_ends ? !(number->value < greatest) : !(number->value <= greatest);
  if (!is_low && !is_high) return;
  constexpr double largest = std::numeric_limits<double>::max();
  const std::string not_this = ", not " + number->text;
  if (least == 0 && !excludes_ends && greatest >= largest)
    throw Usage_error(label + (greatest == largest ? " must be finite and not negative" : " must not be negative"));
  if (std::isinf(greatest))
    throw Usage_error(label + (excludes_ends ? " must be more than " : " must be at least ") + short_number(least) +
                      not_this);
  if (!number->is_whole)
    throw Usage_error(label + " must be between " + short_number(least) + " and " + short_number(greatest) + not_this);
  if (is_low) throw Usage_error(label + " must be at least " + std::to_string(std::int64_t(least)) + not_this);
  throw Usage_error(label + " must be at most " + std::to_string(std::int64_t(greatest)) + not_this);
}

Option& Option_table::Group::operator()(const std::string& name, const std::string& value, Option::Field field,
                                        const std::string& help)
{
  Option option;
  const std::size_t comma = name.find(',');
  option.name = name.substr(0, comma);
  if (comma != std::string::npos) option.short_name = name.substr(comma + 1);
  option.group = title_;
  option.value_name = value;
  option.help = help;
  option.is_rare = is_rare_;
  option.field = std::move(field);
  if (const auto* texts = std::get_if<Text_field>(&option.field)) option.known = texts->known;
  return table_.options_.emplace_back(std::move(option));
}

const Option& Option_table::operator[](const std::string& name) const
{
  return *std::find_if(options_.begin(), options_.end(), [&](const Option& option) { return option.name == name; });
}

void Option_table::refuse_other_modes(const std::string& mode, const std::string& why) const
{
  for (const Option& option : options_)
    if (option.is_given && !option.modes.empty() &&
        std::find(option.modes.begin(), option.modes.end(), mode) == option.modes.end())
      refuse_option(option.name, why);
}

bool Option_table::help_is_given() const
{
  return std::any_of(options_.begin(), options_.end(), [](const Option& option) {
    return option.is_given && (option.name == "help" || option.name == "help-all");
  });
}

std::string Option_table::values_of(const std::string& group) const
{
  std::ostringstream result;
  result << std::hexfloat;
  for (const Option& option : options_) {
    if (option.group != group) continue;
    result << option.name << '=';
    if (option.is_switch())
      result << option.is_given;
    else if (const auto* number = std::get_if<double*>(&option.field);
             number && (option.is_given || option.has_default()))
      result << **number;
    else if (option.is_given || option.has_default())
      result << (option.given_text.empty() ? option.text() : option.given_text);
    result << '\n';
  }
  return result.str();
}

void refuse_option(const std::string& name, const std::string& why)
{
  throw Usage_error("--" + name + " has no effect " + why);
}

void check_word(const std::string& label, const std::string& value, const std::vector<std::string>& known)
{
  if (std::find(known.begin(), known.end(), value) != known.end()) return;
  throw Usage_error(label + " cannot be '" + value + "'; known are: " + boost::algorithm::join(known, ", "));
}

} // namespace CGAL::Shape_correspondence::cli
