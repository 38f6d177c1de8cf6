// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Point_map.h"
#include "texture/Looks_sampler.h"
#include "texture/bake.h"
#include "texture/neighbours.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <algorithm>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr int smoothing_rounds_of_labels = 3;

void check_option(const std::string& name, int value, int least, int most)
{
  if (value < least || value > most)
    throw Invalid_input(name + " of a texture must be between " + std::to_string(least) + " and " +
                        std::to_string(most));
}

/// A transfer under way: where the pixels are, and what parts get.
class Transfer
{
public:
  Transfer(const Structural_graph& source, const Segmented_shape& source_shape, const Structural_graph& target,
           const Segmented_shape& target_shape, const Shape_appearance& target_appearance,
           const Correspondence& correspondence, const Transfer_options& options)
      : map_(source, source_shape, target, target_shape, correspondence),
        target_looks_(target_appearance, options.neutral),
        options_(options)
  {
    check_option("the size", options.size, 16, 8192);
    check_option("the margin", options.margin, 1, 64);
    check_option("the samples", options.samples, 1, 8);
    std::optional<Texture_layout> given;
    if (!options.new_coordinates) given = given_layout(target_shape, target_appearance, options.size);
    result_.has_given_coordinates = given.has_value();
    layout_ = given ? std::move(*given)
                    : new_layout(target_shape, structure(target).frame.axes, options.size, options.margin);
    result_.parts.resize(target_shape.parts().size());
    for (std::size_t part = 0; part < result_.parts.size(); ++part)
      result_.parts[part].sources = map_.sources(part);
  }

  const Point_map& map() const { return map_; }
  Transferred_part& part(std::size_t number) { return result_.parts[number]; }

  /// \param has_looks whether parts of the source have \param colour of a place on the source
  template <typename Has_looks, typename Colour>
  void paint(const Has_looks& has_looks, const Colour& colour)
  {
    for (std::size_t i = 0; i < result_.parts.size(); ++i) {
      Transferred_part& part = result_.parts[i];
      if (std::any_of(part.sources.begin(), part.sources.end(), has_looks))
        part.origin = Looks_origin::SOURCE;
      else if (target_looks_.is_known(i))
        part.origin = Looks_origin::TARGET;
    }
    const auto colour_of_point = [&](std::size_t part, std::size_t triangle, const Eigen::Vector3d& weights) {
      switch (result_.parts[part].origin) {
      case Looks_origin::SOURCE:
        return colour(map_(part, Eigen::Index(triangle), weights));
      case Looks_origin::TARGET:
        return target_looks_(part, triangle, weights);
      default:
        return options_.neutral;
      }
    };
    Texture texture{"transferred", "", {}, Texture_wrap::CLAMP, Texture_wrap::CLAMP};
    texture.image = bake(layout_, options_.size, options_.margin, options_.samples, options_.neutral, colour_of_point);
    Shape_appearance& looks = result_.appearance;
    looks.textures.push_back(std::move(texture));
    looks.materials.push_back({"transferred", Eigen::Vector4d::Ones(), 0});
    for (const std::vector<Flat_triangle>& triangles : layout_) {
      Part_appearance part;
      part.materials.assign(triangles.size(), 0);
      for (const Flat_triangle& triangle : triangles)
        for (const Eigen::Vector2d& corner : triangle)
          part.coordinates.push_back((corner / options_.size).cast<float>());
      looks.parts.push_back(std::move(part));
    }
  }

  Transferred_appearance result() { return std::move(result_); }

private:
  Point_map map_;
  Looks_sampler target_looks_;
  const Transfer_options& options_;
  Texture_layout layout_;
  Transferred_appearance result_;
};

/// The label that most of a triangle is mapped to.
int label_of_triangle(const Point_map& map, const std::vector<int>& labels, std::size_t part, Eigen::Index triangle)
{
  std::map<int, double> votes;
  for (int corner = -1; corner < 3; ++corner) {
    Eigen::Vector3d weights = Eigen::Vector3d::Constant(corner < 0 ? 1. / 3 : 1. / 6);
    if (corner >= 0) weights[corner] = 2. / 3;
    for (const Weighted_place& place : map(part, triangle, weights))
      votes[labels[place.part]] += place.share;
  }
  return std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// Gives triangles the label of most of their neighbours.
void smooth(const Part_mesh& mesh, std::vector<int>& labels)
{
  const std::vector<std::vector<int>> neighbours = neighbours_of(mesh);
  for (int round = 0; round < smoothing_rounds_of_labels; ++round) {
    const std::vector<int> before = labels;
    for (std::size_t t = 0; t < labels.size(); ++t)
      for (int neighbour : neighbours[t]) {
        const int label = before[std::size_t(neighbour)];
        const auto has_it = [&](int other) { return before[std::size_t(other)] == label; };
        if (std::count_if(neighbours[t].begin(), neighbours[t].end(), has_it) >= 2) labels[t] = label;
      }
  }
}

} // namespace

Transferred_appearance transfer_appearance(const Structural_graph& source, const Segmented_shape& source_shape,
                                           const Shape_appearance& source_appearance, const Structural_graph& target,
                                           const Segmented_shape& target_shape,
                                           const Shape_appearance& target_appearance,
                                           const Correspondence& correspondence, const Transfer_options& options)
{
  if (source_appearance.empty())
    throw Invalid_input(source_shape.name() + ": it has no materials, textures or colours to transfer");
  Transfer transfer(source, source_shape, target, target_shape, target_appearance, correspondence, options);
  const Looks_sampler looks(source_appearance, options.neutral);
  transfer.paint([&](std::size_t part) { return looks.is_known(part); },
                 [&](const std::vector<Weighted_place>& places) {
                   Eigen::Vector3d sum = Eigen::Vector3d::Zero();
                   for (const Weighted_place& place : places)
                     sum += place.share * looks(place.part, std::size_t(place.triangle), place.weights);
                   return sum;
                 });
  return transfer.result();
}

Transferred_appearance transfer_labels(const Structural_graph& source, const Segmented_shape& source_shape,
                                       const std::vector<int>& labels, const std::vector<Eigen::Vector3d>& colours,
                                       const Structural_graph& target, const Segmented_shape& target_shape,
                                       const Shape_appearance& target_appearance, const Correspondence& correspondence,
                                       const Transfer_options& options)
{
  if (labels.size() != source_shape.parts().size())
    throw Invalid_input(source_shape.name() + ": there are labels of " + std::to_string(labels.size()) +
                        " parts; it has " + std::to_string(source_shape.parts().size()));
  for (int label : labels)
    if (label < 0 || std::size_t(label) >= colours.size())
      throw Invalid_input(source_shape.name() + ": there is no colour for label " + std::to_string(label));
  Transfer transfer(source, source_shape, target, target_shape, target_appearance, correspondence, options);
  for (std::size_t part = 0; part < target_shape.parts().size(); ++part) {
    const Part_mesh& mesh = target_shape.parts()[part].mesh;
    std::vector<int>& of_triangles = transfer.part(part).labels;
    of_triangles.assign(std::size_t(mesh.triangles.cols()), -1);
    if (transfer.part(part).sources.empty()) continue;
    for (std::size_t t = 0; t < of_triangles.size(); ++t)
      of_triangles[t] = label_of_triangle(transfer.map(), labels, part, Eigen::Index(t));
    smooth(mesh, of_triangles);
  }
  transfer.paint(
      [](std::size_t) { return true; },
      [&](const std::vector<Weighted_place>& places) { return colours[std::size_t(labels[places[0].part])]; });
  return transfer.result();
}

} // namespace CGAL::Shape_correspondence
