// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Pair_validator.h"
#include "base/for_each_index.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <memory>
#include <numeric>
#include <random>
#include <utility>
#include <variant>

namespace CGAL::Shape_correspondence::internal {

namespace {

bool is_in(const Validation_pair& pair, std::size_t shape) { return shape == pair[0] || shape == pair[1]; }

// Leaves of the shapes at most so many, drawn by the number of the pair.
void draw(std::vector<std::size_t>& shapes, std::size_t count, std::uint64_t pair)
{
  std::mt19937_64 random(pair); // the same numbers on all machines
  for (std::size_t i = 0; i < shapes.size(); ++i)
    std::swap(shapes[i], shapes[i + std::size_t(random() % (shapes.size() - i))]);
  if (shapes.size() > count) shapes.resize(count);
}

std::vector<char> left_out_shapes(const std::vector<Validation_shape>& shapes, const Validation_pair& pair,
                                  std::size_t number_of_pair, const Validation_options& options)
{
  std::vector<char> result(shapes.size(), 0);
  std::vector<std::size_t> examples;
  for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
    const bool same_category = shapes[shape].labelled.category == shapes[pair[0]].labelled.category;
    const bool same_source = options.left_out == Left_out::SOURCES && (shapes[shape].source == shapes[pair[0]].source ||
                                                                       shapes[shape].source == shapes[pair[1]].source);
    const bool is_example = same_category && !shapes[shape].is_generated && !same_source && !is_in(pair, shape);
    if (is_example) examples.push_back(shape);
    result[shape] = is_in(pair, shape) || same_source || (options.left_out == Left_out::CATEGORY && same_category) ||
                    (options.examples && is_example);
  }
  if (!options.examples) return result;
  draw(examples, *options.examples, number_of_pair);
  for (std::size_t shape : examples)
    result[shape] = 0;
  return result;
}

std::vector<std::size_t> indices_of(const Eigen::MatrixXi& votes)
{
  std::vector<std::size_t> result(std::size_t(votes.rows()));
  std::iota(result.begin(), result.end(), std::size_t(0));
  return result;
}

Pair_terms role_terms(const Role_votes& source, const Role_votes& target)
{
  return role_terms(source, indices_of(source.roles), target, indices_of(target.roles));
}

// The graph turned about the up axis, as if its meshes had been.
Structural_graph turned(Structural_graph graph, double angle)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point::UnitY()).toRotationMatrix();
  Shape_structure& shape = structure(graph);
  for (Part_abstraction& part : shape.parts) {
    part.surface = (turn * part.surface).eval();
    std::visit([&](auto& geometry) { geometry.points = (turn * geometry.points).eval(); }, part.geometry);
  }
  shape.frame.axes = turn * shape.frame.axes;
  shape.frame.origin = turn * shape.frame.origin;
  for (std::size_t group = 0; group < num_vertices(graph); ++group) {
    Symmetry& symmetry = graph[group].symmetry;
    symmetry.point = (turn * symmetry.point).eval();
    symmetry.direction = (turn * symmetry.direction).eval();
  }
  return graph;
}

// The pairs of least energy. \param role_costs empty: without roles
std::vector<Part_correspondence> pairs_of_least_energy(const Labelled_graph& source, const Labelled_graph& target,
                                                       double role_weight, Eigen::MatrixXd role_costs)
{
  Search_options options;
  options.method = Search_method::EXACT;
  options.matching.weights.roles = role_weight;
  options.matching.role_costs = std::move(role_costs);
  return find_correspondence(*source.graph, *target.graph, options).pairs;
}

void count_front(const std::vector<int>& turns, Front_count& fronts)
{
  const bool is_possible = turns.front() == 0;
  ++fronts.shapes;
  fronts.possible += is_possible;
  fronts.sure += is_possible && turns.size() == 1;
}

} // namespace

Pair_validator::Pair_validator(const std::vector<Validation_shape>& shapes, const std::vector<Labelled_graph>& labelled,
                               const Role_training_options& options)
    : shapes_(shapes), trainer_(labelled, options), all_(trainer_.model()), turned_(shapes.size())
{}

std::vector<Pair_evidence> Pair_validator::run(const std::vector<Validation_pair>& pairs,
                                               const Validation_options& options)
{
  for (const Validation_pair& pair : pairs)
    for (std::size_t end : pair)
      for (int turn = int(turned_[end].size()); turn < 4; ++turn)
        turned_[end].push_back(role_evidence(*shapes_[end].labelled.graph, turn));
  std::vector<Pair_evidence> result(pairs.size());
  for_each_index(pairs.size(), true, [&](std::size_t i) { result[i] = evidence(pairs[i], i, options); });
  return result;
}

Turned_match Pair_validator::turned_match(const Validation_pair& pair, std::size_t number,
                                          const Validation_options& options, const Part_matching_options& parts,
                                          const Pair_weights& weights, const Confidence_weights& confidence) const
{
  auto [told, data] = left_out_model(pair, number, options);
  for (Category_roles& category : data.categories) {
    category.weights = weights;
    category.confidence = confidence;
  }
  std::mt19937_64 random(number); // the same numbers on all machines
  const auto any = [&](std::size_t shape) {
    const double share = double(random() >> 11) / double(1ull << 53);
    const double turns = options.turns == Validation_turns::ANY ? share : std::floor(4 * share) / 4;
    const Structural_graph& graph = *shapes_[shape].labelled.graph;
    return options.turns == Validation_turns::NONE ? graph : turned(graph, 2 * double(EIGEN_PI) * turns);
  };
  const Structural_graph source = any(pair[0]), target = any(pair[1]);
  Search_options search;
  search.alignments = options.fronts == Validation_fronts::AUTO ? 0 : 1;
  search.front_is_sure = options.fronts == Validation_fronts::GIVEN;
  search.parts = parts;
  Turned_match result;
  result.without_roles = find_correspondence(source, target, search).pairs;
  if (options.category_is_told && told < data.categories.size()) search.category = data.categories[told].name;
  search.roles = std::make_shared<const Role_model>(std::move(data));
  const Correspondence found = find_correspondence(source, target, search);
  result.with_roles = found.pairs;
  result.category = found.category;
  return result;
}

std::pair<std::size_t, Role_model_data> Pair_validator::left_out_model(const Validation_pair& pair, std::size_t number,
                                                                       const Validation_options& options) const
{
  Role_model_data data = all_;
  const std::string& category = shapes_[pair[0]].labelled.category;
  const std::size_t own = data.index(category);
  data.categories[own] = trainer_.category(category, left_out_shapes(shapes_, pair, number, options));
  if (data.categories[own].roles.empty()) data.categories.erase(data.categories.begin() + std::ptrdiff_t(own));
  return {data.index(category), std::move(data)};
}

Turned_roles Pair_validator::turned_roles(std::size_t shape, const Role_model& model) const
{
  Turned_roles result;
  for (std::size_t turn = 0; turn < result.size(); ++turn)
    result[turn] = std::make_shared<Shape_roles>(turned_[shape][turn], model);
  return result;
}

Pair_evidence Pair_validator::evidence(const Validation_pair& pair, std::size_t number,
                                       const Validation_options& options) const
{
  const Labelled_graph &source = shapes_[pair[0]].labelled, &target = shapes_[pair[1]].labelled;
  auto [told, data] = left_out_model(pair, number, options);
  const Role_model model(std::move(data));
  const Turned_roles a = turned_roles(pair[0], model), b = turned_roles(pair[1], model);
  const Pair_category of_pair = category_of_pair(*a[0], *b[0], model.data());
  const std::size_t none = model.data().categories.size(), category = options.category_is_told ? told : of_pair.index;
  Pair_evidence result;
  result.truth = ground_truth(source.labels, target.labels);
  result.target_size = target.labels.size();
  if (of_pair.nearest < none) result.nearest = model.data().categories[of_pair.nearest].name;
  const auto terms = [&](std::size_t of_category) {
    return role_terms(a[0]->votes(of_category), b[0]->votes(of_category));
  };
  if (told < none) {
    result.told = terms(told);
    for (const Turned_roles* shape : {&a, &b})
      count_front(front_turns(*shape, told, model.data().trees), result.fronts);
  }
  if (options.role_weight > 0)
    for (std::size_t with : {0u, 1u}) {
      Eigen::MatrixXd role_costs;
      if (with == 1 && category < none)
        role_costs = 1 - agreement_of_votes(a[0]->votes(category), b[0]->votes(category)).array();
      result.least_energy[with] = pairs_of_least_energy(source, target, options.role_weight, std::move(role_costs));
    }
  if (category == none) return result;
  result.category = model.data().categories[category].name;
  result.found = category == told ? result.told : terms(category);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
