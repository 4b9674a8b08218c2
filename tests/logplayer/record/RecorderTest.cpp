// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/Recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "logplayer/images/ImageCoding.h"
#include "tests/Eventually.h"
#include "tests/logplayer/record/RecorderFixture.h"

using namespace logplayer;
using namespace logplayer::tests;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

TEST_F(RecorderTest, whatComesBetweenStartAndStopIsInTheFile) {
  addFrame(1);
  start();
  EXPECT_TRUE(recorder->status().recording());
  for (int i = 2; i <= 100; ++i) addFrame(i);
  stop();
  addFrame(101);
  const ReadLog read = log();
  EXPECT_TRUE(read.complete);
  EXPECT_EQ(read.count("red1/plots/x"), 99U);
  EXPECT_EQ(read.entries.front().time, at(16));
  EXPECT_EQ(read.entries.front().frame, 2U);
  EXPECT_EQ(read.recording.at("dropped_messages"), "0");
  EXPECT_EQ(read.recording.at("software"), "robotcontrol");
  EXPECT_THAT(read.recording.at("started"), MatchesRegex("....-..-..T..:..:..Z"));
  const auto status = recorder->status();
  EXPECT_FALSE(status.recording());
  EXPECT_EQ(status.messages(), 198U);
  EXPECT_EQ(status.bytes(), std::filesystem::file_size(folder / "a.mcap"));
  EXPECT_EQ(status.queued_bytes(), 0U);
  EXPECT_EQ(status.failure(), "");
}

TEST_F(RecorderTest, aFileBeginsWithWhatHoldsAtTheTimeOfItsFirstFrame) {
  recorder->add({table("red1/tables/keys", 1, "old"), frameInfo(1, 1, "debug")});
  recorder->add({table("red1/tables/keys", 2, "new"), frameInfo(2, 2, "debug")});
  start();
  addFrame(500);
  stop();
  const ReadLog read = log();
  ASSERT_EQ(read.entries.size(), 3U);
  EXPECT_EQ(read.entries[0].path, "red1/tables/keys");
  EXPECT_EQ(read.entries[0].time, at(4000));
  EXPECT_EQ(read.entries[0].frame, 0U);
  EXPECT_THAT(read.entries[0].data, HasSubstr("new"));
}

TEST_F(RecorderTest, aRobotWhoseProgramStartsAnewHoldsNothingFromBefore) {
  recorder->add({table("red1/tables/keys", 1, "old")});
  recorder->add({table("blue1/tables/keys", 1, "other")});
  recorder->forget("red1");
  start();
  addFrame(1);
  stop();
  EXPECT_THAT(log().paths(), ElementsAre("blue1/tables/keys", "red1/plots/x", "red1/frames/cognition"));
}

TEST_F(RecorderTest, aChoiceKeepsFramesWithTheirEndAndWhatHolds) {
  choose("*/plots/x");
  start();
  recorder->add({plot("red1/plots/x", 8, 1), plot("red1/plots/y", 8, 1), frameInfo(8, 1)});
  recorder->add({plot("red1/plots/y", 16, 1), frameInfo(16, 2)});
  recorder->add({table("red1/tables/keys", 16, "k"), frameInfo(16, 1, "debug")});
  stop();
  EXPECT_THAT(log().paths(),
              ElementsAre("red1/plots/x", "red1/frames/cognition", "red1/tables/keys", "red1/frames/debug"));
}

TEST_F(RecorderTest, whatIsLeftOutIsNotKeptInMemoryByTheRest) {
  choose("*/plots/x");
  keep(10);
  struct Queue {
    robotcontrol::PlotValue plotted;
    foxglove::RawImage picture;
  };
  auto queue = std::make_shared<Queue>();
  queue->picture.set_data(std::string(1'000'000, 'x'));
  const std::weak_ptr<Queue> watched = queue;
  recorder->add({{"red1/plots/x", at(1), robotlink::PackagePtr(queue, &queue->plotted)},
                 {"red1/images/y", at(1), robotlink::PackagePtr(queue, &queue->picture)}});
  queue.reset();
  EXPECT_TRUE(watched.expired());
  EXPECT_GT(recorder->status().kept_bytes(), 0U);
}

TEST_F(RecorderTest, wantsWhatIsChosenOnlyWhileItIsRecordedOrKept) {
  EXPECT_FALSE(recorder->active());
  EXPECT_FALSE(recorder->wants("red1/models/ball"));
  auto demand = recorder->demand();
  keep(5);
  EXPECT_NE(recorder->demand(), demand);
  EXPECT_TRUE(recorder->wants("red1/models/ball"));
  choose("red1/camera/*");
  EXPECT_FALSE(recorder->wants("red1/models/ball"));
  set([](ControlRecording& control) { control.set_trigger("*/models/ball"); });
  EXPECT_TRUE(recorder->wants("red1/models/ball"));
  demand = recorder->demand();
  keep(0);
  EXPECT_NE(recorder->demand(), demand);
  EXPECT_FALSE(recorder->active());
}

TEST_F(RecorderTest, whatIsNotSetStaysAsItWas) {
  set([](ControlRecording& control) {
    control.set_image_coding(ControlRecording::JPEG);
    control.set_compression(ControlRecording::ZSTD);
    control.set_keep_last(3);
    control.set_trigger("*/lost");
    control.mutable_selection()->add_include("red1/*");
  });
  set([](ControlRecording&) {});
  const auto status = recorder->status();
  EXPECT_EQ(status.image_coding(), ControlRecording::JPEG);
  EXPECT_EQ(status.compression(), ControlRecording::ZSTD);
  EXPECT_EQ(status.keep_last(), 3);
  EXPECT_EQ(status.trigger(), "*/lost");
  EXPECT_EQ(status.selection().include_size(), 1);
}

TEST_F(RecorderTest, imagesAreCodedAndCompressedAsWished) {
  set([](ControlRecording& control) {
    control.set_image_coding(ControlRecording::PNG);
    control.set_compression(ControlRecording::LZ4);
  });
  start();
  recorder->add({image("red1/camera/image", 8, 30'000), frameInfo(8, 1, "platform")});
  stop();
  const ReadLog read = log();
  EXPECT_EQ(read.entries[0].type, "foxglove.CompressedImage");
  EXPECT_EQ(read.entries[0].path, "red1/camera/image");
  foxglove::CompressedImage coded;
  ASSERT_TRUE(coded.ParseFromString(read.entries[0].data));
  EXPECT_EQ(coded.format(), "png");
  EXPECT_EQ((*mcap::Reader::open(folder / "a.mcap", {}))->chunks()[0].compression, mcap::Compression::kLz4);
}

TEST_F(RecorderTest, imagesOfOneChannelAreNeverCodedWithLosses) {
  set([](ControlRecording& control) { control.set_image_coding(ControlRecording::JPEG); });
  start();
  const StreamMessage classes = image("red1/oracle/classes", 8, 30'000);
  recorder->add({classes, frameInfo(8, 1, "platform")});
  stop();
  foxglove::CompressedImage coded;
  ASSERT_TRUE(coded.ParseFromString(log().entries[0].data));
  EXPECT_EQ(coded.format(), "png");
  EXPECT_EQ((*logplayer::rawImage(coded))->data(),
            static_cast<const foxglove::RawImage&>(*classes.value).data());
}

// ---- The last seconds

TEST_F(RecorderTest, theLastSecondsAreSavedWithWhatHeldBefore) {
  keep(1);
  recorder->add({table("red1/tables/keys", 0, "first"), frameInfo(0, 1, "debug")});
  for (int i = 1; i <= 500; ++i) addFrame(i);
  EXPECT_NEAR(recorder->status().kept_seconds(), 1, 0.009);
  ASSERT_TRUE(act(ControlRecording::SAVE_LAST, folder / "last.mcap").has_value());
  recorder->finish();
  EXPECT_EQ(recorder->status().saved_path(), (folder / "last.mcap").string());
  const ReadLog read = log("last.mcap");
  EXPECT_TRUE(read.complete);
  EXPECT_EQ(read.entries.front().path, "red1/tables/keys");
  EXPECT_EQ(read.entries.front().time, at(3000));
  EXPECT_EQ(read.count("red1/plots/x"), 126U);
}

TEST_F(RecorderTest, theLastSecondsCanBeSavedWhileARecordingGoesOn) {
  keep(1);
  start();
  for (int i = 1; i <= 200; ++i) addFrame(i);
  ASSERT_TRUE(act(ControlRecording::SAVE_LAST, folder / "last.mcap").has_value());
  for (int i = 201; i <= 300; ++i) addFrame(i);
  stop();
  EXPECT_EQ(log("last.mcap").count("red1/plots/x"), 126U);
  EXPECT_EQ(log().count("red1/plots/x"), 300U);
}

TEST_F(RecorderTest, aTriggerSavesOnceUntilAllIsNew) {
  keep(1);
  set([](ControlRecording& control) { control.set_trigger("red1/plots/*/lost"); });
  for (int i = 1; i <= 400; ++i) {
    addFrame(i);
    if (i < 150 || i > 310) continue;  // 1.2 s to 2.48 s
    recorder->add(
        {plot("red1/plots/ball/lost", 8 * i, 1), frameInfo(8 * i, static_cast<std::uint64_t>(i), "motion")});
    if (i == 150 || i == 275) recorder->finish();
  }
  recorder->finish();
  std::vector<Instant> ends;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "documents")) {
    const ReadLog read = readLog(entry.path());
    EXPECT_TRUE(read.complete);
    EXPECT_LE(read.count("red1/plots/x"), 127U);
    ends.push_back(read.entries.back().time);
  }
  std::sort(ends.begin(), ends.end());
  EXPECT_THAT(ends, ElementsAre(at(1200), at(2200)));
}

TEST_F(RecorderTest, savingNothingIsRefused) {
  const auto none = act(ControlRecording::SAVE_LAST);
  ASSERT_FALSE(none.has_value());
  EXPECT_THAT(none.error().text, HasSubstr("nothing is kept in memory"));
  keep(1);
  EXPECT_FALSE(act(ControlRecording::SAVE_LAST).has_value());
  ControlRecording tooLong;
  tooLong.set_keep_last(1e9);
  EXPECT_FALSE(recorder->control(tooLong).has_value());
}

// ---- Files

TEST_F(RecorderTest, whatComesFromALogIsRecordedButNotKept) {
  keep(10);
  addFrame(1);
  set([](ControlRecording& control) { control.set_trigger("red1/plots/*"); });
  const std::uint64_t demand = recorder->demand();
  recorder->setLive(false);
  EXPECT_NE(recorder->demand(), demand);
  EXPECT_FALSE(recorder->active());
  EXPECT_FALSE(recorder->wants("red1/plots/x"));
  EXPECT_EQ(recorder->status().kept_bytes(), 0U);
  start();
  for (int i = 2; i <= 20; ++i) addFrame(i);
  EXPECT_EQ(recorder->status().kept_bytes(), 0U);
  stop();
  EXPECT_EQ(log().count("red1/plots/x"), 19U);
  const auto saved = act(ControlRecording::SAVE_LAST, folder / "b.mcap");
  ASSERT_FALSE(saved.has_value());
  EXPECT_THAT(saved.error().text, HasSubstr("cut a range out of it"));
  recorder->setLive(true);
  EXPECT_TRUE(recorder->active());
  addFrame(21);
  EXPECT_GT(recorder->status().kept_bytes(), 0U);
  EXPECT_EQ(recorder->status().keep_last(), 10);
}

TEST_F(RecorderTest, aFileWithoutANameIsNamedAfterTheTime) {
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(act(ControlRecording::START).has_value());
    stop();
  }
  ASSERT_TRUE(act(ControlRecording::START, folder.path()).has_value());
  EXPECT_THAT(recorder->status().path(),
              MatchesRegex(folder.path().string() + "/robotcontrol-[0-9]{8}-[0-9]{6}.mcap"));
  stop();
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "documents")) {
    EXPECT_THAT(entry.path().filename().string(), MatchesRegex("robotcontrol-[0-9]{8}-[0-9]{6}(-2)?.mcap"));
    ++files;
  }
  EXPECT_EQ(files, 2);
}

TEST_F(RecorderTest, whatCannotBeStartedOrStoppedIsRefusedWithTheReason) {
  EXPECT_THAT(act(ControlRecording::STOP).error().text, HasSubstr("nothing is being recorded"));
  start();
  EXPECT_THAT(act(ControlRecording::START, folder / "b.mcap").error().text, HasSubstr("a.mcap"));
  stop();
  EXPECT_FALSE(act(ControlRecording::START, folder / "a.mcap").has_value());
  EXPECT_FALSE(act(ControlRecording::START, folder / "no/such/folder/a.mcap").has_value());
  EXPECT_FALSE(recorder->status().recording());
  EXPECT_THAT(folder.files(), ElementsAre("a.mcap"));
}

TEST_F(RecorderTest, theFileIsClosedWithTheRecorder) {
  start();
  addFrame(1);
  recorder.reset();
  EXPECT_TRUE(log().complete);
}

TEST_F(RecorderTest, aPlatformThatIsSetBackGetsANewFile) {
  recorder->add({table("red1/tables/keys", 0, "kept")});
  start();
  for (int i = 1; i <= 10; ++i) addFrame(i);
  for (int i = 1; i <= 5; ++i) addFrame(i);
  recorder->restart();
  recorder->restart();  // nothing came in between: no file for that
  for (int i = 1; i <= 3; ++i) addFrame(i);
  EXPECT_TRUE(recorder->status().recording());
  stop();
  EXPECT_THAT(folder.files(), ElementsAre("a-2.mcap", "a-3.mcap", "a.mcap"));
  EXPECT_EQ(log().count("red1/plots/x"), 10U);
  EXPECT_EQ(log("a-2.mcap").count("red1/plots/x"), 5U);
  EXPECT_EQ(log("a-2.mcap").count("red1/tables/keys"), 1U);
  EXPECT_EQ(log("a-3.mcap").count("red1/plots/x"), 3U);
  EXPECT_EQ(log("a-3.mcap").count("red1/tables/keys"), 0U);
  for (const char* name : {"a.mcap", "a-2.mcap", "a-3.mcap"}) EXPECT_TRUE(log(name).complete) << name;
  EXPECT_EQ(recorder->status().path(), (folder / "a-3.mcap").string());
}

// ---- Trouble

TEST_F(RecorderTest, whatDoesNotFitIsLeftOutWholeCountedAndSaid) {
  Recorder::Options small = options();
  small.queueBytes = 50'000;
  make(small);
  start();
  for (int i = 1; i <= 20; ++i) {
    addFrame(i);
    recorder->add({image("red1/camera/image", 8 * i, 60'000),
                   frameInfo(8 * i, static_cast<std::uint64_t>(i), "platform")});
    recorder->waitForRoom();
  }
  EXPECT_EQ(recorder->status().dropped_messages(), 40U);
  EXPECT_GT(recorder->status().dropped_bytes(), 20U * 60'000U);
  stop();
  const ReadLog read = log();
  EXPECT_EQ(read.count("red1/plots/x"), 20U);
  EXPECT_EQ(read.count("red1/frames/platform"), 0U);
  EXPECT_EQ(read.recording.at("dropped_messages"), "40");
  recorder.reset();
  ASSERT_FALSE(warnings().empty());
  EXPECT_THAT(warnings()[0], HasSubstr("messages were dropped"));
}

TEST_F(RecorderTest, aFullDiskEndsTheRecordingAndLeavesAReadableFile) {
  // A limit of this process's files stands for the disk.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = before;
  limit.rlim_cur = 3'000'000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  start();
  const auto demand = recorder->demand();
  for (int i = 1; i <= 100; ++i) {
    recorder->add({image("red1/camera/image", 8 * i, 100'000),
                   frameInfo(8 * i, static_cast<std::uint64_t>(i), "platform")});
    recorder->waitForRoom();
  }
  recorder->finish();
  EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  const auto status = recorder->status();
  EXPECT_FALSE(status.recording());
  EXPECT_FALSE(recorder->active());
  EXPECT_NE(recorder->demand(), demand);
  EXPECT_THAT(status.failure(), HasSubstr("a.mcap"));
  EXPECT_THAT(status.failure(), HasSubstr("can be read"));
  EXPECT_THAT(warnings(), ElementsAre(status.failure()));
  const ReadLog read = log();
  EXPECT_EQ(read.error, "");
  EXPECT_GT(read.count("red1/camera/image"), 10U);
  EXPECT_EQ(read.count("red1/camera/image"), read.count("red1/frames/platform"));
  start("b.mcap");  // and another one can be begun
  addFrame(1);
  stop();
  EXPECT_TRUE(log("b.mcap").complete);
}

TEST_F(RecorderTest, whatIsWrittenIsOnItsWayToTheDiskAfterHalfASecond) {
  start();
  addFrame(1);
  EXPECT_TRUE(eventually([this] { return log().count("red1/plots/x") == 1; }))
      << "though nothing came after it";
  EXPECT_TRUE(recorder->status().recording());
}

TEST_F(RecorderTest, manyThreadsMayAddAndControl) {
  keep(0.2);
  std::atomic<bool> quit{false};
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) {
    threads.emplace_back([&, t] {
      const std::string process = "process" + std::to_string(t);
      for (int i = 1; !quit; ++i) {
        const auto number = static_cast<std::uint64_t>(i);
        recorder->add({plot("red1/plots/x", i, i, process, number), frameInfo(i, number, process)});
        recorder->wants("red1/plots/x");
        if (i % 50 == 0) std::this_thread::yield();
      }
    });
  }
  for (int i = 0; i < 5; ++i) {
    start("many" + std::to_string(i) + ".mcap");
    (void)act(ControlRecording::SAVE_LAST, folder.path());
    (void)recorder->status();
    ASSERT_TRUE(eventually([this] { return recorder->status().messages() > 0; }));
    ASSERT_TRUE(act(ControlRecording::STOP).has_value());
  }
  quit = true;
  for (std::thread& thread : threads) thread.join();
  recorder->finish();
  for (int i = 0; i < 5; ++i) {
    const ReadLog read = log("many" + std::to_string(i) + ".mcap");
    EXPECT_TRUE(read.complete);
    EXPECT_EQ(read.count("red1/plots/x") * 2, read.entries.size());
  }
}
