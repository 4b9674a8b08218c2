// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/logplayer/bhuman/QueueBuilder.h"

#include <bit>
#include <cstdlib>

#include <jpeglib.h>

#include "robotlink/base/AtomicFile.h"

namespace logplayer::bhuman {
namespace {

class Payload {
 public:
  Payload& number(std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return *this;
  }
  Payload& int32(std::int64_t value) { return number(static_cast<std::uint64_t>(value), 4); }
  Payload& float64(double value) { return number(std::bit_cast<std::uint64_t>(value), 8); }
  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

QueueBuilder& QueueBuilder::message(std::uint8_t id, std::span<const std::uint8_t> payload) {
  bytes_.push_back(id);
  for (int i = 0; i < 3; ++i) bytes_.push_back(static_cast<std::uint8_t>(payload.size() >> (8 * i)));
  bytes_.insert(bytes_.end(), payload.begin(), payload.end());
  ++messages_;
  return *this;
}

QueueBuilder& QueueBuilder::message(std::uint8_t id, std::string_view payload) {
  return message(id, std::span(reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size()));
}

QueueBuilder& QueueBuilder::joints(std::uint32_t timeMs) {
  Payload payload;
  payload.float64(1000);
  for (int i = 1; i < 22; ++i) payload.float64(0.1);
  return message(5, payload.int32(timeMs).bytes());
}

QueueBuilder& QueueBuilder::odometry(double heading, double xMm, double yMm) {
  return message(8, Payload().float64(heading).float64(xMm).float64(yMm).bytes());
}

QueueBuilder& QueueBuilder::keys() {
  return message(7, Payload().int32(0).int32(0).int32(1).int32(0).int32(1).bytes());
}

QueueBuilder& QueueBuilder::image(std::uint32_t timeMs, int width, int height) {
  Payload payload;
  payload.int32(width).int32(height).int32(timeMs);
  for (int i = 0; i < width * height; ++i)
    payload.number(0xA0604030U, 4);  // Y0 0x30, Cb 0x40, Y1 0x60, Cr 0xA0
  return message(3, payload.bytes());
}

QueueBuilder& QueueBuilder::jpegImage(std::uint32_t timeMs, int width, int height) {
  Payload pixels;
  for (int i = 0; i < width * height; ++i) pixels.number(0xA0604030U, 4);
  return jpegImage(timeMs, width, height, pixels.bytes());
}

QueueBuilder& QueueBuilder::jpegImage(std::uint32_t timeMs, int width, int height,
                                      std::span<const std::uint8_t> quads) {
  const auto jpeg = fourComponentJpeg(quads, width, height);
  Payload payload;
  payload.int32(width).int32(height).int32(timeMs).int32(static_cast<std::int64_t>(jpeg.size()));
  for (const std::uint8_t byte : jpeg) payload.number(byte, 1);
  return message(4, payload.bytes());
}

QueueBuilder& QueueBuilder::sensors(std::uint32_t timeMs) {
  Payload payload;
  for (int i = 0; i < 18; ++i) payload.number(std::bit_cast<std::uint32_t>(i == 5 ? -1.0F : 0.25F), 4);
  for (int i = 0; i < 22; ++i) payload.number(static_cast<std::uint64_t>(i), 2);
  for (int i = 0; i < 22; ++i) payload.number(40, 1);
  return message(6, payload.int32(1).int32(timeMs).bytes());
}

QueueBuilder& QueueBuilder::imageCoordinateSystem(int width, int height, double horizontalAngle,
                                                  double verticalAngle) {
  Payload payload;
  for (int i = 0; i < 14; ++i) payload.float64(1);
  payload.int32(width).int32(height).float64(horizontalAngle).float64(verticalAngle);
  return message(18, payload.float64(165).float64(80).float64(60).bytes());
}

QueueBuilder& QueueBuilder::cameraMatrix(bool valid) {
  using robotlink::Pose3;
  return cameraMatrix(Pose3(Eigen::Translation3d(0.05, 0, 0.5)) *
                          Pose3(Eigen::AngleAxisd(robotlink::radians(30), robotlink::Vector3::UnitY())),
                      valid);
}

QueueBuilder& QueueBuilder::cameraMatrix(const robotlink::Pose3& cameraInRobot, bool valid) {
  Payload payload;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) payload.float64(cameraInRobot.linear()(row, column));
  }
  for (int i = 0; i < 3; ++i) payload.float64(1000 * cameraInRobot.translation()[i]);
  return message(17, payload.int32(valid ? 1 : 0).bytes());
}

std::vector<std::uint8_t> QueueBuilder::fileWith(std::int32_t bytes, std::int32_t messages) const {
  const Payload header = Payload().int32(bytes).int32(messages);
  std::vector<std::uint8_t> file(header.bytes().begin(), header.bytes().end());
  file.insert(file.end(), bytes_.begin(), bytes_.end());
  return file;
}

std::vector<std::uint8_t> QueueBuilder::file() const {
  return fileWith(static_cast<std::int32_t>(bytes_.size()), messages_);
}

std::vector<std::uint8_t> QueueBuilder::appendableFile() const {
  return fileWith(-1, -1);
}

std::vector<std::uint8_t> fourComponentJpeg(std::span<const std::uint8_t> pixels, int width, int height) {
  jpeg_error_mgr errors;
  jpeg_compress_struct codec{};
  codec.err = jpeg_std_error(&errors);
  jpeg_create_compress(&codec);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&codec, &data, &size);
  codec.image_width = static_cast<JDIMENSION>(width);
  codec.image_height = static_cast<JDIMENSION>(height);
  codec.input_components = 4;
  codec.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&codec);
  jpeg_set_quality(&codec, 95, TRUE);
  jpeg_start_compress(&codec, TRUE);
  while (codec.next_scanline < codec.image_height) {
    const std::size_t row = codec.next_scanline * static_cast<std::size_t>(width) * 4;
    auto* pointer = const_cast<JSAMPROW>(pixels.data() + row);
    jpeg_write_scanlines(&codec, &pointer, 1);
  }
  jpeg_finish_compress(&codec);
  std::vector<std::uint8_t> result(data, data + size);
  jpeg_destroy_compress(&codec);
  std::free(data);
  return result;
}

std::vector<std::uint8_t> realLog() {
  const auto text = robotlink::readFile(ROBOTCONTROL_SOURCE_DIR "/../shared/data/logs/bhuman2009.log");
  return text ? std::vector<std::uint8_t>(text->begin(), text->end()) : std::vector<std::uint8_t>();
}

}  // namespace logplayer::bhuman
