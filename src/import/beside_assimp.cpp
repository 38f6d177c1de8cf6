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

#ifdef SHAPE_CORRESPONDENCE_WITH_MINIZIP
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/property_tree/xml_parser.hpp>
#include <minizip/unzip.h>

#include <memory>
#include <sstream>
#include <string_view>
#include <type_traits>
#endif

namespace CGAL::Shape_correspondence::IO {

#ifdef SHAPE_CORRESPONDENCE_WITH_MINIZIP

namespace {

using Archive = std::remove_pointer_t<unzFile>;

/// Moves to the archive's document with the objects: 3D/3dmodel.model, or else the first file with this extension.
bool go_to_model(Archive* archive)
{
  constexpr int any_case = 2;
  if (unzLocateFile(archive, "3D/3dmodel.model", any_case) == UNZ_OK) return true;
  for (int found = unzGoToFirstFile(archive); found == UNZ_OK; found = unzGoToNextFile(archive)) {
    char name[256] = "";
    unzGetCurrentFileInfo64(archive, nullptr, name, sizeof name - 1, nullptr, 0, nullptr, 0);
    if (lower_extension(name) == ".model") return true;
  }
  return false;
}

/// The document with the objects. \throw Invalid_input if it is damaged
std::string model_of_package(const std::string& file)
{
  const std::unique_ptr<Archive, int (*)(unzFile)> archive(unzOpen64(file.c_str()), unzClose);
  std::string result, buffer(std::size_t(1) << 16, '\0');
  if (!archive || !go_to_model(archive.get()) || unzOpenCurrentFile(archive.get()) != UNZ_OK)
    throw Invalid_input("it is no archive with a model, or is damaged; save it again");
  int size = 0;
  while ((size = unzReadCurrentFile(archive.get(), buffer.data(), unsigned(buffer.size()))) > 0)
    result.append(buffer, 0, std::size_t(size));
  if (size < 0 || unzCloseCurrentFile(archive.get()) != UNZ_OK)
    throw Invalid_input("its archive is damaged; save it again");
  return result;
}

void add_name(const std::string& tag, std::map<std::string, std::string>& names)
{
  std::istringstream element(tag + "/>");
  boost::property_tree::ptree tree;
  try {
    boost::property_tree::read_xml(element, tree);
  } catch (const boost::property_tree::xml_parser_error&) {
    return;
  }
  const std::string name = tree.get("object.<xmlattr>.name", "");
  if (!name.empty()) names["Object_" + tree.get("object.<xmlattr>.id", "")] = name;
}

} // namespace

std::map<std::string, std::string> names_in_3mf(const std::string& file)
{
  std::map<std::string, std::string> result;
  const std::string text = model_of_package(file);
  if (text.find(":path=") != std::string::npos)
    throw Invalid_input("its objects are in several files of the archive, as the production extension of 3MF has it, "
                        "which is not read; save it as a 3MF without this extension, as STL or OBJ");
  constexpr std::string_view beginning = "<object ";
  for (std::size_t at = text.find(beginning); at != std::string::npos; at = text.find(beginning, at + 1))
    if (const std::size_t end = text.find_first_of("<>", at + 1); end != std::string::npos && text[end] == '>')
      add_name(text.substr(at, end - at - (text[end - 1] == '/')), result);
  return result;
}

#else

std::map<std::string, std::string> names_in_3mf(const std::string&) { return {}; }

#endif

} // namespace CGAL::Shape_correspondence::IO
