// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/number_text.h"
#include "cli/Option_table.h"
#include "cli/text.h"

#include <algorithm>
#include <type_traits>

// Command lines that a web page writes, in place of command_line.cpp: options are `--name` or `--name VALUE`. Boost's
// parser is a compiled library, which Emscripten does not have.

namespace CGAL::Shape_correspondence::cli {
namespace {

template <typename Number>
Number number_of(const std::string& label, const std::string& text)
{
  Number number{};
  const auto [end, error] = internal::read_number(text, number);
  if (error != std::errc() || end != text.data() + text.size())
    throw Usage_error(label + ": '" + text + "' is not a number in its range");
  return number;
}

void switch_on(const Option& option)
{
  if (const auto* field = std::get_if<bool*>(&option.field)) **field = true;
  if (const auto* off = std::get_if<Switched_off>(&option.field)) *off->field = false;
  if (const auto* to = std::get_if<Switched_to>(&option.field)) *to->field = to->word;
}

void set(Option& option, const std::string& label, const std::string& text)
{
  std::visit(
      [&](auto& field) {
        using Value = Value_of<decltype(field)>;
        if constexpr (is_number<Value>)
          *field = number_of<Value>(label, text);
        else if constexpr (std::is_same_v<Value, std::optional<double>>)
          *field = number_of<double>(label, text);
        else if constexpr (std::is_same_v<Value, std::string>)
          *field = text;
        else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
          field->push_back(text);
        else if constexpr (std::is_same_v<Value, Text_field>)
          option.set_text(label, text);
      },
      option.field);
}

bool is_name(const std::string& argument) { return argument.rfind("--", 0) == 0; }

} // namespace

std::vector<std::string> Option_table::parse(const std::vector<std::string>& arguments)
{
  std::vector<std::string> inputs;
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    if (!is_name(*argument)) {
      inputs.push_back(*argument);
      continue;
    }
    const std::string& label = *argument;
    const auto option =
        std::find_if(options_.begin(), options_.end(), [&](const Option& known) { return "--" + known.name == label; });
    if (option == options_.end()) throw Usage_error("there is no option '" + label + "'");
    option->is_given = true;
    if (option->is_switch()) {
      switch_on(*option);
    } else if (argument + 1 != arguments.end() && !is_name(argument[1])) {
      set(*option, label, *++argument);
    } else if (option->implied) {
      set(*option, label, short_number(*option->implied));
    } else {
      throw Usage_error("the option '" + label + "' has no value");
    }
  }
  for (const Option& option : options_) {
    if (option.is_given) option.check("--" + option.name);
    if (option.is_required && !option.is_given) throw Usage_error("the option '--" + option.name + "' is missing");
  }
  return inputs;
}

std::string Option_table::help(bool all) const
{
  std::string result;
  for (const Option& option : options_)
    if (all || !option.is_rare)
      result += "  --" + option.name + ' ' + option.value_name + "\n      " + option.help + '\n';
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
