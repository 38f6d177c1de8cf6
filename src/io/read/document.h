// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <boost/property_tree/ptree_fwd.hpp>
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The entire content of a stream. \throw Invalid_input, naming `file`, if it is larger than `largest_document`
std::string read_document(std::istream& in, const std::string& file);

/// Throws `Invalid_input` for nesting beyond `deepest_document`, since parsers and destructors recurse.
void check_json_depth(std::string_view text, const std::string& file);

/// Parses an XML document. \throw Invalid_input, naming `file`, if it is invalid or nested too deeply
boost::property_tree::ptree parse_xml(const std::string& text, const std::string& file);

/// A value in a JSON document with its place, so that every error names the file and the place.
class Json_field
{
public:
  /// Throws `Invalid_input` with file, place and `what`.
  [[noreturn]] void fail(const std::string& what) const;

  bool has(const std::string& key) const;
  /// Whether the field is an object that has the text `text` at `key`.
  bool has(const std::string& key, const std::string& text) const;
  Json_field operator[](const std::string& key) const; ///< fails if the key is missing

  std::size_t size() const;                 ///< fails if this is no array
  std::vector<Json_field> elements() const; ///< fails if this is no array
  std::vector<Json_field> elements(std::size_t size, const char* meaning) const;

  double number() const; ///< fails beyond `largest_number`
  double number_at_least_0() const;
  int integer() const;
  bool boolean() const;
  bool is_null() const;
  bool is_text() const;
  std::string text() const;
  std::vector<std::string> texts() const;                  ///< fails if this is no array
  std::map<std::string, std::string> texts_by_key() const; ///< fails if this is no object
  Point point() const;                                     ///< fails beyond `largest_coordinate`
  Point unit_vector() const;
  Points points() const; ///< fails if this is no array
  Points points(std::size_t size, const char* meaning) const;

private:
  friend Json_field parse_json(std::string_view text, const std::string& file);

  using Value = std::shared_ptr<const nlohmann::json>; ///< shares ownership of the document
  using File = std::shared_ptr<const std::string>; ///< name of the file, shared since there may be millions of fields

  Json_field(Value value, File file, std::string place)
      : value_(std::move(value)), file_(std::move(file)), place_(std::move(place))
  {}

  Json_field at(const nlohmann::json& value, std::string place) const
  {
    return {Value(value_, &value), file_, std::move(place)};
  }
  Json_field element(std::size_t index) const;
  void check_size(std::size_t size, const char* meaning) const;

  Value value_;
  File file_;
  std::string place_;
};

/// Parses a JSON document. \throw Invalid_input, naming `file`, if it is invalid or nested too deeply
Json_field parse_json(std::string_view text, const std::string& file);

/// Reads a JSON document. \throw Invalid_input, naming `file`, if it is invalid, too long or nested too deeply
Json_field read_json(std::istream& in, const std::string& file);

/// Reads a JSON document from a file. \throw Invalid_input if the file cannot be read or is invalid
Json_field read_json_file(const std::string& path);

} // namespace CGAL::Shape_correspondence::IO
