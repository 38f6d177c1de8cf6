// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <initializer_list>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::IO {

/// The words that stand for values in files.
template <typename Value>
using Words = std::initializer_list<std::pair<const char*, Value>>;

inline constexpr Words<Abstraction_report::Method> method_words = {
    {"skeleton", Abstraction_report::Method::SKELETON},
    {"meso_skeleton", Abstraction_report::Method::MESO_SKELETON},
    {"medial_axis", Abstraction_report::Method::MEDIAL_AXIS},
    {"axis", Abstraction_report::Method::AXIS},
    {"prism", Abstraction_report::Method::PRISM},
    {"bounding_box", Abstraction_report::Method::BOUNDING_BOX},
    {"copy", Abstraction_report::Method::COPY},
    {"given", Abstraction_report::Method::GIVEN}};

inline constexpr Words<Abstraction_report::Repair> repair_words = {{"none", Abstraction_report::Repair::NONE},
                                                                   {"soup", Abstraction_report::Repair::SOUP},
                                                                   {"holes", Abstraction_report::Repair::HOLES},
                                                                   {"wrap", Abstraction_report::Repair::WRAP}};

inline constexpr Words<bool Abstraction_report::*> flag_words = {
    {"tube", &Abstraction_report::tube},
    {"blob", &Abstraction_report::blob},
    {"branching", &Abstraction_report::branching},
    {"several_components", &Abstraction_report::several_components},
    {"hull_of_box", &Abstraction_report::hull_of_box},
    {"time_limit", &Abstraction_report::time_limit}};

inline constexpr Words<Symmetry_type> symmetry_words = {{"none", Symmetry_type::NONE},
                                                        {"self", Symmetry_type::SELF},
                                                        {"reflection", Symmetry_type::REFLECTION},
                                                        {"rotation", Symmetry_type::ROTATION},
                                                        {"translation", Symmetry_type::TRANSLATION}};

template <typename Value>
const char* word_of(Value value, Words<Value> words)
{
  for (const auto& [word, of_word] : words)
    if (of_word == value) return word;
  return words.begin()->first;
}

inline const char* name_of(Symmetry_type type) { return word_of(type, symmetry_words); }

/// The name of a symmetry or of a part's kind, for people.
inline std::string name_of(const Symmetry& symmetry)
{
  const std::string name = name_of(symmetry.type);
  return symmetry.type == Symmetry_type::ROTATION ? name + ", " + std::to_string(symmetry.order) + "-fold" : name;
}

inline std::string kind_of(const Part_abstraction& part)
{
  return part.is_sheet() ? "sheet" : part.is_closed_curve() ? "closed curve" : "curve";
}

} // namespace CGAL::Shape_correspondence::IO
