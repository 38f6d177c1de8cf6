// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/match_options.h"

namespace CGAL::Shape_correspondence::cli {

/// A shape as messages name it.
struct Named_graph
{
  const Structural_graph& graph;
  const std::string& path;
};

/// Sets what `search` has by parts: those that are chosen, pinned pairs and forbidden ones.
/// \throw Usage_error if there is no part of a name
void choose_parts(const Match_options& match, const Named_graph& source, const Named_graph& target,
                  Search_options& search);

} // namespace CGAL::Shape_correspondence::cli
