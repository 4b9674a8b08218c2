// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/KnownTypes.h"

#include <gtest/gtest.h>

#include "foxglove/Image.pb.h"
#include "tests/robotlink/ros/RosMessages.h"

namespace robotlink::ros {
namespace {

using test::bytesOf;
using test::Encodings;
using test::kRos1;
using test::kRos2;

constexpr char kHeader[] = "\n===\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id";
/// At 5.25 s in the frame "c".
constexpr char kHeaderBytes[] = "05000000 80b2e60e 02000000 6300 ";

PackagePtr converted(const std::string& name, const std::string& definition, const std::string& hex,
                     const Encodings& encodings = kRos2) {
  const auto type = RosType::of(name, encodings.schema, definition, encodings.message);
  if (!type) return nullptr;
  const auto message = RosType::read(*type, bytesOf(hex));
  const KnownType* known = knownType((*type)->name());
  return message && known ? known->convert(**message) : nullptr;
}

std::string textOf(const PackagePtr& message) {
  return message ? message->GetDescriptor()->full_name() + " " + message->ShortDebugString() : "none";
}

constexpr char kImage[] =
    "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\n"
    "uint8[] data";

TEST(KnownTypes, imagesAreRawImages) {
  EXPECT_EQ(
      textOf(converted("sensor_msgs/msg/Image", kImage + std::string(kHeader),
                       std::string("00010000 ") + kHeaderBytes +
                           "0000 01000000 02000000 06000000 6d6f6e6f3800 00 00 02000000 02000000 4142")),
      "foxglove.RawImage timestamp { seconds: 5 nanos: 250000000 } width: 2 height: 1 encoding: \"mono8\" "
      "step: 2 data: \"AB\" frame_id: \"c\"");
}

/// An image of 2 x 1 pixels with this encoding and these bytes in rows of `step`.
std::string imageOf(const std::string& encoding, const std::string& data, int step,
                    const char* height = "01") {
  const auto number = [](std::size_t value) {
    char hex[16];
    std::snprintf(hex, sizeof hex, "%02x000000", static_cast<unsigned>(value));
    return std::string(hex);
  };
  std::string name;
  for (const char c : encoding) name += number(static_cast<unsigned char>(c)).substr(0, 2);
  const auto message = std::dynamic_pointer_cast<const foxglove::RawImage>(converted(
      "sensor_msgs/Image", kImage + std::string(kHeader),
      "0000000000000000 00000000" + std::string(height) + "000000 02000000" + number(encoding.size()) + name +
          "00" + number(static_cast<std::size_t>(step)) + number(data.size() / 2) + data,
      kRos1));
  if (!message) return "none";
  std::string text = message->encoding() + " " + std::to_string(message->step());
  for (const unsigned char c : message->data()) text += " " + std::to_string(c);
  return text;
}

TEST(KnownTypes, readingsThatALaserDoesNotMeasureAreZero) {
  EXPECT_EQ(textOf(converted("sensor_msgs/LaserScan",
                             "std_msgs/Header header\nfloat64 angle_min\nfloat64 angle_increment\n"
                             "float64 range_min\nfloat64 range_max\nfloat64[] ranges" +
                                 std::string(kHeader),
                             "0000000000000000 01000000 63" +                        // frame c
                                 std::string("000000000000f03f 000000000000e03f") +  // 1, 0.5
                                 "000000000000e03f 0000000000000040" +               // 0.5, 2
                                 "03000000 000000000000f03f 0000000000000840 000000000000d03f",
                             kRos1)),
            "foxglove.LaserScan timestamp { } frame_id: \"c\" pose { orientation { w: 1 } } start_angle: 1 "
            "end_angle: 2 ranges: 1 ranges: 0 ranges: 0");
}

constexpr char kMarker[] =
    "std_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 action\ngeometry_msgs/Pose pose\n"
    "geometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\nduration lifetime\nbool frame_locked\n"
    "geometry_msgs/Point[] points\nstd_msgs/ColorRGBA[] colors\nstring text"
    "\n===\nMSG: std_msgs/Header\ntime stamp\nstring frame_id"
    "\n===\nMSG: geometry_msgs/Pose\ngeometry_msgs/Point position\ngeometry_msgs/Quaternion orientation"
    "\n===\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z"
    "\n===\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z"
    "\n===\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w"
    "\n===\nMSG: std_msgs/ColorRGBA\nfloat32 r\nfloat32 g\nfloat32 b\nfloat32 a";
constexpr char kZero[] = "0000000000000000", kOne[] = "000000000000f03f", kTwo[] = "0000000000000040";

/// A marker of a kind with an action, at (1, 2, 0) without a turn, of size (1, 2, 0), red, with two points.
std::string markerOf(int kind, int action, bool isArray = false) {
  char numbers[32];
  std::snprintf(numbers, sizeof numbers, "07000000 %02x000000 %02x000000", static_cast<unsigned>(kind),
                static_cast<unsigned>(action));
  const std::string zero = kZero, one = kOne, two = kTwo;
  const std::string hex = "0000000000000000 01000000 63 01000000 6e " + std::string(numbers) + one + two +
                          zero + zero + zero + zero + one + one + two + zero +
                          "0000803f 00000000 00000000 0000803f" + "0300000000000000 00 02000000" + zero +
                          zero + zero + zero + two + zero + "00000000 02000000 6869";
  if (!isArray) return textOf(converted("visualization_msgs/Marker", kMarker, hex, kRos1));
  return textOf(converted("visualization_msgs/MarkerArray",
                          std::string("visualization_msgs/Marker[] markers\n===\nMSG: "
                                      "visualization_msgs/Marker\n") +
                              kMarker,
                          "02000000" + hex + hex, kRos1));
}

TEST(KnownTypes, markersAreEntities) {
  const std::string begin =
      "foxglove.SceneUpdate entities { timestamp { } frame_id: \"c\" id: \"n/7\" "
      "lifetime { seconds: 3 } ";
  const std::string pose = "pose { position { x: 1 y: 2 } orientation { w: 1 } } ";
  const std::string red = "color { r: 1 a: 1 } ";
  EXPECT_EQ(markerOf(1, 0), begin + "cubes { " + pose + "size { x: 1 y: 2 } " + red + "} }");
  EXPECT_EQ(markerOf(4, 0),
            begin + "lines { " + pose + "thickness: 1 points { } points { y: 2 } " + red + "} }");
  EXPECT_EQ(markerOf(9, 0), begin + "texts { " + pose + "billboard: true " + red + "text: \"hi\" } }");
  // One square at each point.
  const std::string points = markerOf(8, 0);
  EXPECT_NE(points.find("position { x: 1 y: 4 }"), std::string::npos) << points;
  // From the first point to the second, which lies to the left: a quarter of a turn.
  const std::string arrow = markerOf(0, 0);
  EXPECT_NE(arrow.find("z: 0.70710678118654"), std::string::npos) << arrow;
  EXPECT_NE(arrow.find("head_diameter: 2"), std::string::npos) << arrow;
  EXPECT_EQ(markerOf(10, 0), begin + "}") << "meshes of files are left out";
}

TEST(KnownTypes, markersAreDeleted) {
  EXPECT_EQ(markerOf(1, 2), "foxglove.SceneUpdate deletions { timestamp { } id: \"n/7\" }");
  EXPECT_EQ(markerOf(1, 3), "foxglove.SceneUpdate deletions { timestamp { } type: ALL }");
  EXPECT_EQ(markerOf(1, 77), "foxglove.SceneUpdate ");
}

TEST(KnownTypes, arraysOfMarkersAreOneUpdate) {
  const std::string both = markerOf(2, 0, true);
  EXPECT_NE(both.find("spheres", both.find("spheres") + 1), std::string::npos) << both;
}

TEST(KnownTypes, encodingsOfRosHaveOurNames) {
  EXPECT_EQ(imageOf("yuv422", "01020304", 4), "uyvy 4 1 2 3 4");
  EXPECT_EQ(imageOf("yuv422_yuy2", "01020304", 4), "yuyv 4 1 2 3 4");
  EXPECT_EQ(imageOf("8UC3", "010203040506", 6), "bgr8 6 1 2 3 4 5 6");
  EXPECT_EQ(imageOf("16UC1", "01020304", 4), "16UC1 4 1 2 3 4");
}

TEST(KnownTypes, opacityIsLeftOut) {
  EXPECT_EQ(imageOf("bgra8", "010203ff040506ff0000", 10), "bgr8 6 1 2 3 4 5 6");
  EXPECT_EQ(imageOf("rgba8", "010203ff", 4), "rgba8 4 1 2 3 255") << "it has not the bytes of its size";
  EXPECT_EQ(imageOf("rgba8", "010203ff040506ff", 8, "ff"), "rgba8 8 1 2 3 255 4 5 6 255");
}

TEST(KnownTypes, compressedImagesNameTheirCompression) {
  const std::string definition = "std_msgs/Header header\nstring format\nuint8[] data" + std::string(kHeader);
  const auto formatOf = [&](const std::string& hex) {
    const auto image = std::dynamic_pointer_cast<const foxglove::CompressedImage>(converted(
        "sensor_msgs/CompressedImage", definition, "0000000000000000 00000000" + hex + "01000000 41", kRos1));
    return image ? image->format() + " " + image->data() : std::string();
  };
  EXPECT_EQ(formatOf("03000000 6a7067"), "jpeg A");
  EXPECT_EQ(formatOf("0a000000 726762383b206a706567"), "jpeg A") << "rgb8; jpeg";
  EXPECT_EQ(formatOf("04000000 77656270"), "webp A");
}

TEST(KnownTypes, jointsHaveWhatWasSent) {
  EXPECT_EQ(textOf(converted("sensor_msgs/msg/JointState",
                             "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\n"
                             "float64[] effort" +
                                 std::string(kHeader),
                             std::string("00010000 ") + kHeaderBytes +
                                 "0000 02000000 02000000 6100 0000 02000000 6200 0000 02000000"
                                 "000000000000f83f 0000000000000040 00000000 01000000 000000000000f03f")),
            "foxglove.JointStates timestamp { seconds: 5 nanos: 250000000 } "
            "joints { name: \"a\" position: 1.5 effort: 1 } joints { name: \"b\" position: 2 }");
}

TEST(KnownTypes, transformsAreFrameTransforms) {
  const std::string definition =
      "geometry_msgs/TransformStamped[] transforms\n===\nMSG: geometry_msgs/TransformStamped\n"
      "std_msgs/Header header\nstring child_frame_id\nTransform transform\n===\nMSG: "
      "geometry_msgs/Transform\n"
      "Vector3 translation\nQuaternion rotation\n===\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 "
      "y\nfloat64 z\n"
      "===\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w" +
      std::string(kHeader);
  const std::string one = "000000000000f03f", zero = "0000000000000000";
  const std::string values = one + zero + zero + zero + zero + zero + one;
  constexpr char kWanted[] =
      "foxglove.FrameTransforms transforms { timestamp { seconds: 5 } parent_frame_id: \"m\" child_frame_id: "
      "\"b\" "
      "translation { x: 1 } rotation { w: 1 } }";
  EXPECT_EQ(
      textOf(converted(
          "tf2_msgs/msg/TFMessage", definition,
          "00010000 01000000 05000000 00000000 02000000 6d00 0000 02000000 6200 0000 00000000" + values)),
      kWanted);
  EXPECT_EQ(textOf(converted("tf2_msgs/TFMessage", definition,
                             "01000000 05000000 00000000 01000000 6d 01000000 62" + values, kRos1)),
            kWanted);
}

TEST(KnownTypes, textsHaveTheirLevels) {
  const auto levelOf = [](const std::string& name, const std::string& definition, const std::string& hex) {
    return textOf(converted(name, definition, hex, kRos1));
  };
  constexpr char kRos2Log[] =
      "builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nuint32 line";
  EXPECT_EQ(
      levelOf("rcl_interfaces/msg/Log", kRos2Log, "0500000000000000 1e 01000000 6e 02000000 6869 07000000"),
      "foxglove.Log timestamp { seconds: 5 } level: WARNING message: \"hi\" name: \"n\" line: 7");
  constexpr char kRos1Log[] = "Header header\nbyte level\nstring name\nstring msg";
  EXPECT_EQ(levelOf("rosgraph_msgs/Log", kRos1Log + std::string(kHeader),
                    "0500000000000000 00000000 08 00000000 02000000 6869"),
            "foxglove.Log timestamp { seconds: 5 } level: ERROR message: \"hi\"");
  EXPECT_EQ(levelOf("rcl_interfaces/msg/Log", "uint8 level", "03"), "foxglove.Log timestamp { }");
}

TEST(KnownTypes, othersWithTheirNamesHaveNothing) {
  EXPECT_EQ(
      textOf(converted("sensor_msgs/msg/Image", "string width\nuint8 header\nfloat64[] data\nfloat64 step -1",
                       "00010000 02000000 6100 07 00 00000000 00000000 000000000000f0bf")),
      "foxglove.RawImage timestamp { }");
}

}  // namespace
}  // namespace robotlink::ros
