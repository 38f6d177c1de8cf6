// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/directions.h"
#include "matching/Match_task.h"

#include <cstddef>
#include <memory>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

std::size_t index_of_turn(int quarter_turns) { return std::size_t(within_a_turn(quarter_turns)); }

} // namespace

Shared_shape Turned_shapes::aligned(int quarter_turns)
{
  const std::size_t turn = index_of_turn(quarter_turns);
  is_aligned_[turn]([&] { shapes_[turn] = std::make_shared<Deformable_shape>(align_shape(graph_, int(turn))); });
  return shapes_[turn];
}

std::shared_ptr<const Shape_features> Alignments::features(int quarter_turns, const Part_matching_options& options)
{
  const Shared_shape shape = aligned(quarter_turns);
  const std::lock_guard<std::mutex> lock(features_mutex_);
  std::shared_ptr<const Shape_features>& result = features_[index_of_turn(quarter_turns)];
  if (!result || !have_same_features(result->options, options))
    result = std::make_shared<Shape_features>(*shape, options);
  return result;
}

// The roles keep the aligned shapes from which they are predicted alive, since they may outlive the prepared shape.
Turned_roles Alignments::roles(const std::shared_ptr<const Role_model>& model)
{
  const std::lock_guard<std::mutex> lock(roles_mutex_);
  const auto [known, is_new] = roles_.try_emplace(model);
  const int given = given_quarter_turns(structure(shapes_->graph()).frame);
  for (int turn = 0; is_new && turn < int(known->second.size()); ++turn)
    known->second[std::size_t(turn)] = std::make_shared<Shape_roles>(
        [shapes = shapes_, turns = given + turn] { return role_evidence(shapes->graph(), *shapes->aligned(turns)); },
        *model);
  return known->second;
}

Alignments& internal::alignments_of(const Prepared_shape& shape) { return *shape.alignments_; }

Prepared_shape::Prepared_shape(const Structural_graph& graph)
    : graph_(graph), alignments_(std::make_shared<Alignments>(graph))
{}

void Prepared_shape::read_roles(const std::shared_ptr<const Role_model>& model) const
{
  if (!model) return;
  const auto roles = alignments_->roles(model)[0];
  for (std::size_t category = 0; category < Role_model_access::data(*model).categories.size(); ++category)
    roles->distance(category);
}

} // namespace CGAL::Shape_correspondence
