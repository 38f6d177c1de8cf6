// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Pair_command.h"
#include "cli/run.h"
#include "cli/text.h"
#include "cli/transfer_looks.h"
#include "io/system/input_file.h"
#include "matching/unlikely_pairs.h"

#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

const char* const transfer_help =
    R"(Usage: shape_correspondence transfer SOURCE TARGET -o FILE.glb|FILE.obj|FILE.ply [options]

Carries the colours and textures of the source over to the target, along the correspondence of their parts and the map
between their surfaces, and writes the target with them. With --labels, labels of parts are carried over instead.

Everything is baked, pixel by pixel, into one texture of the target. It has the texture coordinates of the target if no
triangles overlap in them; otherwise new ones are laid out.

A target part with several counterparts has the looks of the largest one, or of the highest of several about as large,
which the table lists first. One without counterpart looks like the largest part that it touches of those that share a
material with it in the target; of all that it touches, if it has no looks of its own. Otherwise it keeps its own looks,
or is grey. Labels are not passed on to what touches; a part with several counterparts is divided among them.

SOURCE and TARGET are models, as for `match`. Looks are read from OBJ with its MTL files, glTF/GLB, COLLADA, PLY, OFF,
FBX, 3DS and AC3D; textures must be PNG or JPEG.

FILE.glb has the texture in it; beside FILE.obj, FILE.mtl and FILE.png are written; FILE.ply has colours at the vertices
of divided triangles, and the part and label of each face.

Examples: shape_correspondence transfer painted_chair.glb chair.obj -o painted.glb
          shape_correspondence transfer data/chair_slatted chair.obj --labels data/chair_slatted/labels.json -o l.ply

)";

class Transfer_command : public Pair_command
{
public:
  Transfer_command() : Pair_command(transfer_help)
  {
    constexpr double least_size = 16, largest_size = 8192;
    Option_table::Group add = table.group("Output");
    add("output,o", "FILE", &request_.output, "the target with what was transferred: .glb, .obj or .ply");
    add("size", "N", &request_.options.size, "width and height of the texture in pixels")
        .between(least_size, largest_size);
    add("labels", "LABELS", &request_.labels,
        "transfer labels of the source's parts: 'parts' (their names) or a file labels.json")
        .input();
    add("new-coordinates", &request_.options.new_coordinates,
        "lay out new texture coordinates even if those of the target can be used");
    add_result_option(add);
    add("json", "FILE", &common.json, "write what was transferred to every target part as JSON; - is standard output");
    add_shared_options();
  }

private:
  void check() override
  {
    Pair_command::check();
    if (request_.output.empty()) throw Usage_error("-o is missing: FILE.glb, FILE.obj or FILE.ply");
    const std::string extension = IO::lower_extension(request_.output);
    if (extension != ".glb" && extension != ".obj" && extension != ".ply")
      throw Usage_error("-o must name a file that ends in .glb, .obj or .ply");
  }

  std::vector<std::string> output_files() const override
  {
    std::vector<std::string> result{request_.output, common.json};
    if (IO::lower_extension(request_.output) == ".obj")
      for (const char* beside : {".mtl", ".png"})
        result.push_back(std::filesystem::path(request_.output).replace_extension(beside).string());
    return result;
  }

  void work() override
  {
    load();
    Correspondence pairs = correspondence();
    internal::remove_unlikely_pairs(pairs, search.min_confidence);
    Transferred_looks transferred = transfer_looks(inputs[0], shapes[0], inputs[1], shapes[1], pairs, request_);
    warnings.insert(warnings.end(), pairs.warnings.begin(), pairs.warnings.end());
    transferred.warnings.insert(transferred.warnings.begin(), warnings.begin(), warnings.end());
    write_output(common.json, [&](std::ostream& out) {
      write_transfer_json(out, inputs[0], source(), inputs[1], target(), request_, transferred);
    });
    if (!common.prints_table()) return;
    write_transfer_table(std::cout, source(), target(), transferred);
    write_notes(std::cout, transferred.warnings, common.verbose);
  }

  Transfer_request request_;
};

} // namespace

std::unique_ptr<Command> transfer_command() { return std::make_unique<Transfer_command>(); }

} // namespace CGAL::Shape_correspondence::cli
