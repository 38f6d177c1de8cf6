// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/isolated.h"
#include "io/model_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cstdint>
#include <cstring>

// What is left as it is in the file: the tree of nodes with their names. Steps of assimp that merge nodes or meshes
// would lose the parts. COLLADA files say which way is up; assimp's root node turns them to y up.

namespace CGAL::Shape_correspondence::IO {
namespace {

using Transform = Eigen::Matrix4d;

Transform transform_of(const aiNode& node)
{
  const aiMatrix4x4& m = node.mTransformation;
  Transform result;
  result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return result;
}

class Scene_reader
{
public:
  Scene_reader(const std::string& file, const aiScene& scene) : file_(file), scene_(scene) {}

  Model_content read()
  {
    visit(*scene_.mRootNode, Transform::Identity());
    return std::move(content_);
  }

private:
  void visit(const aiNode& node, const Transform& parent)
  {
    const Transform to_world = parent * transform_of(node);
    Model_part part{node.mName.C_Str(), {}};
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], to_world, part);
    if (!part.corners.empty()) content_.parts.push_back(std::move(part));
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      visit(*node.mChildren[i], to_world);
  }

  void add_mesh(const aiMesh& mesh, const Transform& to_world, Model_part& part)
  {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) { // points and lines; polygons are triangles by now
        ++content_.faces_left_out;
        continue;
      }
      for (unsigned k = 0; k < 3; ++k)
        part.corners.push_back(vertex(mesh, face.mIndices[k], to_world, part.name));
    }
  }

  Point vertex(const aiMesh& mesh, unsigned index, const Transform& to_world, const std::string& name) const
  {
    if (index >= mesh.mNumVertices)
      throw Invalid_input(file_ + ": part '" + name + "' has a face that uses vertex " + std::to_string(index) +
                          ", but only " + std::to_string(mesh.mNumVertices) + " vertices");
    const aiVector3D& v = mesh.mVertices[index];
    return (to_world * Eigen::Vector4d(v.x, v.y, v.z, 1)).head<3>();
  }

  std::string file_;
  const aiScene& scene_;
  Model_content content_;
};

Model_content read_scene(const std::string& file)
{
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false); // they would be nodes of their own
  const aiScene* const scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_SortByPType);
  if (!scene || !scene->mRootNode)
    throw Invalid_input(file + ": it cannot be read as a model of the format that its extension says (" +
                        importer.GetErrorString() + ")");
  Model_content content = Scene_reader(file, *scene).read();
  if (content.parts.empty())
    throw Invalid_input(file + ": there is no triangle in it; a model needs a mesh for every part");
  return content;
}

// The content in bytes, from one process to the other

void append(std::uint64_t number, std::string& bytes)
{
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string encoded(const Model_content& content)
{
  std::string bytes;
  append(content.faces_left_out, bytes);
  for (const Model_part& part : content.parts) {
    append(part.name.size(), bytes);
    append(part.corners.size(), bytes);
    bytes += part.name;
    bytes.append(reinterpret_cast<const char*>(part.corners.data()), part.corners.size() * sizeof(Point));
  }
  return bytes;
}

/// Throws where the bytes are not those of a content.
class Decoder
{
public:
  Decoder(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  Model_content operator()()
  {
    Model_content content;
    content.faces_left_out = number();
    while (at_ < bytes_.size()) {
      Model_part part;
      part.name.resize(number());
      const std::uint64_t corners = number();
      take(part.name.data(), part.name.size());
      if (corners > (bytes_.size() - at_) / sizeof(Point)) fail();
      part.corners.resize(corners);
      take(part.corners.data(), corners * sizeof(Point));
      content.parts.push_back(std::move(part));
    }
    return content;
  }

private:
  [[noreturn]] void fail() const { throw Invalid_input(file_ + ": it breaks its reader; it is damaged"); }

  std::uint64_t number()
  {
    std::uint64_t result = 0;
    take(&result, sizeof result);
    if (result > bytes_.size()) fail();
    return result;
  }

  void take(void* place, std::size_t size)
  {
    if (size > bytes_.size() - at_) fail();
    std::memcpy(place, bytes_.data() + at_, size);
    at_ += size;
  }

  const std::string& bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
};

} // namespace

Model_content read_parts_with_assimp(const std::string& file)
{
  // assimp is not made for damaged files: some end it, some make it take all memory
  const std::string bytes = run_isolated(file, [&] { return encoded(read_scene(file)); });
  return Decoder(bytes, file)();
}

} // namespace CGAL::Shape_correspondence::IO
