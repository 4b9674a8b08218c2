// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/StreamFigures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Grid.pb.h"
#include "foxglove/Ranging.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotlink/packages/DynamicTypes.h"
#include "robotlink/ros/RosType.h"
#include "robotlink/session/Session.h"
#include "widgets/world/FrameTree.h"

namespace widgets {
namespace {

using robotlink::Instant;
using namespace std::chrono_literals;

/// Writes values as CDR does, little-endian.
class Cdr {
 public:
  Cdr& bytes(std::initializer_list<int> values) {
    for (const int value : values) data_.push_back(static_cast<std::uint8_t>(value));
    return *this;
  }
  template <typename T>
  Cdr& add(T value) {
    while ((data_.size() - 4) % sizeof(T) != 0) data_.push_back(0);
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
    data_.insert(data_.end(), raw, raw + sizeof value);
    return *this;
  }
  Cdr& text(const std::string& value) {
    add(static_cast<std::uint32_t>(value.size() + 1));
    data_.insert(data_.end(), value.begin(), value.end());
    data_.push_back(0);
    return *this;
  }
  Cdr& header(const std::string& frame) { return add(std::int32_t{1}).add(std::uint32_t{0}).text(frame); }
  Cdr& pose(double x, double y) {
    for (const double value : {x, y, 0.0, 0.0, 0.0, 0.0, 1.0}) add(value);
    return *this;
  }
  robotlink::PackagePtr as(const std::string& type, const std::string& definition) const {
    const auto made = robotlink::ros::RosType::of(type, "ros2msg", definition + kCommon, "cdr");
    EXPECT_TRUE(made) << (made ? "" : made.error().describe());
    const auto message = robotlink::ros::RosType::read(*made, data_);
    EXPECT_TRUE(message) << (message ? "" : message.error().text);
    return message ? *message : nullptr;
  }

 private:
  static constexpr char kCommon[] =
      "\n===\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id"
      "\n===\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z"
      "\n===\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w"
      "\n===\nMSG: geometry_msgs/Pose\ngeometry_msgs/Point position\ngeometry_msgs/Quaternion orientation"
      "\n===\nMSG: geometry_msgs/PoseStamped\nstd_msgs/Header header\ngeometry_msgs/Pose pose"
      "\n===\nMSG: geometry_msgs/PoseWithCovariance\ngeometry_msgs/Pose pose\nfloat64[36] covariance";
  std::vector<std::uint8_t> data_{0, 1, 0, 0};
};

const foxglove::SceneEntity& entityOf(const std::shared_ptr<const foxglove::SceneUpdate>& update) {
  static const foxglove::SceneEntity kNone;
  EXPECT_NE(update, nullptr);
  EXPECT_TRUE(update && update->entities_size() == 1);
  return update && update->entities_size() == 1 ? update->entities(0) : kNone;
}

TEST(FigureOf, odometryIsAnArrow) {
  Cdr cdr;
  cdr.header("odom").text("base_link").pose(1, 2);
  for (int i = 0; i < 36; ++i) cdr.add(0.0);
  const auto figure = figureOf(*cdr.as("nav_msgs/msg/Odometry",
                                       "std_msgs/Header header\nstring child_frame_id\n"
                                       "geometry_msgs/PoseWithCovariance pose"));
  const auto& entity = entityOf(figure);
  EXPECT_EQ(entity.frame_id(), "odom");
  ASSERT_EQ(entity.arrows_size(), 1);
  EXPECT_EQ(entity.arrows(0).pose().position().x(), 1);
  EXPECT_EQ(entity.arrows(0).pose().position().y(), 2);
}

TEST(FigureOf, aPathIsALine) {
  Cdr cdr;
  cdr.header("map").add(std::uint32_t{2}).header("map").pose(1, 0).header("map").pose(3, 4);
  const auto figure =
      figureOf(*cdr.as("nav_msgs/msg/Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses"));
  const auto& entity = entityOf(figure);
  ASSERT_EQ(entity.lines_size(), 1);
  ASSERT_EQ(entity.lines(0).points_size(), 2);
  EXPECT_EQ(entity.lines(0).points(1).y(), 4);
}

std::shared_ptr<const foxglove::SceneUpdate> mapFigure() {
  Cdr cdr;
  cdr.header("map").add(0.5F).add(std::uint32_t{3}).add(std::uint32_t{2}).pose(10, 0);
  cdr.add(std::uint32_t{6}).bytes({100, 100, 0, 0, 255, 60});
  return figureOf(*cdr.as("nav_msgs/msg/OccupancyGrid",
                          "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data"
                          "\n===\nMSG: nav_msgs/MapMetaData\nfloat32 resolution\nuint32 width\n"
                          "uint32 height\ngeometry_msgs/Pose origin"));
}

TEST(FigureOf, occupiedCellsOfAMapAreSquares) {
  const auto figure = mapFigure();
  const auto& entity = entityOf(figure);
  ASSERT_EQ(entity.triangles_size(), 1);
  const auto& squares = entity.triangles(0);
  EXPECT_EQ(squares.pose().position().x(), 10);
  // One over two cells, and one in the row above; -1 is unknown.
  ASSERT_EQ(squares.points_size(), 8);
  EXPECT_EQ(squares.points(2).x(), 1);
  EXPECT_EQ(squares.points(2).y(), 0.5);
  EXPECT_EQ(squares.points(4).x(), 1);
  EXPECT_EQ(squares.points(4).y(), 0.5);
}

TEST(FigureOf, theMapThatARobotMakesIsSquaresToo) {
  foxglove::Grid grid;
  grid.set_frame_id("field");
  grid.mutable_pose()->mutable_position()->set_x(-3);
  grid.mutable_pose()->mutable_orientation()->set_w(1);
  grid.set_column_count(3);
  grid.mutable_cell_size()->set_x(0.5);
  grid.mutable_cell_size()->set_y(0.5);
  grid.set_row_stride(3);
  grid.set_cell_stride(1);
  grid.add_fields()->set_name("occupancy");
  grid.mutable_fields(0)->set_type(foxglove::PackedElementField::INT8);
  grid.set_data(std::string("\x64\x64\x00\x00\xFF\x3C", 6));
  const auto figure = figureOf(grid);
  const auto& entity = entityOf(figure);
  EXPECT_EQ(entity.frame_id(), "field");
  ASSERT_EQ(entity.triangles_size(), 1);
  EXPECT_EQ(entity.triangles(0).pose().position().x(), -3);
  ASSERT_EQ(entity.triangles(0).points_size(), 8);
  EXPECT_EQ(entity.triangles(0).points(2).x(), 1);
  EXPECT_EQ(entity.triangles(0).points(4).y(), 0.5);
  EXPECT_TRUE(StreamFigures::canShow("p3at1/models/map", "foxglove.Grid"));
}

/// The relative luminance of a color, as WCAG 2 defines it.
double luminance(double r, double g, double b) {
  const auto linear = [](double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

TEST(FigureOf, occupiedCellsOfAMapStandOutInBothThemes) {
  const auto figure = mapFigure();
  const auto& color = entityOf(figure).triangles(0).color();
  const double cells = luminance(color.r(), color.g(), color.b()) + 0.05;
  EXPECT_GT((luminance(0.88, 0.88, 0.88) + 0.05) / cells, 2.5) << "on a light background";
  EXPECT_GT(cells / (luminance(0.2, 0.2, 0.2) + 0.05), 2.5) << "on a dark background";
}

TEST(FigureOf, pointsOfACloudAreDots) {
  Cdr cdr;
  cdr.header("camera").add(std::uint32_t{1}).add(std::uint32_t{2}).add(std::uint32_t{2});
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y"}) {
    cdr.text(name).add(offset).bytes({7}).add(std::uint32_t{1});
    offset += 4;
  }
  cdr.bytes({0}).add(std::uint32_t{8}).add(std::uint32_t{16}).add(std::uint32_t{16});
  cdr.add(1.0F).add(2.0F).add(std::numeric_limits<float>::quiet_NaN()).add(0.0F).bytes({1});
  const auto figure = figureOf(*cdr.as(
      "sensor_msgs/msg/PointCloud2",
      "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\n"
      "bool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense"
      "\n===\nMSG: sensor_msgs/PointField\nstring name\nuint32 offset\nuint8 datatype\nuint32 count"));
  const auto& entity = entityOf(figure);
  ASSERT_EQ(entity.triangles_size(), 1);
  ASSERT_EQ(entity.triangles(0).points_size(), 4) << "the other one is no place";
  EXPECT_NEAR(entity.triangles(0).points(0).x(), 1, 0.02);
  EXPECT_NEAR(entity.triangles(0).points(0).y(), 2, 0.02);
}

TEST(FigureOf, readingsOfALaserAreDots) {
  foxglove::LaserScan scan;
  scan.set_frame_id("laser");
  scan.set_start_angle(0);
  scan.set_end_angle(robotlink::kPi / 2);
  for (const double range : {1.0, 0.0, 2.0}) scan.add_ranges(range);
  const auto figure = figureOf(scan);
  const auto& entity = entityOf(figure);
  ASSERT_EQ(entity.triangles(0).points_size(), 8);
  EXPECT_NEAR(entity.triangles(0).points(4).x(), 0, 0.02);
  EXPECT_NEAR(entity.triangles(0).points(4).y(), 2, 0.02);
}

class StreamFiguresTest : public testing::Test {
 protected:
  void push(const std::string& path, robotlink::Duration at, const robotlink::PackagePtr& value) {
    session_.push({path, Instant(at), value});
    session_.tick();
  }
  static std::shared_ptr<foxglove::SceneUpdate> scene(const std::string& add, const std::string& remove = {},
                                                      int seconds = 0) {
    auto update = std::make_shared<foxglove::SceneUpdate>();
    if (!remove.empty()) update->add_deletions()->set_id(remove);
    if (add.empty()) return update;
    update->add_entities()->set_id(add);
    update->mutable_entities(0)->mutable_lifetime()->set_seconds(seconds);
    return update;
  }
  std::string ids(robotlink::Duration at) {
    std::string all;
    for (const auto& figure : figures_.of(session_.store(), "markers", Instant(at)))
      all += figure.entity->id() + " ";
    return all;
  }

  robotlink::Session session_;
  StreamFigures figures_;
};

TEST_F(StreamFiguresTest, markersStayUntilTheyAreDeletedOrTheirLifeEnds) {
  push("markers", 1s, scene("a"));
  push("markers", 2s, scene("b", {}, 3));
  push("markers", 3s, scene("", "a"));
  EXPECT_EQ(ids(1s), "a ");
  EXPECT_EQ(ids(2s), "a b ");
  EXPECT_EQ(ids(3s), "b ");
  EXPECT_EQ(ids(6s), "");
  EXPECT_EQ(ids(2s), "a b ") << "also back in time";
}

TEST_F(StreamFiguresTest, ownStreamsAreNone) {
  EXPECT_TRUE(StreamFigures::canShow("scan", "foxglove.LaserScan"));
  EXPECT_TRUE(StreamFigures::canShow("markers", "foxglove.SceneUpdate"));
  EXPECT_TRUE(StreamFigures::canShow("tf", "foxglove.FrameTransforms"));
  EXPECT_FALSE(StreamFigures::canShow("red1/range/laser", "foxglove.LaserScan"));
  EXPECT_FALSE(StreamFigures::canShow("scene", "foxglove.SceneUpdate"));
  EXPECT_FALSE(StreamFigures::canShow("transforms", "foxglove.FrameTransforms"));
  EXPECT_FALSE(StreamFigures::canShow("imu", "sensor_msgs.Imu"));
}

class FrameTreeTest : public StreamFiguresTest {
 protected:
  static robotlink::PackagePtr transform(const std::string& parent, const std::string& child, double x) {
    auto message = std::make_shared<foxglove::FrameTransforms>();
    auto& one = *message->add_transforms();
    one.set_parent_frame_id(parent);
    one.set_child_frame_id(child);
    one.mutable_translation()->set_x(x);
    return message;
  }
  double x(const std::string& frame, robotlink::Duration at, const std::string& robot = {}) {
    tree_.update(session_.store(), Instant(at));
    const auto pose = tree_.pose(robot, frame);
    return pose ? pose->translation().x() : -1;
  }

  FrameTree tree_;
};

TEST_F(FrameTreeTest, aMessageMayBeOfOneTransform) {
  auto one = std::make_shared<foxglove::FrameTransform>();
  one->set_parent_frame_id("base");
  one->set_child_frame_id("laser");
  one->mutable_translation()->set_x(0.5);
  push("r1/laser_mount", 1s, one);
  push("r1/tf", 1s, transform("odom", "base", 2));
  EXPECT_EQ(x("laser", 1s), 2.5);
  EXPECT_TRUE(StreamFigures::canShow("r1/laser_mount", "foxglove.FrameTransform"));
  EXPECT_EQ(StreamFigures().of(session_.store(), "r1/laser_mount", Instant(1s)).size(), 1u);
}

TEST_F(FrameTreeTest, framesOfSeveralStreamsAreOneTree) {
  push("tf_static", 1s, transform("base", "laser", 0.5));
  push("tf", 2s, transform("map", "odom", 10));
  push("tf", 2s, transform("odom", "base", 2));
  push("tf", 3s, transform("odom", "base", 3));
  EXPECT_EQ(x("laser", 2s), 12.5);
  EXPECT_EQ(x("laser", 3s), 13.5);
  EXPECT_EQ(x("laser", 2s), 12.5) << "also back in time";
  EXPECT_EQ(x("map", 3s), 0);
  EXPECT_EQ(x("camera", 3s), -1);
}

TEST_F(FrameTreeTest, framesOfTheSameNameAreOfTheirOwnRobots) {
  push("one/tf", 1s, transform("map", "base", 1));
  push("two/tf", 2s, transform("map", "base", 2));
  push("two/tf_static", 2s, transform("base", "laser", 0.5));
  EXPECT_EQ(x("base", 3s, "one"), 1);
  EXPECT_EQ(x("base", 3s, "two"), 2);
  EXPECT_EQ(x("laser", 3s, "two"), 2.5);
  EXPECT_EQ(x("laser", 3s, "one"), -1) << "only the other one has a laser";
  EXPECT_EQ(x("base", 3s), -1) << "there is more than one";
}

TEST_F(FrameTreeTest, streamsWithoutARobotAreOneTree) {
  push("/tf", 1s, transform("map", "base", 1));
  push("/robot1/tf_static", 1s, transform("base", "laser", 0.5));
  EXPECT_EQ(x("laser", 1s), 1.5);
  EXPECT_EQ(x("laser", 1s, "lidar"), 1.5) << "a stream lidar/points of a log without leading slashes";
}

TEST_F(FrameTreeTest, theOnlyTreeIsThatOfAllStreams) {
  push("vehicle/tf", 1s, transform("map", "base", 1));
  EXPECT_EQ(x("base", 1s), 1);
  EXPECT_EQ(x("base", 1s, "lidar"), 1);
}

TEST_F(FrameTreeTest, framesInACircleAreNowhere) {
  push("tf", 1s, transform("a", "b", 1));
  push("tf", 2s, transform("b", "a", 1));
  EXPECT_EQ(x("a", 2s), -1);
}

}  // namespace
}  // namespace widgets
