// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace CGAL::Shape_correspondence::internal {

/// The name of the library calls that a test makes fail; empty: none.
inline std::string failing_library_call;

inline void check_library_call(const char* name)
{
  if (failing_library_call == name) throw std::runtime_error("a failure that a test asked for");
}

/// The result of `call` or, if it throws, of `otherwise`. CGAL and other libraries throw on surfaces that they cannot
/// treat; the caller knows the part and a replacement for the result.
/// \param name name of the call, by which tests make it fail
template <typename Call, typename Fallback>
auto library_call(const char* name, const Call& call, const Fallback& otherwise) -> decltype(call())
{
  try {
    check_library_call(name);
    return call();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return otherwise();
  }
}

} // namespace CGAL::Shape_correspondence::internal
