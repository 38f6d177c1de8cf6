// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/matrix_files.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <cstring>
#include <filesystem>
#include <limits>
#include <sstream>

using namespace CGAL::Shape_correspondence::IO;
using Catch::Matchers::Contains;
using CGAL::Shape_correspondence::Invalid_input;

TEST_CASE("NumPy reads the file: magic, version, header of the length it states, rows of doubles")
{
  Eigen::MatrixXd matrix(2, 3);
  matrix << 0, 0.1, 1e-300, -2, 3, 1. / 3;
  std::ostringstream out;
  write_npy(out, matrix);
  const std::string bytes = out.str();
  CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length = std::size_t((unsigned char)bytes[8]) + 256 * std::size_t((unsigned char)bytes[9]);
  CHECK((10 + length) % 64 == 0);
  const std::string header = bytes.substr(10, length);
  CHECK(header.find("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }") == 0);
  CHECK(header.back() == '\n');
  REQUIRE(bytes.size() == 10 + length + 6 * sizeof(double));
  double numbers[6];
  std::memcpy(numbers, bytes.data() + 10 + length, sizeof numbers);
  for (int i = 0; i < 6; ++i)
    CHECK(numbers[i] == matrix(i / 3, i % 3));
}

TEST_CASE("Rows of large matrices are in their order")
{
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(1100, 7);
  std::ostringstream out;
  write_npy(out, matrix);
  const std::string bytes = out.str();
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(1100, 7);
  const std::size_t size = std::size_t(rows.size()) * sizeof(double);
  REQUIRE(bytes.size() > size);
  std::memcpy(rows.data(), bytes.data() + bytes.size() - size, size);
  CHECK(rows == matrix);
}

TEST_CASE("CSV quotes names and keeps every bit of a number")
{
  Eigen::MatrixXd matrix(2, 2);
  matrix << 0, 0.1, 1. / 3, 2;
  std::ostringstream out;
  write_csv(out, matrix, {"a", "b, \"c\""});
  CHECK(out.str() == ",a,\"b, \"\"c\"\"\"\r\na,0,0.1\r\n\"b, \"\"c\"\"\",0.3333333333333333,2\r\n");
  std::ostringstream formulas; // names that a spreadsheet would evaluate
  matrix << -1, 0, 0, 0;
  write_csv(formulas, matrix, {"=1+1", "@a,b"});
  CHECK(formulas.str() == ",'=1+1,\"'@a,b\"\r\n'=1+1,-1,0\r\n\"'@a,b\",0,0\r\n");
}
