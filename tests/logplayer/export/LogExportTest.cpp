// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/export/LogExport.h"

#include <gmock/gmock.h>

#include <sstream>

#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using namespace std::chrono_literals;
using robotlink::Instant;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class LogExportTest : public testing::Test {
 protected:
  void SetUp() override { SampleLog{.frames = 20}.write(folder_ / "a.mcap"); }
  std::shared_ptr<LogFile> log() const {
    auto file = LogFile::open(folder_ / "a.mcap", {});
    EXPECT_TRUE(file);
    return *file;
  }
  static std::string csv(const std::shared_ptr<LogFile>& file, const std::string& stream,
                         const ExportOptions& options = {}) {
    std::ostringstream text;
    const auto report = writeCsv(file, stream, text, options);
    EXPECT_TRUE(report) << report.error().describe();
    return text.str();
  }

  TestFolder folder_;
};

TEST_F(LogExportTest, imagesAreWrittenAsPngNamedByStreamTimeAndFrame) {
  const auto report = exportImages(log(), {}, folder_ / "images", {});
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->written, 20U);
  EXPECT_THAT(report->losses, IsEmpty());
  const auto file = robotlink::readFile(folder_ / "images/red1-camera-image-0000000000.120000-00004.png");
  ASSERT_TRUE(file);
  const auto image = decodePng({reinterpret_cast<const std::uint8_t*>(file->data()), file->size()});
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 4);
  EXPECT_EQ(image->height, 2);
  EXPECT_EQ(image->data[0], 3);
}

TEST_F(LogExportTest, onlyImagesInTheRangeAndOfTheChosenStreams) {
  const ExportOptions options{.from = sampleTime(5), .to = sampleTime(7)};
  EXPECT_EQ(exportImages(log(), {}, folder_ / "images", options)->written, 3U);
  const auto none = exportImages(log(), {{"blue*"}, {}}, folder_ / "images", {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().id, "export.images");
}

TEST_F(LogExportTest, imagesAreOverwrittenOnlyIfTheyMayBe) {
  ASSERT_TRUE(exportImages(log(), {}, folder_ / "images", {}));
  EXPECT_FALSE(exportImages(log(), {}, folder_ / "images", {}));
  EXPECT_TRUE(exportImages(log(), {}, folder_ / "images", {.overwrite = true}));
}

TEST_F(LogExportTest, aStreamBecomesATableWithItsTimesProcessAndFrame) {
  const std::string text = csv(log(), "red1/models/ball", {.to = sampleTime(1)});
  EXPECT_EQ(text,
            "log_time,log_process,log_frame,timestamp,known,position_in_robot.x,position_in_robot.y,seconds_"
            "since_seen,"
            "standard_deviation\r\n"
            "0.000000000,cognition,1,0.000000000,false,0,0,0,0\r\n"
            "0.040000000,cognition,2,0.040000000,false,1,0,0,0\r\n");
  EXPECT_THAT(csv(log(), "red1/joints/states"), HasSubstr("joints[0].position"));
}

TEST_F(LogExportTest, textsWithCommasAndQuotesAreQuotedInATable) {
  EXPECT_THAT(csv(log(), "red1/log"), HasSubstr(",WARNING,\"frame 10, \"\"quoted\"\"\",cognition/test,"));
}

TEST_F(LogExportTest, aTableOfAnUnknownStreamFails) {
  std::ostringstream text;
  const auto report = writeCsv(log(), "blue1/*", text, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "export.stream");
  EXPECT_FALSE(exportCsv(log(), "red1/none", folder_ / "x.csv", {}));
  EXPECT_EQ(folder_.contents(), "a.mcap");
}

TEST_F(LogExportTest, textsAreLinesWithTimeLevelAndSource) {
  std::ostringstream text;
  ASSERT_TRUE(writeTexts(log(), {}, text, {}));
  EXPECT_EQ(text.str(),
            "    0.000000  warning  red1/cognition/test: frame 0, \"quoted\"\n"
            "    0.400000  warning  red1/cognition/test: frame 10, \"quoted\"\n");
}

TEST_F(LogExportTest, filesAreWrittenWholeOrNotAtAll) {
  ASSERT_TRUE(exportCsv(log(), "red1/models/ball", folder_ / "ball.csv", {}));
  EXPECT_EQ(robotlink::readFile(folder_ / "ball.csv"), csv(log(), "red1/models/ball"));
  ASSERT_TRUE(exportTexts(log(), {}, folder_ / "texts.txt", {}));
  EXPECT_FALSE(exportCsv(log(), "red1/models/ball", folder_ / "ball.csv", {}));
  const ExportOptions canceled{.overwrite = true, .progress = [](double) { return false; }};
  std::filesystem::remove(folder_ / "a.mcap");
  SampleLog{.frames = 200}.write(folder_ / "a.mcap");
  const auto report = exportCsv(log(), "red1/models/ball", folder_ / "other.csv", canceled);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "log.given-up");
  EXPECT_EQ(folder_.contents(), "a.mcap ball.csv texts.txt");
}

TEST_F(LogExportTest, whatOfTheLogIsMissingIsALoss) {
  std::filesystem::remove(folder_ / "a.mcap");
  SampleLog{.close = false}.write(folder_ / "a.mcap");
  std::ostringstream text;
  EXPECT_THAT(writeTexts(log(), {}, text, {})->losses, ElementsAre(HasSubstr("not closed")));
}

// A disk that fills up: it takes some bytes, and no more.
class SmallDisk : public std::streambuf {
 public:
  std::size_t written = 0;

 private:
  std::streamsize xsputn(const char*, std::streamsize count) override {
    if (written + static_cast<std::size_t>(count) > 2000) return 0;
    written += static_cast<std::size_t>(count);
    return count;
  }
  int overflow(int) override { return traits_type::eof(); }
};

TEST_F(LogExportTest, whatIsWrittenInVainEndsAtOnce) {
  SampleLog{.frames = 400}.write(folder_ / "long.mcap");
  const auto file = *LogFile::open(folder_ / "long.mcap", {});
  const std::string stream = file->streams().front().path;
  int looks = 0;
  ExportOptions options;
  options.progress = [&](double) {
    ++looks;
    return true;
  };
  const auto fails = [&](const auto& write, int looksBefore) {
    SmallDisk disk;
    std::ostream out(&disk);
    looks = 0;
    const auto report = write(out);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().id, "file.io");
    EXPECT_THAT(report.error().text, StartsWith("cannot write: "));
    EXPECT_LE(looks, looksBefore);
  };
  int all = 0;
  {
    std::ostringstream out;
    looks = 0;
    ASSERT_TRUE(writeJsonLines(file, "*", out, options));
    all = looks;
    ASSERT_GT(all, 4);
  }
  fails([&](std::ostream& out) { return writeJsonLines(file, "*", out, options); }, 2);
  // A table is made in two passes, of which the first one writes nothing.
  fails([&](std::ostream& out) { return writeCsv(file, "*", out, options); }, all + 2);
}

}  // namespace
}  // namespace logplayer
