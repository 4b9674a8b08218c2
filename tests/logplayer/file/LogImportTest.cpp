// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/file/LogImport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "foxglove/Image.pb.h"
#include "logplayer/file/ContainerFile.h"
#include "logplayer/mcap/read/Reader.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/process/Layout.h"
#include "tests/TestFolder.h"
#include "tests/game/Data.h"
#include "tests/game/Log.h"
#include "tests/logplayer/pictures/AviFile.h"

using namespace logplayer;
using bhuman::QueueBuilder;

namespace {

class LogImport : public testing::Test {
 protected:
  void SetUp() override { ::setenv("ROBOTCONTROL_RESOURCES", ROBOTCONTROL_SOURCE_DIR "/resources", 1); }

  std::filesystem::path written(const std::vector<std::uint8_t>& bytes) const {
    const auto file = folder_ / "old.log";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file;
  }
  std::filesystem::path target() const { return folder_ / "new.mcap"; }

  TestFolder folder_;
};

/// The parameter is the source of a whole log.
class WholeLogImport : public LogImport, public testing::WithParamInterface<std::string> {};

QueueBuilder someLog() {
  return QueueBuilder().begin('m').joints(100).end('m').begin('c').image(150, 4, 2).cameraMatrix(true).end(
      'c');
}

struct LoggedMessage {
  std::string topic;
  mcap::Instant time;
  std::string data;
};

/// All messages of a file in its order; the file must be whole.
std::vector<LoggedMessage> messagesOf(const std::filesystem::path& file) {
  auto reader = mcap::Reader::open(file, {});
  EXPECT_TRUE(reader) << reader.error().describe();
  EXPECT_TRUE((*reader)->complete());
  std::vector<LoggedMessage> messages;
  (*reader)->readAll([&](const mcap::Message& message) {
    messages.push_back(
        {(*reader)->channels().at(message.channelId).topic, message.logTime,
         std::string(reinterpret_cast<const char*>(message.data.data()), message.data.size())});
    return true;
  });
  return messages;
}

std::string topicsOf(const std::vector<LoggedMessage>& messages) {
  std::string topics;
  for (const LoggedMessage& message : messages) topics += message.topic + " ";
  return topics;
}

}  // namespace

TEST_F(LogImport, recognizesOldLogsByTheirContents) {
  EXPECT_TRUE(canImport(written(someLog().file())));
  EXPECT_TRUE(canImport(written(someLog().appendableFile())));
  EXPECT_FALSE(canImport(written({1, 2, 3})));
  EXPECT_FALSE(canImport(folder_ / "missing.log"));
  EXPECT_FALSE(canImport(folder_.path())) << "a folder";
}

TEST_F(LogImport, aLogBeginsWithTheSetUpOfAProgramThatSuitsIt) {
  const auto report = importLog(written(someLog().file()), target(), {});
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->format, "B-Human message queue");
  const auto messages = messagesOf(target());
  EXPECT_EQ(topicsOf(messages),
            "nao/program nao/joints/states nao/frames/motion nao/camera/image nao/camera/pose "
            "nao/frames/cognition ");
  EXPECT_EQ(messages[0].time, messages[1].time);

  robotcontrol::ProgramSetup setup;
  ASSERT_TRUE(setup.ParseFromString(messages[0].data));
  EXPECT_EQ(setup.robot(), "nao");
  const auto layout = robotlink::parseLayout(setup.layout().text(), setup.layout().name());
  ASSERT_TRUE(layout) << describe(layout.error());
  EXPECT_EQ(layout->name, "perception");
  const auto field = robotlink::FieldDescription::parse(setup.field().text(), setup.field().name());
  ASSERT_TRUE(field) << describe(field.error());
  EXPECT_EQ(field->boundaryLength, 6);
  EXPECT_FALSE(setup.description().text().empty());
}

TEST_F(LogImport, fieldAndTeamAreThoseOfTheRobotAndItsName) {
  for (const auto& [robot, team] : {std::pair{"nao", "red"}, std::pair{"blue3", "blue"}}) {
    ImportOptions options;
    options.robot = robot;
    std::filesystem::remove(target());
    const auto report = importLog(written(someLog().file()), target(), options);
    ASSERT_TRUE(report) << report.error().describe();
    robotcontrol::ProgramSetup setup;
    ASSERT_TRUE(setup.ParseFromString(messagesOf(target())[0].data));
    EXPECT_EQ(setup.team(), team);
    EXPECT_EQ(setup.field().name(), "fields/2009.yaml");
    EXPECT_THAT(setup.offered(), testing::Contains("joints/states"));
  }
}

TEST_F(LogImport, aColorTableGoesIntoTheLog) {
  auto table = std::make_shared<robotcontrol::ColorTable>();
  table->add_class_names("orange");
  table->set_cells(std::string(64 * 64 * 64, '\1'));
  ImportOptions options;
  options.robot = "blue2";
  options.colorTable = table;
  ASSERT_TRUE(importLog(written(someLog().file()), target(), options));
  for (const LoggedMessage& message : messagesOf(target())) {
    EXPECT_EQ(message.topic.rfind("blue2/", 0), 0U) << message.topic;
    if (message.topic != "blue2/colors/table") continue;
    EXPECT_TRUE(message.data == table->SerializeAsString());
    EXPECT_EQ(message.time.time_since_epoch(), std::chrono::milliseconds(100)) << "at the first frame's time";
    return;
  }
  FAIL() << "there is no table";
}

TEST_F(LogImport, givingUpLeavesNothing) {
  ImportOptions options;
  options.progress = [](double done) { return done < 0.5; };
  const auto report = importLog(written(someLog().file()), target(), options);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "log.given-up");
  EXPECT_FALSE(std::filesystem::exists(target()));
}

TEST_F(LogImport, allThatUseAnOldLogShareItsCopy) {
  const auto old = written(someLog().file());
  int conversions = 0;
  const auto container = [&] { return ContainerFile::of(old, [&](double) { return ++conversions > 0; }); };
  std::filesystem::path copy;
  {
    const auto first = container();
    ASSERT_TRUE(first) << first.error().describe();
    ASSERT_NE(first->conversion(), nullptr);
    const int once = conversions;
    const auto second = container();
    copy = second->path();
    EXPECT_EQ(copy, first->path());
    EXPECT_EQ(conversions, once);
    EXPECT_TRUE(std::filesystem::exists(copy));
    // One that was rewritten is another one.
    written(someLog().begin('m').joints(100).end('m').file());
    const auto third = container();
    ASSERT_TRUE(third) << third.error().describe();
    EXPECT_NE(third->path(), copy);
  }
  EXPECT_FALSE(std::filesystem::exists(copy));
  const auto itself = ContainerFile::of(folder_ / "any.mcap", {});
  EXPECT_EQ(itself->path(), folder_ / "any.mcap");
  EXPECT_EQ(itself->conversion(), nullptr);
}

TEST_F(LogImport, progressGoesFromNothingToAll) {
  std::vector<double> reported;
  ImportOptions options;
  options.progress = [&](double done) {
    reported.push_back(done);
    return true;
  };
  ASSERT_TRUE(importLog(written(someLog().file()), target(), options));
  ASSERT_FALSE(reported.empty());
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), 1);
}

TEST_F(LogImport, whatCannotBeImportedIsRefusedInWords) {
  const auto other = importLog(written({1, 2, 3}), target(), {});
  EXPECT_EQ(other.error().id, "log.unknown-format");
  EXPECT_EQ(importLog(folder_ / "missing.log", target(), {}).error().id, "log.open");
  const auto log = written(someLog().file());
  std::ofstream(target()) << "somebody's";
  EXPECT_FALSE(importLog(log, target(), {})) << "an existing file";
  EXPECT_TRUE(std::filesystem::exists(target())) << "which stays";
}

TEST_P(WholeLogImport, aLogOf2009BecomesAWholeFileInShortTime) {
  const bool real = GetParam() == "real";
  const auto log = game::dataOf(GetParam()) / "logs/bhuman2009.log";
  if (!std::filesystem::exists(log)) GTEST_SKIP() << "the real log is not at " << log;
  const auto start = std::chrono::steady_clock::now();
  const auto report = importLog(log, target(), {});
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << "usually well below one";
  EXPECT_EQ(report->messages, real ? 2444U : game::Log::kMessages);
  std::map<std::string, int> counts;
  foxglove::RawImage image;
  for (const LoggedMessage& message : messagesOf(target())) {
    ++counts[message.topic];
    if (message.topic == "nao/camera/image" && counts[message.topic] == 1) {
      ASSERT_TRUE(image.ParseFromString(message.data));
      EXPECT_EQ(message.time.time_since_epoch(),
                std::chrono::milliseconds(real ? 486749 : game::Log::imageMs(0)));
    }
  }
  EXPECT_EQ(image.encoding(), "yuyv");
  const int images = real ? 160 : game::View::kCount, motions = real ? 274 : game::Log::kMotionFrames;
  const std::map<std::string, int> expected = {{"nao/program", 1},
                                               {"nao/camera/image", images},
                                               {"nao/camera/pose", images},
                                               {"nao/frames/motion", motions},
                                               {"nao/joints/states", motions},
                                               {"nao/body/sensors", motions},
                                               {"nao/body/readings", motions},
                                               {"nao/motion/status", motions},
                                               {"nao/frames/cognition", images},
                                               {"nao/log", real ? 1 : 3}};
  EXPECT_EQ(counts, expected);
}

INSTANTIATE_TEST_SUITE_P(Logs, WholeLogImport, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

TEST_F(LogImport, theShippedDescriptionsAreSound) {
  const auto robot = robotlink::readRobotDescription(ROBOTCONTROL_SOURCE_DIR "/resources/robots/nao.yaml");
  ASSERT_TRUE(robot) << describe(robot.error());
  EXPECT_EQ(robot->joints.size(), 22U);
  const auto field = robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2009.yaml");
  ASSERT_TRUE(field) << describe(field.error());
  EXPECT_EQ(field->goalLineX(), 3);
  EXPECT_TRUE(field->beacons.empty());
}

TEST_F(LogImport, aVideoBecomesTheLogOfACamera) {
  AviFile avi(64, 48, 25);
  for (int i = 0; i < 3; ++i) avi.add(robotlink::Image(64, 48, robotlink::PixelFormat::kRgb8));
  avi.write(folder_ / "match.avi");
  EXPECT_TRUE(canImport(folder_ / "match.avi"));
  const auto report = importLog(folder_ / "match.avi", target(), {});
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->format, "video");
  const auto messages = messagesOf(target());
  EXPECT_EQ(topicsOf(messages),
            "camera/program camera/camera/image camera/camera/pose camera/frames/camera "
            "camera/camera/image camera/camera/pose camera/frames/camera "
            "camera/camera/image camera/camera/pose camera/frames/camera ");
  EXPECT_EQ(messages.back().time, robotlink::Instant(std::chrono::milliseconds(80)));
}

TEST_F(LogImport, aFolderOfPicturesBecomesTheLogOfACamera) {
  const auto png = encodePng(robotlink::Image(8, 6, robotlink::PixelFormat::kRgb8).view());
  for (const char* name : {"a.png", "b.png"})
    folder_.write(std::string("pictures/") + name, std::string(png->begin(), png->end()));
  EXPECT_TRUE(canImport(folder_ / "pictures"));
  EXPECT_FALSE(canImport(folder_.path()));
  const auto report = importLog(folder_ / "pictures", target(), {.robot = "eye"});
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(topicsOf(messagesOf(target())),
            "eye/program eye/camera/image eye/camera/pose eye/frames/camera "
            "eye/camera/image eye/camera/pose eye/frames/camera ");
}
