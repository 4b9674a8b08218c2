// SPDX-License-Identifier: GPL-3.0-or-later
// The workbench goes on in a scene whose file was edited.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/core/Workbench.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/debugging/Streams.h"
#include "tests/TestFolder.h"
#include "tests/app/TickUntil.h"

using namespace app;
using robotcontrol::SimulationStatus;

namespace {

class SceneReloadTest : public testing::Test {
 protected:
  SceneReloadTest()
      : text(robotlink::readFile(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/pioneer.sdf").value()),
        file(folder.write("room.sdf", text)),
        workbench(folder.path() / "user") {
    workbench.onErrors([this](const robotlink::Errors& e) { errors = e; });
    workbench.onLoaded([this](const LoadedPlatform&) { ++loads; });
    RunOptions options = defaultSimulation();
    options.scene = file;
    workbench.open(SimulationFeed::opening(options));
    EXPECT_TRUE(waitFor([this] { return loads == 1 && status() != nullptr; }));
  }
  template <typename Condition>
  bool waitFor(Condition condition) {
    return app::test::tickUntil(workbench, condition);
  }
  const SimulationStatus* status() {
    return workbench.session().store().latestAs<SimulationStatus>("simulation",
                                                                  workbench.session().timeline().newest());
  }
  void run(const char* line) {
    const auto done = workbench.commands().runLine(line);
    EXPECT_TRUE(done.has_value()) << line << ": " << (done ? "" : done.error().describe());
  }
  void edit(const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    folder.write("room.sdf", text);
  }
  bool hasModel(const std::string& name) {
    const auto* all = workbench.session().store().latestAs<robotcontrol::WorldObjects>(
        robotlink::streams::kObjects, workbench.session().timeline().newest());
    return all != nullptr &&
           std::ranges::find(all->objects(), name, &robotcontrol::WorldObject::path) != all->objects().end();
  }

  TestFolder folder;
  std::string text;
  std::filesystem::path file;
  int loads = 0;
  robotlink::Errors errors;
  Workbench workbench;
};

const char* const kCan =
    "<model name='can'><pose>2 -2 0.2 0 0 0</pose><link name='can'><inertial><mass>0.4</mass></inertial>"
    "<collision name='c'><geometry><cylinder><radius>0.1</radius><length>0.3</length></cylinder></geometry>"
    "</collision></link></model></world>";

}  // namespace

TEST_F(SceneReloadTest, aTextThatIsNotSavedCountsUntilTheFileIsReadAgain) {
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 2; }));
  std::string edited = text;
  edited.replace(edited.find("</world>"), 8, kCan);
  const FileTexts texts{{std::filesystem::weakly_canonical(file), edited}};
  workbench.reloadScene(texts);
  ASSERT_TRUE(waitFor([this] { return loads == 2; }));
  EXPECT_TRUE(hasModel("can"));
  EXPECT_EQ(status()->steps(), 2U);
  EXPECT_EQ(robotlink::readFile(file).value_or(""), text);
  // One that is wrong changes nothing.
  workbench.reloadScene({{std::filesystem::weakly_canonical(file), "<sdf"}});
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_EQ(errors.front().where.file, file.string());
  EXPECT_TRUE(hasModel("can"));
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return !hasModel("can"); }));
}

TEST_F(SceneReloadTest, whatIsThereAgainStandsWhereItWas) {
  edit("</world>", kCan);
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return loads == 2 && hasModel("can"); }));
  run("scene.place can 2.5 -2.5");
  const auto place = [this] {
    const auto* all = workbench.session().store().latestAs<foxglove::FrameTransforms>(
        robotlink::streams::kTransforms, workbench.session().timeline().newest());
    for (const auto& one : all->transforms())
      if (one.child_frame_id() == "body:can/can") return one.translation().x();
    return 0.0;
  };
  ASSERT_TRUE(waitFor([&] { return place() > 2.4; }));
  const std::string with = text;
  edit(kCan, "</world>");
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return loads == 3 && !hasModel("can"); }));
  text = with;
  folder.write("room.sdf", text);
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return loads == 4 && hasModel("can"); }));
  run("simulation.step");
  EXPECT_TRUE(waitFor([this] { return status()->steps() > 0; }));
  EXPECT_NEAR(place(), 2.5, 0.01);
}

TEST_F(SceneReloadTest, aRenamedModelStaysWhereItIs) {
  edit("</world>", kCan);
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return loads == 2 && hasModel("can"); }));
  run("scene.place can 2.5 -2.5");
  const auto place = [this](const char* frame) {
    const auto* all = workbench.session().store().latestAs<foxglove::FrameTransforms>(
        robotlink::streams::kTransforms, workbench.session().timeline().newest());
    const auto found = std::ranges::find(all->transforms(), frame, &foxglove::FrameTransform::child_frame_id);
    return found == all->transforms().end() ? 0.0 : found->translation().x();
  };
  ASSERT_TRUE(waitFor([&] { return place("body:can/can") > 2.4; }));
  edit("name='can'><pose>", "name='jar'><pose>");
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return loads == 3 && hasModel("jar"); }));
  run("simulation.step");
  EXPECT_TRUE(waitFor([this] { return status()->steps() > 0; }));
  EXPECT_NEAR(place("body:jar/can"), 2.5, 0.01);
}

TEST_F(SceneReloadTest, whatDoesNotFitNowIsRefusedWhereItMust) {
  const auto whole = std::filesystem::weakly_canonical(file);
  std::string edited = text;
  edited.replace(edited.find("</world>"), 8, kCan);
  std::string refusal;
  const auto refused = [&refusal](const robotlink::Errors& why) { refusal = why.front().text; };
  workbench.fitScene({{whole, edited}}, refused);
  ASSERT_TRUE(waitFor([this] { return loads == 2 && hasModel("can"); }));
  std::string twice = edited;
  std::string other = kCan;
  twice.replace(twice.find("</world>"), 8, other.replace(other.find("can"), 3, "jar"));
  workbench.fitScene({{whole, twice}}, refused);
  ASSERT_TRUE(waitFor([&refusal] { return !refusal.empty(); }));
  EXPECT_NE(refusal.find("there is no room for 'jar'"), std::string::npos) << refusal;
  EXPECT_TRUE(errors.empty()) << "it is said once";
  EXPECT_EQ(workbench.takeOpeningErrors().size(), 1U) << "the script that asked for it has failed";
  EXPECT_FALSE(hasModel("jar"));
}

TEST_F(SceneReloadTest, theSimulationGoesOnWithWhatWasAdded) {
  run("simulation.step");
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 4; }));
  edit("</world>", kCan);
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return loads == 2; })) << robotlink::describe(errors);
  EXPECT_TRUE(waitFor([this] { return hasModel("can"); }));
  EXPECT_EQ(status()->steps(), 4U);
  run("simulation.step");
  EXPECT_TRUE(waitFor([this] { return status()->steps() == 6; }));
}

TEST_F(SceneReloadTest, anErrorInTheFileLeavesTheSimulationAsItWas) {
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 2; }));
  edit("<model name=\"room\">", "<model nam=\"room\">");
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_GT(errors.front().where.line, 0);
  run("simulation.step");
  EXPECT_TRUE(waitFor([this] { return status()->steps() == 4; }));
}

TEST_F(SceneReloadTest, robotsOfTheEditedFileComeAndGo) {
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 2; }));
  edit("<name>p3at1</name>", "<name>other</name>");
  run("scene.reload");
  ASSERT_TRUE(waitFor([this] { return loads == 2; })) << robotlink::describe(errors);
  EXPECT_EQ(status()->steps(), 2U) << "the simulation goes on";
  EXPECT_EQ(workbench.session().robots(), std::vector<std::string>{"other"});
}

TEST_F(SceneReloadTest, robotsAreAddedAndRemovedByCommands) {
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 2; }));
  run("scene.add burger 2 -2 --name turtle");
  const auto& robots = workbench.session().robots();
  ASSERT_TRUE(waitFor([&] { return robots.size() == 2; })) << robotlink::describe(errors);
  EXPECT_EQ(workbench.loaded()->robots.at("turtle")->name, "burger");
  EXPECT_TRUE(waitFor([this] { return hasModel("turtle") && status()->robots_size() == 2; }));
  EXPECT_EQ(status()->scene_undo(), "the addition of turtle");
  run("scene.remove turtle");
  EXPECT_TRUE(waitFor([&] { return robots.size() == 1 && !hasModel("turtle"); }));
  run("scene.undo");
  EXPECT_TRUE(waitFor([&] { return robots.size() == 2; }));
  run("scene.duplicate turtle twin");
  EXPECT_TRUE(waitFor([&] { return robots.size() == 3; })) << robotlink::describe(errors);
  EXPECT_EQ(status()->steps(), 2U);
  EXPECT_TRUE(errors.empty()) << robotlink::describe(errors);
}

TEST_F(SceneReloadTest, whatWasAddedByHandIsThereAfterAReload) {
  run("scene.add burger 1 -2 --name turtle");
  ASSERT_TRUE(waitFor([this] { return hasModel("turtle"); })) << robotlink::describe(errors);
  edit("</world>", kCan);
  run("scene.reload");
  EXPECT_TRUE(waitFor([this] { return hasModel("can"); })) << robotlink::describe(errors);
  EXPECT_TRUE(hasModel("turtle"));
  EXPECT_EQ(workbench.session().robots().size(), 2U);
}

TEST_F(SceneReloadTest, aModelThatDoesNotExistIsRefusedWithTheFoldersThatWereSearched) {
  run("scene.add unicorn 1 1");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_NE(errors.front().text.find("unicorn"), std::string::npos);
  const auto done = workbench.commands().runLine("scene.add burger 1 1 --height high");
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().id, "scene.height");
}

TEST_F(SceneReloadTest, withoutASimulationThereIsNothingToReload) {
  workbench.close();
  ASSERT_TRUE(waitFor([this] { return loads == 2; }));
  const auto done = workbench.commands().runLine("scene.reload");
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().id, "simulation.none");
}
