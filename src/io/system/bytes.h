// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <Eigen/Core>
#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL::Shape_correspondence::IO {

/// Decodes a number from the bytes of a file.
template <typename Number, boost::endian::order Order = boost::endian::order::little>
Number number_in(const char* bytes)
{
  return boost::endian::endian_load<Number, sizeof(Number), Order>(reinterpret_cast<const unsigned char*>(bytes));
}

/// Decodes a number of any type and converts it to double.
template <typename Number, boost::endian::order Order = boost::endian::order::little>
double real_in(const char* bytes)
{
  return double(number_in<Number, Order>(bytes));
}

/// Appends the bytes of a number, the lowest first.
template <typename Number>
void append_little_endian(std::string& bytes, Number number)
{
  unsigned char own[sizeof(Number)];
  boost::endian::endian_store<Number, sizeof(Number), boost::endian::order::little>(own, number);
  bytes.append(own, own + sizeof own);
}

/// Writes values as bytes, or reads them again by the same calls of `pass()`. The bytes are as in memory.
class Value_bytes
{
public:
  Value_bytes() = default;
  explicit Value_bytes(std::string_view written) : rest_(written), reads_(true) {}

  void raw(void* data, std::size_t size)
  {
    if (!reads_) return void(bytes.append(static_cast<const char*>(data), size));
    check(size, 1);
    rest_.copy(static_cast<char*>(data), size);
    rest_.remove_prefix(size);
  }

  /// Writes or reads a number of elements; fails if the bytes to read are too few. \param of_element least bytes of one
  std::size_t count(std::size_t elements, std::size_t of_element)
  {
    std::uint64_t number = elements;
    raw(&number, sizeof number);
    if (reads_) check(number, of_element);
    return std::size_t(number);
  }

  std::string bytes; ///< what was written

private:
  void check(std::uint64_t elements, std::size_t of_element) const
  {
    if (elements > rest_.size() / of_element) throw Invalid_input("what its reader sends is damaged");
  }

  std::string_view rest_;
  bool reads_ = false;
};

/// Whether a list of such values is one block of bytes: numbers, or vectors of fixed size.
template <typename Value>
constexpr bool is_plain()
{
  if constexpr (std::is_base_of_v<Eigen::EigenBase<Value>, Value>)
    return Value::SizeAtCompileTime != Eigen::Dynamic;
  else
    return std::is_trivially_copyable_v<Value>;
}

/// Writes or reads a number, a matrix, a text or a list. Structures have overloads.
template <typename Value>
void pass(Value_bytes& bytes, Value& value)
{
  if constexpr (std::is_base_of_v<Eigen::EigenBase<Value>, Value>) {
    constexpr std::size_t of_column = sizeof(typename Value::Scalar) * std::size_t(Value::RowsAtCompileTime);
    const std::size_t columns = bytes.count(std::size_t(value.cols()), of_column);
    if constexpr (!is_plain<Value>()) value.resize(value.rows(), Eigen::Index(columns));
    bytes.raw(value.data(), of_column * std::size_t(value.cols()));
  } else if constexpr (is_plain<Value>()) {
    bytes.raw(&value, sizeof value);
  } else {
    using Element = typename Value::value_type;
    constexpr std::size_t of_element = is_plain<Element>() ? sizeof(Element) : 1;
    value.resize(bytes.count(value.size(), of_element));
    if constexpr (is_plain<Element>())
      bytes.raw(value.data(), of_element * value.size());
    else
      for (Element& element : value)
        pass(bytes, element);
  }
}

template <typename... Values>
void pass_all(Value_bytes& bytes, Values&... values)
{
  (pass(bytes, values), ...);
}

} // namespace CGAL::Shape_correspondence::IO
