// SPDX-License-Identifier: GPL-3.0-or-later
// Logs whose program cannot be run here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foxglove/Image.pb.h"
#include "logplayer/base/LogWriter.h"
#include "tests/app/platforms/replay/ReplayFixture.h"

using namespace app::test;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Logs of other programs, older or newer.
class ForeignSetup : public ::testing::Test {
 protected:
  /// One image of a robot whose program was made of this.
  std::filesystem::path write(const std::string& layout, const std::string& description = {}) {
    auto setup = std::make_shared<robotcontrol::ProgramSetup>();
    setup->mutable_layout()->set_name("layouts/foreign.yaml");
    setup->mutable_layout()->set_text(layout);
    setup->mutable_description()->set_text(description);
    auto image = std::make_shared<foxglove::RawImage>();
    const auto file = folder_ / "foreign.mcap";
    auto writer = logplayer::LogWriter::create(file, {});
    EXPECT_TRUE(
        (*writer)->write({{"red1/program", at(0), setup}, {"red1/camera/image", at(1), image, "platform"}}));
    return file;
  }
  /// One image that cannot be decoded.
  std::filesystem::path writeBrokenImage(const std::string& name) {
    auto image = std::make_shared<foxglove::CompressedImage>();
    image->set_format("jpeg");
    image->set_data("no image");
    const auto file = folder_ / name;
    auto writer = logplayer::LogWriter::create(file, {});
    EXPECT_TRUE((*writer)->write({{"red1/camera/image", at(1), image, "platform"}}));
    return file;
  }
  static std::string replayTexts(const Replay& replay) {
    std::string texts;
    for (const auto& message : replay.reported) {
      const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get());
      if (text != nullptr && text->name() == "replay") texts += text->message() + "\n";
    }
    return texts;
  }

 private:
  const TestFolder folder_;
};

TEST_F(ForeignSetup, anImageThatCannotBeDecodedIsReportedForItsOwnRobot) {
  Replay replay(replayOf({{write("version: 9\nname: later\n")}, {writeBrokenImage("broken.mcap")}}));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  ASSERT_EQ(replay.run->robots(), (std::vector<std::string>{"red1", "red1-2"}));
  replay.playToEnd();
  ASSERT_TRUE(replay.run->jump(replay.run->end()).empty());
  std::string paths;
  for (const auto& message : replay.reported) {
    const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get());
    if (text != nullptr && text->message().find("could not be decoded") != std::string::npos)
      paths += message.path + " ";
  }
  EXPECT_THAT(paths, testing::StartsWith("red1-2/log "));
  EXPECT_THAT(paths, testing::Not(HasSubstr("red1/log")));
}

TEST_F(ForeignSetup, aLayoutThatCannotBeReadDoesNotKeepTheLogShut) {
  Replay replay(write("version: 9\nname: later\n"));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  ASSERT_TRUE(replay.run->jump(at(1)).empty());
  EXPECT_THAT(replayTexts(replay), HasSubstr("shipped files are used instead: layouts/foreign.yaml:1"));
  EXPECT_EQ(replay.countOn("red1/camera/image"), 1U);
}

TEST_F(ForeignSetup, aLayoutThatCannotBeRunIsPlayedWithoutAProgram) {
  Replay replay(
      write("version: 1\nname: twice\nprocesses:\n"
            "  - {name: a, blocking: [camera/image], tasks: [segmentation: scan-lines]}\n"
            "  - {name: a, blocking: [camera/image], tasks: [segmentation: scan-lines]}\n"
            "  - {name: debug, debug: true, period_ms: 16}\n"));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  ASSERT_TRUE(replay.run->jump(at(1)).empty());
  EXPECT_THAT(replayTexts(replay),
              HasSubstr("nothing is recomputed, because the log's layout cannot be run: "));
  EXPECT_EQ(replay.countOn("red1/camera/image"), 1U);
  EXPECT_THAT(recomputedPackages(replay.status()), IsEmpty());
}
