// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The words of files for some values.
template <typename Value>
using Words = std::vector<std::pair<const char*, Value>>;

const Words<Abstraction_report::Method>& method_words();
const Words<Abstraction_report::Repair>& repair_words();
const Words<bool Abstraction_report::*>& flag_words();
const Words<Symmetry_type>& symmetry_words();

template <typename Value>
const char* word_of(Value value, const Words<Value>& words)
{
  for (const auto& [word, of_word] : words)
    if (of_word == value) return word;
  return words.front().first;
}

inline const char* name_of(Symmetry_type type) { return word_of(type, symmetry_words()); }

/// A symmetry and a part's kind in words, for people.
std::string name_of(const Symmetry& symmetry);
std::string kind_of(const Part_abstraction& part);

} // namespace CGAL::Shape_correspondence::IO
