// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "roles/Boosted_trees.h"
#include "shape/Part_tree.h"

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The probability from which on a part is taken. If it is half of the F1 with which parts are found, the parts of
// greatest F1 are those for which the number of right ones, less this for each one found, is greatest.
constexpr double usual_worth_of_part = 0.45;

// Tells the parts of a model that is not divided into parts; learned from labelled shapes.
struct Part_model
{
  // Tells the parts of one category.
  struct Category
  {
    std::string name;
    Boosted_trees partness;
    double worth = usual_worth_of_part;
  };

  Boosted_trees affinity;           // probability that two nodes are of one part
  Boosted_trees partness;           // probability that a node is a part, whatever the category
  std::vector<Category> categories; // sorted by name

  bool is_empty() const { return affinity.is_empty(); }

  void write(std::ostream& out) const;
  // \return false if the bytes are not those of a model
  bool read(Stored_bytes& bytes);
};

// The candidates for parts of a surface.
std::vector<Part_node> part_candidates(const Surface_patches& surface, const Part_model& model);

// The probabilities that nodes are parts, less those from which on they are taken; copies have the same.
// \param category null: it is not known
std::vector<double> part_values(const std::vector<Part_node>& nodes, const Byte_rows& features, const Part_model& model,
                                const Part_model::Category* category);

// The likeliest parts, for the best of the four fronts: indices of nodes. \param category null: it is not known
std::vector<std::size_t> likeliest_parts(const Surface_patches& surface, const std::vector<Part_node>& nodes,
                                         const Part_model& model, const Part_model::Category* category);

// A shape whose parts are known, to learn from.
struct Part_example
{
  std::string category, source;
  Surface_patches surface;
  Eigen::MatrixXd areas; // patch × true part

  Eigen::MatrixXd areas_of(const std::vector<Part_node>& nodes) const; // node × true part
  // Share of the union of a node and a true part that is in both: node × true part.
  Eigen::MatrixXd overlaps_of(const std::vector<Part_node>& nodes) const;
};

// \param parts by object and triangle, the index of the true part
Part_example part_example(const Segmented_shape& objects, const std::vector<std::vector<std::size_t>>& parts,
                          std::string category, std::string source);

// Two parts are the same if their intersection has at least this share of the area of their union.
constexpr double same_part_overlap = 0.75;

constexpr std::size_t training_folds = 5; // folds into which sources are divided

// A number from 0 on for the fold of each source, so that folds have about as many shapes.
// \param sources by shape
std::map<std::string, std::size_t> folds_of_sources(const std::vector<std::string>& sources);

// Learns from examples. Which nodes are parts is learned on trees whose affinities have not seen the shape's source;
// what a part of a category is worth, on shapes whose source nothing has seen.
Part_model train_part_model(const std::vector<Part_example>& examples);

} // namespace CGAL::Shape_correspondence::internal
