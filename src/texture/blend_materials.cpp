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

constexpr int fade_steps = 5; // of a colour in an animation

/// The part of a shape that a task is of.
std::size_t part_of(const Blend_task& task, std::size_t side) { return side == 0 ? task.source : task.target; }

/// Draws a blend by the materials of the shapes.
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
      const auto side = std::size_t(surfaces_[i].side);
      Looks looks{side, {}, {}};
      for (std::size_t s = 0; s < 2; ++s)
        looks.colour[s] = only_colour(s, part_of(surfaces_[i].task, s));
      const std::size_t part = part_of(surfaces_[i].task, side);
      looks.appearance = appearance_on(shapes[side].parts()[part].mesh, materials_[side].of_part(part),
                                       {points[side][i], surfaces_[i].triangles});
      looks_.push_back(std::move(looks));
    }
  }

  std::vector<Drawn_mesh> end(std::size_t side, std::size_t part, const Drawn_mesh& mesh) override
  {
    return dressed(mesh, materials_[side].of_part(part), materials_[side]);
  }

  std::vector<double> changes(std::size_t surface) const override
  {
    std::vector<double> result;
    const Blend_task& task = surfaces_[surface].task;
    for (int step = 1; fades(surface) && step < fade_steps; ++step)
      result.push_back(task.begin + step * (task.end - task.begin) / fade_steps);
    return result;
  }

  std::vector<Painted_mesh> surface(std::size_t surface, double t) override
  {
    const Looks& looks = looks_[surface];
    Glb_materials& materials = materials_[looks.side];
    return dressed_meshes(surfaces_[surface].triangles, looks.appearance, materials,
                          [&](int material, bool has_colours) {
                            return fades(surface) ? faded(surface, t) : materials(material, has_colours);
                          });
  }

private:
  struct Looks
  {
    std::size_t side;
    Part_appearance appearance;
    std::array<std::optional<Eigen::Vector4d>, 2> colour; ///< of the parts at both ends, where they have one
  };

  /// The colour of a part that is of one colour.
  std::optional<Eigen::Vector4d> only_colour(std::size_t side, std::size_t part) const
  {
    if (part == Blend_task::no_part) return std::nullopt;
    const Part_appearance& looks = materials_[side].of_part(part);
    const int material = looks.materials.empty() ? -1 : looks.materials[0];
    const auto is_other = [&](int number) { return number != material; };
    if (!looks.colours.empty() || std::any_of(looks.materials.begin(), looks.materials.end(), is_other) ||
        materials_[side].has_texture(material))
      return std::nullopt;
    return materials_[side].colour_of(material, false);
  }

  bool fades(std::size_t surface) const
  {
    const auto& colour = looks_[surface].colour;
    return colour[0] && colour[1] && *colour[0] != *colour[1];
  }

  int faded(std::size_t surface, double t)
  {
    const Blend_task& task = surfaces_[surface].task;
    const double f = task.end > task.begin ? std::clamp((t - task.begin) / (task.end - task.begin), 0., 1.) : t;
    const auto& colour = looks_[surface].colour;
    const Eigen::Vector4d mixed = (1 - f) * *colour[0] + f * *colour[1];
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
