// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// A JSON value to be written. Objects keep the order in which their keys were added.
///
/// The interface is that of `nlohmann::ordered_json`, whose templates make files compile two to three times as long.
class Json
{
public:
  Json() = default; ///< null
  /// A number. \throw Invalid_input if it is not finite: then the input exceeded the range of the computation
  template <typename Number, typename = std::enable_if_t<std::is_arithmetic<Number>::value>>
  Json(Number number) : type_(Type::SCALAR), text_(text_of(number))
  {}
  Json(std::string text) : type_(Type::TEXT), text_(std::move(text)) {} ///< in UTF-8, or else Latin-1
  Json(const char* text) : Json(std::string(text)) {}
  template <typename Value>
  Json(const std::vector<Value>& values) : type_(Type::ARRAY), elements_(values.begin(), values.end())
  {}
  /// An object if every element is an array of a text (the key) and a value; otherwise an array.
  Json(std::initializer_list<Json> elements);

  static Json array(std::initializer_list<Json> elements = {});
  static Json object() { return Json(Type::OBJECT); }
  /// A value stored as its text, in a fraction of the memory. Its content cannot be changed.
  static Json of_text(std::string json);

  std::size_t size() const { return elements_.size(); } ///< number of elements of an array or object
  bool empty() const { return elements_.empty(); }
  bool contains(const std::string& key) const { return index_of(key) < keys_.size(); }
  Json& operator[](const std::string& key); ///< adds the key if it is missing
  Json& operator[](std::size_t i) { return elements_[i]; }
  Json& back() { return elements_.back(); }
  void push_back(Json element); ///< appends to an array; null becomes an array
  void erase(const std::string& key);

  /// The text on one line. Numbers are the shortest that read as the same double or float.
  std::string line() const;
  /// Writes an object for people and line-wise comparison: one line for each key and each element of an array of
  /// objects.
  void write(std::ostream& out) const;

private:
  enum class Type { NONE, SCALAR, TEXT, ARRAY, OBJECT };

  explicit Json(Type type) : type_(type) {}

  template <typename Number>
  static std::string text_of(Number number)
  {
    if constexpr (std::is_same<Number, bool>::value)
      return number ? "true" : "false";
    else if constexpr (std::is_integral<Number>::value)
      return std::to_string(number);
    else
      return text_of_real(number);
  }
  static std::string text_of_real(double number);
  static std::string text_of_real(float number);
  std::size_t index_of(const std::string& key) const;
  bool is_pair() const { return type_ == Type::ARRAY && size() == 2 && elements_[0].type_ == Type::TEXT; }
  void append_to(std::string& line) const;

  Type type_ = Type::NONE;
  std::string text_;              ///< the characters of a text, or the JSON notation of a scalar
  std::vector<std::string> keys_; ///< keys of an object's elements
  std::vector<Json> elements_;
};

} // namespace CGAL::Shape_correspondence::IO
