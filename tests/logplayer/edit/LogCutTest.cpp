// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/LogCut.h"

#include <gmock/gmock.h>

#include "foxglove/Image.pb.h"
#include "logplayer/base/LogWriter.h"
#include "logplayer/bookmarks/BookmarkStorage.h"
#include "logplayer/bookmarks/Bookmarks.h"
#include "logplayer/file/LogFile.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/logplayer/ForeignLog.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using namespace std::chrono_literals;
using robotcontrol::BallModel;
using robotcontrol::KeyTable;
using robotlink::Instant;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class LogCutTest : public testing::Test {
 protected:
  void SetUp() override { SampleLog{}.write(in()); }
  std::filesystem::path in() const { return folder_ / "in.mcap"; }
  std::filesystem::path out() const { return folder_ / "out.mcap"; }

  RewriteReport rewritten(const RewriteOptions& options) {
    const auto report = rewriteLogs(options, out());
    EXPECT_TRUE(report) << report.error().describe();
    auto reader = mcap::Reader::open(out(), {});
    EXPECT_TRUE(reader && (*reader)->complete() && (*reader)->verify() && (*reader)->damage().empty());
    return report.value_or(RewriteReport{});
  }
  std::shared_ptr<LogFile> log() const {
    auto file = LogFile::open(out(), {});
    EXPECT_TRUE(file) << file.error().describe();
    return *file;
  }
  static std::vector<std::string> paths(const LogFile& file) {
    std::vector<std::string> all;
    for (const auto& stream : file.streams()) all.push_back(stream.path);
    return all;
  }
  static std::uint64_t count(const LogFile& file, const std::string& path) {
    for (const auto& stream : file.streams()) {
      if (stream.path == path) return stream.count;
    }
    return 0;
  }
  template <typename T>
  static T latest(LogFile& file, const std::string& path, Instant time) {
    const auto message = file.latest(path, time);
    const T* value = message ? dynamic_cast<const T*>(message->value.get()) : nullptr;
    EXPECT_NE(value, nullptr) << path;
    return value ? *value : T();
  }

  TestFolder folder_;
};

TEST_F(LogCutTest, aCutHasTheFramesInItsRangeWithBothEnds) {
  const auto report = rewritten({.inputs = {{in()}}, .from = sampleTime(10), .to = sampleTime(20)});
  EXPECT_EQ(report.frames, 11U) << "the platform's steps are none";
  EXPECT_THAT(report.losses, IsEmpty());
  const auto file = log();
  EXPECT_EQ(file->begin(), sampleTime(10));
  EXPECT_EQ(file->end(), sampleTime(20));
  EXPECT_EQ(count(*file, "red1/models/ball"), 11U);
  EXPECT_EQ(count(*file, "red1/frames/cognition"), 11U);
  EXPECT_EQ(count(*file, "red1/joints/states"), 11U);
  EXPECT_EQ(latest<BallModel>(*file, "red1/models/ball", sampleTime(15)).position_in_robot().x(), 15);
  EXPECT_EQ(file->latest("red1/models/ball", sampleTime(15))->frame, 16U) << "frames keep their numbers";
}

TEST_F(LogCutTest, whatIsLatchedIsAtItsStart) {
  rewritten({.inputs = {{in()}}, .from = sampleTime(40), .to = sampleTime(60)});
  const auto file = log();
  EXPECT_EQ(latest<KeyTable>(*file, "red1/tables/keys", sampleTime(40)).keys(0).name(), "before");
  EXPECT_EQ(latest<KeyTable>(*file, "red1/tables/keys", sampleTime(60)).keys(0).name(), "after");
  EXPECT_TRUE(file->latest("scene", sampleTime(40)));
  auto reader = mcap::Reader::open(out(), {});
  EXPECT_EQ((*reader)->statistics().messageStart, sampleTime(40)) << "a viewer shows no gap before it";
}

TEST_F(LogCutTest, whatWasPublishedAnewAtTheStartIsThatOne) {
  rewritten({.inputs = {{in()}}, .from = sampleTime(50), .to = sampleTime(60)});
  EXPECT_EQ(latest<KeyTable>(*log(), "red1/tables/keys", sampleTime(50)).keys(0).name(), "after");
}

TEST_F(LogCutTest, framesWithoutTheirEndAreLeftOut) {
  std::filesystem::remove(in());
  SampleLog{.cutLastFrame = true}.write(in());
  const auto report = rewritten({.inputs = {{in()}}});
  EXPECT_EQ(count(*log(), "red1/models/ball"), 99U);
  EXPECT_THAT(report.losses, ElementsAre(HasSubstr("1 frame left out")));
}

TEST_F(LogCutTest, aLogWhoseWriterWasKilledIsCutWithThatLossReported) {
  std::filesystem::remove(in());
  SampleLog{.close = false}.write(in());
  const auto report = rewritten({.inputs = {{in()}}, .from = sampleTime(10)});
  EXPECT_EQ(count(*log(), "red1/models/ball"), 90U);
  EXPECT_THAT(report.losses, ElementsAre(HasSubstr("was not closed")));
}

TEST_F(LogCutTest, bookmarksInTheRangeAreTakenAlongAlsoFromBesideTheLog) {
  const Bookmark inside{1, sampleTime(15), sampleTime(15), "inside"},
      outside{2, sampleTime(5), sampleTime(6), "outside"}, across{3, sampleTime(5), sampleTime(12), "across"};
  ASSERT_TRUE(writeBookmarksBeside(in(), {{1, inside}, {2, outside}, {3, across}}));
  const auto report = rewritten({.inputs = {{in()}}, .from = sampleTime(10), .to = sampleTime(20)});
  EXPECT_EQ(report.bookmarks, 2U);
  const auto bookmarks = Bookmarks::open(out());
  EXPECT_THAT(bookmarks->all(), ElementsAre(Bookmark{3, sampleTime(10), sampleTime(12), "across"}, inside));
}

TEST_F(LogCutTest, filteredStreamsKeepTheEndsOfTheirFrames) {
  rewritten({.inputs = {{in()}}, .streams = {{"*/camera/image"}, {}}});
  EXPECT_THAT(paths(*log()), ElementsAre("red1/camera/image", "red1/frames/cognition"));
  RewriteOptions options{
      .inputs = {{in()}}, .streams = {{"red1/*"}, {"*/camera/*", "*/frames/*"}}, .overwrite = true};
  rewritten(options);
  EXPECT_THAT(paths(*log()),
              ElementsAre("red1/joints/states", "red1/log", "red1/models/ball", "red1/tables/keys"));
}

TEST_F(LogCutTest, robotsOfEqualNamesGetNewOnesAndTheWorldIsThatOfTheFirst) {
  SampleLog{.frames = 20}.write(folder_ / "b.mcap");
  const auto report = rewritten({.inputs = {{in()}, {folder_ / "b.mcap"}}});
  EXPECT_THAT(report.renamed, ElementsAre(std::pair("b.mcap: red1", "red1-2")));
  EXPECT_THAT(report.notes,
              ElementsAre(HasSubstr("scene left out"), HasSubstr("times of in.mcap and b.mcap overlap")));
  const auto file = log();
  EXPECT_THAT(file->robots(), ElementsAre("red1", "red1-2"));
  EXPECT_EQ(count(*file, "red1/models/ball"), 100U);
  EXPECT_EQ(count(*file, "red1-2/models/ball"), 20U);
  EXPECT_EQ(count(*file, "scene"), 1U);
  EXPECT_EQ(latest<foxglove::RawImage>(*file, "red1/camera/image", sampleTime(5)).frame_id(), "red1/camera");
  EXPECT_EQ(latest<foxglove::RawImage>(*file, "red1-2/camera/image", sampleTime(5)).frame_id(),
            "red1-2/camera");
}

TEST_F(LogCutTest, onlyRobotsGetNewNames) {
  for (const char* name : {"one.mcap", "two.mcap"}) {
    tests::ForeignLog foreign(folder_ / name);
    const auto channel =
        foreign.add({"camera/front/info", "their.Pose", "jsonschema", tests::kPoseSchema, "json"});
    foreign.write(channel, 1, "{}");
    foreign.write(channel, 2, "{}");
    ASSERT_TRUE(foreign.close());
  }
  const auto report = rewritten({.inputs = {{folder_ / "one.mcap"}, {folder_ / "two.mcap"}}});
  EXPECT_THAT(report.renamed, IsEmpty());
  EXPECT_EQ(count(*log(), "camera/front/info"), 4U);
}

TEST_F(LogCutTest, twoCutsOfOneLogMakeThatLogAgain) {
  const auto part = [&](const char* name, Instant from, Instant to) {
    const auto cut = rewriteLogs({.inputs = {{in()}}, .from = from, .to = to}, folder_ / name);
    ASSERT_TRUE(cut) << cut.error().describe();
  };
  auto bookmarks = Bookmarks::open(in());
  ASSERT_TRUE(bookmarks);
  bookmarks->add(sampleTime(30), sampleTime(70), "across");
  ASSERT_TRUE(bookmarks->save());
  // Both have what is at the instant of the cut, and the second one what holds there.
  part("first.mcap", Instant(), sampleTime(60));
  part("second.mcap", sampleTime(60), sampleTime(99));
  const auto report = rewritten({.inputs = {{folder_ / "second.mcap"}, {folder_ / "first.mcap"}}});
  EXPECT_TRUE(report.concatenated);
  EXPECT_THAT(report.renamed, IsEmpty());
  EXPECT_THAT(report.notes, IsEmpty());
  EXPECT_EQ(report.frames, 100U);
  EXPECT_EQ(report.bookmarks, 1U);
  const auto original = LogFile::open(in(), {});
  const auto file = log();
  EXPECT_THAT(file->robots(), ElementsAre("red1"));
  for (const auto& stream : (*original)->streams())
    EXPECT_EQ(count(*file, stream.path), stream.count) << stream.path;
  EXPECT_EQ(latest<KeyTable>(*file, "red1/tables/keys", sampleTime(99)).keys(0).name(), "after");
  const auto marks = Bookmarks::open(out());
  ASSERT_TRUE(marks);
  EXPECT_EQ(marks->all().front().from, sampleTime(30));
  EXPECT_EQ(marks->all().front().to, sampleTime(70));
}

TEST_F(LogCutTest, partsStandBesideEachOtherIfThatIsWishedOrTheirTimesOverlap) {
  SampleLog{.frames = 20, .start = 100s}.write(folder_ / "later.mcap");
  const RewriteOptions options{.inputs = {{in()}, {folder_ / "later.mcap"}}, .overwrite = true};
  RewriteOptions separate = options;
  separate.joining = Joining::kSeparate;
  EXPECT_THAT(rewritten(separate).renamed, ElementsAre(std::pair("later.mcap: red1", "red1-2")));
  EXPECT_THAT(rewritten(options).renamed, IsEmpty());
  SampleLog{.frames = 20, .start = 2s}.write(folder_ / "over.mcap");
  const auto beside = rewritten({.inputs = {{in()}, {folder_ / "over.mcap"}}, .overwrite = true});
  EXPECT_THAT(beside.notes, testing::Contains(HasSubstr("the times of in.mcap and over.mcap overlap")));
  const auto refused = rewriteLogs(
      {.inputs = {{in()}, {folder_ / "over.mcap"}}, .joining = Joining::kConcatenate}, folder_ / "none.mcap");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("cannot be joined one after another: the times of"));
}

TEST_F(LogCutTest, robotsWithOtherProgramsAreNoPartsOfOneLog) {
  const auto write = [&](const char* name, double time, const char* layout) {
    auto writer = LogWriter::create(folder_ / name, {});
    ASSERT_TRUE(writer);
    auto setup = std::make_shared<robotcontrol::ProgramSetup>();
    setup->mutable_layout()->set_text(layout);
    ASSERT_TRUE((*writer)->write({{"red1/program", Instant(robotlink::fromSeconds(time)), setup, "debug"}}));
    ASSERT_TRUE((*writer)->container().close());
  };
  write("a.mcap", 1, "compact");
  write("b.mcap", 2, "parallel");
  write("c.mcap", 3, "compact");
  const auto beside = rewritten({.inputs = {{folder_ / "a.mcap"}, {folder_ / "b.mcap"}}, .overwrite = true});
  EXPECT_FALSE(beside.concatenated);
  EXPECT_THAT(beside.notes,
              testing::Contains(HasSubstr("red1 runs a different program in b.mcap than in a.mcap")));
  EXPECT_TRUE(
      rewritten({.inputs = {{folder_ / "a.mcap"}, {folder_ / "c.mcap"}}, .overwrite = true}).concatenated);
}

TEST_F(LogCutTest, aLogIsWrittenAnewWithOtherChunks) {
  rewritten({.inputs = {{in()}}, .compression = mcap::Compression::kLz4, .chunkBytes = 500});
  auto reader = mcap::Reader::open(out(), {});
  EXPECT_GT((*reader)->chunks().size(), 50U);
  EXPECT_EQ((*reader)->chunks().front().compression, mcap::Compression::kLz4);
}

TEST_F(LogCutTest, anOffsetMovesAllTimesOfALog) {
  SampleLog{.robot = "blue1", .frames = 20}.write(folder_ / "b.mcap");
  rewritten({.inputs = {{in()}, {folder_ / "b.mcap", 400ms}}});
  const auto file = log();
  EXPECT_EQ(*file->timeAfter("blue1/models/ball", Instant::min()), sampleTime(10));
  const auto ball = latest<BallModel>(*file, "blue1/models/ball", sampleTime(15));
  EXPECT_EQ(ball.position_in_robot().x(), 5);
  EXPECT_EQ(robotlink::instant(ball.timestamp()), sampleTime(15)) << "also in the messages";
}

TEST_F(LogCutTest, mergedLogsAreInOrderOfTimeInTheFile) {
  SampleLog{.robot = "blue1"}.write(folder_ / "b.mcap");
  rewritten({.inputs = {{in()}, {folder_ / "b.mcap", 20ms}}});
  auto reader = mcap::Reader::open(out(), {});
  Instant before = Instant::min();
  (*reader)->readAll([&](const mcap::Message& message) {
    EXPECT_LE(before, message.logTime);
    before = message.logTime;
    return true;
  });
  EXPECT_EQ(before, sampleTime(99) + 20ms);
}

TEST_F(LogCutTest, anOffsetToBeforeTimeZeroIsRefused) {
  const auto report = rewriteLogs({.inputs = {{in(), -1s}}}, out());
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "log.offset");
}

TEST_F(LogCutTest, attachmentsAndMetadataAreKeptAndTheOriginIsNoted) {
  {
    auto writer = mcap::Writer::append(in(), {});
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->attach({Instant(1s), Instant(1s), "notes.txt", "text/plain", "windy"}));
    ASSERT_TRUE((*writer)->addMetadata({"robotcontrol.recording", {{"dropped_messages", "3"}}}));
  }
  rewritten({.inputs = {{in()}}, .to = sampleTime(20)});
  auto reader = mcap::Reader::open(out(), {});
  EXPECT_EQ((*reader)->attachment("notes.txt")->data, "windy");
  std::map<std::string, std::map<std::string, std::string>> metadata;
  for (const auto& record : (*reader)->metadata()) metadata[record.name] = record.values;
  EXPECT_EQ(metadata["robotcontrol.recording"]["dropped_messages"], "3");
  EXPECT_EQ(metadata["robotcontrol.origin"]["file"], "in.mcap");
  EXPECT_EQ(metadata["robotcontrol.origin"]["to_ns"], "800000000");
}

TEST_F(LogCutTest, messagesOfUnknownTypesAreCopiedAsTheyAre) {
  {
    auto writer = mcap::Writer::create(folder_ / "foreign.mcap", {});
    ASSERT_TRUE(writer);
    const auto schema = (*writer)->addSchema("their.Type", "jsonschema", "{}");
    const auto channel = (*writer)->addChannel("their/topic", *schema, "json", {});
    const std::string data = "{\"x\": 1}";
    ASSERT_TRUE((*writer)->write({*channel,
                                  7,
                                  Instant(1s),
                                  Instant(900ms),
                                  {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()}}));
  }
  rewritten({.inputs = {{folder_ / "foreign.mcap", 1s}}});
  auto reader = mcap::Reader::open(out(), {});
  (*reader)->readAll([&](const mcap::Message& message) {
    EXPECT_EQ(message.logTime, Instant(2s));
    EXPECT_EQ(message.publishTime, Instant(1900ms));
    EXPECT_EQ(message.sequence, 7U);
    EXPECT_EQ(std::string(message.data.begin(), message.data.end()), "{\"x\": 1}");
    return true;
  });
  ASSERT_EQ((*reader)->schemas().size(), 1U) << "and nothing else is in it";
  EXPECT_EQ((*reader)->schemas().begin()->second.encoding, "jsonschema");
}

TEST_F(LogCutTest, nothingIsOverwrittenOrLeftOverUnasked) {
  ASSERT_TRUE(rewriteLogs({.inputs = {{in()}}}, out()));
  const auto again = rewriteLogs({.inputs = {{in()}}}, out());
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().id, "file.exists");
  std::filesystem::remove(out());
  EXPECT_FALSE(rewriteLogs({.inputs = {{in()}}, .from = Instant(100s)}, out()))
      << "nothing lies in this range";
  EXPECT_FALSE(rewriteLogs({.inputs = {{in()}}, .streams = {{"nobody/*"}, {}}}, out()));
  EXPECT_FALSE(rewriteLogs({.inputs = {{in()}}, .from = Instant(2s), .to = Instant(1s)}, out()));
  EXPECT_FALSE(rewriteLogs({.inputs = {{folder_ / "none.mcap"}}}, out()));
  EXPECT_FALSE(rewriteLogs({}, out()));
  EXPECT_EQ(folder_.contents(), "in.mcap");
}

TEST_F(LogCutTest, itIsGivenUpByProgressAndLeavesNothing) {
  double last = -1;
  RewriteOptions options{.inputs = {{in()}}};
  options.progress = [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1);
    last = share;
    return share < 0.5;
  };
  std::filesystem::remove(in());
  SampleLog{.frames = 2000}.write(in());
  const auto report = rewriteLogs(options, out());
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "log.given-up");
  EXPECT_EQ(folder_.contents(), "in.mcap");
}

TEST_F(LogCutTest, aLogCanTakeItsOwnPlace) {
  ASSERT_TRUE(rewriteLogs({.inputs = {{in()}}, .to = sampleTime(9), .overwrite = true}, in()));
  EXPECT_EQ(folder_.contents(), "in.mcap");
  const auto file = LogFile::open(in(), {});
  EXPECT_EQ(count(**file, "red1/models/ball"), 10U);
}

}  // namespace
}  // namespace logplayer
