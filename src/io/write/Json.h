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

/// A JSON value to be written. Objects keep the order in which their keys were set.
///
/// It is built as `nlohmann::ordered_json` is, whose templates make a file that builds values with them take two to
/// three times as long to compile.
class Json
{
public:
  Json() = default; ///< null
  /// \throw Invalid_input if the number is not finite, since then the input has been too much for the computation
  template <typename Number, typename = std::enable_if_t<std::is_arithmetic<Number>::value>>
  Json(Number number) : type_(Type::SCALAR), text_(text_of(number))
  {}
  Json(std::string text) : type_(Type::TEXT), text_(std::move(text)) {} ///< in UTF-8, or else in Latin-1
  Json(const char* text) : Json(std::string(text)) {}
  template <typename Value>
  Json(const std::vector<Value>& values) : type_(Type::ARRAY), elements_(values.begin(), values.end())
  {}
  /// An object if every element is an array of a text, the key, and a value; else an array.
  Json(std::initializer_list<Json> elements);

  static Json array(std::initializer_list<Json> elements = {});
  static Json object() { return Json(Type::OBJECT); }
  /// A value that is kept as its text, in a fraction of the memory. Nothing inside of it can be changed.
  static Json of_text(std::string json);

  std::size_t size() const { return elements_.size(); } ///< of an array or object
  bool empty() const { return elements_.empty(); }
  bool contains(const std::string& key) const { return index_of(key) < keys_.size(); }
  Json& operator[](const std::string& key); ///< added where it is missing
  Json& operator[](std::size_t i) { return elements_[i]; }
  Json& back() { return elements_.back(); }
  void push_back(Json element); ///< into an array, or null, which becomes one
  void erase(const std::string& key);

  /// The text on one line. Numbers are the shortest that read back to the same double or float.
  std::string line() const;
  /// Writes an object for people and for line-wise comparison: a line a key, and a line an element of an array of
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
  std::string text_;              ///< of a text: itself; of a scalar: its notation
  std::vector<std::string> keys_; ///< of an object, by element
  std::vector<Json> elements_;
};

} // namespace CGAL::Shape_correspondence::IO
