// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Json_field.h"
#include "base/limits.h"
#include "io/document.h"
#include "io/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace CGAL::Shape_correspondence::IO {

void Json_field::fail(const std::string& what) const
{
  throw Invalid_input(file_ + ": " + (place_.empty() ? "the document" : place_) + " " + what);
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

std::vector<Json_field> Json_field::elements() const
{
  if (!value_->is_array()) fail("is not an array [...]");
  std::vector<Json_field> result;
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.push_back(at((*value_)[i], place_ + "[" + std::to_string(i) + "]"));
  return result;
}

std::vector<Json_field> Json_field::elements(std::size_t size, const char* meaning) const
{
  std::vector<Json_field> result = elements();
  if (result.size() != size)
    fail("is not " + std::string(meaning) + ": it has " + std::to_string(result.size()) + " elements instead of " +
         std::to_string(size));
  return result;
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

namespace {

/// Throws `std::bad_alloc` if there is not the memory for the values of a document. The parser cannot: it needs memory
/// to take down again what it has built.
void check_memory(const std::string& text)
{
  constexpr std::size_t size_of_value = 128; // bytes, with what lists that grow leave behind
  ::operator delete(::operator new(size_of_value*(1 + std::size_t(std::count(text.begin(), text.end(), ',')))));
}

} // namespace

Json_field read_json(std::istream& in, const std::string& file)
{
  const std::string text = read_document(in, file);
  if (text.empty()) throw Invalid_input(file + ": the file is empty");
  check_json_depth(text, file);
  check_memory(text);
  try {
    return {std::make_shared<const nlohmann::json>(nlohmann::json::parse(text)), file, ""};
  } catch (const nlohmann::json::exception& error) {
    const std::string what = error.what(); // after the name of the exception, in brackets
    throw Invalid_input(file + ": it is not a JSON document (" + what.substr(what.find("] ") + 2) + ")");
  }
}

Json_field read_json_file(const std::string& path)
{
  std::ifstream in = open_input(path);
  return read_json(in, path);
}

} // namespace CGAL::Shape_correspondence::IO
