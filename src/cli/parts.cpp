// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/collection.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "io/read/model_parts.h"
#include "io/system/atomic_file.h"
#include "io/system/input_file.h"
#include "io/system/quoting.h"
#include "structure/outline_graph.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/parts_json.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <locale>
#include <set>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

const char* const parts_help =
    R"(Usage: shape_correspondence parts MODEL... [options]
       shape_correspondence parts FOLDER [--all] [options]

Lists the objects of a model file, their loose pieces, the part that each piece becomes, and the reason. --html also
writes a page with a picture of every model, one colour for each part.

MODEL is a model file or a folder of part meshes, as in `graph`. FOLDER is a folder of such models: of model files with
several objects each, or of folders of part meshes. With --all, the models are all model files in FOLDER and its
subfolders.

If you want other parts, use --parts file, components or segments, which every command has. For full control,
--parts-json FILE writes which piece is in which part. Edit the file and read it with --parts-from. --parts-from also reads
a list with a label for each face of the model (.seg, .txt, .labels).

-o writes the parts of one model as separate objects or files: FILE.glb (a node for each part, with materials), FILE.obj
(an object for each), FILE.ply (one mesh with the number of its part for each face), FILE.seg (these numbers alone, a
line for each face of the model file), or a new folder of OBJ files named like the parts.

Examples: shape_correspondence parts chair.obj
          shape_correspondence parts furniture --all --html furniture.html --quiet
          shape_correspondence parts chair.obj -o chair_parts/

)";

/// Output files for the parts of a model; empty: none.
struct Parts_output
{
  std::string glb, obj, ply; ///< glb and obj: one object for each part; ply: a part index for each face
  std::string seg;           ///< part indices, one line for each face of the model file
  std::string folder;        ///< new folder, one OBJ file for each part

  std::vector<std::string> files() const { return {glb, obj, ply, seg}; }
  bool is_empty() const { return (glb + obj + ply + seg + folder).empty(); }
};

/// Writes one file for each part, named after it as far as the name is valid and unique.
void write_part_files(const std::string& folder, const Segmented_shape& shape)
{
  std::set<std::string> taken; // names in lower case, since some systems ignore case
  const auto take = [&](const std::string& name) {
    return taken.insert(boost::algorithm::to_lower_copy(name, std::locale::classic())).second;
  };
  for (const Shape_part& part : shape.parts()) {
    std::string name = IO::file_name(part.name);
    for (int number = 2; !take(name); ++number)
      name = IO::file_name(part.name) + '#' + std::to_string(number);
    Segmented_shape one(part.name, shape.up());
    one.add_part(part.name, part.mesh);
    IO::write_atomically(folder + '/' + name + ".obj",
                         [&](std::ostream& out) { IO::write_segmented_shape_obj(out, one); });
  }
}

/// The part of each triangle of an object, by the equal or nearest triangle of the parts.
std::vector<int> parts_of_triangles(const Read_model& model, std::size_t object)
{
  std::set<std::size_t> numbers;
  for (const Model_piece& piece : model.split.pieces)
    if (piece.object == object && piece.part != no_part) numbers.insert(piece.part);
  Shape_appearance looks;
  for (std::size_t part = 0; part < model.split.shape.parts().size(); ++part) {
    const auto triangles = std::size_t(model.split.shape.parts()[part].mesh.triangles.cols());
    looks.parts.push_back({std::vector<int>(triangles, int(part)), {}, {}});
  }
  const auto [mesh, labels] = IO::joined_parts(model.split.shape, looks, {numbers.begin(), numbers.end()});
  return appearance_on(mesh, labels, model.objects.parts()[object].mesh).materials;
}

/// Writes one line for each face of the file, then comments with its name and those of the parts. A degenerate face
/// gets the part of the face before it.
void write_face_labels(std::ostream& out, const std::string& path, const Read_model& model)
{
  constexpr int unknown = -1;
  std::vector<int> labels(model.number_of_faces, unknown);
  for (std::size_t object = 0; object < model.faces.size(); ++object) {
    const std::vector<int> parts = parts_of_triangles(model, object);
    for (std::size_t t = 0; t < parts.size(); ++t)
      labels[model.faces[object][t]] = parts[t];
  }
  int last = 0;
  for (int label : labels)
    out << (last = label == unknown ? last : label) << '\n';
  out << "# faces of " << IO::quote_ply(std::filesystem::path(path).filename().string()) << '\n';
  const std::vector<Shape_part>& parts = model.split.shape.parts();
  for (std::size_t part = 0; part < parts.size(); ++part)
    out << "# part " << part << ' ' << IO::quote_ply(parts[part].name) << '\n';
}

/// Writes the parts with the model's materials.
void write_glb(std::ostream& out, const std::string& path, const Common_options& options, Read_model& model)
{
  Loaded_shape shape;
  shape.path = path;
  shape.model = model.split.shape;
  shape.split = model.split;
  shape.reading = options.reading_options();
  read_appearance(shape);
  append(model.warnings, shape.appearance.warnings);
  IO::write_segmented_shape_glb(out, model.split.shape, shape.appearance);
}

/// Writes the parts of a model. \param model receives warnings \throw Invalid_input
void write_parts(const Parts_output& output, const std::string& path, const Common_options& options, Read_model& model)
{
  const Segmented_shape& shape = model.split.shape;
  if (!output.seg.empty() && (fs::is_directory(path) || model.faces.size() != model.objects.parts().size()))
    throw Invalid_input(path + ": labels of faces, " + output.seg +
                        ", are for models in OBJ, OFF, PLY or STL; write the parts as .ply, .obj or .glb");
  write_output(output.seg, [&](std::ostream& out) { write_face_labels(out, path, model); });
  write_output(output.ply, [&](std::ostream& out) { IO::write_segmented_shape_ply(out, shape); });
  write_output(output.obj, [&](std::ostream& out) { IO::write_segmented_shape_obj(out, shape); });
  write_output(output.glb, [&](std::ostream& out) { write_glb(out, path, options, model); });
  if (!output.folder.empty())
    IO::write_folder_atomically(output.folder, [&](const std::string& folder) { write_part_files(folder, shape); });
}

std::vector<std::string> models_in(const std::string& folder)
{
  if (!fs::is_directory(folder)) throw Invalid_input(folder + ": it is not a folder; give one, or leave --all out");
  std::vector<std::string> result;
  for (const std::string& file : IO::files_under(folder))
    if (IO::is_model_file(file)) result.push_back(file);
  if (result.empty()) throw Invalid_input(folder + ": there is no model file in it; give the folder that has them");
  return result;
}

/// A sentence with the numbers of parts and objects, and the upright axis.
std::string summary(const Read_model& model)
{
  std::string result =
      std::to_string(model.objects.parts().size()) + " objects, " + std::to_string(model.split.pieces.size()) +
      (model.split.by_segments ? " segments, " : " pieces, ") + std::to_string(model.split.shape.parts().size()) +
      " parts; " + axis_name(model.objects.up()) + " up";
  if (model.up_confidence < 1)
    result += " (confidence " + std::to_string(std::lround(100 * model.up_confidence)) + " %)";
  return result;
}

void print_model(const std::string& path, const Read_model& model, bool verbose)
{
  std::cout << IO::quote_terminal(path) << ": " << summary(model) << "\n\n";
  std::vector<std::vector<std::string>> objects{{"object", "triangles", "open pieces", "largest piece", "result"}};
  for (std::size_t i = 0; i < model.objects.parts().size(); ++i) {
    const Shape_part& object = model.objects.parts()[i];
    std::size_t open = 0;
    double largest = 0;
    for (const Model_piece& piece : model.split.pieces) {
      if (piece.object != i) continue;
      open += !piece.closed;
      largest = std::max(largest, piece.size);
    }
    objects.push_back({object.name, std::to_string(object.mesh.triangles.cols()), std::to_string(open),
                       short_number(largest), model.split.decisions[i]});
  }
  write_table(std::cout, std::move(objects));
  std::vector<std::vector<std::string>> pieces{{"part", "piece", "size", "surface", "reason"}};
  for (std::size_t part = 0; part < model.split.shape.parts().size(); ++part)
    for (const Model_piece& piece : model.split.pieces)
      if (piece.part == part)
        pieces.push_back({model.split.shape.parts()[part].name, piece.name, short_number(piece.size),
                          piece.closed ? "closed" : "open", piece.reason});
  std::cout << '\n';
  write_table(std::cout, std::move(pieces));
  std::cout << "\nSizes are fractions of the size of the model.\n";
  write_notes(std::cout, model.warnings, verbose);
  std::cout << '\n';
}

class Parts_command : public Command
{
public:
  Parts_command() : Command(parts_help, 1, any_number)
  {
    Option_table::Group add = table.group("Options of parts");
    add("output,o", "PATH", output_field(),
        "write the parts of the one model: as a file .glb, .obj, .ply or .seg, or into a new folder; FILE.html is the "
        "same as --html");
    add("html", "FILE", &common.html, "write a page with a picture of every model").output();
    add("parts-json", "FILE", &pieces_,
        "write which loose piece of the one model is in which part, to be edited and read by --parts-from")
        .output();
    add("parts-from", "FILE", &common.parts_from,
        "read the parts of the models from such a list, or from a list with a label for each face (.seg, .txt, "
        ".labels)");
    add("all", &is_folder_of_models_, "the models are all model files in the folder and its subfolders");
    add_reading_options(table, common);
    add_common_options(table, common);
  }

private:
  /// The field of `--output`: a file, by its ending; a folder, by a trailing slash or no ending.
  Text_field output_field()
  {
    Text_field result = output_by_ending({{".html", &common.html},
                                          {".glb", &output_.glb},
                                          {".obj", &output_.obj},
                                          {".ply", &output_.ply},
                                          {".seg", &output_.seg}});
    const auto set_file = result.set;
    result.set = [this, set_file](const std::string& label, const std::string& path) {
      if (!path.empty() && path != "-" && !fs::path(path).has_extension())
        output_.folder = path;
      else
        set_file(label, path);
    };
    return result;
  }

  std::vector<std::string> output_files() const override
  {
    std::vector<std::string> result = Command::output_files();
    append(result, output_.files());
    return result;
  }

  void check() override
  {
    if (!output_.folder.empty()) IO::check_new_folder(output_.folder);
    if (is_folder_of_models_ && inputs.size() != 1) throw Usage_error("--all takes one folder");
  }

  void work() override
  {
    common.roles = IO::shipped_role_model();
    const std::vector<std::string> paths = is_folder_of_models_ ? models_in(inputs[0]) : models();
    if (!pieces_.empty() && paths.size() != 1) throw Usage_error("--parts-json takes one model");
    if (!output_.is_empty() && paths.size() != 1) throw Usage_error("-o takes one model, except for FILE.html");
    IO::Parts_sheet sheet(paths.size());
    std::string complaints;
    std::size_t shown = 0;
    for (const std::string& path : paths) {
      const std::string title = fs::path(path).stem().string();
      try {
        Read_model model = read_model(path, common);
        write_parts(output_, path, common, model);
        if (common.prints_table()) print_model(path, model, common.verbose);
        if (!common.html.empty()) sheet.add(title, model.objects, model.split, roles_of(model), summary(model));
        write_output(pieces_, [&](std::ostream& out) { IO::write_parts_json(out, model.split); });
        ++shown;
      } catch (const Invalid_input& error) {
        const std::string message = message_about(path, error.what());
        complaints += (complaints.empty() ? "" : "\n") + message;
        sheet.add(title, message);
      }
    }
    if (shown == 0) throw Invalid_input(complaints);
    write_output(common.html, [&](std::ostream& out) { sheet.write(out); });
    if (!complaints.empty()) throw Invalid_input(complaints);
  }

  /// The likeliest roles of the parts; none where the category is not clear.
  static std::vector<std::string> roles_of(const Read_model& model)
  {
    if (model.split.shape.parts().size() < 2) return {};
    return IO::likeliest_roles(internal::outline_graph(model.split.shape));
  }

  /// The inputs, with a folder of shapes replaced by the models in it.
  std::vector<std::string> models() const
  {
    std::vector<std::string> result;
    for (const std::string& input : inputs)
      if (is_folder_of_shapes(input)) {
        for (const std::string& shape : shapes_in(input))
          if (!is_graph_file(shape)) result.push_back(shape);
      } else {
        result.push_back(input);
      }
    return result;
  }

  bool is_folder_of_models_ = false;
  std::string pieces_; // a file; empty: none
  Parts_output output_;
};

} // namespace

std::unique_ptr<Command> parts_command() { return std::make_unique<Parts_command>(); }

} // namespace CGAL::Shape_correspondence::cli
