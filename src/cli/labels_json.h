// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// The labels of parts, with their probabilities, as `labels.json` lists them; parts without a label are left out.
inline IO::Json parts_json(const std::vector<std::string>& parts, const std::vector<Transferred_label>& labels)
{
  IO::Json result = IO::Json::array();
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto& [label, probability] = labels[part];
    if (label.coarse.empty()) continue;
    IO::Json entry = {{"name", parts[part]}, {"coarse", label.coarse}};
    if (!label.fine.empty()) entry["fine"] = label.fine;
    entry["probability"] = probability;
    result.push_back(std::move(entry));
  }
  return result;
}

/// A `labels.json`.
inline IO::Json labels_json(const std::vector<std::string>& parts, const std::string& category,
                            const std::vector<Transferred_label>& labels)
{
  return {{"format", "shape_correspondence/labels"}, {"category", category}, {"parts", parts_json(parts, labels)}};
}

} // namespace CGAL::Shape_correspondence::cli
