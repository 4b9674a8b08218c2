// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// A part of a mesh file in one color.
struct MeshPart {
  /// The names of the node and of the mesh in the file, for <submesh>.
  std::string node, name;
  /// In meters in the file's frame, with its units applied and no turn for its up-axis, as in Gazebo.
  std::shared_ptr<const Mesh> mesh;
  /// Diffuse; unset if the file gives none.
  std::optional<Rgb> color;
};

/// Reads the meshes of scenes (COLLADA, STL, OBJ and others known to Assimp), each file once. A scene shares
/// one; one thread at a time.
class MeshFiles {
 public:
  static constexpr std::size_t kMaxFileBytes = 256U << 20U;
  static constexpr std::size_t kMaxTriangles = 2'000'000;

  using Parts = std::vector<MeshPart>;
  /// All parts of a file, at least one triangle; or why there are none. The result is shared.
  const robotlink::Result<Parts>& read(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, robotlink::Result<Parts>> files_;
};

/// A mesh scaled by `scale` along its axes and moved by `offset` (m); triangles stay counterclockwise if a
/// scale is negative.
std::shared_ptr<const Mesh> scaledMesh(const Mesh& mesh, const Eigen::Vector3d& scale,
                                       const Eigen::Vector3d& offset = Eigen::Vector3d::Zero());

}  // namespace simcore
