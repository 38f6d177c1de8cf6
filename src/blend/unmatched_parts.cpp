// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/quantized.h"
#include "blend/Blend_ends.h"
#include "blend/Blend_part.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Adds the parts of one end.
class Unmatched_part_adder
{
public:
  Unmatched_part_adder(const Blend_input& input, const Blend_ends& ends, int end, std::vector<Blend_part>& parts)
      : shape_(structure(input.graph)),
        quarter_turns_(input.quarter_turns),
        ends_(ends),
        end_(end),
        parts_(parts),
        states_(shape_.parts.size(), State::MISSING)
  {
    for (std::size_t part = 0; part < states_.size(); ++part)
      if (!parts_of(parts_, end_, part).empty()) states_[part] = State::THERE;
  }

  void add_layers()
  {
    while (find_next_layer()) {
      for (std::size_t part = 0; part < states_.size(); ++part)
        if (states_[part] == State::NEXT) add(part);
      std::replace(states_.begin(), states_.end(), State::NEXT, State::THERE);
    }
    for (std::size_t part = 0; part < states_.size(); ++part)
      if (states_[part] == State::MISSING) add(part);
  }

private:
  enum class State : char { MISSING, NEXT, THERE };

  /// The parts that touch those that are there. Returns whether there are any.
  bool find_next_layer()
  {
    bool any = false;
    for (const Contact& contact : shape_.contacts)
      for (std::size_t i : {0u, 1u})
        if (states_[contact.parts[1 - i]] == State::THERE && states_[contact.parts[i]] == State::MISSING) {
          states_[contact.parts[i]] = State::NEXT;
          any = true;
        }
    return any;
  }

  void add(std::size_t part)
  {
    Blend_part result;
    const std::string& name = shape_.parts[part].name;
    result.name = end_ == 0 ? name + '~' : '~' + name;
    result.task.type = end_ == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
    (end_ == 0 ? result.task.source : result.task.target) = part;
    result.attachments = attachments_of(part);
    attach_symmetrically(result, part);
    set_surface(result, part);
    result.add_trees();
    parts_.push_back(std::move(result));
  }

  /// Attaches a part like its mirror image, if it is there, or its own image on both sides.
  void attach_symmetrically(Blend_part& part, std::size_t given)
  {
    const std::size_t image = image_of(given);
    if (image == given) {
      part.image = parts_.size();
      const std::vector<Attachment> images = mirrored_attachments(part.attachments);
      part.attachments.insert(part.attachments.end(), images.begin(), images.end());
    } else if (image != Mirror_images::none) {
      const std::vector<std::size_t> made = parts_of(parts_, end_, image);
      if (made.empty() || !parts_[made[0]].unmatched) return;
      part.image = made[0];
      parts_[part.image].image = parts_.size();
      const std::vector<Attachment> images = mirrored_attachments(parts_[part.image].attachments);
      part.is_reflected = images.size() == parts_[part.image].attachments.size();
      if (part.is_reflected) part.attachments = images;
    }
  }

  void set_surface(Blend_part& part, std::size_t given)
  {
    Part_mesh mesh = ends_.meshes[std::size_t(end_)][given];
    part.attachments = without_diverging(std::move(part.attachments), box_of(mesh.points).diagonal().norm());
    if (part.is_reflected) mesh.points = mirrored(std::move(mesh.points));
    std::vector<Point> anchors;
    for (const Attachment& attachment : part.attachments)
      anchors.push_back(part.is_reflected ? mirrored(attachment.at) : attachment.at);
    part.height = mesh.points.row(1).mean();
    const Part_chart& chart = ends_.charted[std::size_t(end_)].charts[part.is_reflected ? image_of(given) : given];
    for (const Attachment& attachment : part.attachments)
      parts_[attachment.part].holds[std::size_t(attachment.surface)] = true;
    part.unmatched = std::make_shared<Unmatched_part>(chart, mesh, anchors);
  }

  std::size_t image_of(std::size_t given) const { return ends_.images[std::size_t(end_)][given]; }

  /// Where a part touches those that are there.
  std::vector<Attachment> attachments_of(std::size_t part) const
  {
    std::vector<Attachment> result;
    const auto attach = [&](std::size_t other, const Eigen::Vector2d& parameter) {
      const Point at = to_common_frame(shape_.frame, quarter_turns_, evaluate(shape_.parts[part], parameter));
      result.push_back(attachment(parts_of(parts_, end_, other), at));
    };
    for (const Contact& contact : shape_.contacts)
      for (std::size_t i : {0u, 1u}) {
        if (contact.parts[i] != part || states_[contact.parts[1 - i]] != State::THERE) continue;
        attach(contact.parts[1 - i], contact.parameters[i]);
        for (const Contact::Parameters& further : contact.further)
          attach(contact.parts[1 - i], further[i]);
      }
    return result;
  }

  /// The same on the other side of the mirror plane, as far as what they are at has a mirror image.
  std::vector<Attachment> mirrored_attachments(const std::vector<Attachment>& attachments) const
  {
    std::vector<Attachment> result;
    for (const Attachment& given : attachments)
      if (parts_[given.part].has_image()) result.push_back(attachment({parts_[given.part].image}, mirrored(given.at)));
    return result;
  }

  /// The attachment to that part which is nearest.
  Attachment attachment(const std::vector<std::size_t>& candidates, const Point& at) const
  {
    Attachment best{};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t part : candidates) {
      const int surface = parts_[part].end_surface(end_);
      const Mesh_place place = nearest_place(*parts_[part].trees[std::size_t(surface)], at);
      const Point p = place.of(parts_[part].end_points(end_), parts_[part].triangles(surface));
      if ((p - at).squaredNorm() >= least) continue;
      least = (p - at).squaredNorm();
      best = {part, surface, place, p, p};
    }
    best.vanished = vanished(best);
    return best;
  }

  /// Where an attachment is at the end that does not have what is attached.
  Point vanished(const Attachment& attachment) const
  {
    const Blend_part& part = parts_[attachment.part];
    if (part.morph)
      return attachment.place.of(part.points(attachment.surface, 1 - end_), part.triangles(attachment.surface));
    Point result = part.remaining_place(attachment.at, 0);
    for (const Attachment& on : part.attachments)
      result += (on.vanished - on.at) / double(part.attachments.size());
    return result;
  }

  const Shape_structure& shape_;
  int quarter_turns_;
  const Blend_ends& ends_;
  int end_;
  std::vector<Blend_part>& parts_;
  std::vector<State> states_; ///< by part of the end
};

} // namespace

void add_unmatched_parts(const std::array<Blend_input, 2>& inputs, const Blend_ends& ends,
                         std::vector<Blend_part>& parts)
{
  for (int end : {0, 1})
    Unmatched_part_adder(inputs[std::size_t(end)], ends, end, parts).add_layers();
}

std::vector<Attachment> without_diverging(std::vector<Attachment> attachments, double size)
{
  constexpr double most_stretch = 3; // of a distance on the part
  constexpr double near = 0.1;       // over the size: distances count as no less
  for (;;) {
    std::vector<double> strains;
    for (const Attachment& attachment : attachments) {
      double excess = 0;
      for (const Attachment& other : attachments) {
        const double before = std::max((attachment.at - other.at).norm(), near * size);
        excess += std::max(0., (attachment.vanished - other.vanished).norm() - most_stretch * before);
      }
      strains.push_back(excess * (attachment.vanished - attachment.at).norm());
    }
    const long worst = strains.empty() ? 0 : quantized(*std::max_element(strains.begin(), strains.end()));
    std::vector<Attachment> kept;
    for (std::size_t i = 0; i < attachments.size(); ++i)
      if (quantized(strains[i]) < worst) kept.push_back(attachments[i]);
    if (worst == 0 || kept.empty()) return attachments;
    attachments = std::move(kept);
  }
}

} // namespace CGAL::Shape_correspondence::internal
