// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/ground_truth.h>

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <map>
#include <set>

namespace CGAL::Shape_correspondence {

namespace {

/// The parts with one coarse label, and their fine labels.
struct Labelled_parts
{
  std::vector<std::size_t> parts;
  std::set<std::string> fine;
};

std::map<std::string, Labelled_parts> parts_by_coarse_label(const std::vector<Part_label>& labels)
{
  std::map<std::string, Labelled_parts> result;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i].coarse.empty())
      throw Invalid_input("part " + std::to_string(i) + " has no coarse label; give every part one");
    Labelled_parts& labelled = result[labels[i].coarse];
    labelled.parts.push_back(i);
    labelled.fine.insert(labels[i].fine);
  }
  return result;
}

/// Whether fine labels decide: all parts have one, and at least half of the labels of the smaller set are in both.
bool share_fine_labels(const std::set<std::string>& a, const std::set<std::string>& b)
{
  if (a.count("") || b.count("")) return false;
  const std::size_t shared =
      std::count_if(a.begin(), a.end(), [&](const std::string& label) { return b.count(label) > 0; });
  return 2 * shared >= std::min(a.size(), b.size());
}

} // namespace

Ground_truth ground_truth(const std::vector<Part_label>& source, const std::vector<Part_label>& target)
{
  const auto sources = parts_by_coarse_label(source), targets = parts_by_coarse_label(target);
  Ground_truth truth;
  for (const auto& [label, s] : sources) {
    const auto found = targets.find(label);
    if (found == targets.end()) continue;
    const bool decide = share_fine_labels(s.fine, found->second.fine);
    for (std::size_t i : s.parts)
      for (std::size_t j : found->second.parts) {
        truth.coarse_pairs.emplace_back(i, j);
        if (!decide || source[i].fine == target[j].fine) truth.pairs.emplace_back(i, j);
      }
  }
  std::sort(truth.pairs.begin(), truth.pairs.end());
  std::sort(truth.coarse_pairs.begin(), truth.coarse_pairs.end());
  return truth;
}

} // namespace CGAL::Shape_correspondence
