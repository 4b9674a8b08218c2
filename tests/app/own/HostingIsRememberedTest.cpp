// SPDX-License-Identifier: GPL-3.0-or-later
// Where the programs of all kinds of robots run is remembered in the same way, from one run of the workbench
// to the next.
#include <gtest/gtest.h>

#include "app/core/platform/HostingMemory.h"
#include "app/platforms/pioneer/PioneerOptions.h"
#include "app/platforms/real/RealFeed.h"
#include "app/platforms/replay/ReplayFeed.h"
#include "robotcontrol/Hosting.pb.h"
#include "tests/app/platforms/body/BodyBench.h"
#include "tests/app/platforms/replay/ReplayFixture.h"
#include "tests/app/served/ServedWorld.h"

namespace {

using namespace app;
using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;

OwnProgram::Options ownOptions() {
  return {.executable = OWN_PROGRAM_CHILD, .patience = std::chrono::seconds(5)};
}

/// A platform that is open in one run of the workbench, as PlatformThread opens it.
class RunOfTheWorkbench {
 public:
  RunOfTheWorkbench(const PlatformOpening& opening, const std::filesystem::path& file) : hosting_(file) {
    auto feed = opening.make({session_, recorder_, memory_, {}, {}, &hosting_});
    EXPECT_TRUE(feed) << robotlink::describe(feed.error());
    if (!feed) return;
    feed_ = std::move(*feed);
    session_.restart([this] { feed_->begin(); });
  }
  ~RunOfTheWorkbench() {
    EXPECT_TRUE(hosting_.save());
    if (feed_) feed_->end();
  }

  bool isOwn(const std::string& robot) {
    session_.tick();
    const auto* status =
        session_.store().latestAs<HostingStatus>(robot + "/hosting", robotlink::Instant::max());
    EXPECT_NE(status, nullptr);
    return status != nullptr && status->own_process();
  }
  /// Without a robot, for all.
  void choose(const std::string& robot, HostProgram::Where where) {
    robotcontrol::Request request;
    request.set_robot(robot);
    request.mutable_host_program()->set_where(where);
    const auto done = feed_->fulfill(request);
    EXPECT_TRUE(done) << done.error().text;
  }

 private:
  robotlink::Session session_;
  logplayer::Recorder recorder_{{}};
  std::any memory_;
  HostingMemory hosting_;
  std::unique_ptr<PlatformFeed> feed_;
};

void expectRemembered(const PlatformOpening& opening, const std::string& robot) {
  const TestFolder folder;
  const auto file = folder / "hosting.json";
  {
    RunOfTheWorkbench first(opening, file);
    EXPECT_FALSE(first.isOwn(robot));
    first.choose(robot, HostProgram::OWN_PROCESS);
    EXPECT_TRUE(first.isOwn(robot));
  }
  {
    RunOfTheWorkbench second(opening, file);
    EXPECT_TRUE(second.isOwn(robot));
    second.choose("", HostProgram::IN_WORKBENCH);
    EXPECT_FALSE(second.isOwn(robot));
  }
  EXPECT_FALSE(RunOfTheWorkbench(opening, file).isOwn(robot));
}

TEST(HostingIsRemembered, ofAPioneer) {
  const ServedWorld world;
  RealRobotOptions robot = pioneerOptions(world.url());
  robot.program.own = ownOptions();
  expectRemembered(RealFeed::opening(robot), "p3at1");
}

TEST(HostingIsRemembered, ofABodyElsewhere) {
  const test::OfferedBodies hall("scenes/field2002.sdf");
  BodyOptions body;
  body.url = test::urlOf(hall.port());
  body.patience = std::chrono::seconds(30);
  body.program.own = ownOptions();
  expectRemembered(BodyFeed::opening(body), "red1");
}

TEST(HostingIsRemembered, ofTheRobotsOfALog) {
  const TestFolder folder;
  test::recordSimulation(folder / "hosting.mcap", "compact", 25);
  ReplayOptions options = test::replayOf({{folder / "hosting.mcap"}});
  options.recomputeAll = true;
  options.own = ownOptions();
  expectRemembered(ReplayFeed::opening(options), "red1");
}

}  // namespace
