// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxed_graphs.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/matrix_files.h>
#include <CGAL/Shape_correspondence/IO/read_features.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <cstring>
#include <deque>
#include <map>
#include <random>
#include <sstream>

// Features in files of NumPy, and on the faces and vertices of model files.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using namespace std::string_literals;
using Catch::Matchers::Contains;

namespace {

/// A file of NumPy with this dictionary in its header.
std::string npy(const std::string& dictionary, const std::string& data, char version = 1)
{
  const auto byte = [&](std::size_t i) { return std::string(1, char(dictionary.size() >> 8 * i & 255)); };
  return "\x93NUMPY"s + version + '\0' + byte(0) + byte(1) + (version > 1 ? byte(2) + byte(3) : "") + dictionary + data;
}

std::string header(const std::string& type, const std::string& shape, const std::string& order = "False")
{
  return "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }   \n";
}

template <typename Number>
std::string bytes(const std::vector<Number>& numbers)
{
  std::string result(numbers.size() * sizeof(Number), '\0');
  std::memcpy(result.data(), numbers.data(), result.size());
  return result;
}

Eigen::MatrixXf read(const std::string& content)
{
  const Temporary_folder folder;
  return IO::read_features(folder.write("f.npy", content));
}

const std::vector<float> six{1, 2, 3, 4, 5, 6};

/// The features of the parts of a model, where every object is a part.
Eigen::MatrixXd features_on(const std::string& model, const Eigen::MatrixXf& features)
{
  Part_splitting_options options;
  options.mode = Part_splitting::FILE;
  return IO::features_of_parts(features, model, split_parts(IO::read_segmented_shape(model), options));
}

} // namespace

TEST_CASE("Arrays of NumPy: both precisions, both orders, all versions")
{
  Eigen::MatrixXf rows(2, 3), columns(2, 3);
  rows << 1, 3, 5, 2, 4, 6;
  columns << 1, 2, 3, 4, 5, 6;
  CHECK(read(npy(header("<f4", "(3, 2)"), bytes(six))) == rows);
  CHECK(read(npy(header("<f4", "(3L, 2L)"), bytes(six))) == rows);
  CHECK(read(npy(header("<f8", "(3, 2)"), bytes(std::vector<double>(six.begin(), six.end())))) == rows);
  CHECK(read(npy(header("<f4", "(3, 2)", "True"), bytes(six))) == columns);
  for (const int version : {2, 3})
    CHECK(read(npy(header("<f4", "(3, 2)"), bytes(six), char(version))) == rows);
  CHECK(read(npy("{\"shape\":(3,2),\"fortran_order\":False,\"descr\":\"<f4\"}", bytes(six))) == rows);
  std::ostringstream written;
  IO::write_npy(written, rows.transpose().cast<double>());
  CHECK(read(written.str()) == rows);
}

TEST_CASE("Damaged and foreign arrays are refused, with what to do")
{
  const std::string good = npy(header("<f4", "(3, 2)"), bytes(six));
  for (std::size_t size = 0; size < good.size(); ++size) {
    INFO(size);
    CHECK_THAT(complaint([&] { read(good.substr(0, size)); }), Contains("f.npy: ") && Contains("; "));
  }
  const std::string data = bytes(six);
  const std::vector<std::pair<std::string, std::string>> faults{
      {npy(header("<f4", "(3, 3)"), data), "24 bytes follow"},
      {npy(header("<f4", "(3, 1)"), data), "24 bytes follow"},
      {npy(header("<f4", "(4611686018427387904, 4)"), data), "24 bytes follow"},
      {npy(header("<f4", "(99999999999999999999, 4)"), data), "header is damaged"},
      {npy(header("<f4", "(-3, -2)"), data), "header is damaged"},
      {npy(header("<f4", "(6,)"), data), "1 dimensions"},
      {npy(header("<f4", "()"), data), "0 dimensions"},
      {npy(header("<f4", "(1, 3, 2)"), data), "3 dimensions"},
      {npy(header("<f4", "(0, 2)"), ""), "length 0"},
      {npy(header(">f4", "(3, 2)"), data), "big-endian"},
      {npy(header("<i4", "(3, 2)"), data), "'<i4'"},
      {npy(header("<f2", "(3, 4)"), data), "'<f2'"},
      {npy(header("|O", "(3, 2)"), data), "Python objects"},
      {npy("{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (3, 2), }", data), "a structure"},
      {npy(header("<f4", "(3, 2)", "Maybe"), data), "header is damaged"},
      {npy("{'descr': '<f4', 'shape': (3, 2), }", data), "header is damaged"},
      {npy("{'descr': '<f4', 'fortran_order': False, }", data), "header is damaged"},
      {npy("{'fortran_order': False, 'shape': (3, 2), }", data), "header is damaged"},
      {npy("{'descr': '<f4', 'fortran_order': False, 'shape': (3, 2)", data), "header is damaged"},
      {npy("{'descr': '<f4', 'colour': 3}", data), "header is damaged"},
      {npy("", data), "header is damaged"},
      {"\x93NUMPY\x02\x00\xff\xff\xff\xff"s + data, "too long"},
      {"\x93NUMPY\x02\x00\xff\xff\x00\x00"s + data, "cut off"},
      {npy(header("<f4", "(3, 2)"), data, 9), "version 9"},
      {"PK\x03\x04 more of an archive", ".npz"},
      {"1 2 3\n4 5 6\n", "not an array of NumPy"},
      {npy(header("<f4", "(3, 2)"), bytes(std::vector<float>{1, 2, 3, NAN, 5, 6})), "row 1 of the features"},
      {npy(header("<f4", "(3, 2)"), bytes(std::vector<float>{1, 2, 3, 4, INFINITY, 6})), "row 2 of the features"},
      {npy(header("<f8", "(1, 2)"), bytes(std::vector<double>{1, 1e300})), "row 0 of the features"}};
  for (const auto& [content, fault] : faults) {
    INFO(fault);
    CHECK_THAT(complaint([&, &content = content] { read(content); }),
               Contains("f.npy: ") && Contains(fault) && Contains("; "));
  }
  CHECK_THROWS_AS(IO::read_features("missing.npy"), Invalid_input);
  CHECK_THROWS_AS(IO::read_features("."), Invalid_input);
}

TEST_CASE("Rows are the faces of the file: one for each polygon, and for each face that reading leaves out")
{
  const Temporary_folder folder;
  // A line with two corners and a face without area come between the objects
  const std::string model = folder.write("m.obj", obj_box("o low", 0, 0, 0, 0, 1, 1, 1) + "f 1 2\nf 1 1 2\n" +
                                                      obj_box("o high", 1, 0, 1, 0, 1, 1, 1));
  Eigen::MatrixXf features = Eigen::MatrixXf::Zero(2, 14);
  features.row(0).head(6).setOnes();
  features.row(1).tail(6).setOnes();
  features.middleCols(6, 2).setConstant(100);
  Eigen::MatrixXd expected(2, 2);
  expected << 0.5, 0, 0, 0.5;
  CHECK(features_on(model, features).isApprox(expected));

  // Sixteen vertices: those of the lower box first
  features = Eigen::MatrixXf::Zero(2, 16);
  features.row(0).head(8).setOnes();
  features.row(1).tail(8).setOnes();
  CHECK(features_on(model, features).isApprox(expected));
  CHECK_THAT(complaint([&] { features_on(model, Eigen::MatrixXf::Ones(2, 15)); }),
             Contains("m.obj") && Contains("15 rows") && Contains("14 faces and 16 vertices"));
}

TEST_CASE("Faces of OFF, PLY and STL, of labels, and of a folder of files sorted by name")
{
  const std::string vertices = box_vertices(0, 0, 0, 1, 1, 1, "") + box_vertices(0, 1, 0, 1, 1, 1, ""),
                    faces = box_faces(0, "4 ") + box_faces(8, "4 ");
  const Temporary_folder folder;
  const auto check = [&](const std::string& model, Eigen::Index of_faces, Eigen::Index of_vertices) {
    INFO(model);
    for (Eigen::Index rows : {of_faces, of_vertices}) {
      if (rows == 0) continue;
      Eigen::MatrixXf features = Eigen::MatrixXf::Zero(2, rows);
      features.row(0).head(rows / 2).setOnes();
      features.row(1).tail(rows / 2).setOnes();
      const Eigen::MatrixXd parts = features_on(model, features);
      if (parts.cols() == 1) CHECK(parts.isApprox(Eigen::Vector2d(0.5, 0.5)));
      if (parts.cols() == 2) CHECK(parts.isApprox(Eigen::Matrix2d(0.5 * Eigen::Matrix2d::Identity())));
    }
  };
  check(folder.write("m.off", "OFF\n16 12 0\n" + vertices + faces), 12, 16);
  folder.write("labelled.seg", "0\n0\n0\n0\n0\n0\n1\n1\n1\n1\n1\n1\n");
  check(folder.write("labelled.off", "OFF\n16 12 0\n" + vertices + faces), 12, 16);
  check(
      folder.write("m.ply", "ply\nformat ascii 1.0\nelement vertex 16\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n" +
                                vertices + faces),
      12, 16);
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 ";
  check(folder.write("m.stl", "solid a\n" + facet + "0\nendloop\nendfacet\nendsolid a\nsolid b\n" + facet +
                                  "0\nendloop\nendfacet\nendsolid b\n"),
        2, 0);
  const Temporary_folder files;
  files.write("b.off", "OFF\n8 6 0\n" + box_vertices(0, 0, 0, 1, 1, 1, "") + box_faces(0, "4 "));
  files.write("c.obj", obj_box("o c", 0, 0, 1, 0, 1, 1, 1));
  check(files.path(""), 12, 16);
  files.write("a.stl", "solid a\n" + facet + "0\nendloop\nendfacet\nendsolid a\n");
  CHECK_THAT(complaint([&] { features_on(files.path(""), Eigen::MatrixXf::Ones(2, 19)); }),
             Contains("13 faces and 0 vertices"));
}

TEST_CASE("Models without numbered faces have no features")
{
  const Temporary_folder folder;
  const std::string robot =
      folder.write("r.urdf", "<robot name=\"r\"><link name=\"l\"><visual><geometry><box size=\"1 1 1\"/></geometry>"
                             "</visual></link></robot>");
  CHECK_THAT(complaint([&] { features_on(robot, Eigen::MatrixXf::Ones(2, 12)); }),
             Contains("r.urdf") && Contains("OBJ, OFF, PLY or STL"));
}

TEST_CASE("F1 rises with the signal in the features, and noise costs little")
{
  // All pairs of the chairs of data/. The feature of a part is `signal` times the unit vector of its label, plus a
  // random vector of a length of about `noise`
  std::deque<Structural_graph> graphs;
  std::vector<std::vector<Part_label>> labels;
  std::map<std::string, Eigen::Index> column;
  for (const std::string name : {"chair_four_legged", "chair_slatted", "chair_spindle", "chair_swivel", "stool"}) {
    const std::string folder = SHAPE_CORRESPONDENCE_DATA_DIR "/" + name;
    graphs.push_back(boxed_graphs::graph_of(IO::read_segmented_shape(folder)));
    const IO::Labelled_shape labelled = IO::read_part_labels(folder)[0];
    labels.emplace_back();
    for (const Part_abstraction& part : structure(graphs.back()).parts) {
      labels.back().push_back(labelled.labels[labelled.index(part.name)]);
      column.emplace(labels.back().back().coarse, Eigen::Index(column.size()));
    }
  }
  const auto mean_f1 = [&](double signal, double noise, const std::shared_ptr<const Role_model>& roles) {
    std::mt19937 random(1);
    std::vector<double> numbers;
    for (std::size_t shape = 0; shape < graphs.size(); ++shape) {
      Eigen::MatrixXd& features = structure(graphs[shape]).features;
      features.resize(signal + noise > 0 ? 32 : 0, Eigen::Index(labels[shape].size()));
      for (double& number : features.reshaped())
        number = noise / std::sqrt(32.) * std::sqrt(3.) * (2 * double(random()) / double(std::mt19937::max()) - 1);
      for (Eigen::Index part = 0; features.size() > 0 && part < features.cols(); ++part)
        features(column.at(labels[shape][std::size_t(part)].coarse), part) += signal;
    }
    double sum = 0, pairs = 0;
    Search_options options;
    options.roles = roles;
    for (std::size_t a = 0; a < graphs.size(); ++a)
      for (std::size_t b = a + 1; b < graphs.size(); ++b, ++pairs)
        sum += evaluate_correspondence(part_pairs(find_correspondence(graphs[a], graphs[b], options).pairs),
                                       ground_truth(labels[a], labels[b]))
                   .f1();
    return sum / pairs;
  };
  for (const auto& roles : {std::shared_ptr<const Role_model>(), IO::shipped_role_model()}) {
    const double without = mean_f1(0, 0, roles), strong = mean_f1(1, 0, roles), some = mean_f1(1, 1, roles),
                 only_noise = mean_f1(0, 1, roles);
    INFO((roles ? "with roles: " : "by geometry: ")
         << without << ", with features " << strong << ", with noise " << some << ", noise only " << only_noise);
    CHECK(strong > without + (roles ? 0 : 0.05));
    CHECK(some > without - 0.02);
    CHECK(strong >= some);
    CHECK(only_noise > without - 0.1);
  }
}
