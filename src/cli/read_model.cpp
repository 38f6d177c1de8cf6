// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/library_call.h"
#include "base/limits.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "io/documents/kept_answers.h"
#include "io/read/model_parts.h"
#include "io/system/atomic_file.h"
#include "io/system/input_file.h"
#include "io/system/quoting.h"
#include "roles/up_by_roles.h"
#include "shape/Shape_in_frame.h"
#include "structure/outline_graph.h"

#include <CGAL/Shape_correspondence/IO/parts_json.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/estimate_up.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <sstream>
#include <utility>

namespace CGAL::Shape_correspondence::cli {
namespace {

// Prior odds of y as the upright axis, against each other axis; not used with --up auto
constexpr double odds_of_y = 20;
// Prior odds of y if the axes of two models are estimated together
constexpr double odds_of_y_in_pair = 4.5;

bool is_folder(const std::string& path) { return std::filesystem::is_directory(path); }

bool says_up(const std::string& path)
{
  const auto formats = {".dae", ".gltf", ".glb"};
  return std::find(formats.begin(), formats.end(), IO::lower_extension(path)) != formats.end();
}

/// The result of `work`, from the cache if it is there. \param question identifies the work and its input
template <typename Work>
auto answer_to(const std::string& question, const Common_options& options, const Work& work)
{
  using Answer = decltype(work());
  if (options.cache.empty() || !options.keeps_reading) return work();
  return IO::kept_answer<Answer>(options.cache, question, work, [&](const std::string& text) { warn(options, text); });
}

/// A digest of the role model by which parts are chosen. \param roles may be null
std::string content_of(const std::shared_ptr<const Role_model>& roles)
{
  static std::mutex mutex;
  static std::pair<std::shared_ptr<const Role_model>, std::string> last; // most runs use one model
  const std::lock_guard<std::mutex> lock(mutex);
  if (roles && last.first != roles) {
    std::ostringstream text;
    roles->write(text);
    last = {roles, IO::digest(text.str())};
  }
  return roles ? last.second : "none";
}

std::string content_of(const Segmented_shape& shape) { return IO::content_hash(shape, {}); }

constexpr const char* warning_of_up = "The upright axis was taken to be ";

std::string warning_of(const Point& up, const std::string& why, const std::string& option)
{
  return std::string(warning_of_up) + axis_name(up) + ", " + why + "; if that is wrong, give another with " + option +
         ".";
}

std::string stability(const Up_estimate& found)
{
  return "along which the model stands most stably (confidence " + std::to_string(std::lround(100 * found.confidence)) +
         " %)";
}

constexpr const char* likeness = "with which the parts are most like labelled ones";

/// Whether neither options nor the file format give the upright axis of a model.
bool is_up_unknown(const std::string& path, const Common_options& options)
{
  return options.up.empty() && !says_up(path) && !is_folder(path);
}

void find_up(const std::string& path, bool file_says, const Common_options& options, Read_model& model)
{
  if (!options.up.empty() && !options.finds_up()) return model.objects.set_up(options.up_vector());
  const bool is_asked_for = options.finds_up() && !says_up(path);
  if (file_says || (!is_asked_for && !is_up_unknown(path, options))) return;
  const double odds = is_asked_for ? 1 : odds_of_y;
  const Up_estimate found = answer_to("up " + content_of(model.objects) + std::to_string(odds), options,
                                      [&] { return estimate_up(model.objects, odds); });
  model.objects.set_up(found.up);
  model.up_confidence = found.confidence;
  model.is_up_estimated = true;
  if (is_asked_for || found.up != Point::UnitY())
    model.warnings.push_back(warning_of(found.up, stability(found), "--up"));
}

constexpr std::size_t most_named = 8;

/// Warns of changes made by the automatic choice of parts, with the options that undo them.
void warn_of_changes(const std::string& path, Read_model& model)
{
  const Part_split& split = model.split;
  if (split.by_segments) {
    model.warnings.push_back("The model is one piece: its parts come from an automatic segmentation, which is "
                             "rough; `shape_correspondence parts " +
                             path + " --html F` shows them.");
    return;
  }
  if (split.by_materials)
    model.warnings.push_back("Pieces end where the material changes, since then the parts are more like labelled ones; "
                             "--parts components or file makes others.");
  if (!split.changes_objects()) return;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < split.decisions.size(); ++i)
    if (split.is_split(i)) names.push_back(model.objects.parts()[i].name);
  const std::size_t number = names.size();
  names.resize(std::min(number, most_named));
  const std::string more = number > most_named ? " and " + std::to_string(number - most_named) + " more" : "";
  const std::string how = split.is_found
                              ? "Objects that are not one part each were divided by the shape of their pieces: "
                              : "Objects of loose pieces were split into parts: ";
  const std::string what = number > 0 ? how + listed(names) + more : "Objects joined the parts that they belong to";
  const std::string found = split.found_roles.empty() ? "" : " (" + split.found_roles + ")";
  model.warnings.push_back(what + found + ". --parts file takes the objects as they are; `shape_correspondence parts " +
                           path + "` says why.");
}

IO::Model_objects objects_in(const std::string& path, const Common_options& options)
{
  return IO::read_objects(path, options.up_vector(), options.reading_options());
}

/// The upright axis of a model estimated by the roles of its parts. None unless the parts are clearly nearer to
/// labelled parts of a category than with any other axis, or are nearer and the model stands most stably on it.
std::optional<Point> up_by_roles(const Read_model& model, const Common_options& options)
{
  const std::size_t parts = model.split.shape.parts().size();
  const Role_model* const roles = options.roles.get();
  if (!roles || parts < 2 || parts > internal::most_parts) return std::nullopt;
  const std::string question =
      "roles " + content_of(model.split.shape) + content_of(model.objects) + content_of(options.roles);
  const std::vector<Point> up = answer_to(question, options, [&] {
    const internal::Up_by_roles found = internal::up_by_roles(internal::outline_graph(model.split.shape),
                                                              internal::frames_by_axis(model.objects), *roles);
    const Point axis = Point::Unit(Eigen::Index(found.axis));
    const bool is_sure = found.is_clear || (found.is_nearer && estimate_up(model.objects).up == axis);
    return is_sure ? std::vector<Point>{axis} : std::vector<Point>();
  });
  return up.empty() ? std::nullopt : std::optional(up[0]);
}

/// Replaces an estimated upright axis, and the warning about it, by the axis that the roles of the parts give, if any.
void turn_by_roles(const Common_options& options, Read_model& model)
{
  if (!model.is_up_estimated) return;
  const std::optional<Point> up = up_by_roles(model, options);
  if (!up || *up == model.objects.up()) return;
  model.objects.set_up(*up);
  model.split.shape.set_up(*up);
  model.up_confidence = 1;
  std::vector<std::string>& warnings = model.warnings;
  warnings.erase(std::remove_if(warnings.begin(), warnings.end(),
                                [](const std::string& warning) { return warning.rfind(warning_of_up, 0) == 0; }),
                 warnings.end());
  if (*up != Point::UnitY()) warnings.push_back(warning_of(*up, likeness, "--up"));
}

/// Splits the objects of a model into parts. \param objects as they were read
void split_objects(const std::string& path, const IO::Model_objects& objects, const Common_options& options,
                   Read_model& model)
{
  if (!options.parts_from.empty() && !options.has_face_labels()) {
    model.split = IO::split_parts_by_json(model.objects, options.parts_from, objects.materials);
    return;
  }
  Part_splitting_options splitting;
  const bool are_parts = is_folder(path) || objects.are_labelled;
  splitting.mode = options.parts == Part_splitting::AUTO && are_parts ? Part_splitting::FILE : options.parts;
  splitting.materials = objects.materials;
  std::string question =
      "parts " + content_of(model.objects) + content_of(options.roles) + std::to_string(int(splitting.mode));
  for (const std::vector<int>& of_object : splitting.materials)
    for (int material : of_object)
      question += ' ' + std::to_string(material);
  model.split = answer_to(question, options,
                          [&] { return IO::split_parts_by_roles(model.objects, splitting, options.roles.get()); });
  if (splitting.mode == Part_splitting::AUTO) warn_of_changes(path, model);
  if (splitting.mode == Part_splitting::SEGMENTS)
    model.warnings.insert(model.warnings.begin(), "The parts come from an automatic segmentation.");
  if (model.split.pieces_left_out > 0 && splitting.mode != Part_splitting::FILE)
    model.warnings.push_back("Loose pieces that were left out, since they have no area: " +
                             std::to_string(model.split.pieces_left_out) + ".");
  if (model.split.pieces_kept_whole > 0)
    model.warnings.push_back("Pieces that were not divided into segments, since they have no inside: " +
                             std::to_string(model.split.pieces_kept_whole) + "; repair their triangles.");
}

/// What is known of the upright axes of two inputs that are estimated together, indexed by input.
struct Pair_axes
{
  std::array<bool, 2> is_unknown{};
  std::array<std::optional<Point>, 2> by_roles; ///< axis estimated by roles; empty: roles give none
};

/// The axes to estimate together: if both inputs are models, and no option concerns the axis of only one of them, those
/// given neither by options nor by files.
Pair_axes unknown_axes(const std::vector<std::string>& paths, const Common_options& options)
{
  Pair_axes result;
  for (std::size_t i = 0; i < 2; ++i) {
    const Common_options of_input = options.of_input(i);
    if (!(is_folder(paths[i]) || IO::is_model_file(paths[i])) || of_input.finds_up()) return {};
    result.is_unknown[i] = is_up_unknown(paths[i], of_input);
  }
  return result;
}

/// Estimates the unknown axes and sets them in the shapes and in `options.of_pair`. \return warnings
std::vector<std::string> find_up_of_pair(const std::vector<std::string>& paths, const Pair_axes& axes,
                                         const std::array<Segmented_shape*, 2>& shapes, Common_options& options)
{
  std::array<bool, 2> is_known;
  for (std::size_t i = 0; i < 2; ++i) {
    is_known[i] = !axes.is_unknown[i] || axes.by_roles[i].has_value();
    if (axes.by_roles[i]) shapes[i]->set_up(*axes.by_roles[i]);
  }
  const std::array<Up_estimate, 2> found = answer_to(
      "pair " + content_of(*shapes[0]) + content_of(*shapes[1]) + std::to_string(2 * is_known[0] + is_known[1]),
      options, [&] { return estimate_up_of_pair(*shapes[0], *shapes[1], is_known, odds_of_y_in_pair); });
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!axes.is_unknown[i]) continue;
    shapes[i]->set_up(found[i].up);
    options.of_pair[i].up = axis_name(found[i].up);
    if (found[i].up == Point::UnitY()) continue;
    const std::string option = i == 0 ? "--source-up" : "--target-up";
    const std::string why = axes.by_roles[i] ? likeness : stability(found[i]);
    warnings.push_back(paths[i] + ": " + warning_of(found[i].up, why, option));
  }
  return warnings;
}

} // namespace

std::string axis_name(const Point& axis)
{
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return (axis[largest] < 0 ? "-" : "") + std::string(1, "xyz"[largest]);
}

Read_model read_model(const std::string& path, const Common_options& options)
{
  return with_path(path, [&] { return model_of_objects(path, objects_in(path, options), options); });
}

Read_model model_of_objects(const std::string& path, IO::Model_objects objects, const Common_options& options)
{
  internal::check_library_call("reading");
  Read_model model;
  model.objects = std::move(objects.shape);
  model.warnings = mapped(objects.warnings, in_program_words);
  for (const std::string& warning : model.warnings)
    if (options.quiet && warning.rfind(IO::labels_left_out, 0) == 0)
      std::cerr << "shape_correspondence: note: " + IO::quote_terminal(message_about(path, warning)) + '\n';
  find_up(path, objects.says_up, options, model);
  model.faces = std::move(objects.faces);
  model.number_of_faces = objects.number_of_faces;
  split_objects(path, objects, options, model);
  turn_by_roles(options, model);
  return model;
}

std::vector<Read_model> read_pair(const std::vector<std::string>& paths, Common_options& options,
                                  std::vector<std::string>& warnings)
{
  Pair_axes axes = unknown_axes(paths, options);
  if (!axes.is_unknown[0] && !axes.is_unknown[1]) return {};
  std::array<IO::Model_objects, 2> objects;
  std::vector<Read_model> models(2);
  const auto for_both = [&](const auto& work) {
    internal::for_each_index<CGAL::Parallel_if_available_tag>(
        2, [&](std::size_t i) { with_path(paths[i], [&] { work(i, options.of_input(i)); }); });
  };
  for_both([&](std::size_t i, const Common_options& of_input) { objects[i] = objects_in(paths[i], of_input); });
  for (std::size_t i = 0; i < 2; ++i)
    axes.is_unknown[i] = axes.is_unknown[i] && !objects[i].says_up;
  std::vector<std::string> of_axes = find_up_of_pair(paths, axes, {&objects[0].shape, &objects[1].shape}, options);
  for_both([&](std::size_t i, const Common_options& of_input) {
    models[i] = model_of_objects(paths[i], std::move(objects[i]), of_input);
    if (axes.is_unknown[i]) axes.by_roles[i] = up_by_roles(models[i], of_input);
  });
  if (axes.by_roles[0] || axes.by_roles[1]) {
    of_axes = find_up_of_pair(paths, axes, {&models[0].objects, &models[1].objects}, options);
    for (Read_model& model : models)
      model.split.shape.set_up(model.objects.up());
  }
  append(warnings, of_axes);
  return models;
}

} // namespace CGAL::Shape_correspondence::cli
