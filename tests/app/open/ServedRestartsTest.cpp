// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ServedRestarts.h"

#include <gmock/gmock.h>

#include "app/core/PlatformThread.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/session/Session.h"
#include "tests/Eventually.h"
#include "tests/app/open/FakeFeed.h"

namespace app {
namespace {

using robotcontrol::HostingStatus;
using robotcontrol::Request;
using testing::ElementsAre;
using testing::IsEmpty;

/// One robot, red1, in the layout compact.yaml, whose motions were deployed after its program has begun.
class ServedRestartsTest : public testing::Test {
 protected:
  ServedRestartsTest() {
    session_.setRequestSink([this](const Request& request) { asked_.push_back(request); });
    LoadedPlatform loaded = test::fakePlatform("hall");
    loaded.layout = "/layouts/compact.yaml";
    platform_.open(test::fakeOpening(loaded, notes_), {}, [](const auto&) {});
    restarts_.setLoaded(loaded);
    restarts_.programs().noteWritten("motions/sit.mof");
  }
  void ask(const std::string& robot, const std::string& layout = {}) {
    restarts_.ask(robot, layout, [this](const std::string& why) { done_.push_back(why); });
  }
  bool isDone() {
    return eventually([this] {
      restarts_.tick();
      session_.tick();
      return !done_.empty();
    });
  }
  void answer(bool accepted, const std::string& reason = {}) {
    robotcontrol::RequestResult result;
    result.set_id(asked_.back().id());
    result.set_accepted(accepted);
    result.set_reason(reason);
    session_.pushResult(result);
  }
  void publish(HostingStatus::State state, const std::string& text = {}) {
    HostingStatus status;
    status.set_state(state);
    status.set_text(text);
    session_.push({"red1/hosting", robotlink::Instant(std::chrono::seconds(1)),
                   std::make_shared<const HostingStatus>(status)});
    session_.tick();
  }
  std::vector<std::string> waiting() { return restarts_.programs().programs().at(0).waiting; }

  robotlink::Session session_;
  logplayer::Recorder recorder_{logplayer::Recorder::Options{}};
  const std::shared_ptr<test::FeedNotes> notes_ = std::make_shared<test::FeedNotes>();
  std::vector<Request> asked_;
  std::vector<std::string> done_;
  PlatformThread platform_{session_, recorder_};
  ServedRestarts restarts_{session_, platform_};
};

TEST_F(ServedRestartsTest, aRobotThatIsNotThereIsNamed) {
  ask("blue9");
  EXPECT_THAT(done_, IsEmpty()) << "not before the tick";
  restarts_.tick();
  EXPECT_THAT(done_, ElementsAre("there is no robot 'blue9' here"));
  EXPECT_THAT(asked_, IsEmpty());
}

TEST_F(ServedRestartsTest, aProgramThatStartsAgainHasReadWhatWaited) {
  EXPECT_THAT(waiting(), ElementsAre("motions/sit.mof"));
  ask("red1");
  restarts_.tick();
  ASSERT_EQ(asked_.size(), 1U);
  EXPECT_EQ(asked_[0].robot(), "red1");
  EXPECT_TRUE(asked_[0].host_program().start_again());
  EXPECT_THAT(waiting(), ElementsAre("motions/sit.mof")) << "it has not begun yet";
  answer(true);
  ASSERT_TRUE(isDone());
  EXPECT_THAT(done_, ElementsAre(""));
  EXPECT_THAT(waiting(), IsEmpty());
  EXPECT_FALSE(restarts_.takeChanged()) << "the layout is the same";
}

TEST_F(ServedRestartsTest, aProgramThatDoesNotStartHasReadNothing) {
  ask("red1");
  restarts_.tick();
  answer(false, "it is being started already");
  ASSERT_TRUE(isDone());
  EXPECT_THAT(done_, ElementsAre("it is being started already"));
  EXPECT_THAT(waiting(), ElementsAre("motions/sit.mof"));
}

TEST_F(ServedRestartsTest, theLayoutInWhichItRunsIsReadAgainByAStart) {
  ask("red1", "/deployed/compact.yaml");
  restarts_.tick();
  ASSERT_EQ(asked_.size(), 1U);
  EXPECT_TRUE(asked_[0].has_host_program());
}

TEST_F(ServedRestartsTest, inAnotherLayoutAllProgramsStartAgain) {
  ask("red1", "/deployed/walk.yaml");
  ASSERT_TRUE(isDone());
  EXPECT_THAT(done_, ElementsAre(""));
  EXPECT_THAT(asked_, IsEmpty());
  EXPECT_EQ(restarts_.programs().programs().at(0).layout, "walk.yaml");
  EXPECT_THAT(waiting(), IsEmpty());
  EXPECT_TRUE(restarts_.takeChanged());
  EXPECT_FALSE(restarts_.takeChanged()) << "once";
  session_.tick();
  EXPECT_NE(session_.store().find("red1/program"), nullptr) << "who watches is told";
}

TEST_F(ServedRestartsTest, aLayoutThatCannotBeRunChangesNothing) {
  ask("red1", "bad.yaml");
  ASSERT_TRUE(isDone());
  EXPECT_THAT(done_, ElementsAre("the layout is bad"));
  EXPECT_EQ(restarts_.programs().programs().at(0).layout, "compact.yaml");
  EXPECT_THAT(waiting(), ElementsAre("motions/sit.mof"));
  EXPECT_FALSE(restarts_.takeChanged());
}

TEST_F(ServedRestartsTest, aProgramThatBeginsForAnotherReasonHasReadThemToo) {
  publish(HostingStatus::INCOMPLETE);
  publish(HostingStatus::RUNNING, "a process was started again");
  EXPECT_THAT(waiting(), ElementsAre("motions/sit.mof")) << "that is no new program";
  publish(HostingStatus::RUNNING);
  EXPECT_THAT(waiting(), IsEmpty());
}

}  // namespace
}  // namespace app
