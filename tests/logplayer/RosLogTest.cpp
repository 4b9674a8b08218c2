// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of rosbag2 and of ROS 1: listed, searched and exported as all others.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "logplayer/LogInfo.h"
#include "logplayer/export/LogExport.h"
#include "logplayer/search/LogSearch.h"
#include "robotlink/expressions/NumericFields.h"
#include "tests/TestFolder.h"
#include "tests/logplayer/ForeignLog.h"
#include "tests/robotlink/ros/RosMessages.h"

namespace logplayer {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string bytes(const std::string& hex) {
  const auto all = robotlink::ros::test::bytesOf(hex);
  return {all.begin(), all.end()};
}

/// Two ranges in CDR with a message cut short between them, from 10 to 12 s, and a battery of ROS 1.
class RosLogTest : public ::testing::Test {
 protected:
  void SetUp() override {
    tests::ForeignLog log(file_);
    const auto range = log.add(
        {"/sonar/range", "p/msg/Range", "ros2msg",
         "std_msgs/Header header\nuint8 SONAR=0\nuint8 LASER=1\nuint8 kind\nfloat32 range\n" +
             std::string(80, '=') + "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id",
         "cdr"});
    const auto battery =
        log.add({"/battery", "p/Battery", "ros1msg", "float32 volts\nfloat32[] cells", "ros1"});
    log.write(range, 10, bytes("00010000 0a000000 00000000 02000000 6600 01 00 0000003f"));
    log.write(range, 11, bytes("00010000 0a000000"));
    log.write(range, 12, bytes("00010000 0c000000 00000000 02000000 6600 00 00 00000040"));
    log.write(battery, 10.5, bytes("00003841 02000000 0000803f 00000040"));
    ASSERT_TRUE(log.close());
  }
  std::shared_ptr<LogFile> log() const {
    auto file = LogFile::open(file_, {});
    EXPECT_TRUE(file);
    return *file;
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "bag.mcap";
};

TEST_F(RosLogTest, itsStreamsAreListedAsDecoded) {
  const auto info = readLogInfo(file_);
  ASSERT_TRUE(info) << info.error().describe();
  ASSERT_EQ(info->streams.size(), 2U);
  EXPECT_EQ(info->streams[0].type, "p/Battery");
  EXPECT_EQ(info->streams[1].type, "p/msg/Range");
  EXPECT_EQ(info->streams[1].undecoded, 0U);
  EXPECT_THAT(toText(*info), Not(HasSubstr("not decoded")));
}

TEST_F(RosLogTest, itsNumbersCanBePlotted) {
  const auto message = log()->latest("/battery", robotlink::Instant::max());
  ASSERT_TRUE(message);
  EXPECT_THAT(robotlink::numericFields(*message->value), ElementsAre("volts", "cells[0]", "cells[1]"));
}

TEST_F(RosLogTest, itBecomesATable) {
  std::ostringstream out;
  const auto report = writeCsv(log(), "/sonar/range", out, {});
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(out.str(),
            "log_time,log_process,log_frame,header.stamp,header.frame_id,kind,range\r\n"
            "10.000000000,,,10.000000000,f,LASER,0.5\r\n"
            "12.000000000,,,12.000000000,f,SONAR,2\r\n");
  EXPECT_THAT(report->losses, ElementsAre("1 message of /sonar/range could not be read; left out"));
}

TEST_F(RosLogTest, itIsSearchedByItsFields) {
  std::vector<robotlink::Instant> found;
  const auto report = searchLog(log(), "/sonar/range.range > 1", {}, [&](const SearchHit& hit) {
    found.push_back(hit.from);
    return true;
  });
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_THAT(found, ElementsAre(robotlink::Instant(robotlink::fromSeconds(12))));
}

TEST_F(RosLogTest, itsTextsAreThoseOfAllLogs) {
  {
    tests::ForeignLog texts(folder_ / "texts.mcap");
    const auto rosout =
        texts.add({"/rosout", "rcl_interfaces/msg/Log", "ros2msg",
                   "builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg", "cdr"});
    texts.write(rosout, 1, bytes("00010000 01000000 00000000 28 000000 02000000 6e00 0000 03000000 686900"));
    ASSERT_TRUE(texts.close());
  }
  const auto file = LogFile::open(folder_ / "texts.mcap", {});
  ASSERT_TRUE(file);
  std::ostringstream out;
  ASSERT_TRUE(writeTexts(*file, {}, out, {}));
  EXPECT_EQ(out.str(), "    1.000000  error    /n: hi\n");
}

}  // namespace
}  // namespace logplayer
