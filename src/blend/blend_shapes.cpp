// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/schedules.h"
#include "map/Piece_pair.h"
#include "matching/check_correspondence.h"
#include "matching/unlikely_pairs.h"
#include "shape/sample_triangles.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

void check_options(const Blend_options& options)
{
  constexpr int most_samples = 1000;
  if (options.samples < 1) throw Invalid_input("Shape_blend: at least one sample is needed to judge schedules");
  if (options.samples > most_samples)
    throw Invalid_input("Shape_blend: schedules are judged by at most " + std::to_string(most_samples) + " samples");
  if (!(options.min_confidence >= 0 && options.min_confidence <= 1))
    throw Invalid_input("Shape_blend: the least confidence must be between 0 and 1");
  if (!(options.contact_tolerance >= 0 && options.contact_tolerance <= 1))
    throw Invalid_input("Shape_blend: the contact tolerance must be between 0 and 1");
}

void check_time(double t)
{
  if (std::isnan(t)) throw Invalid_input("Shape_blend: the time is not a number; give one between 0 and 1");
}

} // namespace

Shape_blend::Shape_blend(const Structural_graph& source, const Segmented_shape& source_shape,
                         const Structural_graph& target, const Segmented_shape& target_shape,
                         const Correspondence& correspondence, const Blend_options& options)
{
  check_model(source, source_shape);
  check_model(target, target_shape);
  const std::array<Blend_input, 2> inputs = {Blend_input{source, source_shape, 0},
                                             Blend_input{target, target_shape, correspondence.target_quarter_turns}};
  check_options(options);
  check_correspondence("Shape_blend", correspondence, source_shape.parts().size(), target_shape.parts().size());
  Correspondence likely = correspondence;
  remove_unlikely_pairs(likely, options.min_confidence);
  blend_ = std::make_shared<const Blend_structure>(inputs, likely, options);
  schedules_ = ranked_schedules(*blend_, options);
  if (options.schedule.empty()) return;
  const auto is_other = [&](const Blend_schedule& schedule) { return schedule.name != options.schedule; };
  schedules_.erase(std::remove_if(schedules_.begin(), schedules_.end(), is_other), schedules_.end());
  if (schedules_.empty())
    throw Invalid_input("Shape_blend: there is no schedule '" + options.schedule +
                        "'; give one of schedule_names(), or none");
}

std::vector<std::string> Shape_blend::schedule_names() { return {"in two steps", "at one time"}; }

std::vector<Shape_blend> Shape_blend::different_blends() const
{
  std::vector<Shape_blend> result;
  for (const Blend_schedule& schedule : schedules_) {
    // There are at most two distinct schedules
    if (!result.empty() && have_same_times(schedule.tasks, schedules_[0].tasks)) continue;
    result.push_back(*this);
    result.back().schedules_ = {schedule};
  }
  return result;
}

Segmented_shape Shape_blend::operator()(double t) const
{
  check_time(t);
  const auto& [source, target] = blend_->stage.shapes;
  if (t <= 0) return source;
  if (t >= 1) return target;
  const In_between_shape shape(*blend_, schedules_[0].tasks, t);
  Segmented_shape result(source.name() + '~' + target.name(), source.up());
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    if (!shape.is_there(i)) continue;
    const Blend_part& part = blend_->parts[i];
    const Part_mesh mesh = {blend_->stage.to_world(shape.points[i], t), part.triangles(shape.surfaces[i])};
    if (has_area(mesh)) result.add_part(part.name, mesh);
  }
  return result;
}

Blend_quality Shape_blend::quality(double t) const
{
  check_time(t);
  if (t <= 0 || t >= 1) return {};
  return In_between_shape(*blend_, schedules_[0].tasks, t).quality();
}

std::vector<Blend_surface> Shape_blend::surfaces() const
{
  std::vector<Blend_surface> result;
  for (std::size_t i = 0; i < blend_->parts.size(); ++i) {
    const Blend_part& part = blend_->parts[i];
    const Blend_task& task = schedules_[0].tasks[i];
    for (int surface = 0; surface < part.number_of_surfaces(); ++surface) {
      const int side = part.is_matched() ? surface : part.end();
      const double change = part.is_matched() ? Part_morph::change : side == 0 ? task.end : task.begin;
      result.push_back(
          {part.name, task, part.triangles(surface), side == 0 ? 0 : change, side == 0 ? change : 1, side});
    }
  }
  return result;
}

std::vector<Points> Shape_blend::points(double t) const
{
  check_time(t);
  std::vector<Points> result;
  const In_between_shape shape(*blend_, schedules_[0].tasks, t);
  for (std::size_t part = 0; part < blend_->parts.size(); ++part)
    for (int surface = 0; surface < blend_->parts[part].number_of_surfaces(); ++surface)
      result.push_back(blend_->stage.to_world(shape.points_of(part, surface), t));
  return result;
}

} // namespace CGAL::Shape_correspondence
