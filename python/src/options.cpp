// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <pybind11/stl.h>

#include <cmath>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>

namespace shape_correspondence_python {

namespace {

/// The words of Python for the values of an enumeration.
template <typename Value>
struct Words;

template <>
struct Words<SC::Search_method>
{
  static constexpr std::pair<const char*, SC::Search_method> words[] = {
      {"parts", SC::Search_method::PARTS}, {"beam", SC::Search_method::BEAM}, {"exact", SC::Search_method::EXACT}};
};

template <>
struct Words<SC::Energy_norm>
{
  static constexpr std::pair<const char*, SC::Energy_norm> words[] = {{"sum", SC::Energy_norm::SUM},
                                                                      {"pooled", SC::Energy_norm::POOLED}};
};

template <>
struct Words<SC::Abstraction_kind>
{
  static constexpr std::pair<const char*, SC::Abstraction_kind> words[] = {{"auto", SC::Abstraction_kind::AUTOMATIC},
                                                                           {"curve", SC::Abstraction_kind::CURVE},
                                                                           {"sheet", SC::Abstraction_kind::SHEET}};
};

template <>
struct Words<SC::Blend_size>
{
  static constexpr std::pair<const char*, SC::Blend_size> words[] = {{"blend", SC::Blend_size::BLEND},
                                                                     {"source", SC::Blend_size::SOURCE},
                                                                     {"target", SC::Blend_size::TARGET},
                                                                     {"same", SC::Blend_size::SAME}};
};

template <typename Value>
Value value_of(const std::string& option, const std::string& word)
{
  std::string known;
  for (const auto& [name, value] : Words<Value>::words) {
    if (word == name) return value;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  throw SC::Invalid_input(option + " cannot be '" + word + "'; known are: " + known);
}

template <typename Value>
const char* word_of(Value value)
{
  for (const auto& [name, known] : Words<Value>::words)
    if (known == value) return name;
  return "";
}

template <typename Visitor>
void visit(SC::Part_matching_options& options, Visitor& option)
{
  option("overlap", options.weights.overlap);
  option("extent", options.weights.extent);
  option("ground", options.weights.ground);
  option("place", options.weights.place);
  option("orientation", options.weights.orientation);
  option("chamfer", options.weights.chamfer);
  option("whole", options.whole);
  option("tolerance", options.tolerance);
  option("anchor", options.anchor);
  option("warp_width", options.warp_width);
  option("excess", options.excess);
  option("confident_excess", options.confident_excess);
  option("main_surface", options.main_surface);
  option("side_depth", options.side_depth);
  option("wall_width", options.wall_width);
  option("repetition", options.repetition);
  option("category_ratio", options.category_ratio);
  option("category_distance", options.category_distance);
  option("clearly_better", options.clearly_better);
  option("panels", options.panels);
  option("support", options.support);
}

/// Takes the values of options from keyword arguments.
class Reader
{
public:
  explicit Reader(const py::dict& values) : values_(values) {}

  template <typename Field>
  void operator()(const char* name, Field& field)
  {
    if (!values_.contains(name)) return;
    ++used_;
    const py::object value = values_[name];
    try {
      read(name, value, field);
    } catch (const py::cast_error&) {
      throw py::type_error(std::string(name) + " cannot be " + py::repr(value).cast<std::string>());
    }
  }

  void check_all_used() const
  {
    if (used_ != values_.size()) throw py::type_error("there is an option that is not known");
  }

private:
  template <typename Field>
  static void read(const char* name, const py::object& value, Field& field)
  {
    if constexpr (std::is_enum_v<Field>)
      field = value_of<Field>(name, value.cast<std::string>());
    else
      field = value.cast<Field>();
  }
  static void read(const char* name, const py::object& value, std::map<std::string, SC::Abstraction_kind>& field)
  {
    for (const auto& [part, word] : value.cast<std::map<std::string, std::string>>())
      field[part] = value_of<SC::Abstraction_kind>(name, word);
  }

  static void read(const char*, const py::object& value, SC::Part_matching_options& field)
  {
    const py::dict values = value.cast<py::dict>();
    Reader reader(values);
    visit(field, reader);
    reader.check_all_used();
  }

  static void read(const char*, const py::object& value, std::vector<SC::Part_pair>& field)
  {
    for (const auto& [source, target] : value.cast<std::vector<std::pair<std::size_t, std::size_t>>>())
      field.push_back({source, target});
  }

  const py::dict& values_;
  std::size_t used_ = 0;
};

/// Lists options and their defaults.
class Lister
{
public:
  template <typename Field>
  void operator()(const char* name, const Field& field)
  {
    if constexpr (std::is_enum_v<Field>)
      list_[name] = word_of(field);
    else
      list_[name] = py::cast(field);
  }
  void operator()(const char* name, const std::map<std::string, SC::Abstraction_kind>&) { list_[name] = py::dict(); }
  void operator()(const char* name, const std::vector<SC::Part_pair>&) { list_[name] = py::list(); }
  void operator()(const char* name, SC::Part_matching_options& field)
  {
    Lister inner;
    visit(field, inner);
    list_[name] = inner.list();
  }

  const py::dict& list() const { return list_; }

private:
  py::dict list_;
};

template <typename Visitor>
void visit(SC::Search_options& options, Visitor& option)
{
  option("search_method", options.method);
  option("part_matching", options.parts);
  option("category", options.category);
  option("min_confidence", options.min_confidence);
  option("beam_width", options.beam.beam_width);
  option("expansions", options.beam.expansions);
  option("distortion_weight", options.matching.weights.distortion);
  option("connectedness_weight", options.matching.weights.connectedness);
  option("split_weight", options.matching.weights.split);
  option("role_weight", options.matching.weights.roles);
  option("energy_norm", options.matching.norm);
  option("cut_curves", options.matching.cut_curves);
  option("unmatched_cost", options.matching.unmatched_cost);
  option("pinned", options.matching.pinned);
  option("forbidden", options.matching.forbidden);
  option("both_directions", options.both_directions);
  option("maximum_parts", options.maximum_parts);
  option("coarse_target", options.coarse_target);
  option("source_parts", options.source_parts);
  option("target_parts", options.target_parts);
  option("alignments", options.alignments);
  option("front_is_sure", options.front_is_sure);
  option("solutions", options.solutions);
  option("min_marginals", options.min_marginals);
}

template <typename Visitor>
void visit(SC::Structure_options& options, Visitor& option)
{
  option("kind", options.abstraction.kind);
  option("part_kinds", options.abstraction.part_kinds);
  option("edge_length", options.abstraction.edge_length);
  option("triangles", options.abstraction.triangles);
  option("stop_volume", options.abstraction.stop_volume);
  option("maximum_iterations", options.abstraction.maximum_iterations);
  option("time_limit", options.abstraction.time_limit);
  option("curve_points", options.abstraction.curve_points);
  option("sheet_points", options.abstraction.sheet_points);
  option("detect_symmetry", options.symmetry.enabled);
  option("symmetry_tolerance", options.symmetry.tolerance);
  option("detect_reflections", options.symmetry.reflection);
  option("detect_rotations", options.symmetry.rotation);
  option("detect_translations", options.symmetry.translation);
  option("contact_tolerance", options.contacts.tolerance);
}

/// Options that say how a file is read and which machine works, beside those of `Structure_options`.
template <typename Visitor>
void visit(SC::cli::Common_options& options, Visitor& option)
{
  option("up", options.up);
  option("parts", options.parts);
  option("parts_from", options.parts_from);
  option("allow_outside_files", options.reading.allow_outside_files);
  option("cache", options.cache);
  option("threads", options.threads);
}

template <typename Visitor>
void visit(SC::Blend_options& options, Visitor& option)
{
  option("contact_tolerance", options.contact_tolerance);
  option("samples", options.samples);
  option("min_confidence", options.min_confidence);
  option("size", options.size);
  option("schedule", options.schedule);
  option("rank_all", options.rank_all);
}

template <typename Visitor>
void visit(SC::Energy_matrix_options& options, Visitor& option)
{
  option("unmatched_energy", options.unmatched_energy);
}

template <typename Visitor>
void visit(SC::Co_analysis_options& options, Visitor& option)
{
  option("inflation", options.clustering.inflation);
  option("least_cycle_support", options.least_cycle_support);
}

template <typename Visitor>
void visit(SC::Evaluation_options& options, Visitor& option)
{
  option("resamples", options.resamples);
  option("confidence", options.confidence);
  option("seed", options.seed);
}

template <typename... Options>
void read(const py::dict& values, Options&... options)
{
  Reader reader(values);
  (visit(options, reader), ...);
  reader.check_all_used();
}

template <typename... Options>
py::dict defaults(Options... options)
{
  Lister lister;
  (visit(options, lister), ...);
  return lister.list();
}

} // namespace

SC::Search_options search_options(const py::dict& values)
{
  SC::Search_options options;
  read(values, options);
  return options;
}

SC::cli::Common_options model_options(const py::dict& values)
{
  SC::cli::Common_options options;
  SC::Structure_options structure;
  read(values, options, structure);
  options.abstraction = structure.abstraction;
  options.no_symmetry = !structure.symmetry.enabled;
  options.symmetry_tolerance = structure.symmetry.tolerance;
  options.symmetries.clear();
  for (const auto& [is_wanted, kind] :
       {std::pair(structure.symmetry.reflection, "reflection"), std::pair(structure.symmetry.rotation, "rotation"),
        std::pair(structure.symmetry.translation, "translation")})
    if (is_wanted) options.symmetries += (options.symmetries.empty() ? "" : ",") + std::string(kind);
  options.contact_tolerance = structure.contacts.tolerance;
  options.quiet = true;
  check(options);
  return options;
}

SC::Blend_options blend_options(const py::dict& values)
{
  SC::Blend_options options;
  read(values, options);
  return options;
}

SC::Energy_matrix_options energy_matrix_options(const py::dict& values)
{
  SC::Energy_matrix_options options;
  read(values, options);
  if (!(options.unmatched_energy >= 0)) throw SC::Invalid_input("unmatched_energy must not be negative");
  return options;
}

SC::Co_analysis_options co_analysis_options(const py::dict& values)
{
  SC::Co_analysis_options options;
  read(values, options);
  if (!(options.clustering.inflation > 1)) throw SC::Invalid_input("inflation must be more than 1");
  if (!(options.least_cycle_support >= 0 && options.least_cycle_support <= 1))
    throw SC::Invalid_input("least_cycle_support must be between 0 and 1");
  return options;
}

SC::Evaluation_options evaluation_options(const py::dict& values)
{
  SC::Evaluation_options options;
  read(values, options);
  if (options.resamples < 1) throw SC::Invalid_input("resamples must be at least 1");
  if (!(options.confidence > 0 && options.confidence < 1))
    throw SC::Invalid_input("confidence must be between 0 and 1");
  return options;
}

py::dict default_options()
{
  py::dict result;
  result["match"] = defaults(SC::Search_options());
  result["build_graph"] = defaults(SC::Structure_options());
  result["read"] = defaults(SC::cli::Common_options());
  result["blend"] = defaults(SC::Blend_options());
  result["collection"] = defaults(SC::Energy_matrix_options(), SC::Co_analysis_options());
  result["evaluate"] = defaults(SC::Evaluation_options());
  result["paper"] = defaults(SC::paper_options());
  return result;
}

} // namespace shape_correspondence_python
