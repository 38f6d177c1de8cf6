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

// Least probability of a part that is worth taking: parts are chosen so that the sum of (probability - worth) is
// greatest. If the worth is half of the F1 that is reached, this also gives the greatest F1.
constexpr double usual_worth_of_part = 0.45;

// Divides models into parts, as learned from labelled shapes. A node (`Part_node`) is a patch or a union of patches.
struct Part_model
{
  // What was learned about the parts of one category.
  struct Category
  {
    std::string name;
    Boosted_trees partness; // probability that a node is a part
    double worth = usual_worth_of_part;
  };

  Boosted_trees affinity;           // probability that two nodes belong to one part
  Boosted_trees partness;           // probability that a node is a part, whatever the category
  std::vector<Category> categories; // sorted by name

  bool is_empty() const { return affinity.is_empty(); }

  void write(std::ostream& out) const;
  // Reads what `write()` has written. \return false if the bytes are not those of a model
  bool read(Stored_bytes& bytes);
};

// The candidates for parts of a surface: patches, and unions of them in the order of their affinity.
std::vector<Part_node> part_candidates(const Surface_patches& surface, const Part_model& model);

// For each node, the probability that it is a part, averaged over the nodes of the same form, less the worth of a part.
// \param category null if it is not known
std::vector<double> part_values(const std::vector<Part_node>& nodes, const Byte_rows& features, const Part_model& model,
                                const Part_model::Category* category);

// Indices of the likeliest parts: the nodes, with each patch in one of them, that have the greatest sum of part values,
// for the best of four possible fronts of the shape. \param category null if it is not known
std::vector<std::size_t> likeliest_parts(const Surface_patches& surface, const std::vector<Part_node>& nodes,
                                         const Part_model& model, const Part_model::Category* category);

// A shape whose true parts are known, to learn from.
struct Part_example
{
  std::string category, source; // source: where the shape is from, such as a pack of models
  Surface_patches surface;
  Eigen::MatrixXd areas; // areas of patches in true parts: patch × true part

  Eigen::MatrixXd areas_of(const std::vector<Part_node>& nodes) const; // the same for nodes
  // Intersection over union, by area, of each node with each true part: node × true part.
  Eigen::MatrixXd overlaps_of(const std::vector<Part_node>& nodes) const;
};

// \param parts indexed by object and triangle: index of the true part
Part_example part_example(const Segmented_shape& objects, const std::vector<std::vector<std::size_t>>& parts,
                          std::string category, std::string source);

// Two parts are the same if their intersection has at least this share of the area of their union.
constexpr double same_part_overlap = 0.75;

constexpr std::size_t training_folds = 5; // number of folds into which sources are divided for cross-validation

// The fold, from 0 on, of each source of shapes; all folds have about equally many shapes.
// \param sources `Part_example::source`, indexed by shape
std::map<std::string, std::size_t> folds_of_sources(const std::vector<std::string>& sources);

// Learns from examples, with cross-validation over the folds of sources: `partness` is learned from trees of nodes that
// were built by affinities learned from other folds than the shape's, and `worth` is chosen on shapes for which both
// affinities and probabilities were learned from other folds.
Part_model train_part_model(const std::vector<Part_example>& examples);

} // namespace CGAL::Shape_correspondence::internal
