// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/read_objects.h"
#include "io/read/text_words.h"
#include "io/system/bytes.h"
#include "io/system/input_file.h"
#include "shape/Surface_features.h"

#include <CGAL/Shape_correspondence/IO/read_features.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cctype>
#include <filesystem>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr const char* write_again = "write the array again with numpy.save()";
constexpr const char* convert = "write it again with numpy.save(file, array.astype('<f4'))";
constexpr std::string_view npy_mark = "\x93NUMPY", zip_mark = "PK\x03\x04";
constexpr std::size_t longest_header = 1 << 16; // limit in bytes; that of NumPy is 10000

/// Reads a file in NumPy's format .npy.
class Npy_reader
{
public:
  explicit Npy_reader(const std::string& file) : file_(file), in_(open_input(file))
  {
    if (!std::filesystem::is_regular_file(file)) fail("it is a device", "copy the array into a file");
    rest_ = std::filesystem::file_size(file);
  }

  Eigen::MatrixXf read()
  {
    const std::string header = read_header();
    text_ = header;
    read_dictionary();
    const std::size_t size = is_double_ ? sizeof(double) : sizeof(float);
    if (rows_ > rest_ / size / columns_ || rows_ * columns_ * size != rest_)
      fail("its header says an array of shape (" + std::to_string(rows_) + ", " + std::to_string(columns_) + "), but " +
               std::to_string(rest_) + " bytes follow: it is cut off or damaged",
           write_again);
    Eigen::MatrixXf result{Eigen::Index(columns_), Eigen::Index(rows_)};
    // `inner` changes fastest in the file: the column of the array or, in Fortran order, its row
    for (std::size_t outer = 0; outer < (is_fortran_ ? columns_ : rows_); ++outer) {
      const std::size_t count = is_fortran_ ? rows_ : columns_;
      const std::string numbers = bytes(count * size);
      for (std::size_t inner = 0; inner < count; ++inner) {
        const char* const at = &numbers[inner * size];
        const float number = is_double_ ? float(number_in<double>(at)) : number_in<float>(at);
        (is_fortran_ ? result(Eigen::Index(outer), Eigen::Index(inner))
                     : result(Eigen::Index(inner), Eigen::Index(outer))) = number;
      }
    }
    internal::check_features(file_, result);
    return result;
  }

private:
  [[noreturn]] void fail(const std::string& what, const char* remedy) const { refuse(file_ + ": " + what, remedy); }
  [[noreturn]] void fail_in_header() const { fail("its header is damaged", write_again); }

  std::string bytes(std::size_t count)
  {
    if (count > rest_) fail("it is cut off", write_again);
    std::string result(count, '\0');
    in_.read(result.data(), std::streamsize(count));
    if (std::size_t(in_.gcount()) != count) fail("it cannot be read to its end", write_again);
    rest_ -= count;
    return result;
  }

  std::string read_header()
  {
    const std::string start = bytes(std::size_t(std::min<std::uintmax_t>(npy_mark.size() + 2, rest_)));
    if (begins_with(start, zip_mark)) fail("it is an archive of arrays (.npz)", write_again);
    if (!begins_with(start, npy_mark) || start.size() < npy_mark.size() + 2)
      fail("it is not an array of NumPy (.npy)", write_again);
    const int version = start[npy_mark.size()];
    if (version < 1 || version > 3)
      fail("it is of version " + std::to_string(version) + " of the format; 1, 2 and 3 are known", write_again);
    const std::size_t length =
        version == 1 ? number_in<std::uint16_t>(bytes(2).data()) : number_in<std::uint32_t>(bytes(4).data());
    if (length > longest_header)
      fail("its header has " + std::to_string(length) + " bytes, which is too long", write_again);
    return bytes(length);
  }

  /// Reads a header such as {'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }.
  void read_dictionary()
  {
    std::string type;
    bool has_order = false;
    if (!take('{')) fail_in_header();
    while (!take('}')) {
      const std::string key = quoted_text();
      if (!take(':')) fail_in_header();
      if (key == "descr")
        type = begins_with(trimmed(text_), "[") ? "a structure" : quoted_text();
      else if (key == "fortran_order")
        has_order = true, is_fortran_ = read_bool();
      else if (key == "shape")
        read_shape();
      else
        fail_in_header();
      if (type == "a structure") break; // its fields are not read
      take(',');
    }
    check_type(type);
    if (!has_order || columns_ == 0) fail_in_header();
  }

  void check_type(const std::string& type)
  {
    if (type.empty()) fail_in_header();
    if (begins_with(type, ">")) fail("its numbers are big-endian (" + cited(type) + ")", convert);
    if (type.find('O') != std::string::npos) fail("it has Python objects, which are not read", convert);
    is_double_ = type == "<f8";
    if (!is_double_ && type != "<f4")
      fail("its elements are of type " + cited(type) + ", not float32 or float64", convert);
  }

  void read_shape()
  {
    std::vector<std::size_t> shape;
    if (!take('(')) fail_in_header();
    while (!take(')')) {
      text_ = trimmed(text_);
      std::size_t digits = 0, number = 0;
      while (digits < text_.size() && std::isdigit(static_cast<unsigned char>(text_[digits])))
        ++digits;
      if (!parse(text_.substr(0, digits), number)) fail_in_header();
      text_.remove_prefix(digits);
      take('L'); // suffix of integers by Python 2
      take(',');
      shape.push_back(number);
    }
    if (shape.size() != 2 || shape[0] == 0 || shape[1] == 0)
      fail("its array has " + std::to_string(shape.size()) + " dimensions, or one of length 0",
           "give an array of shape (n, d), a row for each face or vertex");
    rows_ = shape[0];
    columns_ = shape[1];
  }

  /// Removes blanks, and then the character `wanted` if it is next. \return whether it was
  bool take(char wanted)
  {
    text_ = trimmed(text_);
    if (text_.empty() && wanted != ',' && wanted != 'L') fail_in_header();
    if (text_.empty() || text_[0] != wanted) return false;
    text_.remove_prefix(1);
    return true;
  }

  std::string quoted_text()
  {
    const char quote = take('\'') ? '\'' : take('"') ? '"' : '\0';
    const std::size_t end = text_.find(quote);
    if (quote == '\0' || end == std::string_view::npos) fail_in_header();
    std::string result(text_.substr(0, end));
    text_.remove_prefix(end + 1);
    return result;
  }

  bool read_bool()
  {
    text_ = trimmed(text_);
    const bool result = begins_with(text_, "True");
    const std::string_view word = result ? "True" : "False";
    if (!begins_with(text_, word)) fail_in_header();
    text_.remove_prefix(word.size());
    return result;
  }

  const std::string& file_;
  std::ifstream in_;
  std::uintmax_t rest_ = 0; ///< number of bytes of the file that are still unread
  std::string_view text_;   ///< unread part of the header
  bool is_double_ = false, is_fortran_ = false;
  std::size_t rows_ = 0, columns_ = 0;
};

} // namespace

Eigen::MatrixXf read_features(const std::string& file) { return Npy_reader(file).read(); }

Eigen::MatrixXd features_of_parts(const Eigen::MatrixXf& features, const std::string& model, const Part_split& split,
                                  const Reading_options& options)
{
  internal::check_features(model, features);
  const Model_objects objects = read_objects(model, Point::UnitY(), options);
  if (objects.number_of_faces == 0)
    throw Invalid_input(model +
                        ": features of faces or vertices are for models in OBJ, OFF, PLY or STL, and folders of "
                        "these; save it as one of them, and compute its features then");
  for (const Model_piece& piece : split.pieces)
    if (piece.object >= objects.shape.parts().size())
      throw Invalid_input(model + ": the file has changed since it was read; try again");
  const auto rows = std::size_t(features.cols());
  const bool are_of_faces = rows == objects.number_of_faces;
  if (!are_of_faces && rows != objects.number_of_vertices)
    throw Invalid_input(model + ": there are " + std::to_string(rows) + " rows of features, but it has " +
                        std::to_string(objects.number_of_faces) + " faces and " +
                        std::to_string(objects.number_of_vertices) +
                        " vertices; give one row for each, in the order of the file. If the program that computed them "
                        "divides polygons or merges vertices, save the model as it has it, and match that one");
  internal::Surface_features placed{features, {}};
  for (std::size_t object = 0; object < objects.shape.parts().size(); ++object) {
    Eigen::Matrix3Xi& columns = placed.columns.emplace_back(3, objects.shape.parts()[object].mesh.triangles.cols());
    for (Eigen::Index corner = 0; corner < columns.size(); ++corner)
      columns.data()[corner] = are_of_faces ? int(objects.faces[object][std::size_t(corner / 3)])
                                            : objects.vertices[object][std::size_t(corner)];
  }
  return internal::integrated(placed, objects.shape, split);
}

} // namespace CGAL::Shape_correspondence::IO
