// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Common_options.h"
#include "cli/run.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>
#include <type_traits>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Whether a field holds a number.
template <typename Value>
constexpr bool is_number = std::is_same_v<Value, int> || std::is_same_v<Value, std::int64_t> ||
                           std::is_same_v<Value, std::size_t> || std::is_same_v<Value, double>;

/// The type that a pointer of `Option::Field` points to; other fields unchanged.
template <typename Field>
using Value_of = std::remove_pointer_t<std::decay_t<Field>>;

/// Checks a number. \throw Usage_error if it is out of the option's range
void check_range(const Option& option, const std::string& label, double number, bool is_whole)
{
  const auto [least, greatest, excludes_ends] = std::tuple(option.least, option.greatest, option.excludes_ends);
  const bool is_low = excludes_ends ? !(number > least) : !(number >= least),
             is_high = excludes_ends ? !(number < greatest) : !(number <= greatest);
  if (!is_low && !is_high) return;
  constexpr double largest = std::numeric_limits<double>::max();
  const std::string not_this = ", not " + option.text();
  if (least == 0 && !excludes_ends && greatest >= largest)
    throw Usage_error(label + (greatest == largest ? " must be finite and not negative" : " must not be negative"));
  if (std::isinf(greatest))
    throw Usage_error(label + (excludes_ends ? " must be more than " : " must be at least ") + short_number(least) +
                      not_this);
  if (!is_whole)
    throw Usage_error(label + " must be between " + short_number(least) + " and " + short_number(greatest) + not_this);
  if (is_low) throw Usage_error(label + " must be at least " + std::to_string(std::int64_t(least)) + not_this);
  throw Usage_error(label + " must be at most " + std::to_string(std::int64_t(greatest)) + not_this);
}

// The syntax of options on a command line, parsed by Boost

namespace po = boost::program_options;

constexpr const char* inputs_key = "INPUT"; // key of positional arguments

template <typename Value>
po::typed_value<Value>* with_default(const Option& option, Value& field)
{
  po::typed_value<Value>* result = po::value(&field);
  if (option.has_default()) result->default_value(field, option.text());
  if constexpr (is_number<Value>)
    if (option.implied) result->implicit_value(Value(*option.implied), short_number(*option.implied));
  return result;
}

template <typename Value>
po::typed_value<Value>* described(const Option& option, po::typed_value<Value>* value)
{
  value->value_name(option.value_name);
  if (option.is_required) value->required();
  return value;
}

/// The parsing rules of an option for Boost. \return owned by the caller
const po::value_semantic* semantic(const Option& option)
{
  return std::visit(
      [&](const auto& field) -> const po::value_semantic* {
        using Value = Value_of<decltype(field)>;
        if constexpr (std::is_same_v<Value, bool>)
          return po::bool_switch()->notifier([field](bool is_set) { *field |= is_set; });
        else if constexpr (std::is_same_v<Value, Switch>)
          return po::bool_switch();
        else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
          return described(option, po::value(field));
        else if constexpr (!std::is_same_v<Value, Text_field>)
          return described(option, with_default(option, *field));
        else if (field.is_repeated)
          return described(option, po::value<std::vector<std::string>>());
        else if (option.has_default())
          return described(option, po::value<std::string>()->default_value("", option.text()));
        else
          return described(option, po::value<std::string>());
      },
      option.field);
}

po::options_description described(const std::deque<Option>& options, bool all)
{
  constexpr unsigned least_description = 48;
  po::options_description result;
  std::vector<std::string> titles; // titles of groups, in the order of their options
  for (const Option& option : options)
    if ((all || !option.is_rare) && std::find(titles.begin(), titles.end(), option.group) == titles.end())
      titles.push_back(option.group);
  for (const std::string& title : titles) {
    po::options_description group(title, unsigned(line_width), least_description);
    for (const Option& option : options) {
      const std::string name = option.name + (option.short_name.empty() ? "" : "," + option.short_name);
      if (option.group == title && (all || !option.is_rare))
        group.add_options()(name.c_str(), semantic(option), option.help.c_str());
    }
    result.add(group);
  }
  return result;
}

void take_texts(const po::variable_value& value, Option& option)
{
  if (const auto* text = boost::any_cast<std::string>(&value.value())) option.set_text("--" + option.name, *text);
  if (const auto* texts = boost::any_cast<std::vector<std::string>>(&value.value()))
    for (const std::string& text : *texts)
      option.set_text("--" + option.name, text);
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
  return std::visit(
      [](const auto& field) -> std::string {
        using Value = Value_of<decltype(field)>;
        if constexpr (std::is_same_v<Value, double>)
          return short_number(*field);
        else if constexpr (is_number<Value>)
          return std::to_string(*field);
        else if constexpr (std::is_same_v<Value, std::string>)
          return *field;
        else if constexpr (std::is_same_v<Value, Text_field>)
          return field.get ? field.get() : "";
        else
          return "";
      },
      field);
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
    if (**count > std::numeric_limits<std::size_t>::max() / 2) // a negative number, wrapped around
      throw Usage_error(label + " must not be negative");
  std::visit(
      [&](const auto& field) {
        using Value = Value_of<decltype(field)>;
        if constexpr (is_number<Value>) check_range(*this, label, double(*field), !std::is_same_v<Value, double>);
      },
      field);
}

Option& Option_table::Group::operator()(const std::string& name, const std::string& value, Option::Field field,
                                        const std::string& help)
{
  Option option;
  const std::size_t comma = name.find(',');
  option.name = name.substr(0, comma);
  if (comma != std::string::npos) option.short_name = name.substr(comma + 1);
  option.group = title;
  option.value_name = value;
  option.help = help;
  option.is_rare = is_rare;
  option.field = std::move(field);
  if (const auto* texts = std::get_if<Text_field>(&option.field)) option.known = texts->known;
  return table.options_.emplace_back(std::move(option));
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

std::vector<std::string> Option_table::parse(const std::vector<std::string>& arguments)
{
  po::options_description all = described(options_, true);
  all.add_options()(inputs_key, po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add(inputs_key, -1);
  po::variables_map values;
  try {
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(arguments).options(all).positional(positional).style(style).run(), values);
    for (Option& option : options_)
      option.is_given = values.count(option.name) > 0 && !values[option.name].defaulted();
    if (help_is_given()) return {};
    po::notify(values);
  } catch (const po::unknown_option& error) {
    const auto names = mapped(options_, [](const Option& option) { return "--" + option.name; });
    const std::string name = error.get_option_name();
    throw Usage_error("there is no option '" + name + "'" + suggestion(name, names));
  } catch (const po::error& error) {
    throw Usage_error(error.what());
  }
  for (Option& option : options_) {
    if (!option.is_given) continue;
    if (const auto* set = std::get_if<Switch>(&option.field)) (*set)();
    if (std::holds_alternative<Text_field>(option.field)) take_texts(values[option.name], option);
    option.check("--" + option.name);
  }
  return values.count(inputs_key) ? values[inputs_key].as<std::vector<std::string>>() : std::vector<std::string>();
}

std::string Option_table::help(bool all) const
{
  std::ostringstream result;
  result << described(options_, all);
  return result.str();
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

Text_field word_field(const std::vector<std::string>& known, const std::function<std::string()>& get,
                      const std::function<void(const std::string&)>& set)
{
  const auto set_checked = [known, set](const std::string& label, const std::string& text) {
    check_word(label, text, known);
    set(text);
  };
  return {get, set_checked, known};
}

} // namespace CGAL::Shape_correspondence::cli
