// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/document.h"
#include "base/limits.h"
#include "io/read/text_words.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <istream>
#include <limits>
#include <sstream>

namespace CGAL::Shape_correspondence::IO {
namespace {

void check_depth(std::size_t depth, const std::string& file)
{
  if (depth > internal::deepest_document)
    refuse(file + ": it is nested deeper than " + std::to_string(internal::deepest_document) + " levels",
           remedy::check_kind);
}

void skip_past(std::string_view end, std::string_view& text)
{
  const std::size_t at = text.find(end);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + end.size());
}

/// Skips an opening tag, whose attributes are quoted. \return whether it is an empty element
bool skip_tag(std::string_view& text)
{
  char quote = 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (quote == 0 && text[i] == '>') {
      const bool closes = text[i - 1] == '/';
      text.remove_prefix(i + 1);
      return closes;
    }
    if (text[i] == quote)
      quote = 0;
    else if (quote == 0 && (text[i] == '"' || text[i] == '\''))
      quote = text[i];
  }
  text = {};
  return false;
}

void check_xml_depth(std::string_view text, const std::string& file)
{
  std::size_t depth = 0;
  while (text = text.substr(std::min(text.find('<'), text.size())), !text.empty()) {
    if (begins_with(text, "<!--")) {
      skip_past("-->", text);
    } else if (begins_with(text, "<![CDATA[")) {
      skip_past("]]>", text);
    } else if (begins_with(text, "<!") || begins_with(text, "<?")) {
      skip_past(">", text);
    } else if (begins_with(text, "</")) {
      depth -= depth > 0 ? 1 : 0;
      skip_past(">", text);
    } else if (!skip_tag(text)) {
      check_depth(++depth, file);
    }
  }
}

/// Whether a value is a point with coordinates of at most `largest_coordinate`.
bool is_point(const nlohmann::json& value)
{
  return value.is_array() && value.size() == 3 && std::all_of(value.begin(), value.end(), [](const auto& coordinate) {
           return coordinate.is_number() && std::abs(coordinate.template get<double>()) <= internal::largest_coordinate;
         });
}

/// Upper estimate of the memory, in bytes, for the values of a document, including reallocated lists.
std::uint64_t memory_of_values(std::string_view text)
{
  constexpr std::uint64_t of_value = 40, of_list = 64, of_object = 96, of_quote = 32;
  std::uint64_t result = of_value;
  for (char c : text)
    result += c == ',' ? of_value : c == '[' ? of_list : c == '{' ? of_object : c == '"' ? of_quote : 0;
  return result;
}

/// Throws `std::bad_alloc` if there is no memory for the values of a document. The parser would crash instead, since it
/// needs memory to destroy a partial document.
void check_memory(std::string_view text, const std::string& file)
{
  const std::uint64_t bytes = memory_of_values(text);
  if (bytes > internal::most_memory_of_values)
    throw Invalid_input(file + ": its values would take more than " +
                        std::to_string(internal::most_memory_of_values >> 30) + " GB of memory; divide it");
  ::operator delete(::operator new(std::size_t(bytes)));
}

} // namespace

std::string read_document(std::istream& in, const std::string& file)
{
  std::string text;
  std::string buffer(std::size_t(1) << 16, '\0');
  while (in) {
    in.read(buffer.data(), std::streamsize(buffer.size()));
    text.append(buffer, 0, std::size_t(in.gcount()));
    if (text.size() > internal::largest_document)
      refuse(file + ": it is longer than " + std::to_string(internal::largest_document >> 20) + " MB",
             remedy::make_smaller);
  }
  check_is_not_wide(text, file);
  return text;
}

void check_json_depth(std::string_view text, const std::string& file)
{
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"')
      in_string = !in_string;
    else if (in_string && c == '\\')
      ++i;
    else if (!in_string && (c == '[' || c == '{'))
      check_depth(++depth, file);
    else if (!in_string && depth > 0 && (c == ']' || c == '}'))
      --depth;
  }
}

boost::property_tree::ptree parse_xml(const std::string& text, const std::string& file)
{
  check_xml_depth(text, file);
  boost::property_tree::ptree result;
  std::istringstream in(text);
  try {
    boost::property_tree::read_xml(in, result);
  } catch (const boost::property_tree::xml_parser_error& error) {
    refuse(file + ": it is not an XML document (line " + std::to_string(error.line()) + ": " + error.message() + ")",
           remedy::correct_text);
  }
  return result;
}

void Json_field::fail(const std::string& what) const
{
  refuse(*file_ + ": " + (place_.empty() ? "the document" : place_) + " " + what, remedy::correct_text);
}

bool Json_field::has(const std::string& key) const
{
  if (!value_->is_object()) fail("is not an object {...}");
  return value_->contains(key);
}

bool Json_field::has(const std::string& key, const std::string& text) const
{
  return value_->is_object() && value_->value(key, nlohmann::json()) == text;
}

Json_field Json_field::operator[](const std::string& key) const
{
  if (!has(key)) fail("has no key \"" + key + "\"");
  return at((*value_)[key], place_.empty() ? key : place_ + "." + key);
}

std::size_t Json_field::size() const
{
  if (!value_->is_array()) fail("is not an array [...]");
  return value_->size();
}

Json_field Json_field::element(std::size_t index) const
{
  return at((*value_)[index], place_ + "[" + std::to_string(index) + "]");
}

std::vector<Json_field> Json_field::elements() const
{
  std::vector<Json_field> result;
  result.reserve(size());
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.push_back(element(i));
  return result;
}

void Json_field::check_size(std::size_t size, const char* meaning) const
{
  if (this->size() != size)
    fail("is not " + std::string(meaning) + ": it has " + std::to_string(this->size()) + " elements instead of " +
         std::to_string(size));
}

std::vector<Json_field> Json_field::elements(std::size_t size, const char* meaning) const
{
  check_size(size, meaning);
  return elements();
}

double Json_field::number() const
{
  if (!value_->is_number()) fail("is not a number");
  const double result = value_->get<double>();
  if (!(std::abs(result) <= internal::largest_number)) fail("is beyond 1e50");
  return result;
}

double Json_field::number_at_least_0() const
{
  const double result = number();
  if (result < 0) fail("is negative");
  return result;
}

int Json_field::integer() const
{
  if (!value_->is_number_integer()) fail("is not a whole number");
  constexpr int largest = std::numeric_limits<int>::max();
  if (std::abs(value_->get<double>()) > largest) fail("is beyond " + std::to_string(largest));
  return value_->get<int>();
}

bool Json_field::boolean() const
{
  if (!value_->is_boolean()) fail("is neither true nor false");
  return value_->get<bool>();
}

bool Json_field::is_null() const { return value_->is_null(); }

bool Json_field::is_text() const { return value_->is_string(); }

std::string Json_field::text() const
{
  if (!value_->is_string()) fail("is not a string");
  return value_->get<std::string>();
}

std::vector<std::string> Json_field::texts() const
{
  std::vector<std::string> result;
  for (const Json_field& element : elements())
    result.push_back(element.text());
  return result;
}

std::map<std::string, std::string> Json_field::texts_by_key() const
{
  if (!value_->is_object()) fail("is not an object");
  std::map<std::string, std::string> result;
  for (const auto& [key, value] : value_->items())
    result[key] = (*this)[key].text();
  return result;
}

Point Json_field::point() const
{
  const std::vector<Json_field> coordinates = elements(3, "a point [x, y, z]");
  const Point result(coordinates[0].number(), coordinates[1].number(), coordinates[2].number());
  if (result.cwiseAbs().maxCoeff() > internal::largest_coordinate) fail("has a coordinate beyond 1e15");
  return result;
}

Point Json_field::unit_vector() const
{
  const Point result = point();
  if (std::abs(result.norm() - 1) > 1e-6) fail("is not a unit vector");
  return result;
}

Points Json_field::points() const
{
  Points result(3, size());
  for (std::size_t i = 0; i < size(); ++i) {
    const nlohmann::json& value = (*value_)[i];
    result.col(Eigen::Index(i)) =
        is_point(value) ? Point(value[0].get<double>(), value[1].get<double>(), value[2].get<double>())
                        : element(i).point(); // slower, since it keeps the place in the document for the error
  }
  return result;
}

Points Json_field::points(std::size_t size, const char* meaning) const
{
  check_size(size, meaning);
  return points();
}

Json_field parse_json(std::string_view text, const std::string& file)
{
  if (text.empty()) refuse(file + ": the file is empty", remedy::save_again);
  check_json_depth(text, file);
  check_memory(text, file);
  try {
    return {std::make_shared<const nlohmann::json>(nlohmann::json::parse(text.begin(), text.end())),
            std::make_shared<const std::string>(file), ""};
  } catch (const nlohmann::json::exception& error) {
    std::string what = error.what(); // the text after the exception's name in brackets
    boost::algorithm::replace_all(what, "; ", ", ");
    refuse(file + ": it is not a JSON document (" + what.substr(what.find("] ") + 2) + ")", remedy::correct_text);
  }
}

Json_field read_json(std::istream& in, const std::string& file) { return parse_json(read_document(in, file), file); }

Json_field read_json_file(const std::string& path)
{
  std::ifstream in = open_input(path);
  return read_json(in, path);
}

} // namespace CGAL::Shape_correspondence::IO
