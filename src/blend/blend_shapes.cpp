// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "blend/Blend_stage.h"
#include "map/check_model.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace CGAL {
namespace Shape_correspondence {
using namespace internal;

namespace {

Blend_stage::Times times_of(const Blend_schedule& schedule)
{
  Blend_stage::Times result;
  for (const Blend_task& task : schedule.tasks)
    result.push_back({task.begin, task.end});
  return result;
}

/// When each kind of task takes place.
struct Schedule_plan
{
  const char* name;
  std::array<double, 2> morph, shrink, grow;
  double from_the_ground; ///< by how much what is highest comes later than what is lowest
};

std::vector<Blend_schedule> plausible_schedules(const Blend_stage& stage)
{
  // What vanishes, or comes, may be all that holds others: it is there until contacts of the other end have come about
  static constexpr Schedule_plan plans[] = {{"all at once", {0, 1}, {0, 1}, {0, 1}, 0},
                                            {"shrink, then grow", {0, 1}, {0, 0.5}, {0.5, 1}, 0},
                                            {"one after the other", {0.25, 0.75}, {0, 0.5}, {0.5, 1}, 0},
                                            {"shrink, morph, grow", {1. / 3, 2. / 3}, {0, 1. / 3}, {2. / 3, 1}, 0},
                                            {"from the ground up", {0, 0.6}, {0, 0.5}, {0.5, 1}, 0.4}};
  std::vector<Blend_schedule> result;
  for (const Schedule_plan& plan : plans) {
    result.emplace_back();
    result.back().name = plan.name;
    for (const Blend_actor& actor : stage.actors()) {
      Blend_task task = actor.task;
      const double delay = actor.morph ? plan.from_the_ground * std::clamp(actor.height, 0., 1.) : 0;
      const auto& times = actor.morph ? plan.morph : task.type == Blend_task_type::SHRINK ? plan.shrink : plan.grow;
      task.begin = times[0] + delay;
      task.end = times[1] + delay;
      result.back().tasks.push_back(task);
    }
  }
  return result;
}

Blend_quality worst(const Blend_quality& a, const Blend_quality& b)
{
  return {std::max(a.gap, b.gap), std::max(a.apart, b.apart), std::max(a.asymmetry, b.asymmetry),
          std::max(a.ground, b.ground)};
}

std::string quoted(const Blend_stage& stage, std::size_t actor) { return '\'' + stage.actors()[actor].name + '\''; }

std::string two_digits(double value)
{
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

void add_contact_fault(const Blend_stage& stage, const Blend_scene& scene, const Blend_scene::Trees& trees,
                       std::vector<std::string>& faults)
{
  const Blend_scene::Open_contact contact = scene.widest_contact(trees);
  if (contact.gap <= Shape_blend::contact_tolerance) return;
  faults.push_back("The contact of " + quoted(stage, contact.actors[0]) + " and " + quoted(stage, contact.actors[1]) +
                   " is open by " + two_digits(contact.gap) + " of the height.");
}

void add_foot_fault(const Blend_stage& stage, const Blend_scene& scene, std::vector<std::string>& faults)
{
  const Blend_scene::Lifted_foot foot = scene.worst_foot();
  if (std::abs(foot.height) <= Shape_blend::ground_tolerance) return;
  faults.push_back("The foot of " + quoted(stage, foot.actor) + " is " + two_digits(std::abs(foot.height)) +
                   " of the height " + (foot.height > 0 ? "above" : "below") + " its place on the ground.");
}

/// \param asymmetry of the whole scene
void add_symmetry_fault(const Blend_stage& stage, const Blend_scene& scene, const Blend_scene::Trees& trees,
                        double asymmetry, std::vector<std::string>& faults)
{
  constexpr std::size_t most_named = 3;
  const double ends = std::max(stage.end_quality(0).asymmetry, stage.end_quality(1).asymmetry);
  if (asymmetry - ends <= Shape_blend::symmetry_tolerance) return;
  const std::vector<double> asymmetries = stage.asymmetries(scene, trees);
  std::vector<std::size_t> order(asymmetries.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return quantized(asymmetries[a]) > quantized(asymmetries[b]); });
  std::string where;
  for (std::size_t i = 0; i < std::min(most_named, order.size()); ++i) {
    if (asymmetries[order[i]] <= ends + Shape_blend::symmetry_tolerance) break;
    where += (i > 0 ? ", " : "") + quoted(stage, order[i]) + " by " + two_digits(asymmetries[order[i]]);
    if (stage.actors()[order[i]].twin == Mirror_twins::none) where += " (it has no mirror image)";
  }
  faults.push_back("It is farther from its mirror image than the ends by " + two_digits(asymmetry - ends) +
                   " of the height, most of all " + where + '.');
}

} // namespace

Shape_blend::Shape_blend(const Structural_graph& source, const Segmented_shape& source_shape,
                         const Structural_graph& target, const Segmented_shape& target_shape,
                         const Correspondence& correspondence, const Blend_options& options)
{
  using namespace internal;
  check_model(source, source_shape);
  check_model(target, target_shape);
  stage_ = std::make_shared<const Blend_stage>(Blend_side{source, source_shape, 0},
                                               Blend_side{target, target_shape, correspondence.target_quarter_turns},
                                               correspondence, options.contact_tolerance);
  schedules_ = plausible_schedules(*stage_);
  const double ends = std::max(stage_->end_quality(0).asymmetry, stage_->end_quality(1).asymmetry);
  std::vector<long> costs(schedules_.size(), std::numeric_limits<long>::max());
  for (std::size_t s = 0; s < schedules_.size(); ++s) {
    if (options.progress && !options.progress(double(s) / double(schedules_.size()))) break;
    const Blend_stage::Times times = times_of(schedules_[s]);
    std::vector<Blend_quality> qualities(std::size_t(options.samples));
    for_each_index<CGAL::Parallel_if_available_tag>(qualities.size(), [&](std::size_t i) {
      const double t = double(i + 1) / double(qualities.size() + 1);
      const Blend_scene scene = stage_->scene(times, t);
      qualities[i] = stage_->quality(scene, scene.trees());
    });
    Blend_quality& quality = schedules_[s].quality;
    quality = std::accumulate(qualities.begin(), qualities.end(), quality, worst);
    costs[s] = quantized(quality.gap + quality.apart + std::max(0., quality.asymmetry - ends) + quality.ground);
  }
  std::vector<std::size_t> order(schedules_.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  std::vector<Blend_schedule> ranked;
  for (std::size_t s : order)
    ranked.push_back(std::move(schedules_[s]));
  schedules_ = std::move(ranked);
}

Segmented_shape Shape_blend::operator()(double t) const
{
  if (t <= 0) return stage_->end(0);
  if (t >= 1) return stage_->end(1);
  const Blend_scene scene = stage_->scene(times_of(schedules_[0]), t);
  Segmented_shape result(stage_->end(0).name() + '~' + stage_->end(1).name(), stage_->up(t));
  for (std::size_t a = 0; a < stage_->actors().size(); ++a) {
    if (!scene.is_there(a)) continue;
    const int surface = scene.surface(a);
    result.add_part(stage_->actors()[a].name,
                    {stage_->to_world(scene.points(a, surface), t), stage_->triangles(a, surface)});
  }
  return result;
}

Blend_check Shape_blend::check(double t) const
{
  if (t <= 0 || t >= 1) return {stage_->end_quality(t <= 0 ? 0 : 1), {}};
  const Blend_scene scene = stage_->scene(times_of(schedules_[0]), t);
  const Blend_scene::Trees trees = scene.trees();
  Blend_check result{stage_->quality(scene, trees), {}};
  add_contact_fault(*stage_, scene, trees, result.faults);
  add_foot_fault(*stage_, scene, result.faults);
  add_symmetry_fault(*stage_, scene, trees, result.quality.asymmetry, result.faults);
  return result;
}

std::vector<Blend_surface> Shape_blend::surfaces() const
{
  std::vector<Blend_surface> result;
  for (std::size_t a = 0; a < stage_->actors().size(); ++a) {
    const Blend_actor& actor = stage_->actors()[a];
    const Blend_task& task = schedules_[0].tasks[a];
    if (!actor.morph) {
      const bool shrinks = task.type == Blend_task_type::SHRINK;
      result.push_back({actor.name, task, stage_->triangles(a, 0), shrinks ? 0 : task.begin, shrinks ? task.end : 1});
      continue;
    }
    const double change = actor.morph->switch_time();
    const double at = change <= 0 ? 0 : change >= 1 ? 1 : task.begin + change * (task.end - task.begin);
    result.push_back({actor.name, task, stage_->triangles(a, 0), 0, at});
    result.push_back({actor.name, task, stage_->triangles(a, 1), at, 1});
  }
  return result;
}

std::vector<Points> Shape_blend::points(double t) const
{
  std::vector<Points> result;
  const Blend_scene scene = stage_->scene(times_of(schedules_[0]), t);
  for (std::size_t a = 0; a < stage_->actors().size(); ++a)
    for (int surface = 0; surface < (stage_->actors()[a].morph ? 2 : 1); ++surface)
      result.push_back(stage_->to_world(scene.points(a, surface), t));
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL
