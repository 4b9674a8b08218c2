// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace logplayer::bhuman {

/// Builds logs of message queues for tests.
class QueueBuilder {
 public:
  QueueBuilder& message(std::uint8_t id, std::span<const std::uint8_t> payload);
  QueueBuilder& message(std::uint8_t id, std::string_view payload);
  QueueBuilder& begin(char process) { return message(1, std::string_view(&process, 1)); }
  QueueBuilder& end(char process) { return message(2, std::string_view(&process, 1)); }
  QueueBuilder& text(std::string_view text) { return message(36, text); }
  /// All angles are 0.1 rad, except for the pan of the head, which is off.
  QueueBuilder& joints(std::uint32_t timeMs);
  QueueBuilder& odometry(double heading, double xMm, double yMm);
  QueueBuilder& keys();
  /// A raw image of uniform color.
  QueueBuilder& image(std::uint32_t timeMs, int width, int height);
  /// The same as a JPEG with four components, as the robots' code wrote it.
  QueueBuilder& jpegImage(std::uint32_t timeMs, int width, int height);
  /// Any image; `quads` are the bytes Y0 Cb Y1 Cr of each pixel.
  QueueBuilder& jpegImage(std::uint32_t timeMs, int width, int height, std::span<const std::uint8_t> quads);
  /// The camera is 0.5 m above the ground and looks ahead, 30 degrees down.
  QueueBuilder& cameraMatrix(bool valid);
  QueueBuilder& cameraMatrix(const robotlink::Pose3& cameraInRobot, bool valid);
  QueueBuilder& sensors(std::uint32_t timeMs);
  QueueBuilder& imageCoordinateSystem() { return imageCoordinateSystem(160, 120, 0.9, 0.7); }
  /// With full opening angles, rad.
  QueueBuilder& imageCoordinateSystem(int width, int height, double horizontalAngle, double verticalAngle);

  /// A complete file.
  std::vector<std::uint8_t> file() const;
  /// A file as a robot writes it directly to its disk, without numbers in the header.
  std::vector<std::uint8_t> appendableFile() const;
  std::size_t size() const { return 8 + bytes_.size(); }

 private:
  std::vector<std::uint8_t> fileWith(std::int32_t bytes, std::int32_t messages) const;

  std::vector<std::uint8_t> bytes_;
  int messages_ = 0;
};

/// A JPEG with four components that are stored without conversion.
std::vector<std::uint8_t> fourComponentJpeg(std::span<const std::uint8_t> pixels, int width, int height);

/// The log of a real robot; empty if it is missing.
std::vector<std::uint8_t> realLog();

}  // namespace logplayer::bhuman
