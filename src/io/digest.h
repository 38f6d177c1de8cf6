// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_DIGEST_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_DIGEST_H

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// A digest (SHA-1) of bytes.
inline std::string digest(const std::string& bytes)
{
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return to_string(generator(bytes.data(), bytes.size()));
}

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_DIGEST_H
