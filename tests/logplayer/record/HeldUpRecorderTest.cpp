// SPDX-License-Identifier: GPL-3.0-or-later
// A recorder whose thread is held up, so that files wait for each other.
#include <gtest/gtest.h>

#include <atomic>

#include "tests/Eventually.h"
#include "tests/logplayer/record/RecorderFixture.h"

using namespace logplayer;
using namespace logplayer::tests;

namespace {

/// A recorder whose thread is held up by its first warning, as by a slow disk.
class HeldUpRecorderTest : public RecorderTest {
 protected:
  void SetUp() override {
    Recorder::Options given = options();
    given.queueBytes = 8000;
    given.warn = [this](const std::string&) {
      if (warned_.exchange(true)) return;
      eventually([this] { return released_.load(); });
    };
    make(std::move(given));
  }
  /// Waits until the thread is held up; one message of the present file was dropped by then.
  void holdUp() {
    recorder->add({image("red1/camera/image", 0, 60'000)});
    ASSERT_TRUE(eventually([this] { return warned_.load(); }));
  }
  void release() { released_ = true; }
  void TearDown() override {
    release();
    recorder.reset();
  }

 private:
  std::atomic<bool> warned_{false}, released_{false};
};

}  // namespace

TEST_F(HeldUpRecorderTest, whatWasDroppedIsCountedForItsOwnFile) {
  start("a.mcap");
  holdUp();
  ASSERT_TRUE(act(ControlRecording::STOP).has_value());
  start("b.mcap");
  release();
  stop();
  EXPECT_EQ(log("a.mcap").recording.at("dropped_messages"), "1");
  EXPECT_EQ(log("b.mcap").recording.at("dropped_messages"), "0");
}

TEST_F(HeldUpRecorderTest, theFileThatWasStartedLastIsTheOneThatIsShown) {
  start("a.mcap");
  addFrame(1);
  holdUp();
  recorder->restart();
  ASSERT_TRUE(act(ControlRecording::STOP).has_value());
  start("b.mcap");
  release();
  addFrame(2);
  recorder->finish();
  EXPECT_EQ(recorder->status().path(), (folder / "b.mcap").string());
  EXPECT_EQ(recorder->status().messages(), 2U);
}
