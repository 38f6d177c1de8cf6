// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/quantized.h"
#include "io/read/model_parts.h"
#include "map/Charted_mesh.h"
#include "map/Piece_pair.h"
#include "shape/sample_triangles.h"
#include "shape/triangles_below.h"
#include "texture/textures.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

void check_option(const std::string& name, int value, int least, int most)
{
  if (value < least || value > most)
    throw Invalid_input(name + " of a texture must be between " + std::to_string(least) + " and " +
                        std::to_string(most));
}

std::vector<Steps> sizes_of_parts(const Segmented_shape& shape)
{
  std::vector<double> areas;
  for (const Shape_part& part : shape.parts())
    areas.push_back(contacts::total_area(contacts::sampled_triangles_of(part.mesh)));
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.);
  std::vector<Steps> result;
  for (double area : areas)
    result.push_back(quantized(area / whole));
  return result;
}

/// A transfer in progress: the layout of the target and the appearance of its parts.
class Transfer
{
public:
  Transfer(const Structural_graph& source, const Segmented_shape& source_shape, const Structural_graph& target,
           const Segmented_shape& target_shape, const Shape_appearance& target_appearance,
           const Correspondence& correspondence, const Transfer_options& options)
      : map_(source, source_shape, target, target_shape, correspondence),
        target_appearance_(target_appearance),
        target_sampler_(target_appearance, options.neutral),
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
  std::vector<Transferred_part>& parts() { return result_.parts; }

  /// Gives target parts the appearance of their largest source part that has one; of several about as large, of the one
  /// that reaches highest.
  void take_from_sources(const Segmented_shape& source, const Shape_frame& frame, const Appearance_sampler& looks)
  {
    constexpr double about_as_large = 0.8;
    const std::vector<Steps> sizes = sizes_of_parts(source);
    std::vector<Steps> tops;
    for (const Shape_part& part : source.parts())
      tops.push_back(quantized(frame.to_frame(part.mesh.points).row(1).maxCoeff()));
    for (Transferred_part& part : result_.parts) {
      std::vector<std::size_t>& from = part.sources;
      const auto end =
          std::stable_partition(from.begin(), from.end(), [&](std::size_t s) { return looks.is_known(s); });
      if (end == from.begin()) continue;
      part.origin = Appearance_origin::SOURCE;
      std::stable_sort(from.begin(), end, [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
      const auto smaller = std::find_if(
          from.begin(), end, [&](std::size_t s) { return double(sizes[s]) < about_as_large * double(sizes[from[0]]); });
      std::stable_sort(from.begin(), smaller, [&](std::size_t a, std::size_t b) { return tops[a] > tops[b]; });
    }
  }

  /// Gives each part without an appearance from the source that of the largest part it touches that has one, in rounds.
  void take_from_neighbours(const std::vector<Contact>& contacts, const Segmented_shape& target)
  {
    const std::vector<Steps> sizes = sizes_of_parts(target);
    const auto is_larger = [&](std::size_t a, std::size_t b) {
      return sizes[a] > sizes[b] || (sizes[a] == sizes[b] && a < b);
    };
    std::map<std::size_t, std::size_t> found; // for each part, the chosen neighbour in this round
    do {
      found.clear();
      for (const Contact& contact : contacts)
        for (const auto& [part, other] :
             {std::pair(contact.parts[0], contact.parts[1]), std::pair(contact.parts[1], contact.parts[0])}) {
          if (result_.parts[part].origin != Appearance_origin::NEUTRAL ||
              result_.parts[other].origin == Appearance_origin::NEUTRAL || !may_look_like(part, other))
            continue;
          std::size_t& best = found.emplace(part, other).first->second;
          if (is_larger(other, best)) best = other;
        }
      for (const auto& [part, other] : found) {
        result_.parts[part].origin = Appearance_origin::NEIGHBOUR;
        result_.parts[part].neighbour = other;
      }
    } while (!found.empty());
  }

  /// Paints the target part by part with the colours of locations on the source.
  template <typename Colour>
  void paint(const Colour& colour)
  {
    for (std::size_t i = 0; i < result_.parts.size(); ++i)
      if (Appearance_origin& origin = result_.parts[i].origin;
          origin == Appearance_origin::NEUTRAL && target_sampler_.is_known(i))
        origin = Appearance_origin::TARGET;
    const auto colour_of_point = [&](std::size_t part, std::size_t triangle, const Eigen::Vector3d& weights) {
      const Appearance_origin origin = result_.parts[part].origin;
      if (origin == Appearance_origin::TARGET) return target_sampler_(part, triangle, weights);
      return origin == Appearance_origin::NEUTRAL ? options_.neutral : colour(part, Eigen::Index(triangle), weights);
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
  /// Whether a part may take the appearance of another one: they share a material, or it has no own appearance to keep.
  bool may_look_like(std::size_t part, std::size_t other) const
  {
    if (!target_sampler_.is_known(part)) return true;
    const std::vector<int>&own = target_appearance_.parts[part].materials,
          &others = target_appearance_.parts[other].materials;
    return std::any_of(own.begin(), own.end(), [&](int material) {
      return material >= 0 && std::find(others.begin(), others.end(), material) != others.end();
    });
  }

  Point_map map_;
  const Shape_appearance& target_appearance_;
  Appearance_sampler target_sampler_;
  const Transfer_options& options_;
  Texture_layout layout_;
  Transferred_appearance result_;
};

int label_of_triangle(const Point_map& map, const std::vector<int>& labels, std::size_t part, Eigen::Index triangle)
{
  std::map<int, int> votes;
  for (int corner = -1; corner < 3; ++corner) {
    Eigen::Vector3d weights = Eigen::Vector3d::Constant(corner < 0 ? 1. / 3 : 1. / 6);
    if (corner >= 0) weights[corner] = 2. / 3;
    ++votes[labels[map(part, triangle, weights).part]];
  }
  return std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// Barycentric coordinates of the projection of a point to the plane of a triangle, also outside of the triangle.
Eigen::Vector3d plane_coordinates(const Point& p, const internal::contacts::Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  const Point normal = internal::contacts::area_vector(triangle);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return {1, 0, 0};
  const double of_a = (c - b).cross(p - b).dot(normal) / squared, of_b = (a - c).cross(p - c).dot(normal) / squared;
  return {of_a, of_b, 1 - of_a - of_b};
}

} // namespace

Transferred_appearance transfer_appearance(const Structural_graph& source, const Segmented_shape& source_shape,
                                           const Shape_appearance& source_appearance, const Structural_graph& target,
                                           const Segmented_shape& target_shape,
                                           const Shape_appearance& target_appearance,
                                           const Correspondence& correspondence, const Transfer_options& options)
{
  if (source_appearance.empty())
    throw Invalid_input(source_shape.name() +
                        ": it has no materials, textures or colours to transfer; give it some, or transfer labels");
  Transfer transfer(source, source_shape, target, target_shape, target_appearance, correspondence, options);
  const Appearance_sampler looks(source_appearance, options.neutral);
  transfer.take_from_sources(source_shape, structure(source).frame, looks);
  transfer.take_from_neighbours(structure(target).contacts, target_shape);
  // Two maps, so that a source part is not divided among its counterpart and neighbours that copy the counterpart
  std::array<Correspondence, 2> pairs;
  const std::vector<Transferred_part>& parts = transfer.parts();
  const auto map_of = [&](std::size_t part) { return parts[part].origin == Appearance_origin::NEIGHBOUR ? 1 : 0; };
  for (std::size_t part = 0; part < parts.size(); ++part) {
    std::size_t like = part;
    while (parts[like].origin == Appearance_origin::NEIGHBOUR)
      like = parts[like].neighbour;
    if (parts[like].origin == Appearance_origin::SOURCE)
      pairs[map_of(part)].pairs.push_back({parts[like].sources[0], part});
  }
  std::deque<Point_map> maps; // index: map_of()
  for (Correspondence& chosen : pairs) {
    chosen.target_quarter_turns = correspondence.target_quarter_turns;
    maps.emplace_back(source, source_shape, target, target_shape, chosen);
  }
  transfer.paint([&](std::size_t part, Eigen::Index triangle, const Eigen::Vector3d& weights) {
    const Part_place place = maps[map_of(part)](part, triangle, weights);
    return looks(place.part, std::size_t(place.triangle), place.weights);
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
      throw Invalid_input(source_shape.name() + ": there is no colour for label " + std::to_string(label) +
                          "; give one for each label");
  Transfer transfer(source, source_shape, target, target_shape, target_appearance, correspondence, options);
  for (std::size_t part = 0; part < target_shape.parts().size(); ++part) {
    const Part_mesh& mesh = target_shape.parts()[part].mesh;
    Transferred_part& transferred = transfer.parts()[part];
    std::vector<int>& of_triangles = transferred.labels;
    of_triangles.assign(std::size_t(mesh.triangles.cols()), -1);
    if (transferred.sources.empty()) continue;
    transferred.origin = Appearance_origin::SOURCE;
    for (std::size_t t = 0; t < of_triangles.size(); ++t)
      of_triangles[t] = label_of_triangle(transfer.map(), labels, part, Eigen::Index(t));
    smooth(neighbours_of(mesh), of_triangles, [](std::size_t, int) { return true; });
  }
  transfer.paint([&](std::size_t part, Eigen::Index triangle, const Eigen::Vector3d& weights) {
    return colours[std::size_t(labels[transfer.map()(part, triangle, weights).part])];
  });
  return transfer.result();
}

Part_appearance appearance_on(const Part_mesh& mesh, const Part_appearance& appearance, const Part_mesh& on_it)
{
  Part_appearance result;
  if (appearance.empty() || mesh.triangles.cols() == 0) return result;
  const std::vector<std::size_t> below = internal::triangles_below(mesh, on_it);
  for (Eigen::Index t = 0; t < on_it.triangles.cols(); ++t) {
    const std::size_t triangle = below[std::size_t(t)];
    if (!appearance.materials.empty()) result.materials.push_back(appearance.materials[triangle]);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d weights = plane_coordinates(on_it.points.col(on_it.triangles(k, t)),
                                                        internal::triangle_of(mesh, Eigen::Index(triangle)));
      if (!appearance.coordinates.empty())
        result.coordinates.push_back(internal::value_at<float>(appearance.coordinates, triangle, weights));
      if (appearance.colours.empty()) continue;
      const Eigen::Vector3d inside = weights.cwiseMax(0) / weights.cwiseMax(0).sum();
      result.colours.push_back(internal::value_at<float>(appearance.colours, triangle, inside));
    }
  }
  return result;
}

Shape_appearance appearance_of_parts(const Segmented_shape& objects, const Shape_appearance& appearance,
                                     const Part_split& split)
{
  Shape_appearance result{appearance.materials, appearance.textures, {}, appearance.warnings};
  result.parts.resize(split.shape.parts().size());
  if (appearance.parts.empty()) return result;
  std::vector<std::set<std::size_t>> objects_of(result.parts.size());
  for (const Model_piece& piece : split.pieces)
    if (piece.part != no_part) objects_of[piece.part].insert(piece.object);
  for (std::size_t part = 0; part < result.parts.size(); ++part) {
    const auto [mesh, looks] =
        IO::joined_parts(objects, appearance, {objects_of[part].begin(), objects_of[part].end()});
    result.parts[part] = appearance_on(mesh, looks, split.shape.parts()[part].mesh);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence
