// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options.h"

#include "cli/jobs.h"
#include "cli/run.h"

#include <CGAL/Shape_correspondence/paper_structure_options.h>

#include <pybind11/stl.h>

#include <functional>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace shape_correspondence_python {

namespace {

using SC::cli::Option;
using SC::cli::Option_table;

/// The keyword arguments of a function: options of the program, and further ones.
struct Keywords
{
  Option_table table;

  Keywords() = default;
  virtual ~Keywords() = default;

  /// Adds an option that the program does not have, or not in this form.
  template <typename Field>
  void add(const char* name, Field& field, const char* help = "")
  {
    table.group("Python")(name, "VALUE", &field, help).in_python();
  }

  /// Sets the options named in `values`. \throw TypeError for a name that is no option
  void read(const py::dict& values)
  {
    for (const auto& [key, value] : values)
      if (!value.is_none() && !value.equal(py::str(""))) // an empty text, like None, leaves the default
        read(key.cast<std::string>(), py::reinterpret_borrow<py::object>(value));
  }

private:
  void read(const std::string& name, const py::object& value);
};

/// The value of an option; None for an empty text.
py::object value_of(const Option& option)
{
  return std::visit(
      [&](const auto& field) -> py::object {
        using Field = std::decay_t<decltype(field)>;
        if constexpr (std::is_same_v<Field, bool*> || std::is_same_v<Field, int*> ||
                      std::is_same_v<Field, std::int64_t*> || std::is_same_v<Field, std::size_t*> ||
                      std::is_same_v<Field, double*>)
          return py::cast(*field);
        else if (const std::string text = option.text(); !text.empty())
          return py::cast(text);
        else
          return py::none();
      },
      option.field);
}

std::string text_of(const py::object& value)
{
  return py::module_::import("os").attr("fspath")(value).cast<std::string>();
}

/// Sets an option. \throw cast_error if the value is of another type
void set(const std::string& name, const py::object& value, Option& option)
{
  std::visit(
      [&](auto& field) {
        using Field = std::decay_t<decltype(field)>;
        if constexpr (std::is_same_v<Field, SC::cli::Text_field>) {
          if (!field.is_repeated) return option.set_text(name, value.cast<std::string>());
          for (const auto& [part, word] : value.cast<std::map<std::string, std::string>>())
            option.set_text(name, part + '=' + word);
        } else if constexpr (std::is_same_v<Field, std::string*>) {
          *field = text_of(value);
        } else if constexpr (std::is_pointer_v<Field>) {
          *field = value.cast<std::decay_t<decltype(*field)>>();
        }
      },
      option.field);
}

void Keywords::read(const std::string& name, const py::object& value)
{
  std::vector<std::string> names;
  for (Option& option : table.options()) {
    if (option.keyword.empty()) continue;
    names.push_back(option.keyword);
    if (option.keyword != name) continue;
    try {
      if (value.equal(value_of(option))) return; // the default, also where it is None
      set(name, value, option);
      option.is_given = true;
    } catch (const py::cast_error&) {
      throw py::type_error(name + " cannot be " + py::repr(value).cast<std::string>());
    }
    return option.check(name);
  }
  throw py::type_error("there is no option '" + name + "'" + SC::cli::suggestion(name, names));
}

struct Part_matching_keywords : Keywords
{
  explicit Part_matching_keywords(SC::Part_matching_options& options)
  {
    add("overlap", options.weights.overlap);
    add("extent", options.weights.extent);
    add("ground", options.weights.ground);
    add("place", options.weights.place);
    add("orientation", options.weights.orientation);
    add("chamfer", options.weights.chamfer);
    add("whole", options.whole);
    add("tolerance", options.tolerance);
    add("anchor", options.anchor);
    add("warp_width", options.warp_width);
    add("excess", options.excess);
    add("confident_excess", options.confident_excess);
    add("main_surface", options.main_surface);
    add("side_depth", options.side_depth);
    add("wall_width", options.wall_width);
    add("repetition", options.repetition);
    add("category_ratio", options.category_ratio);
    add("category_distance", options.category_distance);
    add("clearly_better", options.clearly_better);
    add("panels", options.panels);
    add("support", options.support);
  }
};

struct Search_keywords : Keywords
{
  SC::cli::Match_options match;

  explicit Search_keywords(const SC::Search_options& search = {})
  {
    match.search = search;
    table
        .group("Python")("search_method", "METHOD", SC::cli::choice(match.search.method, SC::cli::search_methods),
                         "parts (least cost of substituting parts), beam (least deformation energy by the paper's "
                         "beam search) or exact (least deformation energy, with a proof)")
        .in_python();
    add_match_options(table, match);
    add("paper", match.paper, "the method of the paper, its graphs included");
    add("cut_curves", match.search.energy.cut_curves, "whether curves may be cut into segments and joined");
    add("alignments", match.search.alignments,
        "number of turns of the target about the up axis to try, nearest to the given one first; 0: all");
    add("front_is_sure", match.search.front_is_sure,
        "whether the given orientation is right; otherwise matching by parts turns a shape by a multiple of 90° if the "
        "roles of its parts clearly say that its front is another side");
  }
};

struct Model_keywords : Keywords
{
  SC::cli::Common_options common;
  bool paper = false;

  Model_keywords()
  {
    common.quiet = true;
    add_model_options(table, common);
    add_common_options(table, common);
    SC::Symmetry_options& symmetry = common.structure.symmetry;
    add("detect_symmetry", symmetry.enabled, "if False, every part is a group of its own");
    add("detect_reflections", symmetry.reflection, "whether to look for reflections");
    add("detect_rotations", symmetry.rotation, "whether to look for rotations");
    add("detect_translations", symmetry.translation, "whether to look for translations");
    add("paper", paper, "graphs as in the paper: `abstraction` flow, and parts touch at a closest pair of points");
    add("parts_from", common.parts_from,
        "a list of pieces and their parts, as `graph --parts-json` of the program writes it, or of labels of faces");
  }
};

struct Blend_keywords : Keywords
{
  SC::Blend_options options;
  SC::cli::Blend_output output;

  Blend_keywords()
  {
    add("contact_tolerance", options.contact_tolerance,
        "largest gap between parts in contact, as a fraction of the shape's height");
    add("samples", options.samples, "number of in-between shapes by which a schedule is rated");
    add("min_confidence", options.min_confidence,
        "pairs of lower confidence, in [0, 1], are left out: their parts come and go");
    SC::cli::Option_table::Group group = table.group("Output");
    add_output_options(group, output);
    add("schedule", options.schedule, "one of `schedule_names()`; None: the best");
  }
};

struct Collection_keywords : Keywords
{
  SC::cli::Common_options common;
  SC::cli::Collection_options options;

  Collection_keywords() { add_collection_options(table, common, options); }
};

py::list listed(const Option_table& table, const std::function<bool(const Option&)>& is_wanted = {})
{
  py::list result;
  for (const Option& option : table.options())
    if (!option.keyword.empty() && (!is_wanted || is_wanted(option)))
      result.append(py::make_tuple(option.keyword, value_of(option), option.help));
  return result;
}

std::vector<SC::Part_pair> pairs_of(const py::object& value)
{
  std::vector<SC::Part_pair> result;
  for (const auto& [source, target] : value.cast<std::vector<std::pair<std::size_t, std::size_t>>>())
    result.push_back({source, target});
  return result;
}

} // namespace

SC::Search_options search_options(const py::dict& values, bool is_for_pair)
{
  const bool paper = values.contains("paper") && py::cast<bool>(values["paper"]);
  Search_keywords keywords(paper ? SC::paper_options() : SC::Search_options());
  py::dict rest;
  const auto refuse = [](const std::string& name) {
    throw py::type_error(name + " is for a pair of shapes, not for a set");
  };
  for (const auto& [key, borrowed] : values) {
    const std::string name = key.cast<std::string>();
    const py::object value = py::reinterpret_borrow<py::object>(borrowed);
    SC::Search_options& search = keywords.match.search;
    const bool chooses_parts =
        name == "source_parts" || name == "target_parts" || name == "pinned" || name == "forbidden";
    if (chooses_parts && !is_for_pair) refuse(name);
    if (name == "part_matching" && !value.is_none())
      Part_matching_keywords(search.parts).read(value);
    else if (name == "source_parts")
      search.source_parts = value.cast<std::vector<std::size_t>>();
    else if (name == "target_parts")
      search.target_parts = value.cast<std::vector<std::size_t>>();
    else if (name == "pinned")
      search.energy.pinned = pairs_of(value);
    else if (name == "forbidden")
      search.energy.forbidden = pairs_of(value);
    else
      rest[key] = value;
  }
  keywords.read(rest);
  for (const Option& option : keywords.table.options())
    if (option.is_given && option.is_for_pairs && !is_for_pair) refuse(option.keyword);
  return keywords.match.search;
}

SC::cli::Common_options model_options(const py::dict& values)
{
  Model_keywords keywords;
  keywords.read(values);
  if (keywords.paper) {
    const SC::Structure_options paper = SC::paper_structure_options();
    SC::Structure_options& structure = keywords.common.structure;
    if (!values.contains("abstraction")) structure.abstraction.abstractor = paper.abstraction.abstractor;
    structure.contacts.closest_points = paper.contacts.closest_points;
  }
  return keywords.common;
}

SC::Blend_options blend_options(const py::dict& values, bool& has_size)
{
  Blend_keywords keywords;
  keywords.read(values);
  has_size = keywords.output.size.has_value();
  keywords.options.size = keywords.output.size.value_or(SC::Blend_size::BLEND);
  return keywords.options;
}

SC::cli::Collection_options collection_options(const py::dict& values)
{
  Collection_keywords keywords;
  keywords.read(values);
  return keywords.options;
}

py::list options_of(const std::string& function)
{
  const auto is_of_reading = [](const Option& option) {
    return option.group == SC::cli::reading_group || option.keyword == "parts_from";
  };
  if (function == "read") return listed(Model_keywords().table, is_of_reading);
  const auto is_of_graphs = [&](const Option& option) {
    return !is_of_reading(option) || option.keyword == "allow_outside_files"; // for meshes that a saved graph names
  };
  if (function == "build_graph") return listed(Model_keywords().table, is_of_graphs);
  if (function == "blend") return listed(Blend_keywords().table);
  if (function == "collection") return listed(Collection_keywords().table);
  if (function == "part_matching") {
    SC::Part_matching_options options;
    return listed(Part_matching_keywords(options).table);
  }
  return listed(Search_keywords().table);
}

} // namespace shape_correspondence_python
