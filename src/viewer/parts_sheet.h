// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/Glb_file.h"

#include <CGAL/Shape_correspondence/split_parts.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// A web page with several models, one colour for each part, and a table of their objects.
class Parts_sheet
{
public:
  /// \param models number of models that are going to be added
  explicit Parts_sheet(std::size_t models);

  /// Adds a model. \param objects its objects, for their names \param roles roles of the parts; empty if they are not
  /// known \param summary text that is shown above the parts
  void add(const std::string& title, const Segmented_shape& objects, const Part_split& split,
           const std::vector<std::string>& roles, const std::string& summary);
  /// Adds a model that cannot be used.
  void add(const std::string& title, const std::string& complaint);

  void write(std::ostream& out) const;

private:
  std::size_t triangles_of_model_;
  Json models_ = Json::array();
  Glb_file glb_;
  std::vector<int> roots_;
};

} // namespace CGAL::Shape_correspondence::IO
