// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Labels of faces as parts, and output of parts as objects, files and labels.
#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <sstream>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using namespace std::string_literals;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

using Names = std::vector<std::string>;

std::map<std::string, Eigen::Index> parts(const Segmented_shape& shape)
{
  std::map<std::string, Eigen::Index> result;
  for (const Shape_part& part : shape.parts())
    result[part.name] = part.mesh.triangles.cols();
  return result;
}

using Parts = std::map<std::string, Eigen::Index>;

/// Two boxes above each other without objects, with six faces each.
const std::string two_boxes = box_vertices(0, 0, 0, 1, 1, 1, "v ") + box_vertices(0, 1, 0, 1, 1, 1, "v ") +
                              box_faces(1, "f ") + box_faces(9, "f ");

std::string off_boxes()
{
  return "OFF\n16 12 0\n" + box_vertices(0, 0, 0, 1, 1, 1, "") + box_vertices(0, 1, 0, 1, 1, 1, "") +
         box_faces(0, "4 ") + box_faces(8, "4 ");
}

std::string ply_boxes(const std::string& property, const std::vector<std::string>& labels,
                      const std::string& comments = "")
{
  std::string result = "ply\nformat ascii 1.0\n" + comments +
                       "element vertex 16\nproperty float x\nproperty float y\n"
                       "property float z\nelement face 12\nproperty list uchar int vertex_indices\n" +
                       property + "\nend_header\n" + box_vertices(0, 0, 0, 1, 1, 1, "") +
                       box_vertices(0, 1, 0, 1, 1, 1, "");
  std::istringstream faces(box_faces(0, "4 ") + box_faces(8, "4 "));
  std::size_t i = 0;
  for (std::string face; std::getline(faces, face); ++i)
    result += face + ' ' + labels[i] + '\n';
  return result;
}

/// A list with one word for the first six faces and another for the rest. \param end end of each line
std::string list(const std::string& first, const std::string& second, const std::string& end = "\n")
{
  std::string result;
  for (int i = 0; i < 12; ++i)
    result += (i < 6 ? first : second) + end;
  return result;
}

Segmented_shape read_with(const std::string& model, const std::string& labels)
{
  IO::Reading_options options;
  options.face_labels = labels;
  return IO::read_segmented_shape(model, Point::UnitY(), nullptr, options);
}

} // namespace

TEST_CASE("Faces of PLY with a property for parts are read as these parts")
{
  const Temporary_folder folder;
  std::vector<std::string> labels(12, "3");
  std::fill(labels.begin() + 4, labels.end(), "7");
  for (const char* name : {"part", "label", "category_id", "object_id", "segment"}) {
    const std::string file = folder.write("a.ply", ply_boxes("property int "s + name, labels));
    CHECK(parts(IO::read_segmented_shape(file)) == Parts{{name + "_3"s, 8}, {name + "_7"s, 16}});
  }
  for (const char* name : {"Label", "LABEL", "PartId", "scalar_Segment"}) {
    const std::string file = folder.write("a.ply", ply_boxes("property int "s + name, labels));
    CHECK(IO::read_segmented_shape(file).parts().size() == 2);
  }
  // A face gets the more frequent label of its corners, in case of a tie the lower one
  const auto of_vertices = [](const std::string& numbers) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "property uchar label\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0 " +
           numbers.substr(0, 1) + "\n1 0 0 " + numbers.substr(1, 1) + "\n0 1 0 " + numbers.substr(2, 1) + "\n0 0 1 " +
           numbers.substr(3, 1) + "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  };
  CHECK(parts(IO::read_segmented_shape(folder.write("a.ply", of_vertices("5511")))) ==
        Parts{{"label_1", 2}, {"label_5", 2}});
  CHECK(parts(IO::read_segmented_shape(folder.write("a.ply", of_vertices("9123")))) ==
        Parts{{"label_1", 3}, {"label_2", 1}});
  CHECK(parts(IO::read_segmented_shape(folder.write(
            "a.ply", ply_boxes("property uchar part", labels, "comment part 3 front leg\ncomment part 7 %20a\n")))) ==
        Parts{{"front leg", 8}, {" a", 16}});
  std::vector<std::string> both;
  for (int i = 0; i < 12; ++i)
    both.push_back(i < 6 ? "1 0" : "1 1");
  CHECK(parts(IO::read_segmented_shape(
            folder.write("a.ply", ply_boxes("property int label\nproperty float part", both)))) ==
        Parts{{"part_0", 12}, {"part_1", 12}});
  CHECK(parts(IO::read_segmented_shape(folder.write(
            "a.ply", ply_boxes("property int label", std::vector<std::string>(12, "5"))))) == Parts{{"label_5", 24}});
  CHECK(parts(IO::read_segmented_shape(folder.write(
            "a.ply", ply_boxes("property uchar red", std::vector<std::string>(12, "5"))))) == Parts{{"a", 24}});
}

TEST_CASE("Lists of labels of faces make the parts of OBJ, OFF, PLY and STL")
{
  const Temporary_folder folder;
  const std::string obj = folder.write("m.obj", two_boxes), off = folder.write("m.off", off_boxes());
  const Parts numbered{{"label_0", 12}, {"label_1", 12}};
  for (const std::string& model : {obj, off}) {
    CHECK(parts(read_with(model, folder.write("l.seg", list("0", "1")))) == numbered);
    CHECK(parts(read_with(model, folder.write("l.seg", list("0", "1", "\r\n")))) == numbered);
    CHECK(parts(read_with(model, folder.write("l.txt", list("0", "1", " ")))) == numbered);
    CHECK(parts(read_with(model, folder.write("l.txt", "# of faces\n" + list("front leg", "seat")))) ==
          Parts{{"front leg", 12}, {"seat", 12}});
    CHECK(parts(read_with(model, folder.write("l.labels", "seat\n1 2 3\n4 5 6\nback\n12 11 10 9 8 7\n"))) ==
          Parts{{"seat", 12}, {"back", 12}});
  }
  for (const char* text : {"0\n1\n", "seat\n1 2 3\n", "seat\n1 2 3 3 4 5 6 7 8 9 10 11 12\n", ""})
    CHECK_THAT(complaint([&] { read_with(obj, folder.write("l.seg", text)); }),
               Contains("l.seg") && (Contains("12 faces") || Contains("empty")));
  const auto refusal = [&](const std::string& text) {
    return complaint([&] { read_with(obj, folder.write("l.seg", text)); });
  };
  for (const char* second : {"leg", "0.5", "-0", "1 0", "1e0", "01"})
    CHECK_THAT(refusal("0\n" + list("0", second)),
               Contains("l.seg, line 8: '" + std::string(second) + "' is not a whole"));
  CHECK_THAT(refusal("0\n\n" + list("0", "1").substr(4)), Contains("11 labels") && Contains("line 2 has none"));
  CHECK_THAT(refusal("seat\n1 2 3\nback\n4 x\n"), Contains("line 4: 'x' is not the number of a face"));
  CHECK_THAT(refusal("seat\n1 2 3\nback\n4 3\n"), Contains("line 4: face '3' has a label already"));
  CHECK(parts(read_with(obj, folder.write("l.seg", "# part -1 seat\n" + list("-1", "1") + "\n# end\n\n"))) ==
        Parts{{"seat", 12}, {"label_1", 12}});
  CHECK_THAT(complaint([&] { read_with(obj, folder.write("l.eseg", list("0", "1"))); }), Contains("edges"));
  CHECK_THAT(complaint([&] { read_with(obj, folder.path("none.seg")); }), Contains("none.seg"));
  // The list has a label for a degenerate face, too
  const std::string with_flat_face = std::string(two_boxes).insert(two_boxes.find("f "), "f 1 1 2\n");
  CHECK(parts(read_with(folder.write("d.obj", with_flat_face), folder.write("d.txt", "2\n" + list("0", "1")))) ==
        numbered);
}

TEST_CASE("A list of labels beside a model is read with it, if it fits")
{
  const Temporary_folder folder;
  const std::string model = folder.write("m.obj", two_boxes);
  std::vector<std::string> warnings;
  folder.write("m.seg", list("0", "1"));
  CHECK(IO::read_segmented_shape(model, Point::UnitY(), &warnings).parts().size() == 2);
  CHECK_THAT(warnings.at(0), Contains("m.seg"));
  folder.write("m.seg", "1\n2\n");
  CHECK(IO::read_segmented_shape(model, Point::UnitY(), &warnings).parts().size() == 1);
  CHECK_THAT(warnings.at(1), Contains("m.seg") && Contains("left out"));
  CHECK_THAT(run("graph " + quoted(model) + " --parts components --quiet").error, Contains("left out"));
  folder.write("m.seg", list("0", "1") + "# faces of other.obj\n");
  CHECK(IO::read_segmented_shape(model, Point::UnitY(), &warnings).parts().size() == 1);
  CHECK_THAT(warnings.at(2), Contains("left out") && Contains("other.obj"));
}

TEST_CASE("Every command takes labels of faces as parts, and does not split them further")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("m.obj", two_boxes));
  const std::string labels = quoted(folder.write("l.seg", list("0", "1")));
  const std::string boxes = " --abstraction boxes --json -";
  for (const char* mode : {"", " --parts file"}) {
    const Run graph = run("graph " + model + " --parts-from " + labels + mode + boxes);
    INFO(graph.error);
    REQUIRE(graph.status == 0);
    CHECK(json::parse(graph.out)["parts"].size() == 2);
  }
  const Run match =
      run("match " + model + " " + model + " --source-parts-from " + labels + " --target-parts-from " + labels + boxes);
  INFO(match.error);
  REQUIRE(match.status == 0);
  CHECK(json::parse(match.out)["pairs"].size() == 2);
  // Faces of two boxes that have the same label stay one part
  const std::string legs = quoted(folder.write("legs.ply", ply_boxes("property int part", [] {
                                                 std::vector<std::string> result;
                                                 for (int i = 0; i < 12; ++i)
                                                   result.push_back(i % 6 < 3 ? "0" : "1");
                                                 return result;
                                               }())));
  CHECK(json::parse(run("graph " + legs + boxes).out)["parts"].size() == 2);
  folder.write("folder/a.obj", two_boxes);
  const Run refused = run("parts " + quoted(folder.path("folder")) + " --parts-from " + labels);
  CHECK(refused.status == 1);
  CHECK_THAT(refused.error, Contains("folder") && Contains("labels of faces"));
}

TEST_CASE("Parts are written as objects, files and labels that read back as the same parts")
{
  const Temporary_folder folder;
  const std::string model = folder.write("table.obj", obj_table());
  const Segmented_shape table = IO::read_segmented_shape(model);
  for (const char* name : {"out.obj", "out.ply", "out.glb", "folder", "folder.d/"}) {
    CAPTURE(name);
    const Run done = run("parts " + quoted(model) + " -o " + quoted(folder.path(name)));
    INFO(done.error);
    REQUIRE(done.status == 0);
    CHECK(parts(IO::read_segmented_shape(folder.path(name))) == parts(table));
  }
  CHECK(fs::exists(folder.path("folder/leg_1.obj")));
  CHECK(run("parts " + quoted(model) + " -o " + quoted(folder.path("folder"))).status == 1); // the folder exists
  REQUIRE(run("parts " + quoted(model) + " -o " + quoted(folder.path("all.seg"))).status == 0);
  std::string expected;
  for (int face = 0; face < 30; ++face)
    expected += std::to_string(face / 6) + '\n';
  CHECK(text_of(folder.path("all.seg")) ==
        expected +
            "# faces of table.obj\n# part 0 top\n# part 1 leg_1\n# part 2 leg_2\n# part 3 leg_3\n# part 4 leg_4\n");
  // Labels of the parts that the program finds in a model of one object give the same parts when read with it
  std::string boxes;
  for (int i = 0; i < 5; ++i)
    boxes += obj_box("", i, 2 * i, 0, 0, 1, 1, 1);
  const std::string whole = folder.write("whole.obj", boxes + "f 1 1 2\n");
  REQUIRE(run("parts " + quoted(whole) + " --parts components -o " + quoted(folder.path("whole.seg"))).status == 0);
  CHECK_THAT(text_of(folder.path("whole.seg")), Catch::Matchers::StartsWith(expected + "4\n# faces of whole.obj\n"));
  CHECK(parts(IO::read_segmented_shape(whole)) ==
        Parts{{"whole", 12}, {"whole#2", 12}, {"whole#3", 12}, {"whole#4", 12}, {"whole#5", 12}});
  for (const char* output : {"out.xyz", "-"})
    CHECK(run("parts " + quoted(model) + " -o " + output).status == 2);
  CHECK(run("parts " + quoted(model) + " " + quoted(whole) + " -o " + quoted(folder.path("two.obj"))).status == 2);
  CHECK_FALSE(fs::exists(folder.path("two.obj")));
  const Run no_faces = run("parts " + quoted(folder.path("out.glb")) + " -o " + quoted(folder.path("g.seg")));
  CHECK(no_faces.status == 1);
  CHECK_THAT(no_faces.error, Contains("OBJ, OFF, PLY or STL"));
}

TEST_CASE("Files of parts have names that every system takes, all different")
{
  const Temporary_folder folder;
  const Names wanted{"a/b", "a_b", "A_B", "..", "con", "", "x.", std::string(300, 'n')};
  std::string text;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    text += obj_box("o " + wanted[i], int(i), 2 * double(i), 0, 0, 1, 1, 1);
  const Run done = run("parts " + quoted(folder.write("m.obj", text)) + " -o " + quoted(folder.path("parts")));
  INFO(done.error);
  REQUIRE(done.status == 0);
  Names names;
  for (const auto& entry : fs::directory_iterator(folder.path("parts")))
    names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  CHECK(names == Names{"A_B#3", "__", "_con", "a_b", "a_b#2", std::string(200, 'n'), "object", "x_"});
  Parts expected;
  for (const std::string& name : wanted)
    expected[name.empty() ? "object" : name] = 12;
  CHECK(parts(IO::read_segmented_shape(folder.path("parts"))) == expected);
}
