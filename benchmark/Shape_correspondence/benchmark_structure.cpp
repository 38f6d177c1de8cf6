// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures symmetry groups, contacts and the guess of the upright axis on labelled shapes, y up:
//   benchmark_structure [--quiet] [--brute-force] SHAPE_FOLDER...
// Every folder holds parts/NAME.obj and labels.json. The parts' skeletons are not needed: their surfaces are enough.
// With --brute-force, contacts are compared with distances that are measured in another, slow way.

#include "brute_force_contacts.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/estimate_up.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>

namespace SC = CGAL::Shape_correspondence;

namespace {

constexpr std::size_t PART_SAMPLES = 256;

using Labels = std::vector<SC::Part_label>; // by part

struct Totals
{
  std::size_t shapes = 0, parts = 0, groups = 0, large_groups = 0, mixed_groups = 0, contacts = 0, pieces = 0,
              joins = 0;
  std::size_t stated_contacts = 0, stated_contacts_found = 0, comparable_contacts = 0;
  std::size_t equal_sets = 0, gathered_sets = 0;
  std::size_t upright = 0, near_pairs = 0, missed_contacts = 0, false_contacts = 0;
  double symmetry_seconds = 0, contact_seconds = 0;
};

Labels labels_of(const std::string& folder, const SC::Segmented_shape& shape)
{
  const SC::IO::Labelled_shape labelled = SC::IO::read_part_labels(folder).front();
  Labels result;
  for (const SC::Shape_part& part : shape.parts())
    result.push_back(labelled.labels.at(labelled.index(part.name)));
  return result;
}

using Name_pair = std::pair<std::string, std::string>;

/// The contacts that structure.json states, if the folder has one.
std::set<Name_pair> stated_contacts(const std::string& folder)
{
  std::set<Name_pair> result;
  std::ifstream file(folder + "/structure.json");
  if (!file) return result;
  const nlohmann::json document = nlohmann::json::parse(file);
  for (const auto& contact : document.at("contacts")) {
    const auto names = contact.at("parts").get<std::vector<std::string>>();
    result.insert(std::minmax(names[0], names[1]));
  }
  return result;
}

double mesh_area(const SC::Part_mesh& mesh)
{
  double area = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const SC::Point p = mesh.points.col(mesh.triangles(0, t));
    const SC::Point u = mesh.points.col(mesh.triangles(1, t)), v = mesh.points.col(mesh.triangles(2, t));
    area += (u - p).cross(v - p).norm() / 2;
  }
  return area;
}

/// A part as symmetry detection sees it, with its box's diagonal for a curve.
SC::Part_abstraction make_part(const SC::Shape_part& input)
{
  SC::Part_abstraction part;
  part.name = input.name;
  part.surface = SC::sample_surface(input.mesh, PART_SAMPLES);
  part.hull = input.mesh.points;
  part.area = mesh_area(input.mesh);
  SC::Curve curve;
  curve.points.resize(3, 2);
  curve.points << input.mesh.points.rowwise().minCoeff(), input.mesh.points.rowwise().maxCoeff();
  part.geometry = curve;
  return part;
}

SC::Points all_samples(const SC::Segmented_shape& shape)
{
  double total = 0;
  for (const SC::Shape_part& part : shape.parts())
    total += mesh_area(part.mesh);
  SC::Points result(3, 0);
  for (const SC::Shape_part& part : shape.parts()) {
    const auto n = static_cast<std::size_t>(4 + 4096 * mesh_area(part.mesh) / total);
    const SC::Points samples = SC::sample_surface(part.mesh, n);
    result.conservativeResize(3, result.cols() + samples.cols());
    result.rightCols(samples.cols()) = samples;
  }
  return result;
}

/// The sets of parts whose coarse labels are equal and whose sizes agree, as the fine labels or, without them, the
/// sizes of axis-parallel boxes tell.
std::vector<std::vector<std::size_t>> equal_sets(const SC::Segmented_shape& shape, const Labels& labels,
                                                 const SC::Shape_frame& frame)
{
  std::vector<std::vector<std::size_t>> sets;
  std::vector<Eigen::Vector4d> sizes;
  for (const SC::Shape_part& part : shape.parts()) {
    const SC::Points local = frame.to_frame(part.mesh.points);
    const SC::Point extent = local.rowwise().maxCoeff() - local.rowwise().minCoeff();
    sizes.emplace_back(extent.x(), extent.y(), extent.z(), std::sqrt(mesh_area(part.mesh)) / frame.height);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto fits = [&](const std::vector<std::size_t>& set) {
      const std::size_t j = set.front();
      return labels[i].coarse == labels[j].coarse && (sizes[i] - sizes[j]).norm() < 0.03 * sizes[j].norm();
    };
    const auto found = std::find_if(sets.begin(), sets.end(), fits);
    if (found == sets.end())
      sets.push_back({i});
    else
      found->push_back(i);
  }
  sets.erase(std::remove_if(sets.begin(), sets.end(), [](const auto& set) { return set.size() < 2; }), sets.end());
  return sets;
}

std::string name_of(const SC::Symmetry& symmetry)
{
  switch (symmetry.type) {
  case SC::Symmetry_type::REFLECTION:
    return "reflection";
  case SC::Symmetry_type::ROTATION:
    return "rotation " + std::to_string(symmetry.order);
  case SC::Symmetry_type::TRANSLATION:
    return "translation";
  case SC::Symmetry_type::SELF:
    return "self";
  default:
    return "none";
  }
}

/// Compares contacts with the distances of all pairs of parts that are within the tolerance of each other's box.
void compare_with_brute_force(const SC::Segmented_shape& shape, const SC::Shape_frame& frame,
                              const std::vector<SC::Contact>& contacts, bool are_joined, Totals& totals)
{
  std::vector<Eigen::AlignedBox3d> boxes(shape.parts().size());
  Eigen::AlignedBox3d all;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const SC::Points local = frame.axes.transpose() * shape.parts()[i].mesh.points;
    boxes[i] = {SC::Point(local.rowwise().minCoeff()), SC::Point(local.rowwise().maxCoeff())};
    all.extend(boxes[i]);
  }
  const double tolerance = SC::Contact_options().tolerance * all.diagonal().norm();
  std::set<std::pair<std::size_t, std::size_t>> touching;
  for (const SC::Contact& contact : contacts)
    touching.insert({contact.parts[0], contact.parts[1]});

  const SC::benchmark::Brute_force_contacts brute_force(shape);
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      const bool is_contact = touching.count({a, b}) > 0;
      if (!is_contact && boxes[a].exteriorDistance(boxes[b]) > tolerance) continue;
      const double distance = brute_force.distance(a, b);
      const bool is_inside = brute_force.is_inside(a, b) || brute_force.is_inside(b, a);
      totals.near_pairs += distance <= tolerance;
      const bool missed = !is_contact && distance < tolerance;
      const bool wrong =
          is_contact && !are_joined && !is_inside && distance > tolerance + brute_force.uncertainty(a, b);
      totals.missed_contacts += missed;
      totals.false_contacts += wrong;
      if (missed || wrong)
        std::cout << (missed ? "  MISSED " : "  WRONG ") << shape.parts()[a].name << " - " << shape.parts()[b].name
                  << ": " << distance / tolerance << " of the tolerance\n";
    }
}

/// Counts groups of several parts, and those with several labels. \return the group of every part
std::vector<std::size_t> count_groups(const std::vector<SC::Part_group>& groups, const Labels& labels, bool quiet,
                                      Totals& totals)
{
  std::vector<std::size_t> group_of(labels.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::set<std::string> coarse;
    std::string members;
    for (std::size_t part : groups[g].parts) {
      group_of[part] = g;
      coarse.insert(labels[part].coarse);
      members += " " + (labels[part].fine.empty() ? labels[part].coarse : labels[part].fine);
    }
    const bool mixed = coarse.size() > 1;
    totals.mixed_groups += mixed;
    totals.large_groups += groups[g].parts.size() > 1;
    if (groups[g].parts.size() > 1 && (!quiet || mixed))
      std::cout << (mixed ? "  MIXED " : "  ") << name_of(groups[g].symmetry) << " of " << groups[g].parts.size() << ":"
                << members << "  (residual " << std::setprecision(4) << groups[g].symmetry.residual << ")\n";
  }
  return group_of;
}

/// Counts the sets of equal parts, and those that are in one group, or in mirrored pairs.
void count_equal_sets(const std::vector<std::vector<std::size_t>>& sets, const std::vector<SC::Part_group>& groups,
                      const std::vector<std::size_t>& group_of, const Labels& labels, bool quiet, Totals& totals)
{
  for (const std::vector<std::size_t>& set : sets) {
    std::map<std::size_t, std::size_t> uses;
    for (std::size_t part : set)
      ++uses[group_of[part]];
    const bool gathered = std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
      const SC::Part_group& group = groups[use.first];
      return uses.size() == 1 || (group.symmetry.type == SC::Symmetry_type::REFLECTION);
    });
    ++totals.equal_sets;
    totals.gathered_sets += gathered;
    if (!gathered && !quiet) {
      std::cout << "  apart:";
      for (const auto& [group, count] : uses)
        std::cout << " " << count << " " << labels[groups[group].parts[0]].coarse << " in "
                  << name_of(groups[group].symmetry);
      std::cout << "\n";
    }
  }
}

/// Counts the contacts that the folder states, and those of them that were found.
void count_stated_contacts(const std::string& folder, const std::vector<SC::Contact>& contacts,
                           const std::vector<SC::Part_abstraction>& parts, Totals& totals)
{
  const std::set<Name_pair> stated = stated_contacts(folder);
  for (const SC::Contact& contact : contacts)
    totals.stated_contacts_found +=
        stated.count(std::minmax(parts[contact.parts[0]].name, parts[contact.parts[1]].name));
  totals.stated_contacts += stated.size();
  if (!stated.empty()) totals.comparable_contacts += contacts.size();
}

void measure(const std::string& folder, bool quiet, bool brute_force, Totals& totals)
{
  const SC::Segmented_shape shape = SC::IO::read_segmented_shape(folder + "/parts");
  const Labels labels = labels_of(folder, shape);
  std::vector<SC::Part_abstraction> parts;
  for (const SC::Shape_part& part : shape.parts())
    parts.push_back(make_part(part));
  const SC::Shape_frame frame = SC::compute_shape_frame(all_samples(shape), shape.up());
  CGAL::Real_timer timer;
  timer.start();
  const std::vector<SC::Part_group> groups = SC::detect_symmetry_groups(parts, frame);
  const double symmetry_seconds = timer.time();
  std::vector<std::string> warnings;
  const std::vector<SC::Contact> contacts =
      SC::detect_contacts<CGAL::Parallel_if_available_tag>(shape, parts, frame, {}, warnings);
  const double contact_seconds = timer.time() - symmetry_seconds;

  std::cout << folder << ": " << parts.size() << " parts, " << groups.size() << " groups, " << contacts.size()
            << " contacts, " << warnings.size() + 1 << " piece(s), mirror " << frame.mirror_x << frame.mirror_z << ", "
            << std::fixed << std::setprecision(1) << 1000 * symmetry_seconds << " + " << 1000 * contact_seconds
            << " ms\n";
  const std::vector<std::size_t> group_of = count_groups(groups, labels, quiet, totals);
  count_equal_sets(equal_sets(shape, labels, frame), groups, group_of, labels, quiet, totals);
  count_stated_contacts(folder, contacts, parts, totals);
  for (const std::string& warning : warnings)
    if (!quiet) std::cout << "  " << warning << "\n";
  if (brute_force) compare_with_brute_force(shape, frame, contacts, !warnings.empty(), totals);
  totals.upright += SC::estimate_up(shape).up == shape.up();
  ++totals.shapes;
  totals.parts += parts.size();
  totals.groups += groups.size();
  totals.contacts += contacts.size();
  totals.pieces += warnings.size() > 0;
  totals.joins += warnings.size();
  totals.symmetry_seconds += symmetry_seconds;
  totals.contact_seconds += contact_seconds;
}

void print(const Totals& t)
{
  std::cout << "\nshapes " << t.shapes << ", parts " << t.parts << ", groups " << t.groups << ", of two or more "
            << t.large_groups << "\ngroups that mix coarse labels: " << t.mixed_groups << " (" << std::setprecision(2)
            << 100.0 * t.mixed_groups / std::max<std::size_t>(1, t.groups) << " % of all, "
            << 100.0 * t.mixed_groups / std::max<std::size_t>(1, t.large_groups) << " % of those of two or more)"
            << "\nsets of equal parts in one group or in mirrored pairs: " << t.gathered_sets << " of " << t.equal_sets
            << " (" << 100.0 * t.gathered_sets / std::max<std::size_t>(1, t.equal_sets) << " %)\ncontacts "
            << t.contacts << "; shapes in pieces before joining: " << t.pieces << ", joined by " << t.joins
            << " pairs\nupright axis found: " << t.upright << "\n";
  if (t.near_pairs > 0)
    std::cout << "pairs of parts that brute force finds near: " << t.near_pairs << ", missed by the contacts "
              << t.missed_contacts << "; contacts that it does not find near: " << t.false_contacts << "\n";
  if (t.stated_contacts > 0)
    std::cout << "contacts stated " << t.stated_contacts << ", found of those " << t.stated_contacts_found
              << ", found where stated " << t.comparable_contacts << "\n";
  std::cout << "seconds: symmetry " << t.symmetry_seconds << ", contacts " << t.contact_seconds << "\n";
}

} // namespace

int main(int argc, char** argv)
{
  Totals totals;
  bool quiet = false, brute_force = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    quiet = quiet || argument == "--quiet";
    brute_force = brute_force || argument == "--brute-force";
    if (argument == "--quiet" || argument == "--brute-force") continue;
    try {
      measure(argument, quiet, brute_force, totals);
    } catch (const std::exception& error) {
      std::cerr << argv[i] << ": " << error.what() << "\n";
      return 1;
    }
  }
  print(totals);
}
