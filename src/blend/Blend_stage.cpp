// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_stage.h"

#include "base/quantized.h"
#include "base/quarter_turn.h"
#include "blend/surface_components.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

bool is_mirrored_in_x(const Blend_input& input)
{
  const Shape_frame& frame = structure(input.graph).frame;
  return input.quarter_turns % 2 == 0 ? frame.mirror_x : frame.mirror_z;
}

contacts::Box box_in_frame(const Blend_input& input, const Shape_frame& frame)
{
  contacts::Box box;
  for (const Shape_part& part : input.shape.parts()) {
    const Points local = to_common_frame(frame, input.quarter_turns, part.mesh.points);
    box.extend(contacts::Box(local.rowwise().minCoeff(), local.rowwise().maxCoeff()));
  }
  return box;
}

/// The frame of the stage: the surface itself, not samples of it, is what stands, is in the middle and has a height.
Shape_frame staged_frame(const Blend_input& input)
{
  constexpr double upright = 0.5; // a shape that is flatter keeps the height that its frame says
  Shape_frame frame = structure(input.graph).frame;
  const contacts::Box box = box_in_frame(input, frame);
  Point origin(is_mirrored_in_x(input) ? 0 : box.center().x(), box.min().y(), box.center().z());
  frame.origin += frame.axes * quarter_turn(input.quarter_turns).transpose() * (frame.height * origin);
  if (box.sizes().y() > upright) frame.height *= box.sizes().y();
  return frame;
}

Segmented_shape moved(const Segmented_shape& shape, const Point& up, const Shape_frame& frame,
                      const Eigen::Matrix3d& rotation, double scale)
{
  const bool is_turned = !rotation.isIdentity(1e-12); // otherwise, not by rounding either
  Segmented_shape result(shape.name(), up);
  for (const Shape_part& part : shape.parts()) {
    Points points = part.mesh.points.colwise() - frame.origin;
    if (is_turned) points = rotation * points;
    if (scale != 1) points *= scale;
    result.add_part(part.name, {std::move(points), part.mesh.triangles});
  }
  return result;
}

} // namespace

Blend_stage::Blend_stage(const std::array<Blend_input, 2>& inputs)
    : graphs{inputs[0].graph, inputs[1].graph}, quarter_turns_{inputs[0].quarter_turns, inputs[1].quarter_turns}
{
  for (std::size_t end : {0u, 1u}) {
    structure(graphs[end]).frame = staged_frame(inputs[end]);
    add(inputs[end], end);
    are_symmetric = are_symmetric && is_mirrored_in_x(inputs[end]);
  }
  for (std::size_t end : {0u, 1u})
    images[end] = are_symmetric ? mirror_images(meshes[end]) : Mirror_images(meshes[end].size());
}

void Blend_stage::add(const Blend_input& input, std::size_t end)
{
  std::vector<const Points*> surfaces;
  for (const Shape_part& part : input.shape.parts())
    surfaces.push_back(&part.mesh.points);
  charted[end] = charted_shape(graphs[end], input.quarter_turns, surfaces);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    meshes[end].push_back({charted[end].surfaces[i], input.shape.parts()[i].mesh.triangles});
  boxes[end] = box_in_frame(input, structure(graphs[end]).frame);
  widest_gap[end] = internal::widest_gap(pointers_to(trees_of(meshes[end])));
}

Points Blend_stage::to_stage(int end, const Points& given) const
{
  const auto e = std::size_t(end);
  return to_common_frame(structure(graphs[e]).frame, quarter_turns_[e], given);
}

std::array<double, 2> Blend_stage::heights(Blend_size size) const
{
  const std::array<double, 2> given = {structure(graphs[0]).frame.height, structure(graphs[1]).frame.height};
  switch (size) {
  case Blend_size::SOURCE:
    return {given[0], given[0]};
  case Blend_size::TARGET:
    return {given[1], given[1]};
  case Blend_size::SAME:
    return {1, 1};
  default:
    return given;
  }
}

std::array<Segmented_shape, 2> Blend_stage::moved_shapes(const std::array<Blend_input, 2>& inputs,
                                                         Blend_size size) const
{
  const Shape_frame &from = structure(graphs[0]).frame, &to = structure(graphs[1]).frame;
  const std::array<double, 2> asked = heights(size);
  const Eigen::Matrix3d rotation = from.axes * quarter_turn(inputs[1].quarter_turns) * to.axes.transpose();
  const Point up = inputs[0].shape.up();
  return {moved(inputs[0].shape, up, from, Eigen::Matrix3d::Identity(), asked[0] / from.height),
          moved(inputs[1].shape, up, to, rotation, asked[1] / to.height)};
}

std::vector<Point> Blend_stage::places_of(int end, const Contact& contact) const
{
  const Shape_structure& shape = structure(graphs[std::size_t(end)]);
  std::vector<Point> result;
  const auto add = [&](const Contact::Parameters& parameters) {
    Point sum = Point::Zero();
    for (std::size_t i : {0u, 1u}) {
      const Point on_part = evaluate(shape.parts[contact.parts[i]], parameters[i]);
      sum += to_stage(end, on_part);
    }
    result.push_back(sum / 2);
  };
  add(contact.parameters);
  for (const Contact::Parameters& further : contact.further)
    add(further);
  const auto key = [](const Point& p) { return std::tuple(quantized(p.x()), quantized(p.y()), quantized(p.z())); };
  std::sort(result.begin(), result.end(), [&](const Point& p, const Point& q) { return key(p) < key(q); });
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
