// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <string>

namespace CGAL::Shape_correspondence::IO {

/// A digest (SHA-1) of bytes.
inline std::string digest(const std::string& bytes)
{
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return to_string(generator(bytes.data(), bytes.size()));
}

} // namespace CGAL::Shape_correspondence::IO
