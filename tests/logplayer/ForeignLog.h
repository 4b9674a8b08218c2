// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "logplayer/mcap/write/Writer.h"

namespace logplayer::tests {

/// A log as written by other programs: messages in any encoding, with any schema.
class ForeignLog {
 public:
  explicit ForeignLog(const std::filesystem::path& file)
      : writer_(std::move(*mcap::Writer::create(file, {}))) {}

  struct Topic {
    std::string topic;
    std::string type;
    /// Empty: no schema.
    std::string schemaEncoding;
    std::string schema;
    std::string encoding;
  };
  std::uint16_t add(const Topic& topic) {
    std::uint16_t schema = 0;
    if (!topic.schemaEncoding.empty())
      schema = *writer_->addSchema(topic.type, topic.schemaEncoding, topic.schema);
    return *writer_->addChannel(topic.topic, schema, topic.encoding, {});
  }
  void write(std::uint16_t channel, double time, const std::string& data) {
    const robotlink::Instant at(robotlink::fromSeconds(time));
    const mcap::Bytes bytes(reinterpret_cast<const std::uint8_t*>(data.data()), data.size());
    good_ = writer_->write({channel, 0, at, at, bytes}).has_value() && good_;
  }
  /// Closes the file; returns whether everything was written.
  bool close() { return writer_->close().has_value() && good_; }

 private:
  bool good_ = true;
  std::unique_ptr<mcap::Writer> writer_;
};

inline constexpr char kPoseSchema[] = R"({"type": "object", "properties": {
  "stamp": {"type": "object", "title": "time", "properties": {"sec": {"type": "integer"}, "nsec": {"type": "integer"}}},
  "frame": {"type": "string"},
  "position": {"type": "object", "properties": {"x": {"type": "number"}, "y": {"type": "number"}}},
  "covariance": {"type": "array", "items": {"type": "number"}}}})";

inline constexpr char kLogSchema[] = R"({"title": "foxglove.Log", "type": "object", "properties": {
  "timestamp": {"type": "object", "title": "time", "properties": {"sec": {"type": "integer"}, "nsec": {"type": "integer"}}},
  "level": {"title": "foxglove.Level", "oneOf": [{"title": "INFO", "const": 2}, {"title": "WARNING", "const": 3}]},
  "message": {"type": "string"}, "name": {"type": "string"}, "file": {"type": "string"}, "line": {"type": "integer"}}})";

/// A log with two poses and an invalid one, two texts, images in FlatBuffers, and a message of ROS 1 without
/// a definition; from 100 to 101
/// s.
inline bool writeForeignLog(const std::filesystem::path& file) {
  ForeignLog log(file);
  const auto pose = log.add({"a/b/c", "their.Pose", "jsonschema", kPoseSchema, "json"});
  const auto text = log.add({"/rosout", "foxglove.Log", "jsonschema", kLogSchema, "json"});
  const auto image = log.add({"/camera", "foxglove.RawImage", "flatbuffer", "table", "flatbuffer"});
  const auto odometry = log.add({"/odom", "nav_msgs/Odometry", "ros1msg", "no definition", "ros1"});
  log.write(
      pose, 100,
      R"({"stamp": {"sec": 5, "nsec": 250000000}, "frame": "map", "position": {"x": 1.5, "y": -2}, "covariance": [1, null]})");
  log.write(pose, 100.2, R"({"frame": "map", "position": {"x": 2, "y": "far"}, "note": [1]})");
  log.write(pose, 100.3, R"({"frame": )");
  log.write(
      text, 100.4,
      R"({"timestamp": {"sec": 100, "nsec": 0}, "level": 3, "message": "battery low", "name": "base", "line": 12})");
  log.write(text, 100.5, R"({"level": 2, "message": "all well", "name": "base"})");
  for (int i = 0; i < 10; ++i) log.write(image, 100 + 0.1 * i, std::string(64, '\1'));
  log.write(odometry, 101, std::string(8, '\0'));
  return log.close();
}

}  // namespace logplayer::tests
