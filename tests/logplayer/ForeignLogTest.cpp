// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of other programs: what is JSON is read as values, what is not decoded is named as that.
#include "tests/logplayer/ForeignLog.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "logplayer/LogInfo.h"
#include "logplayer/export/LogExport.h"
#include "robotlink/expressions/FieldPath.h"
#include "tests/TestFolder.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using robotlink::Instant;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class ForeignLogTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(tests::writeForeignLog(folder_ / "a.mcap")); }
  std::shared_ptr<LogFile> log() const {
    auto file = LogFile::open(folder_ / "a.mcap", {});
    EXPECT_TRUE(file);
    return *file;
  }
  static const LogInfo::Stream* streamOf(const LogInfo& info, const std::string& path) {
    for (const auto& stream : info.streams) {
      if (stream.path == path) return &stream;
    }
    return nullptr;
  }
  template <typename Write>
  std::string written(Write write, ExportReport* to = nullptr) {
    std::ostringstream text;
    const auto report = write(text);
    EXPECT_TRUE(report) << report.error().describe();
    if (report && to != nullptr) *to = *report;
    return text.str();
  }

  TestFolder folder_;
};

}  // namespace

TEST_F(ForeignLogTest, infoNamesEncodingsAndClaimsOnlyWhatIsDecoded) {
  const auto info = readLogInfo(folder_ / "a.mcap");
  ASSERT_TRUE(info) << info.error().describe();
  EXPECT_EQ(info->images, 0U) << "they are in FlatBuffers";
  EXPECT_THAT(info->robots, IsEmpty()) << "a topic a/b/c is no robot";
  EXPECT_EQ(streamOf(*info, "/camera")->encoding, "flatbuffer");
  EXPECT_EQ(streamOf(*info, "/camera")->undecoded, 10U);
  EXPECT_EQ(streamOf(*info, "a/b/c")->undecoded, 0U);
  const std::string text = toText(*info);
  EXPECT_THAT(text, HasSubstr("flatbuffer, not decoded"));
  EXPECT_THAT(text, HasSubstr("ros1, not decoded"));
  EXPECT_THAT(text, HasSubstr("11 messages (flatbuffer, ros1)"));
  EXPECT_EQ(toJson(*info).at("streams").at(0).at("encoding"), "flatbuffer");
}

TEST_F(ForeignLogTest, jsonIsReadAsValues) {
  const auto file = log();
  const auto message = file->latest("a/b/c", Instant(robotlink::fromSeconds(100.1)));
  ASSERT_TRUE(message);
  EXPECT_EQ(robotlink::numberAt(*message->value, "position.y"), -2);
  EXPECT_EQ(written([&](auto& out) { return writeTexts(file, {}, out, {}); }),
            "  100.400000  warning  /base: battery low\n  100.500000  info     /base: all well\n");
}

TEST_F(ForeignLogTest, aTableSaysWhichRowsItLacks) {
  ExportReport report;
  const std::string text = written([&](auto& out) { return writeCsv(log(), "a/b/c", out, {}); }, &report);
  EXPECT_EQ(text,
            "log_time,log_process,log_frame,covariance[0],covariance[1],frame,position.x,position.y,stamp,"
            "other_fields\r\n"
            "100.000000000,,,1,nan,map,1.5,-2,5.250000000,\r\n"
            "100.200000000,,,,,map,2,,,\"{\"\"note\"\":[1],\"\"position.y\"\":\"\"far\"\"}\"\r\n");
  EXPECT_THAT(report.losses, ElementsAre("1 message of a/b/c could not be read; left out"));
}

TEST_F(ForeignLogTest, whatIsNotDecodedIsNoTableAndNoImage) {
  std::ostringstream out;
  const auto table = writeCsv(log(), "/camera", out, {});
  ASSERT_FALSE(table);
  EXPECT_THAT(table.error().text,
              HasSubstr("the messages of /camera are in the encoding 'flatbuffer', which is not supported"));
  const auto images = exportImages(log(), {}, folder_ / "images", {});
  ASSERT_FALSE(images);
  EXPECT_THAT(images.error().text, HasSubstr("those of /camera are in an unsupported encoding"));
}

TEST_F(ForeignLogTest, severalStreamsMakeOneTable) {
  ExportReport report;
  const std::string text = written([&](auto& out) { return writeCsv(log(), "*,-/odom", out, {}); }, &report);
  EXPECT_THAT(text, HasSubstr("log_time,log_stream,log_process,log_frame,/rosout.timestamp,"));
  EXPECT_THAT(text, HasSubstr(",a/b/c.position.x,"));
  EXPECT_THAT(text, HasSubstr("\r\n100.200000000,a/b/c,,,,"));
  EXPECT_THAT(text, HasSubstr("\r\n100.400000000,/rosout,,,100.000000000,"));
  EXPECT_EQ(report.written, 4U);
  EXPECT_THAT(report.losses, ElementsAre(HasSubstr("10 messages left out"), HasSubstr("1 message of a/b/c")));
  std::ostringstream none;
  EXPECT_EQ(writeCsv(log(), "red1/*", none, {}).error().id, "export.stream");
}

TEST_F(ForeignLogTest, streamsBecomeLinesOfJson) {
  ExportReport report;
  const std::string text =
      written([&](auto& out) { return writeJsonLines(log(), "a/b/c,/rosout", out, {}); }, &report);
  std::istringstream lines(text);
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const auto first = nlohmann::json::parse(line);
  EXPECT_EQ(first.at("stream"), "a/b/c");
  EXPECT_EQ(first.at("log_time"), 100);
  EXPECT_EQ(first.at("type"), "their.Pose");
  EXPECT_EQ(first.at("message").at("position").at("y"), -2);
  EXPECT_FALSE(first.at("message").contains("other_fields"));
  EXPECT_EQ(report.written, 4U);
  EXPECT_THAT(report.losses, ElementsAre(HasSubstr("1 message of a/b/c")));
}

TEST_F(ForeignLogTest, onlyWhatALogSaysToBeARobotIsOne) {
  SampleLog{}.write(folder_ / "ours.mcap");
  EXPECT_THAT((*LogFile::open(folder_ / "ours.mcap", {}))->robots(), ElementsAre("red1"));
  {
    tests::ForeignLog foreign(folder_ / "same.mcap");
    const auto channel =
        foreign.add({"red1/models/ball", "their.Ball", "jsonschema", tests::kPoseSchema, "json"});
    foreign.write(channel, 1, "{}");
    ASSERT_TRUE(foreign.close());
  }
  EXPECT_THAT((*LogFile::open(folder_ / "same.mcap", {}))->robots(), IsEmpty());
}

TEST_F(ForeignLogTest, jsonWithoutASchemaIsReadByItsFirstMessage) {
  {
    tests::ForeignLog foreign(folder_ / "plain.mcap");
    const auto channel = foreign.add({"/speed", "", "", "", "json"});
    foreign.write(channel, 1, R"({"speed": 0.5})");
    foreign.write(channel, 2, R"({"speed": 1.5})");
    ASSERT_TRUE(foreign.close());
  }
  const auto file = LogFile::open(folder_ / "plain.mcap", {});
  ASSERT_TRUE(file);
  EXPECT_EQ(written([&](auto& out) { return writeCsv(*file, "/speed", out, {}); }),
            "log_time,log_process,log_frame,speed\r\n1.000000000,,,0.5\r\n2.000000000,,,1.5\r\n");
}

}  // namespace logplayer
