// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Alignments.h"

#include <cstddef>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

std::size_t index_of_turn(int quarter_turns) { return std::size_t((quarter_turns % 4 + 4) % 4); }

} // namespace

Matching_problem::Shared_shape Prepared_shape::Alignments::aligned(int quarter_turns)
{
  const std::size_t turn = index_of_turn(quarter_turns);
  std::call_once(is_aligned_[turn],
                 [&] { shapes_[turn] = std::make_shared<Deformable_shape>(align_shape(graph_, int(turn))); });
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
  if (role_model_ != model) turned_roles_ = {};
  role_model_ = model;
  std::shared_ptr<const Shape_roles>& result = turned_roles_[std::size_t(quarter_turns)];
  if (!result) result = std::make_shared<Shape_roles>(graph_, *model, quarter_turns);
  return result;
}

Turned_roles Prepared_shape::Alignments::roles_by_turn(const std::shared_ptr<const Role_model>& model)
{
  Turned_roles result;
  for (int turn = 0; turn < int(turns); ++turn)
    result[std::size_t(turn)] = roles(model, turn);
  return result;
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
