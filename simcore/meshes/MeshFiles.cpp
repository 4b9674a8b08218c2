// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/meshes/MeshFiles.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>

namespace simcore {
namespace fs = std::filesystem;

namespace {

constexpr int kMaxNodeDepth = 200;
constexpr float kMaxCoordinate = 1e6F;  // m

/// Collects the meshes of a file's tree of nodes, in the file's frame.
class PartCollector {
 public:
  explicit PartCollector(const aiScene& scene) : scene_(scene) {}

  void add(const aiNode& node, const aiMatrix4x4& above, int depth) {
    if (depth > kMaxNodeDepth) return;
    const aiMatrix4x4 nodeInFile = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] < scene_.mNumMeshes) addMesh(*scene_.mMeshes[node.mMeshes[i]], node, nodeInFile);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], nodeInFile, depth + 1);
  }
  std::size_t triangles() const { return triangles_; }
  MeshFiles::Parts take() { return std::move(parts_); }

 private:
  void addMesh(const aiMesh& source, const aiNode& node, const aiMatrix4x4& nodeInFile) {
    triangles_ += source.mNumFaces;
    if (triangles_ > MeshFiles::kMaxTriangles || source.mNormals == nullptr) return;
    auto mesh = std::make_shared<Mesh>();
    const aiMatrix3x3 turned = aiMatrix3x3(nodeInFile).Inverse().Transpose();
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D point = nodeInFile * source.mVertices[i], normal = turned * source.mNormals[i];
      const Eigen::Vector3f vertex(point.x, point.y, point.z), direction(normal.x, normal.y, normal.z);
      if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > kMaxCoordinate) return;
      const bool usable = direction.allFinite() && direction.norm() > 0;
      mesh->vertices.push_back(vertex);
      mesh->normals.push_back(usable ? Eigen::Vector3f(direction.normalized()) : Eigen::Vector3f::UnitZ());
    }
    const bool mirrored = nodeInFile.Determinant() < 0;
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
      const aiFace& face = source.mFaces[i];
      if (face.mNumIndices != 3) continue;
      const unsigned a = face.mIndices[0], b = face.mIndices[mirrored ? 2 : 1],
                     c = face.mIndices[mirrored ? 1 : 2];
      if (std::max({a, b, c}) < source.mNumVertices) mesh->triangles.push_back({a, b, c});
    }
    if (mesh->triangles.empty()) return;
    parts_.push_back({node.mName.C_Str(), source.mName.C_Str(), std::move(mesh), colorOf(source)});
  }

  std::optional<Rgb> colorOf(const aiMesh& mesh) const {
    if (mesh.mMaterialIndex >= scene_.mNumMaterials) return std::nullopt;
    const aiMaterial& material = *scene_.mMaterials[mesh.mMaterialIndex];
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    aiColor3D color;
    // Assimp's own default material means that there is none.
    if (std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME ||
        material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != AI_SUCCESS) {
      return std::nullopt;
    }
    const auto byte = [](float value) {
      return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.F, 1.F) * 255));
    };
    return Rgb{byte(color.r), byte(color.g), byte(color.b)};
  }

  const aiScene& scene_;
  std::size_t triangles_ = 0;
  MeshFiles::Parts parts_;
};

robotlink::Result<MeshFiles::Parts> readParts(const fs::path& file) {
  const auto failed = [&](const std::string& reason) {
    return robotlink::failure("scene.mesh", "the mesh cannot be read: " + reason, {file.string(), 0, 0});
  };
  std::error_code error;
  const auto bytes = fs::file_size(file, error);
  if (error) return failed("there is no such file");
  if (bytes > MeshFiles::kMaxFileBytes) return failed("it is larger than 256 MB");
  try {
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 45.F);
    const aiScene* scene =
        importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_SortByPType |
                                             aiProcess_JoinIdenticalVertices | aiProcess_GenSmoothNormals);
    if (scene == nullptr || scene->mRootNode == nullptr) return failed(importer.GetErrorString());
    PartCollector collector(*scene);
    collector.add(*scene->mRootNode, aiMatrix4x4(), 0);
    if (collector.triangles() > MeshFiles::kMaxTriangles)
      return failed("it has more than 2 million triangles");
    MeshFiles::Parts parts = collector.take();
    if (parts.empty()) return failed("it has no triangles");
    return parts;
  } catch (const std::exception& exception) {
    return failed(exception.what());
  }
}

}  // namespace

const robotlink::Result<MeshFiles::Parts>& MeshFiles::read(const fs::path& file) {
  const auto found = files_.find(file);
  return found != files_.end() ? found->second : files_.emplace(file, readParts(file)).first->second;
}

std::shared_ptr<const Mesh> scaledMesh(const Mesh& mesh, const Eigen::Vector3d& scale,
                                       const Eigen::Vector3d& offset) {
  auto result = std::make_shared<Mesh>(mesh);
  for (Eigen::Vector3f& vertex : result->vertices)
    vertex = (vertex.cast<double>().cwiseProduct(scale) + offset).cast<float>();
  for (Eigen::Vector3f& normal : result->normals) {
    const Eigen::Vector3d turned = normal.cast<double>().cwiseQuotient(scale);
    if (turned.allFinite() && turned.norm() > 0) normal = turned.normalized().cast<float>();
  }
  if (scale.prod() < 0) {
    for (auto& triangle : result->triangles) std::swap(triangle[1], triangle[2]);
  }
  return result;
}

}  // namespace simcore
