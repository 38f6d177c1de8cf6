// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/model_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

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

  std::vector<Model_part> read()
  {
    visit(*scene_.mRootNode, Transform::Identity());
    return std::move(parts_);
  }

private:
  void visit(const aiNode& node, const Transform& parent)
  {
    const Transform to_world = parent * transform_of(node);
    Model_part part{node.mName.C_Str(), {}};
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], to_world, part);
    if (!part.corners.empty()) parts_.push_back(std::move(part));
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      visit(*node.mChildren[i], to_world);
  }

  void add_mesh(const aiMesh& mesh, const Transform& to_world, Model_part& part) const
  {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue; // points and lines; polygons are triangles by now
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
  std::vector<Model_part> parts_;
};

} // namespace

std::vector<Model_part> read_parts_with_assimp(const std::string& file)
{
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_SortByPType);
  if (!scene || !scene->mRootNode)
    throw Invalid_input(file + ": it cannot be read as a model of the format that its extension says (" +
                        importer.GetErrorString() + ")");
  std::vector<Model_part> parts = Scene_reader(file, *scene).read();
  if (parts.empty()) throw Invalid_input(file + ": there is no triangle in it; a model needs a mesh for every part");
  return parts;
}

} // namespace CGAL::Shape_correspondence::IO
