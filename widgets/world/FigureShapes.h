// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace foxglove {
class SceneEntity;
}
namespace google::protobuf {
class Message;
}

namespace widgets {

/// Draws a message as an entity, in the frame that the message names. Fields are found by their names, as ROS
/// or Foxglove have them; what is missing or senseless is left out. Any thread.
using FigureShape = void (*)(const google::protobuf::Message& message, foxglove::SceneEntity& entity);

/// The readings of a laser as dots.
void scanFigure(const google::protobuf::Message& message, foxglove::SceneEntity& entity);
/// The points of a cloud as dots; of a large cloud every nth one.
void cloudFigure(const google::protobuf::Message& message, foxglove::SceneEntity& entity);
/// A pose as an arrow, also within odometry or with a covariance.
void poseFigure(const google::protobuf::Message& message, foxglove::SceneEntity& entity);
/// Many poses as arrows.
void posesFigure(const google::protobuf::Message& message, foxglove::SceneEntity& entity);
/// A path as a line.
void pathFigure(const google::protobuf::Message& message, foxglove::SceneEntity& entity);
/// The occupied cells of a map as squares on the ground.
void gridFigure(const google::protobuf::Message& message, foxglove::SceneEntity& entity);

/// The same for an occupancy grid of Foxglove, such as the map that a robot makes.
void packedGridFigure(const google::protobuf::Message& message, foxglove::SceneEntity& entity);

/// A frame as its axes (x red, y green, z blue) with its name.
void frameFigure(const std::string& frame, foxglove::SceneEntity& entity);

}  // namespace widgets
