// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/quarter_turn.h"
#include "matching/Alignments.h"

#include <cstddef>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

std::size_t index_of_turn(int quarter_turns) { return std::size_t(within_a_turn(quarter_turns)); }

} // namespace

Matching_problem::Shared_shape Prepared_shape::Alignments::aligned(int quarter_turns)
{
  const std::size_t turn = index_of_turn(quarter_turns);
  is_aligned_[turn]([&] { shapes_[turn] = std::make_shared<Deformable_shape>(align_shape(graph_, int(turn))); });
  return shapes_[turn];
}

std::shared_ptr<const Shape_features> Prepared_shape::Alignments::features(int quarter_turns,
                                                                           const Part_matching_options& options)
{
  const Matching_problem::Shared_shape shape = aligned(quarter_turns);
  const std::lock_guard<std::mutex> lock(features_mutex_);
  std::shared_ptr<const Shape_features>& result = features_[index_of_turn(quarter_turns)];
  if (!result || !are_same(result->options, options)) result = std::make_shared<Shape_features>(*shape, options);
  return result;
}

std::shared_ptr<const Shape_roles> Prepared_shape::Alignments::roles(const std::shared_ptr<const Role_model>& model,
                                                                     int quarter_turns)
{
  const std::lock_guard<std::mutex> lock(roles_mutex_);
  return roles_of(model, quarter_turns);
}

const std::shared_ptr<const Shape_roles>&
Prepared_shape::Alignments::roles_of(const std::shared_ptr<const Role_model>& model, int quarter_turns)
{
  if (role_model_ != model) {
    turned_roles_ = {};
    fronts_.clear();
  }
  role_model_ = model;
  std::shared_ptr<const Shape_roles>& result = turned_roles_[std::size_t(quarter_turns)];
  if (!result)
    result =
        std::make_shared<Shape_roles>([this, turns = given_quarter_turns(structure(graph_).frame) +
                                                     quarter_turns] { return role_evidence(graph_, *aligned(turns)); },
                                      *model);
  return result;
}

Turned_roles Prepared_shape::Alignments::roles_by_turn(const std::shared_ptr<const Role_model>& model)
{
  const std::lock_guard<std::mutex> lock(roles_mutex_);
  for (int turn = 0; turn < int(turns); ++turn)
    roles_of(model, turn);
  return turned_roles_;
}

int Prepared_shape::Alignments::front(const std::shared_ptr<const Role_model>& model, std::size_t category,
                                      const Part_matching_options& options)
{
  const std::lock_guard<std::mutex> lock(roles_mutex_);
  for (int turn = 0; turn < int(turns); ++turn)
    roles_of(model, turn);
  for (const Front& known : fronts_)
    if (known.category == category && known.clearly_better == options.clearly_better) return known.turn;
  const int turn = likely_front(turned_roles_, category, model->data().trees, options);
  fronts_.push_back({category, options.clearly_better, turn});
  return turn;
}

Prepared_shape::Prepared_shape(const Structural_graph& graph)
    : graph_(graph), alignments_(std::make_shared<Alignments>(graph))
{}

void Prepared_shape::read_roles(const std::shared_ptr<const Role_model>& model) const
{
  if (!model) return;
  const auto roles = alignments_->roles(model);
  for (std::size_t category = 0; category < model->data().categories.size(); ++category)
    roles->distance(category);
}

} // namespace CGAL::Shape_correspondence
