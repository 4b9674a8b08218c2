// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/RecordingThread.h"

#include <gmock/gmock.h>

#include <future>

#include "tests/logplayer/RecordedMessages.h"

using namespace logplayer;
using namespace logplayer::tests;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace {

class RecordingThreadTest : public ::testing::Test {
 protected:
  RecordingThread::Options options(std::size_t queueBytes = 64U << 20U) {
    return {queueBytes,
            [this](const robotlink::Error& error, bool newest) {
              failures_.push_back(error.describe() + (newest ? "" : " (of an older file)"));
            },
            [this](const std::string& text) { warnings_.push_back(text); }};
  }
  std::shared_ptr<RecordingFile> file(const std::string& name) const {
    return std::move(*RecordingFile::create(folder_ / name, {}));
  }
  static RecordedFramePtr frame(int i) { return frameOf({plot("red1/plots/x", i, i)}); }
  ReadLog log(const std::string& name) const { return readLog(folder_ / name); }

  TestFolder folder_;
  // Written in the worker thread, read after it has ended or finished.
  std::vector<std::string> failures_, warnings_;
};

TEST_F(RecordingThreadTest, framesGoToTheFileThatWasOpenWhenTheyCame) {
  RecordingThread thread(options());
  thread.push(frame(1));
  thread.open(file("a.mcap"), {table("red1/tables/keys", 0, "held")});
  thread.push(frame(2));
  thread.push(frame(3));
  thread.close();
  thread.push(frame(4));
  thread.open(file("b.mcap"), {});
  thread.push(frame(5));
  thread.close();
  thread.finish();
  EXPECT_THAT(log("a.mcap").paths(), ElementsAre("red1/tables/keys", "red1/plots/x", "red1/plots/x"));
  EXPECT_EQ(log("a.mcap").entries[0].time, at(2)) << "what holds gets the time of the first frame";
  EXPECT_THAT(log("b.mcap").paths(), ElementsAre("red1/plots/x"));
  EXPECT_EQ(log("b.mcap").entries[0].time, at(5));
  EXPECT_TRUE(log("b.mcap").complete);
}

TEST_F(RecordingThreadTest, progressIsThatOfTheNewestFile) {
  RecordingThread thread(options());
  thread.open(file("a.mcap"), {});
  thread.push(frame(1));
  thread.push(frame(2));
  thread.finish();
  EXPECT_EQ(thread.progress().path, folder_ / "a.mcap");
  EXPECT_EQ(thread.progress().messages, 2U);
  EXPECT_EQ(thread.progress().queuedBytes, 0U);
  thread.close();
  thread.finish();
  EXPECT_EQ(thread.progress().bytes, std::filesystem::file_size(folder_ / "a.mcap"));
  thread.open(file("b.mcap"), {});
  EXPECT_EQ(thread.progress().path, folder_ / "b.mcap");
  EXPECT_EQ(thread.progress().messages, 0U);
}

TEST_F(RecordingThreadTest, aRecordingContinuesInAFileThatIsNamedAfterItsFirst) {
  RecordingThread thread(options());
  thread.open(file("game.mcap"), {});
  thread.openNext({}, {});  // nothing is in the first one yet
  thread.push(frame(1));
  thread.openNext({}, {table("red1/tables/keys", 0, "held")});
  thread.push(frame(2));
  thread.openNext({}, {});
  thread.push(frame(3));
  thread.close();
  thread.finish();
  EXPECT_EQ(folder_.contents(), "game-2.mcap game-3.mcap game.mcap");
  EXPECT_THAT(log("game-2.mcap").paths(), ElementsAre("red1/tables/keys", "red1/plots/x"));
  EXPECT_EQ(thread.progress().path, folder_ / "game-3.mcap");
  EXPECT_THAT(failures_, IsEmpty());
}

TEST_F(RecordingThreadTest, aContinuationThatCannotBeMadeEndsTheRecording) {
  RecordingThread thread(options());
  std::filesystem::create_directory(folder_ / "gone");
  thread.open(file("gone/a.mcap"), {});
  thread.push(frame(1));
  thread.finish();
  std::filesystem::remove_all(folder_ / "gone");
  thread.openNext({}, {});
  thread.push(frame(2));
  thread.openNext({}, {});
  thread.finish();
  EXPECT_THAT(failures_, ElementsAre(HasSubstr("a-2.mcap")));
}

TEST_F(RecordingThreadTest, whatTheQueueDropsIsCountedByFileAndWarnedOf) {
  std::promise<void> started, go;
  RecordingThread::Options slow = options(10'000);
  slow.failed = [&](const robotlink::Error&, bool) {
    started.set_value();
    go.get_future().wait();
  };
  RecordingThread thread(std::move(slow));
  std::filesystem::create_directory(folder_ / "gone");
  thread.open(file("gone/x.mcap"), {});
  thread.push(frame(0));
  thread.finish();
  std::filesystem::remove_all(folder_ / "gone");
  thread.openNext({}, {});  // fails, which holds the thread up
  started.get_future().wait();
  thread.open(file("a.mcap"), {});
  for (int i = 0; i < 4; ++i) thread.push(frameOf({image("red1/camera/image", i, 4000)}));
  EXPECT_EQ(thread.progress().dropped.messages, 2U);
  EXPECT_LE(thread.progress().queuedBytes, 10'000U);
  thread.close();
  go.set_value();
  thread.finish();
  EXPECT_EQ(log("a.mcap").count("red1/camera/image"), 2U);
  EXPECT_EQ(log("a.mcap").recording.at("dropped_messages"), "2");
  ASSERT_FALSE(warnings_.empty());
  EXPECT_THAT(warnings_.back(), HasSubstr("2 messages were dropped"));
  thread.open(file("b.mcap"), {});
  EXPECT_EQ(thread.progress().dropped.messages, 0U) << "they belong to the file before";
}

TEST_F(RecordingThreadTest, itsEndWaitsForAllThatWasPushed) {
  {
    RecordingThread thread(options());
    thread.open(file("a.mcap"), {});
    for (int i = 0; i < 500; ++i) thread.push(frame(i));
    thread.waitForRoom();
    thread.close();
  }
  EXPECT_EQ(log("a.mcap").count("red1/plots/x"), 500U);
  EXPECT_TRUE(log("a.mcap").complete);
}

}  // namespace
