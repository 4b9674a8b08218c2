// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/process/Link.h"

namespace google::protobuf {
class Message;
}

namespace robotlink::ros {

/// visualization_msgs/Marker and MarkerArray as a foxglove.SceneUpdate: each marker is an entity with the id
/// "NAMESPACE/ID" or the deletion of one. Meshes of files are left out, since the files are elsewhere. Any
/// thread.
PackagePtr sceneOfMarker(const google::protobuf::Message& message);
PackagePtr sceneOfMarkers(const google::protobuf::Message& message);

}  // namespace robotlink::ros
