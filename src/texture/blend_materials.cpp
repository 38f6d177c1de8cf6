// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "texture/dressed_meshes.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr int fade_steps = 5; // number of intermediate colours in an animation

class Material_painter : public Blend_painter
{
public:
  Material_painter(Glb_file& glb, const Shape_blend& blend, const Blend_appearance& appearance)
      : glb_(glb),
        materials_{Glb_materials(glb, appearance.source), Glb_materials(glb, appearance.target)},
        surfaces_(blend.surfaces())
  {
    const std::array<Segmented_shape, 2> shapes = {blend(0), blend(1)};
    const std::array<std::vector<Points>, 2> points = {blend.points(0), blend.points(1)};
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const Blend_task& task = surfaces_[i].task;
      const auto side = std::size_t(surfaces_[i].side);
      const std::size_t part = side == 0 ? task.source : task.target;
      looks_.push_back({appearance_on(shapes[side].parts()[part].mesh, materials_[side].of_part(part),
                                      {points[side][i], surfaces_[i].triangles}),
                        fade_of(task)});
    }
  }

  std::vector<Drawn_mesh> end(std::size_t side, std::size_t part, const Drawn_mesh& mesh) override
  {
    return materials_[side].dressed(mesh, part);
  }

  std::vector<double> changes(std::size_t surface) const override
  {
    std::vector<double> result;
    const Blend_task& task = surfaces_[surface].task;
    for (int step = 1; looks_[surface].fade && step < fade_steps; ++step)
      result.push_back(task.begin + step * (task.end - task.begin) / fade_steps);
    return result;
  }

  std::vector<Painted_mesh> surface(std::size_t surface, double t) override
  {
    const auto& [appearance, fade] = looks_[surface];
    return materials_[std::size_t(surfaces_[surface].side)].dressed(
        surfaces_[surface].triangles, appearance, fade ? faded(*fade, surfaces_[surface].task, t) : -1);
  }

private:
  /// The first and the last colour of a transition.
  using Fade = std::array<Eigen::Vector4d, 2>;

  struct Looks
  {
    Part_appearance appearance;
    std::optional<Fade> fade; ///< defined if the parts at both ends have a single colour
  };

  std::optional<Fade> fade_of(const Blend_task& task) const
  {
    if (task.source == Blend_task::no_part || task.target == Blend_task::no_part) return std::nullopt;
    const auto from = materials_[0].only_colour(task.source), to = materials_[1].only_colour(task.target);
    if (!from || !to || *from == *to) return std::nullopt;
    return Fade{*from, *to};
  }

  int faded(const Fade& fade, const Blend_task& task, double t)
  {
    const double f = task.end > task.begin ? std::clamp((t - task.begin) / (task.end - task.begin), 0., 1.) : t;
    const Eigen::Vector4d mixed = (1 - f) * fade[0] + f * fade[1];
    const auto [known, is_new] = faded_.emplace(std::array<double, 4>{mixed[0], mixed[1], mixed[2], mixed[3]}, 0);
    if (is_new) known->second = glb_.add_material("faded", mixed.head<3>(), mixed[3]);
    return known->second;
  }

  Glb_file& glb_;
  std::array<Glb_materials, 2> materials_;
  std::vector<Blend_surface> surfaces_;
  std::vector<Looks> looks_;
  std::map<std::array<double, 4>, int> faded_;
};

} // namespace

void write_blend_glb(std::ostream& out, const Shape_blend& blend, const Blend_appearance& appearance, int frames)
{
  Glb_file glb;
  Material_painter painter(glb, blend, appearance);
  write_blend_animation(out, blend, frames, glb, painter);
}

void write_blend_frame_glb(std::ostream& out, const Shape_blend& blend, const Blend_appearance& appearance, double t)
{
  Glb_file glb;
  Material_painter painter(glb, blend, appearance);
  write_blend_frame(out, blend, t, glb, painter);
}

} // namespace CGAL::Shape_correspondence::IO
