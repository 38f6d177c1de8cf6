// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Minimizes a user-defined energy by exact search: every part of the source is assigned the part of the target that is
// nearest in relative place and size, and parts in contact prefer parts in contact.
#include <CGAL/Shape_correspondence.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/exact_search.h>

#include <cmath>
#include <iostream>

namespace SC = CGAL::Shape_correspondence;

// Centre and diagonal of a part's bounding box, relative to those of the shape
struct Part_measures
{
  SC::Point centre;
  double size;
};

std::vector<Part_measures> measures_of(const SC::Segmented_shape& shape)
{
  SC::Point low = SC::Point::Constant(1e300), high = -low;
  for (const SC::Shape_part& part : shape.parts()) {
    low = low.cwiseMin(part.mesh.points.rowwise().minCoeff());
    high = high.cwiseMax(part.mesh.points.rowwise().maxCoeff());
  }
  std::vector<Part_measures> result;
  for (const SC::Shape_part& part : shape.parts()) {
    const SC::Point least = part.mesh.points.rowwise().minCoeff(), most = part.mesh.points.rowwise().maxCoeff();
    result.push_back(
        {((least + most) / 2 - low).cwiseQuotient(high - low), (most - least).norm() / (high - low).norm()});
  }
  return result;
}

int main(int argc, char** argv)
{
  const std::string source_file = argc > 1 ? argv[1] : DATA_DIR "/table_four_legged";
  const std::string target_file = argc > 2 ? argv[2] : DATA_DIR "/table_trestle";
  try {
    const SC::Segmented_shape source = SC::IO::read_segmented_shape(source_file);
    const SC::Segmented_shape target = SC::IO::read_segmented_shape(target_file);
    const SC::Structural_graph a = SC::build_structural_graph(source), b = SC::build_structural_graph(target);
    const auto parts_of = [](const SC::Structural_graph& graph) { return SC::structure(graph).parts.size(); };

    // A variable for every part of the source; its labels are the parts of the target
    SC::Pairwise_energy energy;
    const std::vector<Part_measures> of_source = measures_of(source), of_target = measures_of(target);
    for (const Part_measures& p : of_source) {
      Eigen::VectorXd cost(parts_of(b));
      for (std::size_t j = 0; j < parts_of(b); ++j)
        cost[Eigen::Index(j)] = (p.centre - of_target[j].centre).norm() + std::abs(p.size - of_target[j].size);
      energy.unary.push_back(cost);
    }

    // A term for every contact of the source: 0 if the two parts become one part or two parts in contact, 1 otherwise
    Eigen::MatrixXd separated =
        Eigen::MatrixXd::Ones(parts_of(b), parts_of(b)) - Eigen::MatrixXd::Identity(parts_of(b), parts_of(b));
    for (const SC::Contact& contact : SC::structure(b).contacts)
      separated(contact.parts[0], contact.parts[1]) = separated(contact.parts[1], contact.parts[0]) = 0;
    for (const SC::Contact& contact : SC::structure(a).contacts)
      energy.edges.push_back(
          {std::min(contact.parts[0], contact.parts[1]), std::max(contact.parts[0], contact.parts[1]), separated});

    const SC::Search_result result = SC::exact_search(energy);
    const SC::Solution& best = result.solutions.front();
    std::cout << "energy " << best.energy << (result.optimal ? ", proven minimal\n" : "\n");
    for (std::size_t i = 0; i < parts_of(a); ++i)
      std::cout << SC::structure(a).parts[i].name << " -> " << SC::structure(b).parts[best.assignment[i]].name << '\n';
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
