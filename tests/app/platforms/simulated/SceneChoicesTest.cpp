// SPDX-License-Identifier: GPL-3.0-or-later
// What users choose for the programs of a scene belongs to it.
#include <gtest/gtest.h>

#include "app/core/platform/HostingMemory.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/RobotTables.h"
#include "tests/TestFolder.h"

namespace {

using namespace app;

constexpr char kPlace[] = "self-localisation";

/// Scenes that are open one after the other in one run of the workbench, as PlatformThread opens them.
class OpenedScenes {
 public:
  explicit OpenedScenes(const std::filesystem::path& file) : hosting_(file) {}
  ~OpenedScenes() {
    EXPECT_TRUE(hosting_.save());
    if (feed_) feed_->end();
  }

  void open(const std::filesystem::path& scene, std::function<void(RunOptions&)> adapt = {}) {
    auto feed = SimulationFeed::opening(scene, [&](RunOptions& options) {
                  options.own = {};
                  if (adapt) adapt(options);
                }).make({session_, recorder_, memory_, {}, {}, &hosting_});
    ASSERT_TRUE(feed) << robotlink::describe(feed.error());
    if (feed_) feed_->end();
    feed_ = std::move(*feed);
    session_.restart([this] { feed_->begin(); });
    for (int i = 0; i < 20; ++i) feed_->step();
    session_.tick();
  }
  void choose(const std::string& robot, const std::string& solution) {
    robotcontrol::Request request;
    request.set_id(++asked_);
    request.set_robot(robot);
    request.mutable_select_solution()->set_task(kPlace);
    request.mutable_select_solution()->set_solution(solution);
    const auto done = feed_->fulfill(request);
    EXPECT_TRUE(done) << done.error().text;
    for (int i = 0; i < 20; ++i) feed_->step();
    session_.tick();
  }
  std::string solutionOf(const std::string& robot) {
    return robotlink::activeSolution(session_.store(), robot, kPlace);
  }
  std::string layoutOf(const std::string& robot) { return feed_->describe().layoutOf(robot).stem().string(); }
  PlatformFeed& feed() { return *feed_; }

 private:
  robotlink::Session session_;
  logplayer::Recorder recorder_{{}};
  std::any memory_;
  HostingMemory hosting_;
  std::unique_ptr<PlatformFeed> feed_;
  std::uint64_t asked_ = 0;
};

class SceneChoicesTest : public testing::Test {
 protected:
  const TestFolder folder;
  const std::filesystem::path kept = folder / "hosting.json", game = sceneNamed("game2002-1"),
                              field = sceneNamed("field2002");
};

TEST_F(SceneChoicesTest, solutionsThatWereChosenInTheGameAreKeptWithIt) {
  {
    OpenedScenes first(kept);
    first.open(game);
    EXPECT_EQ(first.solutionOf("red1"), "field-monte-carlo");
    first.choose("red1", "kalman");
    EXPECT_EQ(first.solutionOf("red1"), "kalman");
    first.open(game);
    EXPECT_EQ(first.solutionOf("red1"), "kalman") << "also without leaving the workbench";
    EXPECT_EQ(first.solutionOf("blue1"), "field-monte-carlo");
  }
  {
    OpenedScenes second(kept);
    second.open(field);
    EXPECT_NE(second.solutionOf("red1"), "kalman") << "that was another scene";
    second.open(game);
    EXPECT_EQ(second.solutionOf("red1"), "kalman");
    EXPECT_EQ(second.solutionOf("blue1"), "field-monte-carlo");
  }
  OpenedScenes third(kept);
  third.open(game, [](RunOptions& options) {
    EXPECT_TRUE(chooseSolutions({std::string("red/") + kPlace + "=odometry"}, options));
  });
  EXPECT_EQ(third.solutionOf("red1"), "odometry") << "what is asked for now goes first";
  third.choose("red1", "field-monte-carlo");
  third.open(game);
  EXPECT_EQ(third.solutionOf("red1"), "field-monte-carlo");
}

TEST_F(SceneChoicesTest, whatARobotChoseGoesBeforeWhatAllWereGivenAtTheStart) {
  OpenedScenes scenes(kept);
  scenes.open(game, [](RunOptions& options) {
    EXPECT_TRUE(chooseSolutions({std::string(kPlace) + "=odometry"}, options));
  });
  scenes.choose("red1", "kalman");
  scenes.open(game);
  EXPECT_EQ(scenes.solutionOf("red1"), "kalman");
  EXPECT_EQ(scenes.solutionOf("blue1"), "odometry");
}

TEST_F(SceneChoicesTest, layoutsThatWereChosenInOneSceneAreNotThoseOfAnother) {
  {
    OpenedScenes first(kept);
    first.open(game);
    EXPECT_EQ(first.layoutOf("red1"), "soccer");
    EXPECT_TRUE(first.feed().setLayout(layoutNamed("balanced")).empty());
    EXPECT_EQ(first.layoutOf("red1"), "balanced");
    first.open(sceneNamed("game2002-2"));
    EXPECT_EQ(first.layoutOf("red1"), "soccer") << "which the scene names";
    first.open(game);
    EXPECT_EQ(first.layoutOf("red1"), "balanced");
  }
  OpenedScenes second(kept);
  second.open(game);
  EXPECT_EQ(second.layoutOf("red1"), "balanced");
}

TEST_F(SceneChoicesTest, theLayoutOfARobotThatIsCalledLikeItsKindIsNotThatOfTheKind) {
  const auto burger = [](const std::string& name, const std::string& y) {
    return "<include><uri>model://burger</uri><name>" + name + "</name><pose>0 " + y +
           " 0.01 0 0 0</pose></include>";
  };
  const auto two = folder.write(
      "two.sdf", "<sdf version='1.9'><world name='w'><include><uri>model://ground_plane</uri></include>" +
                     burger("burger", "0") + burger("other", "2") + "</world></sdf>");
  std::string usual;
  {
    OpenedScenes first(kept);
    first.open(two);
    usual = first.layoutOf("other");
    ASSERT_NE(usual, "pioneer-wander");
    EXPECT_TRUE(first.feed().setLayoutOf("burger", layoutNamed("pioneer-wander")).empty());
    EXPECT_EQ(first.layoutOf("burger"), "pioneer-wander");
    EXPECT_EQ(first.layoutOf("other"), usual);
  }
  OpenedScenes second(kept);
  second.open(two);
  EXPECT_EQ(second.layoutOf("burger"), "pioneer-wander");
  EXPECT_EQ(second.layoutOf("other"), usual);
}

}  // namespace
