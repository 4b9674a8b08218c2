// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/KnownTypes.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Ranging.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotlink/ros/KnownMarkers.h"
#include "robotlink/ros/MessageView.h"

namespace robotlink::ros {

using google::protobuf::Message;

namespace {

/// Encodings that have another name in ROS.
std::string rawEncoding(const std::string& name) {
  if (name == "yuv422") return "uyvy";
  if (name == "yuv422_yuy2") return "yuyv";
  if (name == "8UC1") return "mono8";
  return name == "8UC3" ? "bgr8" : name;
}

/// Leaves out each fourth byte, the opacity: images of cameras are opaque.
void dropAlpha(foxglove::RawImage& image) {
  if (image.encoding() != "rgba8" && image.encoding() != "bgra8") return;
  const std::size_t width = image.width(), height = image.height(), step = image.step();
  const std::string& from = image.data();
  if (width > step / 4 || (height > 0 && step > from.size() / height)) return;
  std::string pixels;
  pixels.reserve(3 * width * height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) pixels.append(from, y * step + 4 * x, 3);
  image.set_encoding(image.encoding() == "rgba8" ? "rgb8" : "bgr8");
  image.set_step(static_cast<std::uint32_t>(3 * width));
  image.set_data(std::move(pixels));
}

PackagePtr rawImage(const Message& message) {
  const MessageView from(&message);
  auto image = std::make_shared<foxglove::RawImage>();
  assign(*image->mutable_timestamp(), from.in("header").in("stamp"));
  image->set_frame_id(from.in("header").text("frame_id"));
  image->set_width(from.natural("width"));
  image->set_height(from.natural("height"));
  image->set_step(from.natural("step"));
  image->set_encoding(rawEncoding(from.text("encoding")));
  image->set_data(from.text("data"));
  dropAlpha(*image);
  return image;
}

/// "jpeg", or "rgb8; jpeg compressed bgr8".
std::string compression(const std::string& format) {
  if (format.find("compressedDepth") != std::string::npos) return format;
  for (const char* name : {"jpeg", "png"})
    if (format.find(name) != std::string::npos) return name;
  return format == "jpg" ? "jpeg" : format;
}

PackagePtr compressedImage(const Message& message) {
  const MessageView from(&message);
  auto image = std::make_shared<foxglove::CompressedImage>();
  assign(*image->mutable_timestamp(), from.in("header").in("stamp"));
  image->set_frame_id(from.in("header").text("frame_id"));
  image->set_format(compression(from.text("format")));
  image->set_data(from.text("data"));
  return image;
}

PackagePtr jointStates(const Message& message) {
  const MessageView from(&message);
  auto states = std::make_shared<foxglove::JointStates>();
  assign(*states->mutable_timestamp(), from.in("header").in("stamp"));
  for (int i = 0; i < from.count("name"); ++i) {
    foxglove::JointState& joint = *states->add_joints();
    joint.set_name(from.textAt("name", i));
    if (i < from.count("position")) joint.set_position(from.numberAt("position", i));
    if (i < from.count("velocity")) joint.set_velocity(from.numberAt("velocity", i));
    if (i < from.count("effort")) joint.set_effort(from.numberAt("effort", i));
  }
  return states;
}

PackagePtr frameTransforms(const Message& message) {
  const MessageView from(&message);
  auto transforms = std::make_shared<foxglove::FrameTransforms>();
  for (int i = 0; i < from.count("transforms"); ++i) {
    const MessageView one = from.element("transforms", i);
    foxglove::FrameTransform& transform = *transforms->add_transforms();
    assign(*transform.mutable_timestamp(), one.in("header").in("stamp"));
    transform.set_parent_frame_id(one.in("header").text("frame_id"));
    transform.set_child_frame_id(one.text("child_frame_id"));
    assign(*transform.mutable_translation(), one.in("transform").in("translation"));
    assign(*transform.mutable_rotation(), one.in("transform").in("rotation"));
  }
  return transforms;
}

/// Converts a laser scan. Distances outside of the laser's range become 0: they are no readings.
PackagePtr laserScan(const Message& message) {
  const MessageView from(&message);
  auto scan = std::make_shared<foxglove::LaserScan>();
  assign(*scan->mutable_timestamp(), from.in("header").in("stamp"));
  scan->set_frame_id(from.in("header").text("frame_id"));
  scan->mutable_pose()->mutable_orientation()->set_w(1);
  scan->set_start_angle(from.number("angle_min"));
  const int count = from.count("ranges");
  scan->set_end_angle(from.number("angle_min") + from.number("angle_increment") * std::max(0, count - 1));
  const double minimum = from.number("range_min"), maximum = from.number("range_max");
  for (int i = 0; i < count; ++i) {
    const double range = from.numberAt("ranges", i);
    scan->add_ranges(range >= minimum && (maximum <= 0 || range <= maximum) ? range : 0);
  }
  for (int i = 0; i < from.count("intensities"); ++i) scan->add_intensities(from.numberAt("intensities", i));
  return scan;
}

/// Levels are 10, 20 to 50 in ROS 2, and 1, 2, 4 to 16 in ROS 1.
foxglove::Log::Level levelOf(double level) {
  constexpr std::array kRos2{10, 20, 30, 40, 50};
  constexpr std::array kRos1{1, 2, 4, 8, 16};
  for (const auto& levels : {kRos2, kRos1}) {
    const auto found = std::ranges::find(levels, level);
    if (found != levels.end())
      return static_cast<foxglove::Log::Level>(foxglove::Log::DEBUG + (found - levels.begin()));
  }
  return foxglove::Log::UNKNOWN;
}

PackagePtr textOf(const MessageView& from, const MessageView& stamp) {
  auto text = std::make_shared<foxglove::Log>();
  assign(*text->mutable_timestamp(), stamp);
  text->set_level(levelOf(from.number("level")));
  text->set_message(from.text("msg"));
  text->set_name(from.text("name"));
  text->set_file(from.text("file"));
  text->set_line(from.natural("line"));
  return text;
}

PackagePtr ros2Text(const Message& message) {
  const MessageView from(&message);
  return textOf(from, from.in("stamp"));
}

PackagePtr ros1Text(const Message& message) {
  const MessageView from(&message);
  return textOf(from, from.in("header").in("stamp"));
}

}  // namespace

const KnownType* knownType(std::string_view name) {
  static constexpr std::array<KnownType, 10> kTypes{{
      {"rcl_interfaces.Log", &foxglove::Log::descriptor, &ros2Text},
      {"rosgraph_msgs.Log", &foxglove::Log::descriptor, &ros1Text},
      {"sensor_msgs.CompressedImage", &foxglove::CompressedImage::descriptor, &compressedImage},
      {"sensor_msgs.Image", &foxglove::RawImage::descriptor, &rawImage},
      {"sensor_msgs.JointState", &foxglove::JointStates::descriptor, &jointStates},
      {"sensor_msgs.LaserScan", &foxglove::LaserScan::descriptor, &laserScan},
      {"tf.tfMessage", &foxglove::FrameTransforms::descriptor, &frameTransforms},
      {"tf2_msgs.TFMessage", &foxglove::FrameTransforms::descriptor, &frameTransforms},
      {"visualization_msgs.Marker", &foxglove::SceneUpdate::descriptor, &sceneOfMarker},
      {"visualization_msgs.MarkerArray", &foxglove::SceneUpdate::descriptor, &sceneOfMarkers},
  }};
  const auto found = std::ranges::find(kTypes, name, &KnownType::name);
  return found == kTypes.end() ? nullptr : &*found;
}

}  // namespace robotlink::ros
