// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a large collection of structural graphs for timing: the models of data/ with other proportions, tapered, and
// with or without some of their parts; the same ones every time.
//   generate_collection NUMBER OUTPUT_FOLDER
// Parts are abstracted by their bounding boxes, so that a graph takes milliseconds.

#include "generator/models.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <set>

namespace SC = CGAL::Shape_correspondence;
namespace gen = CGAL::Shape_correspondence::generator;
namespace fs = std::filesystem;

namespace {

/// Random numbers that are the same with every standard library.
class Chance
{
public:
  explicit Chance(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return low + (high - low) * double(engine_()) / double(engine_.max()); }
  bool happens(double probability) { return between(0, 1) < probability; }

private:
  std::mt19937 engine_;
};

/// Random scaling of the axes, and a taper; mirror symmetry in the planes x = 0 and z = 0 is kept.
class Deformation
{
public:
  explicit Deformation(Chance& chance) : taper_(chance.between(-.15, .15))
  {
    for (int axis = 0; axis < 3; ++axis)
      scale_[axis] = chance.between(.7, 1.4);
  }

  SC::Point operator()(const SC::Point& p) const
  {
    const double width = 1 + taper_ * p.y();
    return {scale_[0] * width * p.x(), scale_[1] * p.y(), scale_[2] * width * p.z()};
  }

private:
  double taper_;
  double scale_[3];
};

/// The parts of a random group to leave out, if every other part keeps a contact; empty: leave out none.
std::set<std::string> left_out(const gen::Assembly& model, Chance& chance)
{
  const gen::Part_group& group = model.groups[std::size_t(chance.between(0, double(model.groups.size()) - 1e-9))];
  const std::set<std::string> names(group.parts.begin(), group.parts.end());
  std::set<std::string> held;
  for (const auto& [a, b] : model.contacts) {
    const std::string &first = model.parts[std::size_t(a)].name, &second = model.parts[std::size_t(b)].name;
    if (names.count(first) || names.count(second)) continue;
    held.insert({first, second});
  }
  return held.size() + names.size() == model.parts.size() && chance.happens(.7) ? names : std::set<std::string>();
}

SC::Segmented_shape variant(const gen::Assembly& model, const std::string& name, Chance& chance)
{
  const Deformation deformed(chance);
  const std::set<std::string> without = left_out(model, chance);
  SC::Segmented_shape shape(name);
  for (const gen::Part& part : model.parts) {
    if (without.count(part.name)) continue;
    const gen::Mesh& mesh = part.solid.mesh;
    SC::Part_mesh copy{SC::Points(3, mesh.points.size()), Eigen::Matrix3Xi(3, mesh.faces.size())};
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      copy.points.col(Eigen::Index(i)) = deformed(mesh.points[i]);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
      copy.triangles.col(Eigen::Index(i)) << mesh.faces[i][0], mesh.faces[i][1], mesh.faces[i][2];
    shape.add_part(part.name, std::move(copy));
  }
  return shape;
}

void write_collection(int number, const fs::path& folder)
{
  fs::create_directories(folder);
  SC::Structure_options options;
  options.abstraction.abstractor = SC::Bounding_box_abstraction();
  for (int i = 0; i < number; ++i) {
    const gen::Model& model = gen::models()[std::size_t(i) % gen::models().size()];
    Chance chance{unsigned(i)};
    const std::string count = std::to_string(100000 + i).substr(1), name = model.name + "_" + count;
    std::ofstream out(folder / (count + "_" + model.name + ".json"));
    SC::IO::write_structural_graph_json(
        out, SC::build_structural_graph<CGAL::Parallel_if_available_tag>(variant(model.make(), name, chance), options));
    if (!out) throw SC::Invalid_input(folder.string() + ": it cannot be written to");
  }
}

} // namespace

int main(int argc, char** argv)
{
  const int number = argc == 3 ? std::atoi(argv[1]) : 0;
  if (number < 1) {
    std::cerr << "usage: generate_collection NUMBER OUTPUT_FOLDER\n";
    return 2;
  }
  try {
    write_collection(number, argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
