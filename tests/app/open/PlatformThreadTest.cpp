// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PlatformThread.h"

#include <gmock/gmock.h>

#include <future>
#include <optional>

#include "logplayer/record/Recorder.h"
#include "robotlink/session/Session.h"
#include "tests/Eventually.h"
#include "tests/app/Requests.h"
#include "tests/app/open/FakeFeed.h"

namespace app {
namespace {

using robotcontrol::ControlReplay;
using robotcontrol::Request;
using test::failingOpening;
using test::fakeOpening;
using test::fakePlatform;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Loaded = tl::expected<LoadedPlatform, robotlink::Errors>;

class PlatformThreadTest : public testing::Test {
 protected:
  /// Waits for the result of a function that takes a handler.
  template <typename Begin>
  static Loaded resultOf(Begin begin) {
    const auto promised = std::make_shared<std::promise<Loaded>>();
    auto result = promised->get_future();
    begin([promised](const Loaded& loaded) { promised->set_value(loaded); });
    return result.get();
  }
  Loaded open(PlatformOpening opening) {
    return resultOf([&](auto handler) { thread_->open(std::move(opening), {}, handler); });
  }
  Loaded open(const std::string& title) { return open(fakeOpening(fakePlatform(title), notes_)); }
  Loaded close() {
    return resultOf([&](auto handler) { thread_->close(handler); });
  }
  /// Requests something; the answer is noted by the words of the request.
  void ask(Request request) {
    const std::string words = robotlink::inWords(request);
    session_.request(std::move(request), [this, words](const auto& result) {
      answers_.push_back(words + ": " + (result.accepted() ? "yes" : result.reason()));
    });
  }
  bool answered(std::size_t count) {
    return eventually([&] {
      session_.tick();
      return answers_.size() >= count;
    });
  }
  static Request stop(const std::string& robot, bool engaged = true) {
    Request request;
    request.set_robot(robot);
    request.mutable_stop()->set_engaged(engaged);
    return request;
  }
  static Request frames(int count) {
    Request request;
    request.mutable_control_replay()->set_action(ControlReplay::STEP_FRAME);
    request.mutable_control_replay()->set_count(count);
    return request;
  }
  /// Keeps the thread busy until the returned promise is fulfilled.
  std::promise<void> block() {
    std::promise<void> mayGoOn;
    PlatformOpening opening = failingOpening("", "");
    opening.adapter = "other";
    opening.make = [going = mayGoOn.get_future().share()](const PlatformContext&) {
      going.wait();
      return PlatformOpening::Made(tl::unexpected(robotlink::Errors()));
    };
    thread_->open(std::move(opening), {}, [](const auto&) {});
    return mayGoOn;
  }
  std::vector<std::string> wordsOfRequests() const {
    std::vector<std::string> words;
    for (const Request& request : notes_->requests()) words.push_back(robotlink::inWords(request));
    return words;
  }

  robotlink::Session session_;
  logplayer::Recorder recorder_{logplayer::Recorder::Options{}};
  const std::shared_ptr<test::FeedNotes> notes_ = std::make_shared<test::FeedNotes>();
  std::vector<std::string> answers_;
  std::unique_ptr<PlatformThread> thread_ = [this] {
    auto thread = std::make_unique<PlatformThread>(session_, recorder_);
    session_.setRequestSink([made = thread.get()](const Request& request) { made->request(request); });
    return thread;
  }();
};

TEST_F(PlatformThreadTest, onePlatformEndsBeforeTheNextBegins) {
  PlatformOpening other = fakeOpening(fakePlatform("b"), notes_);
  other.adapter = "another kind";
  ASSERT_TRUE(open("a"));
  const auto loaded = open(std::move(other));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->title, "b");
  EXPECT_THAT(loaded->ended, ElementsAre("a was shut down."));
  EXPECT_THAT(notes_->events(), ElementsAre("a: begin", "a: everything is read", "a: end", "b: begin",
                                            "b: everything is read"));
}

TEST_F(PlatformThreadTest, oneOfTheSameKindMakesWayAndItsPlaybackGoesOn) {
  ASSERT_TRUE(open("a"));
  ASSERT_TRUE(open("b"));
  EXPECT_THAT(notes_->events(), ElementsAre("a: begin", "a: everything is read", "a: makes way", "b: goes on",
                                            "a: end", "b: begin", "b: everything is read"));
}

TEST_F(PlatformThreadTest, whatMadeWayInVainIsRestoredAndItsTroubleReportedToo) {
  ASSERT_TRUE(open("a"));
  const auto failed = open(failingOpening("scene.bad", "the scene is bad"));
  ASSERT_FALSE(failed);
  ASSERT_EQ(failed.error().size(), 2U);
  EXPECT_EQ(failed.error()[0].text, "the scene is bad");
  EXPECT_EQ(failed.error()[1].text, "the port was taken meanwhile");
  EXPECT_EQ(notes_->events().back(), "a: is restored");
  ask(test::keyRequest("red1", "package/models/ball"));
  EXPECT_TRUE(answered(1));
  EXPECT_THAT(answers_, ElementsAre("set key of red1: yes")) << "it still runs";
}

TEST_F(PlatformThreadTest, whatWasChosenComesBackOnlyWithTheSameSources) {
  ProgramOverrides chosen;
  chosen.note(test::selectRequest("red1", "ball-model", "kalman"));
  ASSERT_TRUE(open(fakeOpening(fakePlatform("a"), notes_, {{"red1", chosen}})));
  ASSERT_TRUE(open("b"));
  EXPECT_THAT(notes_->events(), testing::Not(testing::Contains("b gets those of red1")));
  ASSERT_TRUE(close());
  ASSERT_TRUE(open("a"));
  EXPECT_THAT(notes_->events(), testing::Contains("a gets those of red1"));
}

TEST_F(PlatformThreadTest, nothingThatRunsCanDoNothing) {
  ask(test::keyRequest("red1", "package/models/ball"));
  ASSERT_TRUE(answered(1));
  EXPECT_THAT(answers_, ElementsAre(HasSubstr("nothing is running that can do this; open a scene")));
  const auto layout = resultOf([&](auto handler) { thread_->setLayout("walk.yaml", handler); });
  ASSERT_FALSE(layout);
  EXPECT_THAT(robotlink::describe(layout.error()), HasSubstr("nothing is running that uses a layout"));
  const auto log = resultOf([&](auto handler) { thread_->addLog("a.mcap", {}, {}, handler); });
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().front().id, "replay.none");
  const auto closed = close();
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->time, std::nullopt);
  EXPECT_THAT(closed->ended, IsEmpty());
}

TEST_F(PlatformThreadTest, onlyRobotsOfASimulationHaveLayoutsOfTheirOwn) {
  ASSERT_TRUE(open("a"));
  const auto all = resultOf([&](auto handler) { thread_->setLayout("walk.yaml", handler); });
  ASSERT_TRUE(all);
  EXPECT_EQ(all->layout, "walk.yaml");
  const auto one = resultOf([&](auto handler) { thread_->setLayout("run.yaml", handler, "red1"); });
  ASSERT_FALSE(one);
  EXPECT_THAT(one.error().front().text, HasSubstr("without a name, red1 gets the layout of all"));
}

TEST_F(PlatformThreadTest, stepsInALogThatCannotKeepUpAreMadeAsOne) {
  ASSERT_TRUE(open("a"));
  std::promise<void> goOn = block();
  for (const int count : {1, 2, 4}) ask(frames(count));
  goOn.set_value();
  ASSERT_TRUE(answered(3));
  EXPECT_THAT(answers_, testing::Each(HasSubstr(": yes")));
  ASSERT_EQ(notes_->requests().size(), 1U);
  EXPECT_EQ(notes_->requests().front().control_replay().count(), 7);
}

TEST_F(PlatformThreadTest, stepsAreNotJoinedAcrossWhatIsAskedBetweenThem) {
  ASSERT_TRUE(open("a"));
  std::promise<void> goOn = block();
  ask(frames(1));
  ask(test::keyRequest("red1", "package/models/ball"));
  ask(frames(1));
  ask(frames(-1));
  goOn.set_value();
  ASSERT_TRUE(answered(4));
  EXPECT_THAT(wordsOfRequests(), ElementsAre(robotlink::inWords(frames(1)), "set key of red1",
                                             robotlink::inWords(frames(1)), robotlink::inWords(frames(-1))))
      << "nor one back to one forward";
}

TEST_F(PlatformThreadTest, stepsAreNotJoinedAcrossWhatIsDoneBetweenThem) {
  ASSERT_TRUE(open("a"));
  std::promise<void> goOn = block();
  ask(frames(1));
  thread_->connectNow();
  ask(frames(1));
  goOn.set_value();
  ASSERT_TRUE(answered(2));
  EXPECT_EQ(notes_->requests().size(), 2U);
}

TEST_F(PlatformThreadTest, stopGoesBeforeAllThatWaits) {
  ASSERT_TRUE(open("a"));
  std::promise<void> goOn = block();
  ask(test::keyRequest("red1", "package/models/ball"));
  ask(stop("red1"));
  EXPECT_EQ(notes_->events().back(), "switch: stop") << "while the thread is blocked";
  goOn.set_value();
  ASSERT_TRUE(answered(2));
  EXPECT_THAT(wordsOfRequests(), ElementsAre("stop of red1", "set key of red1"));
}

TEST_F(PlatformThreadTest, stopIsReleasedBySayingSoOnly) {
  ASSERT_TRUE(open("a"));
  Request empty = stop("red1");
  empty.mutable_stop()->clear_engaged();
  ask(empty);
  EXPECT_EQ(notes_->events().back(), "switch: stop");
  ask(stop("red1", false));
  EXPECT_EQ(notes_->events().back(), "switch: go");
  EXPECT_TRUE(answered(2));
}

TEST_F(PlatformThreadTest, stopOfARobotThatIsStillToBeOpenedWaitsForIt) {
  std::promise<void> goOn = block();
  ask(stop("red1"));
  thread_->open(fakeOpening(fakePlatform("a"), notes_), {}, [](const auto&) {});
  ask(stop("red1"));
  goOn.set_value();
  ASSERT_TRUE(answered(2));
  EXPECT_THAT(answers_, ElementsAre("stop of red1: yes", "stop of red1: yes"));
}

TEST_F(PlatformThreadTest, whatAProgramLeavesOpenIsRefusedWhenItEnds) {
  notes_->answers = false;
  ASSERT_TRUE(open("a"));
  ask(test::keyRequest("red1", "package/models/ball"));
  ASSERT_TRUE(eventually([&] { return !notes_->requests().empty(); }));
  session_.tick();
  EXPECT_THAT(answers_, IsEmpty());
  ASSERT_TRUE(close());
  ASSERT_TRUE(answered(1));
  EXPECT_THAT(answers_, ElementsAre("set key of red1: the robot's program ended before it answered; repeat "
                                    "the request"));
}

TEST_F(PlatformThreadTest, aSceneIsReadAgainInPlaceOrOpenedOrNeither) {
  const auto reload = [&](test::FeedNotes::Reload way) {
    notes_->reload = way;
    const auto promised = std::make_shared<std::promise<std::pair<std::string, Loaded>>>();
    auto result = promised->get_future();
    thread_->reload(
        {}, false,
        [promised](const Loaded& loaded) {
          promised->set_value({"in place", loaded});
        },
        [promised](const Loaded& loaded) {
          promised->set_value({"opened", loaded});
        });
    const auto [how, loaded] = result.get();
    return how + ": " + (loaded ? loaded->title : robotlink::describe(loaded.error()));
  };
  using Reload = test::FeedNotes::Reload;
  EXPECT_EQ(reload(Reload::kInPlace), "in place: there is no simulation; open a scene first");
  ASSERT_TRUE(open("a"));
  EXPECT_EQ(reload(Reload::kInPlace), "in place: a");
  EXPECT_EQ(reload(Reload::kFails), "in place: the scene is bad");
  EXPECT_EQ(reload(Reload::kOpened), "opened: a again");
}

TEST_F(PlatformThreadTest, whatIsReadHoldsForPlatformsThatAreOpenedLater) {
  PlatformFeed::Demand demand;
  demand.transforms = false;
  thread_->setDemand(demand);
  ASSERT_TRUE(open("a"));
  EXPECT_THAT(notes_->events(), ElementsAre("a: begin", "a: nobody reads transforms"));
  thread_->setDemand({});
  EXPECT_TRUE(eventually([&] { return notes_->events().back() == "a: everything is read"; }));
}

TEST_F(PlatformThreadTest, thePlatformEndsWithItsThread) {
  ASSERT_TRUE(open("a"));
  session_.setRequestSink({});
  thread_.reset();
  EXPECT_EQ(notes_->events().back(), "a: end");
}

}  // namespace
}  // namespace app
