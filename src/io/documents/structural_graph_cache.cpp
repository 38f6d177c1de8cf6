// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/atomic_file.h"
#include "io/system/checked_file.h"
#include "io/system/digest.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <type_traits>

namespace CGAL::Shape_correspondence::IO {
namespace {

/// Raise it with every change that makes another graph of the same shape and options. Before 14, steps of the flow
/// were not CGAL's.
constexpr int algorithms_version = 14;

/// Values in their bytes, one after the other.
class Bytes
{
public:
  template <typename Number>
  std::enable_if_t<std::is_arithmetic<Number>::value || std::is_enum<Number>::value> add(const Number& number)
  {
    text_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }

  void add(const std::string& text)
  {
    add(static_cast<std::uint64_t>(text.size()));
    text_ += text;
  }

  template <typename Scalar, int Rows, int Cols>
  void add(const Eigen::Matrix<Scalar, Rows, Cols>& matrix)
  {
    add(static_cast<std::uint64_t>(matrix.cols()));
    text_.append(reinterpret_cast<const char*>(matrix.data()),
                 sizeof(Scalar) * static_cast<std::size_t>(matrix.size()));
  }

  template <typename... Values>
  void add_all(const Values&... values)
  {
    (add(values), ...);
  }

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

/// The same with every compiler for the abstractors of the package.
std::string name_of_abstractor(const Abstraction_options& options)
{
  const auto& abstractor = options.abstractor;
  if (abstractor.target<Fitted_abstraction>()) return "fitted";
  if (abstractor.target<Mean_curvature_abstraction>()) return "flow";
  if (abstractor.target<Bounding_box_abstraction>()) return "boxes";
  return abstractor.target_type().name();
}

void add(const Abstraction_options& options, Bytes& bytes)
{
  bytes.add_all(name_of_abstractor(options), options.kind, options.part_kinds.size());
  for (const auto& [part, kind] : options.part_kinds)
    bytes.add_all(part, kind);
  // Graphs that depend on the time limit are not kept
  bytes.add_all(options.edge_length, options.triangles, options.stop_volume, options.maximum_iterations,
                options.curve_points, options.sheet_points);
}

std::string title(const std::string& content) { return "shape_correspondence cache entry " + content; }

} // namespace

std::string content_hash(const Segmented_shape& shape, const Structure_options& options)
{
  Bytes bytes;
  bytes.add_all(algorithms_version, shape.name(), shape.up(), shape.parts().size());
  for (const Shape_part& part : shape.parts())
    bytes.add_all(part.name, part.mesh.points, part.mesh.triangles);
  add(options.abstraction, bytes);
  const Symmetry_options& symmetry = options.symmetry;
  bytes.add_all(symmetry.tolerance, symmetry.enabled, symmetry.reflection, symmetry.rotation, symmetry.translation,
                options.contacts.tolerance, options.contacts.closest_points);
  return digest(bytes.text());
}

Structural_graph_cache::Structural_graph_cache(std::string folder) : folder_(std::move(folder))
{
  make_folder(folder_, "a cache folder");
  remove_leftovers(folder_);
}

std::string Structural_graph_cache::path(const std::string& content) const
{
  return (std::filesystem::path(folder_) / (content + ".graph")).string();
}

bool Structural_graph_cache::is_damaged(const std::string& content) const
{
  return std::filesystem::exists(path(content)) && !find(content);
}

std::optional<Structural_graph> Structural_graph_cache::find(const std::string& content) const
{
  const std::optional<std::string> text = read_checked_file(path(content), title(content));
  if (!text) return std::nullopt;
  try {
    std::istringstream in(*text);
    Structural_graph graph = read_structural_graph_json(in, path(content));
    if (structure(graph).content == content) return graph;
  } catch (const Invalid_input&) {
  }
  return std::nullopt;
}

void Structural_graph_cache::insert(const Structural_graph& graph) const
{
  const Shape_structure& shape = structure(graph);
  const auto reached_limit = [](const Part_abstraction& part) { return part.report.time_limit; };
  if (shape.content.empty() || std::any_of(shape.parts.begin(), shape.parts.end(), reached_limit)) return;
  std::ostringstream text;
  write_structural_graph_json(text, graph);
  write_checked_file(path(shape.content), title(shape.content), text.str());
}

} // namespace CGAL::Shape_correspondence::IO
