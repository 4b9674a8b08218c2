// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of ROS as they become figures of the views Scene and Field.
#include <cstdlib>

#include "foxglove/Scene.pb.h"
#include "robotlink/ros/KnownTypes.h"
#include "robotlink/session/Session.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/ros/RosMessages.h"
#include "widgets/world/FrameTree.h"
#include "widgets/world/StreamFigures.h"

namespace figures_fuzz {

using robotlink::Instant;
using robotlink::ros::test::fuzzInput;
using robotlink::ros::test::kRos1;

namespace {

constexpr char kCommon[] =
    "\n===\nMSG: std_msgs/Header\ntime stamp\nstring frame_id"
    "\n===\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z"
    "\n===\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z"
    "\n===\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w"
    "\n===\nMSG: geometry_msgs/Pose\nPoint position\nQuaternion orientation"
    "\n===\nMSG: geometry_msgs/PoseStamped\nstd_msgs/Header header\nPose pose"
    "\n===\nMSG: geometry_msgs/Transform\nVector3 translation\nQuaternion rotation"
    "\n===\nMSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\nstring child_frame_id\n"
    "Transform transform"
    "\n===\nMSG: std_msgs/ColorRGBA\nfloat32 r\nfloat32 g\nfloat32 b\nfloat32 a"
    "\n===\nMSG: sensor_msgs/PointField\nstring name\nuint32 offset\nuint8 datatype\nuint32 count"
    "\n===\nMSG: nav_msgs/MapMetaData\nfloat32 resolution\nuint32 width\nuint32 height\n"
    "geometry_msgs/Pose origin"
    "\n===\nMSG: visualization_msgs/Marker\nstd_msgs/Header header\nstring ns\nint32 id\nint32 type\n"
    "int32 action\ngeometry_msgs/Pose pose\ngeometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\n"
    "duration lifetime\nbool frame_locked\ngeometry_msgs/Point[] points\nstd_msgs/ColorRGBA[] colors\n"
    "string text";

/// A header at 1 s in the frame "c".
constexpr char kHeader[] = "01000000 00000000 01000000 63 ";
constexpr char kZero[] = "0000000000000000 ", kOne[] = "000000000000f03f ";

std::string pose() {
  std::string hex;
  for (const char* number : {kOne, kOne, kZero, kZero, kZero, kZero, kOne}) hex += number;
  return hex;
}

std::string seed(const std::string& name, const std::string& definition, const std::string& hex) {
  return fuzzInput(kRos1, name, definition + kCommon, hex);
}

std::string markers(const std::string& kind) {
  std::string one = std::string(kHeader) + "01000000 6e 07000000 " + kind + "000000 00000000" + pose();
  one += std::string(kOne) + kOne + kOne + "0000803f 00000000 00000000 0000803f 0300000000000000 00 02000000";
  one += std::string(kZero) + kZero + kZero + kOne + kZero + kZero + "00000000 02000000 6869";
  return seed("visualization_msgs/MarkerArray", "visualization_msgs/Marker[] markers",
              "02000000" + one + one);
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  auto message = robotlink::ros::test::messageOfFuzzInput({reinterpret_cast<const char*>(data), size});
  if (!message) return 0;
  if (const auto* known = robotlink::ros::knownType(message->GetDescriptor()->full_name())) {
    if (auto converted = known->convert(*message)) message = converted;
  }
  robotlink::Session session;
  session.push({"r/stream", Instant(std::chrono::seconds(1)), message});
  session.tick();
  const Instant now(std::chrono::seconds(2));
  widgets::StreamFigures figures;
  widgets::FrameTree frames;
  frames.update(session.store(), now);
  static_cast<void>(frames.pose("r", "c"));
  const auto of = figures.of(session.store(), "r/stream", now);
  for (const auto& figure : of)
    if (figure.entity == nullptr) std::abort();
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  const std::string header = kHeader;
  return {
      seed("sensor_msgs/LaserScan",
           "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
           "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
           "float32[] ranges\nfloat32[] intensities",
           header +
               "00000000 0000803f 0000003f 00000000 00000000 00000000 00002041 02000000 0000803f 0000c07f "
               "00000000"),
      seed("sensor_msgs/PointCloud2",
           "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\n"
           "bool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense",
           header + "01000000 01000000 02000000 01000000 78 00000000 07 01000000 01000000 79 04000000 07 "
                    "01000000 00 08000000 08000000 08000000 0000803f00000040 01"),
      seed("nav_msgs/OccupancyGrid", "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data",
           header + "0000003f 02000000 02000000" + pose() + "04000000 646400ff"),
      seed("nav_msgs/Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses",
           header + "02000000" + header + pose() + header + pose()),
      seed("geometry_msgs/PoseArray", "std_msgs/Header header\ngeometry_msgs/Pose[] poses",
           header + "02000000" + pose() + pose()),
      seed("tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms",
           "02000000" + header + "01000000 64" + pose() + header + "01000000 63" + pose()),
      markers("00"),
      markers("04"),
      markers("08"),
      markers("0b"),
  };
}

const FuzzRegistration kTarget({"figures", &fuzzSeeds, &runInput});

}  // namespace figures_fuzz
