// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/number_text.h"
#include "cli/Option_table.h"
#include "cli/text.h"

#include <algorithm>
#include <sstream>

// Options on a command line: --name VALUE, --name=VALUE, -n VALUE, -nVALUE; --switch, -s, and several such letters
// behind one dash. All behind -- are inputs. Own code, since Boost's parser is a compiled library, which other systems
// lack.

namespace CGAL::Shape_correspondence::cli {
namespace {

template <typename Number>
Number number_of(const std::string& label, const std::string& text)
{
  using Read = std::conditional_t<std::is_same_v<Number, std::size_t>, std::int64_t, Number>; // negative ones, too
  Read read{};
  const auto [end, error] = internal::read_number(text, read);
  if (error != std::errc() || end != text.data() + text.size() || (read > 0 && Read(Number(read)) != read))
    throw Usage_error(label + " needs a number that is not too large, not '" + text + "'");
  return Number(read);
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

bool is_repeated(const Option& option)
{
  const auto* text = std::get_if<Text_field>(&option.field);
  return text ? text->is_repeated : std::holds_alternative<std::vector<std::string>*>(option.field);
}

/// How messages name an option.
std::string label_of(const Option& option) { return "--" + option.name; }

/// A word of a command line that has the form of an option.
struct Option_word
{
  std::string name;                    ///< with its dashes
  std::optional<std::string> attached; ///< what is behind it in the same word
};

std::optional<Option_word> option_word(const std::string& word)
{
  if (word.size() < 2 || word[0] != '-') return std::nullopt;
  if (word[1] != '-')
    return Option_word{word.substr(0, 2), word.size() > 2 ? std::optional(word.substr(2)) : std::nullopt};
  const std::size_t sign = word.find('=');
  return Option_word{word.substr(0, sign), sign < word.size() ? std::optional(word.substr(sign + 1)) : std::nullopt};
}

/// Reads the words of a command line in turn.
class Command_line
{
public:
  Command_line(std::deque<Option>& options, const std::vector<std::string>& words)
      : options_(options), words_(words.begin(), words.end())
  {}

  /// \return the inputs
  std::vector<std::string> read()
  {
    std::vector<std::string> inputs;
    while (!words_.empty()) {
      const std::string word = take();
      if (word == "--") {
        inputs.insert(inputs.end(), words_.begin(), words_.end());
        break;
      }
      if (const std::optional<Option_word> option = option_word(word))
        read_option(*option);
      else
        inputs.push_back(word);
    }
    return inputs;
  }

private:
  std::string take()
  {
    std::string word = std::move(words_.front());
    words_.pop_front();
    return word;
  }

  Option* find(const std::string& name) const
  {
    const auto found = std::find_if(options_.begin(), options_.end(), [&](const Option& option) {
      return name == label_of(option) || (!option.short_name.empty() && name == "-" + option.short_name);
    });
    return found == options_.end() ? nullptr : &*found;
  }

  [[noreturn]] void refuse(const std::string& name) const
  {
    std::vector<std::string> names;
    for (const Option& option : options_)
      names.push_back(label_of(option));
    throw Usage_error("there is no option '" + name + "'" + suggestion(name, names));
  }

  void read_option(const Option_word& word)
  {
    Option* const option = find(word.name);
    if (!option) refuse(word.name);
    const std::string label = label_of(*option);
    if (option->is_given && !is_repeated(*option)) throw Usage_error(label + " is given more than once");
    option->is_given = true;
    if (!option->is_switch()) return set(*option, label, word.attached ? *word.attached : next_value(*option));
    switch_on(*option);
    if (!word.attached) return;
    if (word.name == label) throw Usage_error(label + " takes no value");
    words_.push_front('-' + *word.attached); // more switches
  }

  std::string next_value(const Option& option)
  {
    if (option.implied) return is_number_next() ? take() : short_number(*option.implied);
    if (words_.empty() || is_option_next())
      throw Usage_error(label_of(option) + " needs a value, " + option.value_name);
    return take();
  }

  bool is_number_next() const
  {
    double number = 0;
    return !words_.empty() && internal::read_number(words_.front(), number).ec == std::errc();
  }

  bool is_option_next() const
  {
    const std::optional<Option_word> word = option_word(words_.front());
    return word && (word->name[1] == '-' || find(word->name));
  }

  std::deque<Option>& options_;
  std::deque<std::string> words_;
};

/// An option and its value, as the help shows them.
std::string heading(const Option& option)
{
  std::string result = option.short_name.empty() ? label_of(option) : "-" + option.short_name + ", " + label_of(option);
  if (option.is_switch()) return result;
  result +=
      option.implied ? "[=" + option.value_name + "(=" + short_number(*option.implied) + ")]" : " " + option.value_name;
  return option.has_default() ? result + " (=" + option.text() + ")" : result;
}

/// Headings on the left, what the options do on the right, from a column on; below a heading that is too long.
void write_options(std::ostream& out, const std::vector<const Option*>& options, std::size_t column)
{
  for (const Option* option : options) {
    std::string line = "  " + heading(*option);
    if (line.size() + 1 > column) {
      out << line << '\n';
      line.clear();
    }
    for (const std::string& text : wrapped(option->help, line_width - column)) {
      line.resize(column, ' ');
      out << line << text << '\n';
      line.clear();
    }
  }
}

} // namespace

std::vector<std::string> Option_table::parse(const std::vector<std::string>& arguments)
{
  std::vector<std::string> inputs = Command_line(options_, arguments).read();
  if (help_is_given()) return {};
  for (const Option& option : options_) {
    if (option.is_given) option.check(label_of(option));
    if (option.is_required && !option.is_given) throw Usage_error(label_of(option) + " is missing");
  }
  return inputs;
}

std::string Option_table::help(bool all) const
{
  constexpr std::size_t widest_column = 40;
  std::vector<std::pair<std::string, std::vector<const Option*>>> groups; // in the order of their first options
  std::size_t column = 0;
  for (const Option& option : options_) {
    if (option.is_rare && !all) continue;
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& known) { return known.first == option.group; });
    if (group == groups.end()) group = groups.insert(group, {option.group, {}});
    group->second.push_back(&option);
    column = std::max(column, heading(option).size() + 4);
  }
  std::ostringstream result;
  for (const auto& [title, options] : groups) {
    result << '\n' << title << ":\n";
    write_options(result, options, std::min(column, widest_column));
  }
  return result.str();
}

} // namespace CGAL::Shape_correspondence::cli
