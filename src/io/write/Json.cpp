// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/Json.h"
#include "base/number_text.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

std::string quoted(const std::string& text)
{
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  return std::all_of(text.begin(), text.end(), is_plain) ? '"' + text + '"' : nlohmann::json(utf8_text(text)).dump();
}

} // namespace

Json::Json(std::initializer_list<Json> elements) : Json(array(elements))
{
  if (!std::all_of(elements.begin(), elements.end(), [](const Json& element) { return element.is_pair(); })) return;
  type_ = Type::OBJECT;
  for (Json& pair : elements_) {
    keys_.push_back(pair.elements_[0].text_);
    pair = Json(pair.elements_[1]);
  }
}

Json Json::array(std::initializer_list<Json> elements)
{
  Json result(Type::ARRAY);
  result.elements_ = elements;
  return result;
}

Json Json::of_text(std::string json)
{
  Json result(Type::SCALAR);
  result.text_ = std::move(json);
  return result;
}

std::string Json::text_of_real(double number)
{
  if (!std::isfinite(number))
    throw Invalid_input(
        "a number of the result is not finite: the input is too degenerate to be computed with; repair it");
  return nlohmann::json(number).dump();
}

std::string Json::text_of_real(float number)
{
  return std::isfinite(number) ? internal::number_text(number) : text_of_real(double(number));
}

std::size_t Json::index_of(const std::string& key) const
{
  return std::size_t(std::find(keys_.begin(), keys_.end(), key) - keys_.begin());
}

Json& Json::operator[](const std::string& key)
{
  const std::size_t index = index_of(key);
  if (index < keys_.size()) return elements_[index];
  type_ = Type::OBJECT;
  keys_.push_back(key);
  return elements_.emplace_back();
}

void Json::push_back(Json element)
{
  type_ = Type::ARRAY;
  elements_.push_back(std::move(element));
}

void Json::erase(const std::string& key)
{
  const auto index = std::ptrdiff_t(index_of(key));
  keys_.erase(keys_.begin() + index);
  elements_.erase(elements_.begin() + index);
}

void Json::append_to(std::string& line) const
{
  if (type_ == Type::NONE) line += "null";
  if (type_ == Type::SCALAR) line += text_;
  if (type_ == Type::TEXT) line += quoted(text_);
  if (type_ != Type::ARRAY && type_ != Type::OBJECT) return;
  line += type_ == Type::ARRAY ? '[' : '{';
  for (std::size_t i = 0; i < size(); ++i) {
    if (i > 0) line += ',';
    if (type_ == Type::OBJECT) line += quoted(keys_[i]) + ':';
    elements_[i].append_to(line);
  }
  line += type_ == Type::ARRAY ? ']' : '}';
}

std::string Json::line() const
{
  std::string result;
  append_to(result);
  return result;
}

void Json::write(std::ostream& out) const
{
  for (std::size_t k = 0; k < size(); ++k) {
    const Json& value = elements_[k];
    out << (k == 0 ? "{\n" : ",\n") << "  " << quoted(keys_[k]) << ": ";
    if (value.type_ != Type::ARRAY || value.empty() || value.elements_[0].type_ != Type::OBJECT) {
      out << value.line();
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i)
      out << (i == 0 ? "[\n    " : ",\n    ") << value.elements_[i].line();
    out << "\n  ]";
  }
  out << "\n}\n";
}

} // namespace CGAL::Shape_correspondence::IO
