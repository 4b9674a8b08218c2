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

// Conversions between packages and the values that code calculates with. `assign` writes into a field:
// assign(*message.mutable_pose(), pose). The other direction is named after the result. Units and frames are
// kept: meters, radians, seconds. Pure functions.

void assign(google::protobuf::Timestamp& to, Instant from);
/// The nearest representable instant: seconds beyond some 146 years either way are clamped.
Instant instant(const google::protobuf::Timestamp& from);

void assign(foxglove::Vector3& to, const Vector3& from);
Vector3 vector3(const foxglove::Vector3& from);
/// Points and directions in a plane.
void assign(foxglove::Point2& to, const Vector2& from);
Vector2 vector2(const foxglove::Point2& from);
void assign(foxglove::Pose& to, const Pose3& from);
/// The identity if the orientation is unset; a quaternion that is not of unit length is normalized.
Pose3 pose3(const foxglove::Pose& from);
void assign(robotcontrol::Pose2& to, const Pose2& from);
Pose2 pose2(const robotcontrol::Pose2& from);

/// Channels are scaled from 0..255 to 0..1; alpha is in [0, 1].
void assign(foxglove::Color& to, Rgb from, double alpha = 1);

/// Copies the pixels; `frame` is the name of the camera's coordinate frame, `time` when the image was taken.
void assign(foxglove::RawImage& to, const ImageView& from, Instant time, const std::string& frame);
/// A view of the message's pixels, valid as long as the message. Empty if size, step and encoding do not fit
/// the data, so images from a link can be read safely.
ImageView imageView(const foxglove::RawImage& from);

}  // namespace robotlink
