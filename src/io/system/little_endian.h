// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <boost/endian/conversion.hpp>

#include <string>

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

} // namespace CGAL::Shape_correspondence::IO
