// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Option_table.h"
#include "cli/text.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <sstream>

// How people write options on a command line, by Boost

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace po = boost::program_options;

constexpr const char* inputs_key = "INPUT"; // of positional arguments

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

/// How Boost parses an option. \return owned by who gets it
const po::value_semantic* semantic(const Option& option)
{
  return std::visit(
      [&](const auto& field) -> const po::value_semantic* {
        using Value = Value_of<decltype(field)>;
        if constexpr (std::is_same_v<Value, bool>)
          return po::bool_switch()->notifier([field](bool is_set) { *field |= is_set; });
        else if constexpr (std::is_same_v<Value, Switched_off>)
          return po::bool_switch()->notifier([field](bool is_set) { *field.field &= !is_set; });
        else if constexpr (std::is_same_v<Value, Switched_to>)
          return po::bool_switch()->notifier([field](bool is_set) {
            if (is_set) *field.field = field.word;
          });
        else if constexpr (std::is_same_v<Value, std::optional<double>>)
          return described(option, po::value<double>()->notifier([field](double value) { *field = value; }));
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
  std::vector<std::string> titles; // in their order
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
    std::vector<std::string> names;
    for (const Option& option : options_)
      names.push_back("--" + option.name);
    const std::string name = error.get_option_name();
    throw Usage_error("there is no option '" + name + "'" + suggestion(name, names));
  } catch (const po::error& error) {
    throw Usage_error(error.what());
  }
  for (Option& option : options_) {
    if (!option.is_given) continue;
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

} // namespace CGAL::Shape_correspondence::cli
