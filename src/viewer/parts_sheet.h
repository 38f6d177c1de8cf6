// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/split_parts.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// A web page with a picture of each of several models, a colour a part, and what became of its objects. It needs no
/// network.
class Parts_sheet
{
public:
  /// \param title of the model \param objects its objects, for their names \param lines what is said under its picture
  void add(const std::string& title, const Segmented_shape& objects, const Part_split& split,
           const std::vector<std::string>& lines);
  /// A model without a picture.
  void add(const std::string& title, const std::string& complaint);

  void write(std::ostream& out) const;

private:
  std::string figures_;
};

} // namespace CGAL::Shape_correspondence::IO
