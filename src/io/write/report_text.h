// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The words of a report, as files have them.
const char* name_of(Abstraction_report::Method method);
const char* name_of(Abstraction_report::Repair repair);
std::vector<std::string> flags_of(const Abstraction_report& report);

/// The kind of a symmetry, as files have it.
const char* name_of(Symmetry_type type);

/// A symmetry and a part's kind in words, for people.
std::string name_of(const Symmetry& symmetry);
std::string kind_of(const Part_abstraction& part);

} // namespace CGAL::Shape_correspondence::IO
