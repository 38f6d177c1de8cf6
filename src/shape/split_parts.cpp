// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/directions.h"
#include "base/limits.h"
#include "base/quantized.h"
#include "shape/Loose_piece.h"
#include "shape/Shape_in_frame.h"
#include "shape/canonical_surface.h"
#include "shape/group_pieces.h"
#include "shape/meshes.h"
#include "shape/oriented_box.h"
#include "shape/sample_triangles.h"
#include "shape/split_patches.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Largest number of segments of a model in one piece: more are noise, on a surface without an inside; it stays whole
constexpr std::size_t most_segments = 30;

double size_of_model(const Segmented_shape& model)
{
  if (model.parts().empty())
    throw Invalid_input("shape '" + model.name() + "': there is no object to make parts of; give it a surface");
  const Points points = all_vertices(model);
  const Point middle = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
  return size_of(points, middle);
}

/// The name with `#` and the first number, from `number` on, that makes it unused; it is added to `taken`.
std::string unused_name(const std::string& name, std::size_t number, std::set<std::string>& taken)
{
  std::string result = name + '#' + std::to_string(number);
  while (!taken.insert(result).second)
    result = name + '#' + std::to_string(++number);
  return result;
}

/// Throws `Invalid_input` unless every triangle has a material, or none has.
void check_materials(const std::vector<Shape_part>& objects, const std::vector<std::vector<int>>& materials)
{
  if (materials.empty()) return;
  if (materials.size() != objects.size())
    throw Invalid_input("split_parts(): there are materials of " + std::to_string(materials.size()) + " objects for " +
                        std::to_string(objects.size()) + "; give those of each, or none");
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (materials[i].size() != std::size_t(objects[i].mesh.triangles.cols()))
      throw Invalid_input("split_parts(): '" + objects[i].name + "' has " +
                          std::to_string(objects[i].mesh.triangles.cols()) + " triangles, but materials of " +
                          std::to_string(materials[i].size()) + "; give one for each triangle");
}

/// The loose pieces of a model, and the parts made of them.
class Splitter
{
public:
  Splitter(const Segmented_shape& objects, const Segmentation_options& segmentation,
           const std::vector<std::vector<int>>& materials, bool divide)
      : objects_(objects.parts()),
        segmentation_(segmentation),
        size_(size_of_model(objects)),
        result_{Segmented_shape(objects.name(), objects.up()), {}, {}}
  {
    check_materials(objects_, materials);
    result_.by_materials = divide && !materials.empty();
    for (std::size_t i = 0; i < objects_.size(); ++i)
      for (Loose_piece& piece : loose_pieces(i, objects_[i].mesh, flatness_tolerance(size_),
                                             result_.by_materials ? materials[i] : std::vector<int>()))
        add_piece(std::move(piece));
    sort_pieces(objects.up());
    name_pieces();
  }

  /// Replaces the pieces of some objects by their patches.
  void take_patches(const Segmented_shape& objects, const Surface_patches& surface, const std::vector<bool>& are_taken)
  {
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(),
                                 [&](const Loose_piece& piece) { return are_taken[piece.object]; }),
                  pieces_.end());
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      if (!are_taken[i]) continue;
      result_.patched_objects.push_back(objects_[i].name);
      std::map<std::size_t, std::vector<std::size_t>> triangles; // indexed by patch
      for (std::size_t t = 0; t < surface.of_triangles[i].size(); ++t)
        triangles[surface.of_triangles[i][t]].push_back(t);
      std::vector<int> number(std::size_t(objects_[i].mesh.points.cols()), -1);
      for (auto& [patch, of_patch] : triangles) {
        Loose_piece piece = loose_piece(i, extracted(objects_[i].mesh, of_patch, number), flatness_tolerance(size_));
        piece.triangles = std::move(of_patch);
        add_piece(std::move(piece));
      }
    }
    sort_pieces(objects.up());
    name_pieces();
  }

  /// Makes the parts; in objects where a part ends within a loose piece, patches replace the pieces.
  /// \param part_of_triangle indexed by object and triangle \param nodes the tree of the patches
  Part_split of_patches(const Segmented_shape& objects, const Surface_patches& surface,
                        const std::vector<std::vector<std::size_t>>& part_of_triangle,
                        const std::vector<Part_node>& nodes)
  {
    std::vector<bool> are_divided(objects_.size(), false);
    for (const Loose_piece& piece : pieces_) {
      const std::vector<std::size_t>& part = part_of_triangle[piece.object];
      are_divided[piece.object] =
          are_divided[piece.object] || std::any_of(piece.triangles.begin(), piece.triangles.end(),
                                                   [&](std::size_t t) { return part[t] != part[piece.triangles[0]]; });
    }
    if (std::find(are_divided.begin(), are_divided.end(), true) != are_divided.end())
      take_patches(objects, surface, are_divided);
    Disjoint_sets sets(pieces_.size());
    std::map<std::size_t, std::size_t> first; // indexed by part: its first piece
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const auto [known, is_new] = first.emplace(part_of_triangle[pieces_[i].object][pieces_[i].triangles[0]], i);
      if (!is_new) sets.unite(known->second, i);
    }
    result_.is_found = true;
    result_.unions = unions_of_pieces(surface, nodes);
    for (const auto& [part, piece] : first) {
      Group group;
      for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (sets[i] == sets[piece]) group.push_back(i);
      for (std::size_t i : group)
        result_.pieces[i].reason = "looks like a part with " + result_.pieces[largest(group)].name;
    }
    return of_sets(sets);
  }

  /// Divides pieces into segments.
  void segment()
  {
    result_.by_segments = true;
    std::vector<Loose_piece> whole;
    whole.swap(pieces_);
    for (const Loose_piece& piece : whole) {
      const Mesh_segmentation segments = segment_mesh(piece.mesh, segmentation_);
      result_.pieces_left_out += segments.pieces_left_out;
      result_.pieces_kept_whole += segments.pieces_kept_whole;
      for (const Shape_part& segment : segments.shape.parts())
        add_piece(loose_piece(piece.object, segment.mesh, flatness_tolerance(size_)));
    }
    name_pieces();
  }

  /// Makes every object a part.
  Part_split objects()
  {
    for (Model_piece& piece : result_.pieces)
      piece.part = piece.object;
    for (const Shape_part& object : objects_)
      result_.shape.add_part(object.name, object.mesh);
    return finished({});
  }

  /// Makes every piece a part.
  Part_split pieces() { return of_sets(Disjoint_sets(pieces_.size())); }

  Part_split automatic(const Part_splitting_options& options)
  {
    if (pieces_.size() == 1)
      return std::size_t(pieces_[0].mesh.triangles.cols()) > most_segmented_triangles ? pieces() : segments_of_whole();
    std::vector<std::string> names;
    for (const Model_piece& piece : result_.pieces)
      names.push_back(piece.name);
    const Piece_groups groups = group_pieces(pieces_, names, objects_.size(), size_, options);
    if (groups.sets.number_of_sets() == 1) return pieces();
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      result_.pieces[i].reason = groups.reasons[i];
    return of_sets(groups.sets, groups.kept);
  }

  /// Divides a model that is one piece into segments.
  Part_split segments_of_whole()
  {
    const Loose_piece whole = pieces_[0];
    segment();
    if (pieces_.size() > most_segments) {
      pieces_.assign(1, whole);
      name_pieces();
    }
    return pieces();
  }

  Part_split assigned(const std::map<std::string, std::string>& part_of_piece)
  {
    std::vector<std::string> names; // names of parts
    std::map<std::string, Group> groups;
    std::set<std::string> known;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      Model_piece& piece = result_.pieces[i];
      known.insert(piece.name);
      const auto part = part_of_piece.find(piece.name);
      if (part == part_of_piece.end())
        throw Invalid_input("every piece must be listed, and '" + piece.name + "' of the model is not");
      if (part->second.empty()) continue;
      if (groups.count(part->second) == 0) names.push_back(part->second);
      groups[part->second].push_back(i);
    }
    for (const auto& [piece, part] : part_of_piece)
      if (known.count(piece) == 0)
        throw Invalid_input("only pieces of the model must be listed, and it has no '" + piece + "'");
    for (Model_piece& piece : result_.pieces)
      piece.part = no_part;
    for (const std::string& name : names)
      add_part(groups[name], name);
    return finished({});
  }

private:
  using Group = std::vector<std::size_t>; // indices of pieces

  /// The unions of whole pieces in the nodes of a tree of patches. Each joins two pieces or earlier unions; unions are
  /// numbered on from the pieces.
  std::vector<std::array<std::size_t, 2>> unions_of_pieces(const Surface_patches& surface,
                                                           const std::vector<Part_node>& nodes) const
  {
    constexpr std::size_t none = Part_node::none;
    std::vector<std::size_t> piece_of_patch(surface.patches.size(), none), patches(pieces_.size(), 0);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      for (std::size_t t : pieces_[i].triangles) {
        std::size_t& piece = piece_of_patch[surface.of_triangles[pieces_[i].object][t]];
        patches[i] += piece == none;
        piece = i;
      }
    struct Union
    {
      std::size_t whole = none;                 // number of the piece, or the union of pieces, that it holds whole
      std::map<std::size_t, std::size_t> begun; // number of patches of each piece that it holds in part
    };
    std::vector<std::array<std::size_t, 2>> result;
    const auto add = [&](Union& to, std::size_t number) {
      if (to.whole != none && number != none) {
        result.push_back({to.whole, number});
        number = pieces_.size() + result.size() - 1;
      }
      if (number != none) to.whole = number;
    };
    std::vector<Union> unions(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      Union& all = unions[k];
      for (std::size_t child : nodes[k].children)
        if (child != none) {
          add(all, unions[child].whole);
          for (const auto& [piece, number] : unions[child].begun)
            all.begun[piece] += number;
        }
      if (nodes[k].is_leaf() && piece_of_patch[k] != none) all.begun[piece_of_patch[k]] = 1;
      for (auto i = all.begun.begin(); i != all.begun.end();) {
        const bool is_whole = i->second == patches[i->first];
        if (is_whole) add(all, i->first);
        i = is_whole ? all.begun.erase(i) : std::next(i);
      }
    }
    return result;
  }

  void add_piece(Loose_piece piece)
  {
    if (has_area(piece.mesh))
      pieces_.push_back(std::move(piece));
    else
      ++result_.pieces_left_out;
  }

  /// Sorts the pieces of each object by their positions along a direction of the shape's frame, so that their names do
  /// not depend on the order of triangles.
  void sort_pieces(const Point& up)
  {
    if (pieces_.size() <= objects_.size()) return;
    std::vector<const Part_mesh*> surfaces;
    for (const Loose_piece& piece : pieces_)
      surfaces.push_back(&piece.surface);
    const Shape_frame frame = rough_frame(surfaces, up);
    const auto key = [&](const Loose_piece& piece) {
      const double place = generic_direction().dot(Point(frame.to_frame(piece.middle)));
      return std::tuple(piece.object, quantized(place), -quantized(piece.area / (size_ * size_)));
    };
    std::vector<std::pair<decltype(key(pieces_[0])), std::size_t>> order;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      order.emplace_back(key(pieces_[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<Loose_piece> sorted;
    for (const auto& [place, i] : order)
      sorted.push_back(std::move(pieces_[i]));
    pieces_.swap(sorted);
  }

  void name_pieces()
  {
    count_.assign(objects_.size(), 0);
    std::vector<std::size_t> number(objects_.size(), 0);
    for (const Loose_piece& piece : pieces_)
      ++count_[piece.object];
    std::set<std::string> taken;
    for (std::size_t i = 0; i < objects_.size(); ++i)
      if (count_[i] == 1) taken.insert(objects_[i].name);
    result_.pieces.clear();
    for (const Loose_piece& piece : pieces_) {
      std::string name = objects_[piece.object].name;
      if (count_[piece.object] > 1) name = unused_name(name, ++number[piece.object], taken);
      result_.pieces.push_back({name, piece.object, 0, piece.closed, piece.size / size_, ""});
    }
  }

  Part_split of_sets(const Disjoint_sets& sets, const std::vector<std::string>& kept = {})
  {
    std::map<std::size_t, Group> groups;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      groups[sets[i]].push_back(i);
    std::set<std::string> taken;
    for (const Shape_part& object : objects_)
      taken.insert(object.name);
    std::vector<std::size_t> parts_of_object(objects_.size(), 0);
    for (const auto& [first, group] : groups) {
      const std::size_t object = pieces_[largest(group)].object, number = ++parts_of_object[object];
      const std::string& name = objects_[object].name;
      add_part(group, number == 1 ? name : unused_name(name, number, taken));
      result_.pieces[largest(group)].reason.clear();
    }
    return finished(kept);
  }

  std::size_t largest(const Group& group) const
  {
    return *std::max_element(group.begin(), group.end(),
                             [&](std::size_t a, std::size_t b) { return pieces_[a].area < pieces_[b].area; });
  }

  /// Whether some pieces are exactly those of an object.
  bool is_object(const Group& group) const
  {
    if (result_.by_segments) return false;
    const std::size_t object = pieces_[group[0]].object;
    return group.size() == count_[object] &&
           std::all_of(group.begin(), group.end(), [&](std::size_t i) { return pieces_[i].object == object; });
  }

  void add_part(const Group& group, const std::string& name)
  {
    std::vector<const Part_mesh*> meshes;
    for (std::size_t i : group) {
      result_.pieces[i].part = result_.shape.parts().size();
      meshes.push_back(&pieces_[i].mesh);
    }
    result_.shape.add_part(name, is_object(group) ? objects_[pieces_[group[0]].object].mesh : joined(meshes));
  }

  Part_split finished(const std::vector<std::string>& kept)
  {
    std::vector<std::set<std::size_t>> parts(objects_.size());
    for (const Model_piece& piece : result_.pieces)
      parts[piece.object].insert(piece.part);
    const std::vector<std::string>& patched = result_.patched_objects;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      const bool is_patched = std::find(patched.begin(), patched.end(), objects_[i].name) != patched.end();
      result_.decisions.push_back(decision(count_[i], is_patched, parts[i].size(), kept.empty() ? "" : kept[i]));
    }
    return std::move(result_);
  }

  /// What the user is told about the parts made of an object.
  std::string decision(std::size_t pieces, bool is_patched, std::size_t parts, const std::string& why_kept) const
  {
    const std::string count = std::to_string(pieces) + (result_.by_segments ? " segments"
                                                        : is_patched        ? " patches"
                                                                            : " pieces");
    if (pieces == 0) return "left out: it has no area";
    if (pieces == 1) return "one piece";
    if (parts > 1) return count + ", split into " + std::to_string(parts) + " parts";
    return count + ", kept whole" + (why_kept.empty() ? "" : ": " + why_kept);
  }

  const std::vector<Shape_part>& objects_;
  const Segmentation_options segmentation_;
  double size_;
  std::vector<Loose_piece> pieces_;
  std::vector<std::size_t> count_; ///< indexed by object: number of pieces
  Part_split result_;
};

} // namespace

bool Part_split::is_split(std::size_t object) const
{
  std::set<std::size_t> parts;
  for (const Model_piece& piece : pieces)
    if (piece.object == object) parts.insert(piece.part);
  return parts.size() > 1;
}

bool Part_split::changes_objects() const
{
  std::map<std::size_t, std::size_t> object_of_part;
  for (const Model_piece& piece : pieces)
    if (!object_of_part.emplace(piece.part, piece.object).second && object_of_part[piece.part] != piece.object)
      return true;
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (is_split(i)) return true;
  return false;
}

Part_split split_parts(const Segmented_shape& objects, const Part_splitting_options& options)
{
  Splitter splitter(objects, options.segmentation, options.materials, options.divide_by_materials);
  switch (options.mode) {
  case Part_splitting::FILE:
    return splitter.objects();
  case Part_splitting::COMPONENTS:
    return splitter.pieces();
  case Part_splitting::SEGMENTS:
    splitter.segment();
    return splitter.pieces();
  case Part_splitting::AUTO:
    break;
  }
  return splitter.automatic(options);
}

Surface_patches internal::patches_of_objects(const Segmented_shape& objects,
                                             const std::vector<std::vector<int>>& materials)
{
  return surface_patches(objects, Shape_in_frame(objects).frame.axes.transpose(), materials);
}

Part_split internal::split_patches(const Segmented_shape& objects, const Surface_patches& surface,
                                   const std::vector<std::vector<int>>& materials, const std::vector<Part_node>& nodes,
                                   const std::vector<std::size_t>& cut)
{
  std::vector<std::size_t> part_of_patch(surface.patches.size(), 0);
  for (std::size_t i = 0; i < cut.size(); ++i)
    for (std::size_t patch : nodes[cut[i]].patches)
      part_of_patch[patch] = i;
  std::vector<std::vector<std::size_t>> parts = surface.of_triangles;
  for (std::vector<std::size_t>& of_object : parts)
    for (std::size_t& patch : of_object)
      patch = part_of_patch[patch];
  return Splitter(objects, {}, materials, true).of_patches(objects, surface, parts, nodes);
}

Part_split split_parts(const Segmented_shape& objects, const std::map<std::string, std::string>& part_of_piece,
                       bool by_segments, const Segmentation_options& segmentation,
                       const std::vector<std::vector<int>>& materials, const std::vector<std::string>& patched_objects)
{
  Splitter splitter(objects, segmentation, materials, true);
  if (by_segments) splitter.segment();
  if (!patched_objects.empty()) {
    std::vector<bool> are_patched;
    for (const Shape_part& object : objects.parts())
      are_patched.push_back(std::find(patched_objects.begin(), patched_objects.end(), object.name) !=
                            patched_objects.end());
    splitter.take_patches(objects, patches_of_objects(objects, materials), are_patched);
  }
  return splitter.assigned(part_of_piece);
}

} // namespace CGAL::Shape_correspondence
