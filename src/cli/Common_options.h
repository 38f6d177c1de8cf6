// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Thrown if the command line is invalid; exit status 2.
class Usage_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Throws `Usage_error` for an option without effect. \param why ends the sentence "… has no effect"
[[noreturn]] void refuse_option(const std::string& name, const std::string& why);

/// Throws `Usage_error` if `value` is none of `known`. \param label names the option
void check_word(const std::string& label, const std::string& value, const std::vector<std::string>& known);

/// A field that an option sets by parsing the text of its value.
struct Text_field
{
  std::function<std::string()> get;
  /// Sets the field. \param label name of the option, for messages \throw Usage_error
  std::function<void(const std::string& label, const std::string& text)> set;
  std::vector<std::string> known = {}; ///< allowed words; empty: any text
  bool is_repeated = false;            ///< whether `set` is called for each of several values
};

/// A field set to one of several words. \param get returns its current word; null: no default is shown
Text_field word_field(const std::vector<std::string>& known, const std::function<std::string()>& get,
                      const std::function<void(const std::string&)>& set);

/// The action of a switch that does more than set a field to true.
using Switch = std::function<void()>;

/// An option of a command, with the data for help, checks, completion and Python.
struct Option
{
  using Field = std::variant<bool*, Switch, int*, std::int64_t*, std::size_t*, double*, std::string*,
                             std::vector<std::string>*, Text_field>;

  std::string name;       ///< long name
  std::string short_name; ///< one letter, or empty
  std::string group;
  std::string value_name; ///< such as FILE; empty: the option is a switch
  std::string help;
  Field field; ///< what the option sets; its value when the option is added is the default

  std::vector<std::string> known; ///< allowed values; empty: any
  double least = -std::numeric_limits<double>::infinity(), greatest = -least;
  bool excludes_ends = false; ///< whether `least` and `greatest` themselves are excluded
  bool shows_default = true;  ///< false if the default means "none" or depends on other options
  bool is_required = false, is_input = false, is_output = false;
  bool is_for_pairs = false;      ///< whether it applies to the match of two shapes only, not to a collection
  std::optional<double> implied;  ///< number that the option has when given without a value
  std::vector<std::string> modes; ///< modes of the command in which it has an effect; empty: all
  std::string asked_mode;         ///< mode of the command that it selects when given; empty: none
  std::string keyword;            ///< name in Python; empty: not available there
  bool is_rare = false;           ///< shown by `--help-all` only

  bool is_given = false;
  std::string given_text; ///< value of a `Text_field` as given

  // Setters, which return the option
  Option& words(std::vector<std::string> all) { return known = std::move(all), *this; }
  Option& at_least(double number) { return least = number, *this; }
  Option& between(double from, double to) { return least = from, greatest = to, *this; }
  Option& more_than(double number) { return excludes_ends = true, at_least(number); }
  Option& without_default() { return shows_default = false, *this; }
  Option& required() { return is_required = true, *this; }
  Option& input() { return is_input = true, *this; }
  Option& output() { return is_output = true, *this; }
  Option& for_pairs() { return is_for_pairs = true, *this; }
  Option& implies(double number) { return implied = number, *this; }
  Option& only_for(std::vector<std::string> all) { return modes = std::move(all), *this; }
  Option& asks_for(const char* mode) { return asked_mode = mode, *this; }
  Option& in_python(const char* other_name = "");
  Option& rare() { return is_rare = true, *this; }
  Option& usual() { return is_rare = false, *this; }

  bool is_switch() const { return value_name.empty(); }
  /// The value as text; numbers with four significant digits.
  std::string text() const;
  /// Whether the help shows the default.
  bool has_default() const;
  /// Sets the field from a text. \pre it is a `Text_field` \param label name of the option, for messages
  /// \throw Usage_error if the text is empty or not allowed
  void set_text(const std::string& label, const std::string& text);
  /// Checks the value. \throw Usage_error if it is not allowed, empty, or out of range
  void check(const std::string& label) const;
};

/// The options of a command in groups, each defined once. They are bound to variables, which must outlive the table.
///
/// A new option is one call, next to those of its group: `add("name", "VALUE", &field, "help")`, without a value name
/// for a switch, followed by its rules, such as `.between(0, 1).in_python()`. Parsing, checks, `--help`, completion and
/// the Python keyword are derived from it; `scripts/check_documents --update` writes the program's reference.
class Option_table
{
public:
  Option_table() = default;
  Option_table(const Option_table&) = delete;
  Option_table& operator=(const Option_table&) = delete;

  /// Adds options to a group: `group("name", "VALUE", field, "help")`.
  struct Group
  {
    Option_table& table;
    std::string title;
    bool is_rare;

    /// Adds an option. \param name long name, or `name,n` with one letter \param value name of the value
    Option& operator()(const std::string& name, const std::string& value, Option::Field field, const std::string& help);
    /// Adds a switch.
    Option& operator()(const std::string& name, Option::Field field, const std::string& help)
    {
      return (*this)(name, "", std::move(field), help);
    }
  };
  Group group(const std::string& title) { return {*this, title, false}; }
  /// A group of which `--help` shows only the options that are `usual()`.
  Group rare_group(const std::string& title) { return {*this, title, true}; }

  const std::deque<Option>& options() const { return options_; }
  std::deque<Option>& options() { return options_; }
  /// The option with a name, which must exist.
  const Option& operator[](const std::string& name) const;
  bool is_given(const std::string& name) const { return (*this)[name].is_given; }

  /// Sets the variables. \return the inputs; none if help is requested, which ends parsing \throw Usage_error
  std::vector<std::string> parse(const std::vector<std::string>& arguments);

  /// Refuses given options that have no effect in a mode of the command. \param why see `refuse_option()`
  void refuse_other_modes(const std::string& mode, const std::string& why) const;

  bool help_is_given() const;
  /// The help text. \param all whether to include rare options
  std::string help(bool all) const;

  /// Name and value of every option of a group, numbers with all digits: a key for results that depend on them.
  std::string values_of(const std::string& group) const;

private:
  std::deque<Option> options_;
};

/// A field with one word for each of its values.
template <typename Value>
Text_field choice(Value& field, const std::vector<std::pair<const char*, Value>>& words)
{
  std::vector<std::string> known;
  for (const auto& [word, value] : words)
    known.emplace_back(word);
  const auto get = [&field, words] {
    for (const auto& [word, value] : words)
      if (field == value) return std::string(word);
    return std::string();
  };
  return word_field(known, get, [&field, words](const std::string& text) {
    for (const auto& [word, value] : words)
      if (text == word) field = value;
  });
}

} // namespace CGAL::Shape_correspondence::cli

namespace CGAL::Shape_correspondence {

class Role_model;
}

namespace CGAL::Shape_correspondence::cli {

/// The options that all commands share.
struct Common_options
{
  std::string json, glb, html; ///< files to write; empty: none
  std::string cache;           ///< folder of cached graphs; empty: none
  bool keeps_reading = true;   ///< whether the cache also keeps the parts and upright axes found for models
  std::string up;              ///< x, -x, +x etc., or auto; empty: the axis in the file, or an estimate that favours y
  std::string progress = "auto"; ///< auto, always or never
  Part_splitting parts = Part_splitting::AUTO;
  std::string features;   ///< like `Of_input::features`, set by `of_input()`
  std::string parts_from; ///< a file that assigns pieces to parts, or has labels of faces; empty: none
  IO::Reading_options reading;
  Structure_options structure;
  struct Of_input
  {
    std::string up, parts_from; ///< empty: the value for all inputs
    std::string features;       ///< file with features of the model's faces or vertices; empty: none
  };
  std::array<Of_input, 2> of_pair; ///< options of the source and of the target
  /// Role model to find the upright axes of models that do not give one; null: by stability alone.
  std::shared_ptr<const Role_model> roles;
  /// Called in place of a progress bar with the name of the work, the amount done and the total. May throw to end work.
  std::function<void(const std::string&, std::size_t, std::size_t)> on_progress;
  bool quiet = false, verbose = false, help = false, help_all = false;
  int threads = 0; ///< number of threads; 0: as many as the machine has

  Common_options of_input(std::size_t index) const;
  /// The options for reading model files, including the labels of faces that define parts.
  IO::Reading_options reading_options() const;
  /// Whether `parts_from` is a file of labels of faces rather than of pieces.
  bool has_face_labels() const;
  /// The upright direction; y if it is to be estimated.
  Point up_vector() const;
  bool finds_up() const { return up == "auto"; }
  /// Whether to print a table: not if standard output takes the JSON.
  bool prints_table() const { return !quiet && json != "-"; }
};

/// The field of `--output`: files by the endings of their names; `-` is JSON on standard output.
/// \param files an ending, such as `.json`, and the variable that it sets; the setter throws `Usage_error` for others
Text_field output_by_ending(const std::vector<std::pair<std::string, std::string*>>& files);

/// The words of a comma-separated list.
std::vector<std::string> words_of(const std::string& list);

constexpr const char* reading_group = "Options on model files";
constexpr const char* abstraction_group = "Options on part abstraction";
constexpr const char* abstraction_option = "abstraction";

/// Adds the options of all commands.
void add_common_options(Option_table& table, Common_options& options);
/// Adds the options for reading model files: upright axis and parts.
void add_reading_options(Option_table& table, Common_options& options);
/// Adds the options for reading models, abstracting their parts and building their structural graphs.
void add_model_options(Option_table& table, Common_options& options);
/// Adds the options that apply to the source or to the target only.
void add_pair_options(Option_table& table, Common_options& options);

} // namespace CGAL::Shape_correspondence

namespace CGAL::Shape_correspondence::cli {

constexpr const char* match_group = "Options of match";

/// The search methods with their names on the command line.
extern const std::vector<std::pair<const char*, Search_method>> search_methods;

/// The options of the search as given on the command line.
struct Match_options
{
  Search_options search;               ///< the members that options set directly; `search_options()` sets the others
  std::optional<Search_method> method; ///< empty: selected by other options
  std::string front = "likely";        ///< given, likely or auto
  std::optional<int> alignments;       ///< number of alignments; empty: depends on `front`
  bool paper = false;
  std::string roles = "auto";                 ///< auto, none or a file
  std::string examples;                       ///< a folder; empty: none
  std::string source_parts, target_parts;     ///< names of the only parts to match, with commas; empty: all
  std::array<std::string, 2> features;        ///< files for the source and the target; empty: none
  std::vector<std::string> pinned, forbidden; ///< pairs of parts, A=B
};

void add_match_options(Option_table& table, Match_options& match);

/// The search options, except for parts given by name, which need the shapes. \throw Usage_error
Search_options search_options(const Match_options& match, const Option_table& given);

/// Sets the options of graphs implied by `--paper`, unless they are given.
void take_graphs_of_paper(const Match_options& match, const Option_table& given, Structure_options& options);

} // namespace CGAL::Shape_correspondence::cli
