// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/Conversions.h"

#include <google/protobuf/timestamp.pb.h>

#include <algorithm>
#include <limits>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Sensing.pb.h"

namespace robotlink {

void assign(google::protobuf::Timestamp& to, Instant from) {
  const auto whole = std::chrono::floor<std::chrono::seconds>(from.time_since_epoch());
  to.set_seconds(whole.count());
  to.set_nanos(static_cast<std::int32_t>((from.time_since_epoch() - whole).count()));
}

Instant instant(const google::protobuf::Timestamp& from) {
  // Less than half of what fits, so that neither the result nor the difference of two results overflows,
  // whatever a link delivers.
  constexpr std::int64_t kMaxSeconds = std::numeric_limits<std::int64_t>::max() / 2 / 1'000'000'000 - 10;
  const std::int64_t whole = std::clamp<std::int64_t>(from.seconds(), -kMaxSeconds, kMaxSeconds);
  return Instant(std::chrono::seconds(whole) + Duration(from.nanos()));
}

void assign(foxglove::Vector3& to, const Vector3& from) {
  to.set_x(from.x());
  to.set_y(from.y());
  to.set_z(from.z());
}

Vector3 vector3(const foxglove::Vector3& from) {
  return {from.x(), from.y(), from.z()};
}

void assign(foxglove::Point2& to, const Vector2& from) {
  to.set_x(from.x());
  to.set_y(from.y());
}

Vector2 vector2(const foxglove::Point2& from) {
  return {from.x(), from.y()};
}

void assign(foxglove::Pose& to, const Pose3& from) {
  assign(*to.mutable_position(), Vector3(from.translation()));
  const Eigen::Quaterniond rotation(from.linear());
  auto& out = *to.mutable_orientation();
  out.set_x(rotation.x());
  out.set_y(rotation.y());
  out.set_z(rotation.z());
  out.set_w(rotation.w());
}

Pose3 pose3(const foxglove::Pose& from) {
  Pose3 result = Pose3::Identity();
  result.translation() = vector3(from.position());
  const auto& q = from.orientation();
  const Eigen::Quaterniond rotation(q.w(), q.x(), q.y(), q.z());
  if (rotation.squaredNorm() > 1e-12) result.linear() = rotation.normalized().toRotationMatrix();
  return result;
}

void assign(robotcontrol::Pose2& to, const Pose2& from) {
  to.set_x(from.x);
  to.set_y(from.y);
  to.set_heading(from.heading);
}

Pose2 pose2(const robotcontrol::Pose2& from) {
  return {from.x(), from.y(), from.heading()};
}

void assign(foxglove::Color& to, Rgb from, double alpha) {
  to.set_r(from.r / 255.0);
  to.set_g(from.g / 255.0);
  to.set_b(from.b / 255.0);
  to.set_a(alpha);
}

void assign(foxglove::RawImage& to, const ImageView& from, Instant time, const std::string& frame) {
  assign(*to.mutable_timestamp(), time);
  to.set_width(static_cast<std::uint32_t>(from.width));
  to.set_height(static_cast<std::uint32_t>(from.height));
  to.set_encoding(std::string(encodingName(from.format)));
  to.set_step(static_cast<std::uint32_t>(from.step));
  to.set_frame_id(frame);
  to.set_data(from.data, static_cast<std::size_t>(from.step) *
                             static_cast<std::size_t>(rowsOf(from.format, from.height)));
}

ImageView imageView(const foxglove::RawImage& from) {
  constexpr std::uint32_t kMaxSide = 1U << 15U;
  for (const PixelFormat format : kPixelFormats) {
    if (from.encoding() != encodingName(format)) continue;
    const std::size_t rowBytes = std::size_t{from.width()} * static_cast<std::size_t>(bytesPerPixel(format));
    if (from.width() > kMaxSide || from.height() > kMaxSide || from.step() < rowBytes ||
        from.step() > 8 * kMaxSide)
      return {};
    const int width = static_cast<int>(from.width()), height = static_cast<int>(from.height());
    if (!canHaveSize(format, width, height)) return {};
    const auto rows = static_cast<std::size_t>(rowsOf(format, height));
    if (from.data().size() < std::size_t{from.step()} * (rows - 1) + rowBytes) return {};
    return {width, height, static_cast<int>(from.step()), format,
            reinterpret_cast<const std::uint8_t*>(from.data().data())};
  }
  return {};
}

}  // namespace robotlink
