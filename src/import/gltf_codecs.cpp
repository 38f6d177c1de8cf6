// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "import/beside_assimp.h"

#ifdef SHAPE_CORRESPONDENCE_WITH_DRACO
#include <draco/compression/decode.h>
#include <draco/core/decoder_buffer.h>
#endif
#ifdef SHAPE_CORRESPONDENCE_WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace CGAL::Shape_correspondence::IO {
namespace {

#ifdef SHAPE_CORRESPONDENCE_WITH_DRACO

/// The values of an attribute, one column for each vertex; an empty matrix if they cannot be read.
Eigen::MatrixXd numbers_of(draco::PointAttribute& attribute, std::uint32_t points)
{
  constexpr int most_components = 4;
  if (attribute.num_components() > most_components) return {};
  attribute.set_normalized(false); // the glTF document, not Draco, says whether they are
  Eigen::MatrixXd result(attribute.num_components(), points);
  for (std::uint32_t point = 0; point < points; ++point)
    if (!attribute.ConvertValue<double>(attribute.mapped_index(draco::PointIndex(point)), result.col(point).data()))
      return {};
  return result;
}

/// Decodes a mesh; the result has no attributes if the data are damaged.
Draco_mesh decoded_by_draco(std::string_view bytes)
{
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  const auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return {};
  draco::Mesh& mesh = *decoded.value();
  Draco_mesh result;
  result.corners.reserve(3 * std::size_t(mesh.num_faces()));
  for (std::uint32_t f = 0; f < mesh.num_faces(); ++f)
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(f)))
      result.corners.push_back(corner.value());
  for (int i = 0; i < mesh.num_attributes(); ++i)
    result.attributes[int(mesh.attribute(i)->unique_id())] = numbers_of(*mesh.attribute(i), mesh.num_points());
  return result;
}

#endif
#ifdef SHAPE_CORRESPONDENCE_WITH_MESHOPTIMIZER

/// Decompresses a view after checking its sizes, which the library only asserts. \return whether the data are valid
bool decode_meshopt(const Meshopt_view& view, std::string& result)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*>(view.bytes.data());
  const bool is_of_indices = view.stride == 2 || view.stride == 4;
  if (view.mode == "ATTRIBUTES")
    return view.stride % 4 == 0 &&
           meshopt_decodeVertexBuffer(result.data(), view.count, view.stride, bytes, view.bytes.size()) == 0;
  if (view.mode == "TRIANGLES")
    return is_of_indices && view.count % 3 == 0 &&
           meshopt_decodeIndexBuffer(result.data(), view.count, view.stride, bytes, view.bytes.size()) == 0;
  return view.mode == "INDICES" && is_of_indices &&
         meshopt_decodeIndexSequence(result.data(), view.count, view.stride, bytes, view.bytes.size()) == 0;
}

/// Inverts the filter that was applied before compression. \return whether the filter fits the data
bool undo_filter(const Meshopt_view& view, std::string& result)
{
  if (view.filter.empty() || view.filter == "NONE") return true;
  if (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8))
    meshopt_decodeFilterOct(result.data(), view.count, view.stride);
  else if (view.filter == "QUATERNION" && view.stride == 8)
    meshopt_decodeFilterQuat(result.data(), view.count, view.stride);
  else if (view.filter == "EXPONENTIAL" && view.stride % 4 == 0)
    meshopt_decodeFilterExp(result.data(), view.count, view.stride);
  else
    return false;
  return true;
}

/// The decompressed bytes of a view; empty if the data are damaged.
std::string decoded_by_meshoptimizer(const Meshopt_view& view)
{
  std::string result(view.count * view.stride, '\0');
  return decode_meshopt(view, result) && undo_filter(view, result) ? result : std::string();
}

#endif

} // namespace

Gltf_codecs gltf_codecs()
{
  Gltf_codecs result;
#ifdef SHAPE_CORRESPONDENCE_WITH_DRACO
  result.draco = decoded_by_draco;
#endif
#ifdef SHAPE_CORRESPONDENCE_WITH_MESHOPTIMIZER
  result.meshopt = decoded_by_meshoptimizer;
#endif
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
