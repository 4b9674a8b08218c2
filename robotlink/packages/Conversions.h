// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"

namespace google::protobuf {
class Timestamp;
}
namespace foxglove {
class Color;
class Point2;
class Pose;
class RawImage;
class Vector3;
}  // namespace foxglove
namespace robotcontrol {
class Pose2;
}

namespace robotlink {

// Between packages and the values that code calculates with. `assign` writes into a field:
// assign(*message.mutable_pose(), pose).

void assign(google::protobuf::Timestamp& to, Instant from);
/// Seconds that would not fit are brought to the nearest that do (some 146 years).
Instant instant(const google::protobuf::Timestamp& from);

void assign(foxglove::Vector3& to, const Vector3& from);
Vector3 vector3(const foxglove::Vector3& from);
void assign(foxglove::Point2& to, const Vector2& from);
Vector2 vector2(const foxglove::Point2& from);
void assign(foxglove::Pose& to, const Pose3& from);
/// The identity where the orientation is unset; a quaternion that is not of unit length is normalised.
Pose3 pose3(const foxglove::Pose& from);
void assign(robotcontrol::Pose2& to, const Pose2& from);
Pose2 pose2(const robotcontrol::Pose2& from);

/// Channels as 0..255; alpha in [0, 1].
void assign(foxglove::Color& to, Rgb from, double alpha = 1);

/// Takes the pixels over; `frame` is the id of the camera's frame.
void assign(foxglove::RawImage& to, const ImageView& from, Instant time, const std::string& frame);
/// A view on the message's pixels, valid as long as it; an empty view where size, step and encoding do not
/// fit the data.
ImageView imageView(const foxglove::RawImage& from);

}  // namespace robotlink
