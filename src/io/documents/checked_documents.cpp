// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/documents/kept_answers.h"
#include "io/read/document.h"
#include "io/read/shipped_roles.h"
#include "io/system/atomic_file.h"
#include "io/system/bytes.h"
#include "io/system/input_file.h"
#include "roles/Role_model_data.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {
namespace {

/// To be increased with every change that alters the graph of a shape for the same options.
constexpr int algorithms_version = 14;
/// To be increased with every change that alters the parts or the upright axis of a model for the same options.
constexpr int reading_version = 2;
constexpr std::size_t most_kept = 20'000'000; // limit for an answer in a cache, in bytes

/// \param values copies, since `pass()` takes values that it may change
template <typename... Values>
void append_all(Value_bytes& bytes, Values... values)
{
  pass_all(bytes, values...);
}

/// The abstractor's name in keys of the cache; for abstractors of the package, independent of the compiler.
std::string name_of_abstractor(const Abstraction_options& options)
{
  const auto& abstractor = options.abstractor;
  if (abstractor.target<Fitted_abstraction>()) return "fitted";
  if (abstractor.target<Mean_curvature_abstraction>()) return "flow";
  if (abstractor.target<Bounding_box_abstraction>()) return "boxes";
  return abstractor.target_type().name();
}

void append_options(const Abstraction_options& options, Value_bytes& bytes)
{
  append_all(bytes, name_of_abstractor(options), options.kind, options.part_kinds.size());
  for (const auto& [part, kind] : options.part_kinds)
    append_all(bytes, part, kind);
  // The time limit is not included, since graphs that depend on it are not kept
  append_all(bytes, options.edge_length, options.triangles, options.stop_volume, options.maximum_iterations,
             options.curve_points, options.sheet_points);
}

std::string title(const std::string& content) { return "shape_correspondence cache entry " + content; }

constexpr const char* model_title = "shape_correspondence role model";

internal::Stored_bytes bytes_of(std::string_view text, std::shared_ptr<const void> owner)
{
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(text.data());
  return {begin, begin + text.size(), std::move(owner)};
}

} // namespace

// Conversion of what a cache keeps of a model, parts and upright axes, to bytes and back

template <typename Value>
static void pass(Value_bytes& bytes, std::array<Value, 2>& pair)
{
  pass_all(bytes, pair[0], pair[1]);
}

static void pass(Value_bytes& bytes, Up_estimate& up) { pass_all(bytes, up.up, up.confidence); }

static void pass(Value_bytes& bytes, Model_piece& piece)
{
  pass_all(bytes, piece.name, piece.object, piece.part, piece.closed, piece.size, piece.reason);
}

static void pass(Value_bytes& bytes, Shape_part& part)
{
  pass_all(bytes, part.name, part.mesh.points, part.mesh.triangles);
}

static void pass(Value_bytes& bytes, Segmented_shape& shape)
{
  std::string name = shape.name();
  Point up = shape.up();
  std::vector<Shape_part> parts = shape.parts();
  pass_all(bytes, name, up, parts);
  shape = Segmented_shape(name, up);
  for (Shape_part& part : parts)
    shape.add_part(std::move(part.name), std::move(part.mesh));
}

static void pass(Value_bytes& bytes, Part_split& split)
{
  pass_all(bytes, split.shape, split.pieces, split.decisions, split.by_segments, split.is_found, split.found_roles,
           split.patched_objects, split.by_materials, split.unions, split.pieces_left_out, split.pieces_kept_whole);
}

std::string content_hash(const Segmented_shape& shape, const Structure_options& options)
{
  Value_bytes bytes;
  append_all(bytes, algorithms_version, shape.name(), shape.up(), shape.parts().size());
  for (const Shape_part& part : shape.parts())
    append_all(bytes, part.name, part.mesh.points, part.mesh.triangles);
  append_options(options.abstraction, bytes);
  const Symmetry_options& symmetry = options.symmetry;
  append_all(bytes, symmetry.tolerance, symmetry.enabled, symmetry.reflection, symmetry.rotation, symmetry.translation,
             options.contacts.tolerance, options.contacts.closest_points);
  return digest(bytes.bytes);
}

Structural_graph_cache::Structural_graph_cache(std::string folder) : folder_(std::move(folder))
{
  make_folder(folder_, "a cache folder");
}

std::string Structural_graph_cache::path(const std::string& content) const
{
  return (std::filesystem::path(folder_) / (content + ".graph")).string();
}

bool Structural_graph_cache::is_damaged(const std::string& content) const
{
  std::error_code error;
  return std::filesystem::exists(path(content), error) && !find(content);
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
  write_checked_entry(path(shape.content), title(shape.content), text.str());
}

template <typename Answer>
Answer kept_answer(const std::string& cache, const std::string& question, const std::function<Answer()>& work,
                   const Tell& warn)
{
  const std::string name = digest(std::to_string(reading_version) + question);
  const std::string kept_title = "shape_correspondence reading " + name;
  const std::filesystem::path folder = std::filesystem::path(cache) / "models";
  const std::string file = (folder / name).string();
  Answer answer;
  try {
    const std::string bytes = read_checked_file(file, kept_title).value_or("");
    Value_bytes kept(bytes);
    pass(kept, answer);
    return answer;
  } catch (const Invalid_input&) { // it is missing or damaged
  }
  std::error_code error;
  if (std::filesystem::exists(file, error)) warn(file + ": it is damaged; it is made again");
  answer = work();
  Value_bytes made;
  pass(made, answer);
  try {
    make_folder(folder.string(), "a cache folder");
    if (made.bytes.size() < most_kept) write_checked_entry(file, kept_title, made.bytes);
  } catch (const Invalid_input&) { // reported when the graph is to be kept
  }
  return answer;
}

template Part_split kept_answer(const std::string&, const std::string&, const std::function<Part_split()>&,
                                const Tell&);
template Up_estimate kept_answer(const std::string&, const std::string&, const std::function<Up_estimate()>&,
                                 const Tell&);
template std::array<Up_estimate, 2> kept_answer(const std::string&, const std::string&,
                                                const std::function<std::array<Up_estimate, 2>()>&, const Tell&);
template std::vector<Point> kept_answer(const std::string&, const std::string&,
                                        const std::function<std::vector<Point>()>&, const Tell&);

void write_role_model(const std::string& path, const Role_model& model)
{
  std::ostringstream content;
  model.write(content);
  write_checked_file(path, model_title, content.str());
}

Role_model read_role_model(const std::string& path)
{
  std::ifstream in = open_input(path);
  const std::optional<std::string> content = checked_content(read_document(in, path), model_title);
  if (!content)
    throw Invalid_input(path + ": it is not a role model, or it is damaged; train one by `train_role_model()`");
  const auto bytes = std::make_shared<const std::string>(*content);
  return internal::Role_model_access::model(internal::read_role_model_data(bytes_of(*bytes, bytes), path));
}

std::shared_ptr<const Role_model> shipped_role_model()
{
  static const auto model = std::make_shared<const Role_model>([] {
    // The digest is not checked: the bytes are part of the program, and the check would double the time
    std::string_view bytes(reinterpret_cast<const char*>(shipped_roles), shipped_roles_size);
    bytes.remove_prefix(bytes.find('\n') + 1);
    return internal::Role_model_access::model(
        internal::read_role_model_data(bytes_of(bytes, nullptr), "the role model of the package"));
  }());
  return model;
}

} // namespace CGAL::Shape_correspondence::IO
