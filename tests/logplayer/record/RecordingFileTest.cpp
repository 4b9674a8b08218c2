// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/RecordingFile.h"

#include <gmock/gmock.h>

#include "foxglove/Image.pb.h"
#include "tests/logplayer/RecordedMessages.h"

namespace logplayer {
namespace {

using robotcontrol::ControlRecording;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::frameOf;
using tests::plot;
using tests::readLog;
using tests::table;

class RecordingFileTest : public testing::Test {
 protected:
  std::unique_ptr<RecordingFile> create(const RecordingFile::Options& options = {}) {
    auto file = RecordingFile::create(path_, options);
    EXPECT_TRUE(file) << file.error().describe();
    return file ? std::move(*file) : nullptr;
  }

  const TestFolder folder_;
  const std::filesystem::path path_ = folder_ / "a.mcap";
};

TEST_F(RecordingFileTest, whatIsLatchedGetsTheTimeOfTheFirstFrameAndBelongsToNone) {
  const auto file = create();
  file->beginWith({table("red1/keys", 3, "old"), table("red1/modules", 4, "old")});
  ASSERT_TRUE(file->write(*frameOf({plot("red1/plots/a", 50, 1, "cognition", 7)})));
  ASSERT_TRUE(file->write(*frameOf({plot("red1/plots/a", 60, 2, "cognition", 8)})));
  ASSERT_TRUE(file->close({}));
  EXPECT_EQ(file->messages(), 4U);
  const auto log = readLog(path_);
  EXPECT_THAT(log.paths(), ElementsAre("red1/keys", "red1/modules", "red1/plots/a", "red1/plots/a"));
  EXPECT_EQ(log.entries[0].time, tests::at(50));
  EXPECT_EQ(log.entries[0].frame, 0U);
  EXPECT_EQ(log.entries[2].frame, 7U);
  EXPECT_TRUE(log.complete);
}

TEST_F(RecordingFileTest, withoutAFrameWhatIsLatchedKeepsTheTimeOfItsFirst) {
  const auto file = create();
  file->beginWith({table("red1/keys", 30, "old"), table("red1/modules", 40, "old")});
  ASSERT_TRUE(file->close({}));
  const auto log = readLog(path_);
  ASSERT_THAT(log.paths(), ElementsAre("red1/keys", "red1/modules"));
  EXPECT_EQ(log.entries[1].time, tests::at(30));
}

TEST_F(RecordingFileTest, aFrameWithoutMessagesIsNotTheFirst) {
  const auto file = create();
  file->beginWith({table("red1/keys", 3, "old")});
  ASSERT_TRUE(file->write(*frameOf({})));
  EXPECT_EQ(file->messages(), 0U);
  ASSERT_TRUE(file->write(*frameOf({plot("red1/plots/a", 50, 1)})));
  ASSERT_TRUE(file->close({}));
  EXPECT_EQ(readLog(path_).entries.at(0).time, tests::at(50));
}

TEST_F(RecordingFileTest, itEndsWithAReportOfWhatWasDroppedAndWhoWroteIt) {
  const auto file = create({.software = "robotcontrol 1.2"});
  ASSERT_TRUE(file->close({.messages = 3, .bytes = 4000}));
  const auto log = readLog(path_);
  EXPECT_EQ(log.recording.at("dropped_messages"), "3");
  EXPECT_EQ(log.recording.at("dropped_bytes"), "4000");
  EXPECT_EQ(log.recording.at("software"), "robotcontrol 1.2");
  EXPECT_THAT(log.recording.at("started"), testing::MatchesRegex("....-..-..T..:..:..Z"));
}

TEST_F(RecordingFileTest, imagesAreCodedWithoutALossWhereAskedOrWhereTheyMayHoldClasses) {
  auto color = std::make_shared<foxglove::RawImage>();
  color->set_width(4);
  color->set_height(2);
  color->set_step(12);
  color->set_encoding("rgb8");
  color->set_data(std::string(24, 'x'));
  const auto formatsWith = [&](ControlRecording::ImageCoding coding) {
    std::filesystem::remove(path_);
    const auto file = create({.imageCoding = coding, .software = ""});
    EXPECT_TRUE(file->write(*frameOf({{"red1/camera/image", tests::at(0), color},
                                      tests::image("red1/camera/classes", 0, 2000),
                                      plot("red1/plots/a", 0, 1)})));
    EXPECT_TRUE(file->close({}));
    std::vector<std::string> formats;
    for (const auto& entry : readLog(path_).entries) {
      foxglove::CompressedImage image;
      if (entry.type == "foxglove.CompressedImage" && image.ParseFromString(entry.data))
        formats.push_back(image.format());
      else
        formats.push_back(entry.type);
    }
    return formats;
  };
  EXPECT_THAT(formatsWith(ControlRecording::AS_IS),
              ElementsAre("foxglove.RawImage", "foxglove.RawImage", "robotcontrol.PlotValue"));
  EXPECT_THAT(formatsWith(ControlRecording::JPEG), ElementsAre("jpeg", "png", "robotcontrol.PlotValue"));
  EXPECT_THAT(formatsWith(ControlRecording::PNG), ElementsAre("png", "png", "robotcontrol.PlotValue"));
}

TEST_F(RecordingFileTest, anImageThatCannotBeCodedIsRecordedAsItIs) {
  auto strange = std::make_shared<foxglove::RawImage>();
  strange->set_width(4);
  strange->set_height(2);
  strange->set_step(4);
  strange->set_encoding("infrared");
  strange->set_data(std::string(8, 'x'));
  const auto file = create({.imageCoding = ControlRecording::JPEG, .software = ""});
  ASSERT_TRUE(file->write(*frameOf({{"red1/camera/image", tests::at(0), strange}})));
  ASSERT_TRUE(file->close({}));
  const auto log = readLog(path_);
  ASSERT_EQ(log.entries.size(), 1U);
  EXPECT_EQ(log.entries[0].type, "foxglove.RawImage");
  EXPECT_EQ(log.entries[0].data, strange->SerializeAsString());
}

TEST_F(RecordingFileTest, itIsNotWrittenOverAnotherFile) {
  folder_.write("a.mcap", "precious");
  const auto refused = RecordingFile::create(path_, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().describe(), HasSubstr("a.mcap"));
  EXPECT_EQ(std::filesystem::file_size(path_), 8U);
}

TEST_F(RecordingFileTest, aNameIsTakenAsItIs) {
  EXPECT_EQ(newRecordingPath("x/game.mcap", folder_ / "unused").value(), "x/game.mcap");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "unused"));
}

TEST_F(RecordingFileTest, withoutANameItIsNamedAfterTheTimeInAFolderThatIsMade) {
  const auto path = newRecordingPath("", folder_ / "logs" / "new").value();
  EXPECT_EQ(path.parent_path(), folder_ / "logs" / "new");
  EXPECT_TRUE(std::filesystem::is_directory(path.parent_path()));
  EXPECT_THAT(path.filename().string(), testing::MatchesRegex("robotcontrol-[0-9]+-[0-9]+.*\\.mcap"));
}

TEST_F(RecordingFileTest, inAFolderANameThatExistsIsNotTakenAgain) {
  const auto first = newRecordingPath(folder_.path(), "").value();
  EXPECT_EQ(first.parent_path(), folder_.path());
  folder_.write(first.filename(), "");
  const auto second = newRecordingPath(folder_.path(), "").value();
  EXPECT_NE(second, first);
  EXPECT_FALSE(std::filesystem::exists(second));
}

TEST_F(RecordingFileTest, aFolderThatCannotBeMadeIsNamed) {
  folder_.write("file", "");
  const auto refused = newRecordingPath("", folder_ / "file" / "logs");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().describe(), HasSubstr((folder_ / "file" / "logs").string()));
  EXPECT_THAT(refused.error().text, HasSubstr("choose another one"));
}

TEST_F(RecordingFileTest, aRecordingGoesOnUnderTheFirstNumberThatIsFree) {
  EXPECT_EQ(nextRecordingPath(folder_ / "game.mcap"), folder_ / "game-2.mcap");
  folder_.write("game-2.mcap", "");
  folder_.write("game-3.mcap", "");
  EXPECT_EQ(nextRecordingPath(folder_ / "game.mcap"), folder_ / "game-4.mcap");
  EXPECT_EQ(nextRecordingPath(folder_ / "a.b.mcap"), folder_ / "a.b-2.mcap");
}

}  // namespace
}  // namespace logplayer
