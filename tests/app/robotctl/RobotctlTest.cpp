// SPDX-License-Identifier: GPL-3.0-or-later
// The program as its users call it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <string>

#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

struct PrintedOutcome {
  int status = -1;
  std::string text;  ///< stdout and stderr
};

PrintedOutcome run(const std::string& command) {
  PrintedOutcome outcome;
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    outcome.text.append(buffer.data(), count);
  }
  outcome.status = WEXITSTATUS(::pclose(pipe));
  return outcome;
}

PrintedOutcome robotctl(const std::string& arguments, const std::string& environment = {}) {
  return run(environment + ROBOTCTL + " " + arguments);
}

const std::string kLayout = ROBOTCONTROL_SOURCE_DIR "/resources/layouts/compact.yaml";

}  // namespace

TEST(Robotctl, helpIsGivenAndWrongUsageIsTwo) {
  EXPECT_EQ(robotctl("--help").status, 0);
  EXPECT_EQ(robotctl("sim --help").status, 0);
  EXPECT_EQ(robotctl("").status, 2);
  EXPECT_EQ(robotctl("fly").status, 2);
  EXPECT_EQ(robotctl("sim " + kScene + " --seconds minus").status, 2);
  EXPECT_EQ(robotctl("sim " + kScene + " --solution nonsense").status, 2);
  EXPECT_EQ(robotctl("sim " + kScene + " --patience -1").status, 2);
}

TEST(Robotctl, simTakesTheNameOfAShippedScene) {
  EXPECT_EQ(robotctl("sim field2002 --seconds 0.1").status, 0);
  const PrintedOutcome outcome = robotctl("sim field2020");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.text.find("there is no scene 'field2020'"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("field2002"), std::string::npos) << outcome.text;
}

TEST(Robotctl, simPrintsItsFiguresAsOneJsonObject) {
  const PrintedOutcome outcome = robotctl("sim " + kScene + " --seconds 1 --seed 5 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const auto figures = nlohmann::json::parse(outcome.text);
  EXPECT_EQ(figures.at("steps"), 250);
  EXPECT_EQ(figures.at("images"), 25);
  EXPECT_EQ(figures.at("seed"), 5);
  EXPECT_EQ(figures.at("robots"), 1);
  EXPECT_NEAR(figures.at("simulated_seconds").get<double>(), 1, 0.009);
  for (const char* name : {"real_time_factor", "ms_per_step", "ms_per_image"})
    EXPECT_GT(figures.at(name).get<double>(), 0);
  EXPECT_TRUE(figures.contains("ball_contacts"));
  EXPECT_TRUE(figures.contains("digest"));
}

TEST(Robotctl, simPrintsItsFiguresForPeopleRoundedAndWithUnits) {
  const PrintedOutcome outcome = robotctl("sim " + kScene + " --seconds 1 --seed 5");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_THAT(outcome.text, testing::HasSubstr("scene       field2002.sdf, seed 5\n"));
  EXPECT_THAT(outcome.text, testing::HasSubstr("robots      1, in the layout compact\n"));
  EXPECT_THAT(outcome.text, testing::ContainsRegex(
                                "time        1\\.00 s simulated in [0-9.]+ m?s: [0-9.]+ times real time"));
  EXPECT_THAT(outcome.text, testing::ContainsRegex("physics     250 steps, [0-9.]+ ms each"));
  EXPECT_THAT(outcome.text, testing::ContainsRegex("images      25, [0-9.]+ ms each"));
  EXPECT_THAT(outcome.text, testing::HasSubstr("goals       red 0, blue 0\n"));
  EXPECT_THAT(outcome.text, testing::Not(testing::HasSubstr("_"))) << "names are for programs";
  EXPECT_THAT(outcome.text, testing::Not(testing::ContainsRegex("[0-9]\\.[0-9][0-9][0-9][0-9]")));
}

TEST(Robotctl, robotsAreAddedToAGame) {
  const PrintedOutcome outcome = robotctl("sim " + kScene + " --seconds 0.2 --json --robots 3");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(nlohmann::json::parse(outcome.text).at("robots"), 4);
  EXPECT_EQ(robotctl("sim " + kScene + " --seconds 0.1 --robots 2 --teams green").status, 2);
  const PrintedOutcome house =
      robotctl("sim " ROBOTCONTROL_SOURCE_DIR
               "/resources/scenes/house.map --seconds 0.1 --json --robot ers210 --robots 2");
  EXPECT_EQ(house.status, 0) << house.text;
}

TEST(Robotctl, simRefusesOptionsThatWouldHaveNoEffect) {
  const auto script = std::filesystem::path(testing::TempDir()) / "nothing.script";
  std::ofstream(script) << "simulation.step\n";
  const auto refused = [](const std::string& options, const std::string& why, int status = 2) {
    const PrintedOutcome outcome = robotctl("sim " + kScene + " --seconds 0.1 " + options);
    EXPECT_EQ(outcome.status, status) << options << ": " << outcome.text;
    EXPECT_THAT(outcome.text, testing::HasSubstr(why)) << options;
  };
  refused("--teams red", "--robots");
  refused("--robot burger", "--robots");
  refused("--radius 2", "--trials");
  refused("--shadow nonsense=kalman", "there is no task 'nonsense'");
  refused("--shadow ball-model=nonsense", "has no solution 'nonsense'");
  refused("--shadow red9/ball-model=last-percept", "red9", 1);
  refused("--solution ball-model=kalman --shadow red1/ball-model=kalman", "is the solution that is used", 1);
  refused("--walk 0.1 --errors", "omit --errors");
  refused("--script " + script.string(), "omit --seconds");
  const PrintedOutcome errors = robotctl("sim " + kScene + " --errors --script " + script.string());
  EXPECT_EQ(errors.status, 2);
  EXPECT_THAT(errors.text, testing::HasSubstr("omit --errors"));
  const std::string room = "sim " ROBOTCONTROL_SOURCE_DIR "/resources/scenes/pioneer.sdf --seconds 0.1";
  const PrintedOutcome game = robotctl(room + " --game 2002");
  EXPECT_EQ(game.status, 1);
  EXPECT_THAT(game.text, testing::HasSubstr("--game"));
  EXPECT_EQ(robotctl(room + " --game none").status, 0);
  const PrintedOutcome shadow =
      robotctl("sim " + kScene + " --seconds 0.1 --shadow red1/ball-model=last-percept");
  EXPECT_EQ(shadow.status, 0) << shadow.text;
  std::filesystem::remove(script);
}

TEST(Robotctl, layoutsAreChosenForSingleRobotsAndModelsSearchedInFolders) {
  const PrintedOutcome outcome =
      robotctl("sim mixed --layout p3at1=pioneer --layout parallel --seconds 0.1 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(nlohmann::json::parse(outcome.text).at("robots"), 3);
  const PrintedOutcome nobody = robotctl("sim mixed --layout nobody=pioneer --seconds 0.1");
  EXPECT_EQ(nobody.status, 1);
  EXPECT_THAT(nobody.text, testing::HasSubstr("nobody"));
  EXPECT_EQ(robotctl("sim mixed --layout =pioneer --seconds 0.1").status, 2);
  const auto folder = std::filesystem::path(testing::TempDir()) / "search";
  std::filesystem::create_directories(folder / "mine" / "crate");
  std::ofstream(folder / "mine" / "crate" / "model.sdf")
      << "<sdf version='1.9'><model name='crate'><static>true</static><link name='l'/></model></sdf>";
  std::ofstream(folder / "world.sdf")
      << "<sdf version='1.9'><world name='w'><include><uri>model://crate</uri>"
         "</include></world></sdf>";
  const std::string world = "sim " + (folder / "world.sdf").string() + " --seconds 0.1 --json";
  EXPECT_EQ(robotctl(world).status, 1);
  const PrintedOutcome found = robotctl(world + " --models /nowhere:" + (folder / "mine").string());
  EXPECT_EQ(found.status, 0) << found.text;
  std::filesystem::remove_all(folder);
}

TEST(Robotctl, aScriptAddsAndRemovesRobotsWithoutAWindow) {
  const auto script = std::filesystem::path(testing::TempDir()) / "robots.script";
  std::ofstream(script) << "simulation.step\nscene.add burger 1 0.6 --name turtle\nsimulation.step\n"
                           "print simulation.robots\nscene.remove turtle\nscene.undo\nscene.undo\n"
                           "print simulation.steps\n";
  const PrintedOutcome outcome = robotctl("sim " + kScene + " --script " + script.string());
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(outcome.text, "2\n4\n") << "robots, and steps";
  std::ofstream(script) << "scene.add unicorn 1 0.6\n";
  const PrintedOutcome wrong = robotctl("sim " + kScene + " --script " + script.string());
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.text, testing::HasSubstr("unicorn"));
  std::filesystem::remove(script);
}

TEST(Robotctl, aMapInCapitalsHasARobotAsAnyMap) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "capitals";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/house.map", folder / "HOUSE.MAP",
                             std::filesystem::copy_options::overwrite_existing);
  const PrintedOutcome outcome = robotctl("sim " + (folder / "HOUSE.MAP").string() + " --seconds 0.1 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(nlohmann::json::parse(outcome.text).at("robots"), 1);
  std::filesystem::remove_all(folder);
}

TEST(Robotctl, withoutResourcesItIsSaidWhereTheyWereLookedForAndWhatNamesThem) {
  const PrintedOutcome wrong = robotctl("sim " + kScene, "ROBOTCONTROL_RESOURCES=/no/such/folder ");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.text, testing::HasSubstr("ROBOTCONTROL_RESOURCES names the folder '/no/such/folder'"));
  // The program alone, as after a bad installation.
  const auto folder = std::filesystem::path(testing::TempDir()) / "alone";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(ROBOTCTL, folder / "robotctl",
                             std::filesystem::copy_options::overwrite_existing);
  const PrintedOutcome none = run((folder / "robotctl").string() + " sim " + kScene);
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.text, testing::HasSubstr("no folder 'resources' in or above '" +
                                            std::filesystem::canonical(folder).string() + "'"));
  EXPECT_THAT(none.text, testing::HasSubstr("ROBOTCONTROL_RESOURCES"));
  std::filesystem::remove_all(folder);
}

TEST(Robotctl, theDigestIsTheSameEveryTimeAndAnotherForAnotherSeed) {
  const std::string command = "sim " + kScene + " --seconds 1 --digest --seed ";
  const PrintedOutcome first = robotctl(command + "1");
  ASSERT_EQ(first.status, 0);
  EXPECT_EQ(first.text, robotctl(command + "1").text);
  EXPECT_NE(first.text, robotctl(command + "2").text);
}

TEST(Robotctl, threadsHaveRealTimeAndAnyRunTheTimeThatIsAskedFor) {
  const auto realSeconds = [](const std::string& options) {
    const PrintedOutcome outcome = robotctl("sim " + kScene + " --json " + options);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return nlohmann::json::parse(outcome.text).at("real_seconds").get<double>();
  };
  EXPECT_GT(realSeconds("--seconds 0.5 --executor threads"), 0.48);
  EXPECT_GT(realSeconds("--seconds 1 --speed 4"), 0.24);
  EXPECT_EQ(robotctl("sim " + kScene + " --trials 1 --executor threads").status, 2);
  EXPECT_EQ(robotctl("sim " + kScene + " --trials 1 --speed 1").status, 2);
}

TEST(Robotctl, aSceneThatIsNotThereAndABadLayoutFailWithTheirPlace) {
  const PrintedOutcome scene = robotctl("sim /no/such.sdf --seconds 1");
  EXPECT_EQ(scene.status, 1);
  EXPECT_NE(scene.text.find("/no/such.sdf"), std::string::npos);
  const auto file = std::filesystem::path(testing::TempDir()) / "bad.yaml";
  std::ofstream(file) << "version: 1\nname: bad\nprocesses:\n  - name: a\n    color: green\n";
  const PrintedOutcome layout = robotctl("layout check " + file.string());
  EXPECT_EQ(layout.status, 1);
  EXPECT_NE(layout.text.find(file.string() + ":5:"), std::string::npos) << layout.text;
}

TEST(Robotctl, aRecordedSimulationIsRunAgainToTheSameBytes) {
  const auto folder = std::filesystem::path(testing::TempDir());
  const auto remove = [&](const char* name) { std::filesystem::remove(folder / name); };
  const auto path = [&](const char* name) { return (folder / name).string(); };
  for (const char* name : {"run-in.mcap", "run-a.mcap", "run-b.mcap"}) remove(name);
  ASSERT_EQ(robotctl("sim " + kScene + " --seconds 1 --record " + path("run-in.mcap")).status, 0);
  const std::string command =
      "run --json --platform log:" + path("run-in.mcap") +
      " --package percepts/regions=recomputed --package red1/models/ball=recomputed --record ";
  const PrintedOutcome first = robotctl(command + path("run-a.mcap"));
  ASSERT_EQ(first.status, 0) << first.text;
  const auto summary = nlohmann::json::parse(first.text);
  ASSERT_EQ(summary.at("differences").size(), 2U);
  for (const auto& difference : summary["differences"]) {
    EXPECT_GT(difference.at("compared"), 20);
    EXPECT_EQ(difference.at("different"), 0) << difference.dump();
    EXPECT_TRUE(difference.at("first_s").is_null());
  }
  ASSERT_EQ(robotctl(command + path("run-b.mcap")).status, 0);
  const auto bytes = [&](const char* name) {
    std::ifstream file(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_GT(bytes("run-a.mcap").size(), 10'000U);
  EXPECT_TRUE(bytes("run-a.mcap") == bytes("run-b.mcap"));
  EXPECT_EQ(robotctl(command + path("run-a.mcap")).status, 1) << "it must not exist";

  const PrintedOutcome other =
      robotctl("run --platform log:" + path("run-in.mcap") +
               " --package percepts/regions=recomputed --solution segmentation=whole-image");
  EXPECT_EQ(other.status, 0);
  EXPECT_NE(other.text.find("red1/percepts/regions: "), std::string::npos) << other.text;
  EXPECT_NE(other.text.find("largest: "), std::string::npos) << other.text;
  // A log that was made by a replay can be replayed.
  EXPECT_EQ(robotctl("run --platform log:" + path("run-a.mcap")).status, 0);
}

TEST(Robotctl, aSolutionOrTaskThatDoesNotExistIsRefused) {
  const auto refused = [](const std::string& arguments, const std::string& why) {
    const PrintedOutcome outcome = robotctl(arguments);
    EXPECT_EQ(outcome.status, 1) << arguments;
    EXPECT_NE(outcome.text.find(why), std::string::npos) << outcome.text;
  };
  const std::string sim = "sim " + kScene + " --seconds 0.1 ";
  refused(sim + "--solution no-such-task=grid", "there is no task 'no-such-task'");
  refused(sim + "--solution segmentation=no-such", "task segmentation has no solution 'no-such'; it has ");
  // A task of other robots' layouts.
  refused(sim + "--solution path-planning=direct",
          "no robot here has the task 'path-planning' in its layout");
  const auto file = std::filesystem::path(testing::TempDir()) / "run-solutions.mcap";
  std::filesystem::remove(file);
  ASSERT_EQ(robotctl("sim " + kScene + " --seconds 0.5 --record " + file.string()).status, 0);
  const std::string run = "run --platform log:" + file.string() + " --package percepts/regions=recomputed ";
  refused(run + "--solution no-such-task=grid", "there is no task 'no-such-task'");
  refused(run + "--solution segmentation=no-such", "task segmentation has no solution 'no-such'; it has ");
  // One that exists, but cannot run here: another one must not take its place unsaid.
  const std::string blind = (std::filesystem::path(testing::TempDir()) / "run-blind.mcap").string();
  ASSERT_EQ(robotctl("log filter --force " + file.string() + " " + blind + " --exclude '*/oracle/*'").status,
            0);
  refused("run --platform log:" + blind + " --package models/ball=recomputed --solution ball-model=oracle",
          "red1: task ball-model cannot be done by oracle: neither the robot nor another task provides ");
}

TEST(Robotctl, runWarnsOfASolutionThatChangesNothing) {
  const auto file = std::filesystem::path(testing::TempDir()) / "run-unused.mcap";
  std::filesystem::remove(file);
  ASSERT_EQ(robotctl("sim " + kScene + " --seconds 0.5 --record " + file.string()).status, 0);
  const std::string command = "run --platform log:" + file.string() + " --solution segmentation=whole-image ";
  const PrintedOutcome warned = robotctl(command);
  EXPECT_EQ(warned.status, 0);
  EXPECT_NE(warned.text.find("warning: red1: task segmentation does not run"), std::string::npos)
      << warned.text;
  EXPECT_NE(warned.text.find("--package all=recomputed"), std::string::npos) << warned.text;
  const PrintedOutcome used = robotctl(command + "--package all=recomputed");
  EXPECT_EQ(used.status, 0) << used.text;
  EXPECT_EQ(used.text.find("warning"), std::string::npos) << used.text;
  EXPECT_NE(used.text.find("recomputed: red1/percepts/regions"), std::string::npos) << used.text;
  EXPECT_NE(used.text.find("recomputed: red1/models/ball"), std::string::npos) << used.text;
  EXPECT_EQ(used.text.find("e+0"), std::string::npos) << used.text;
  const PrintedOutcome mixed = robotctl(command + "--package all=recomputed --package models/ball=logged");
  EXPECT_EQ(mixed.text.find("recomputed: red1/models/ball"), std::string::npos) << mixed.text;
}

TEST(Robotctl, runSaysWhatIsWrongWithItsArgumentsAndLogs) {
  EXPECT_EQ(robotctl("run").status, 2);
  EXPECT_EQ(robotctl("run --platform sim:x.sdf").status, 2);
  EXPECT_EQ(robotctl("run --platform log:").status, 2);
  EXPECT_EQ(robotctl("run --platform log:x.mcap --package percepts/ball=maybe").status, 2);
  EXPECT_EQ(robotctl("run --platform log:x.mcap --offset 1 --offset 2").status, 2);
  const PrintedOutcome missing = robotctl("run --platform log:/no/such.mcap");
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.text.find("/no/such.mcap"), std::string::npos) << missing.text;
  // One that was not closed: what is there is played, and the loss reported.
  const auto cut = std::filesystem::path(testing::TempDir()) / "run-cut.mcap";
  std::filesystem::remove(cut);
  ASSERT_EQ(robotctl("sim " + kScene + " --seconds 1 --record " + cut.string()).status, 0);
  std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - 100);
  EXPECT_EQ(robotctl("run --platform /no/such.mcap").status, 1) << "a log's path is enough";
  const PrintedOutcome lossy = robotctl("run --platform " + cut.string());
  EXPECT_EQ(lossy.status, 3) << lossy.text;
  EXPECT_NE(lossy.text.find("not closed"), std::string::npos) << lossy.text;
  const PrintedOutcome refused =
      robotctl("run --platform log:" + cut.string() + " --package camera/image=recomputed");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.text.find("camera/image cannot be recomputed: no task of layout compact yields it"),
            std::string::npos)
      << refused.text;
}

TEST(Robotctl, simRecordsIntoANewFileAndNeverOverAnOldOne) {
  const auto file = std::filesystem::path(testing::TempDir()) / "robotctl-record.mcap";
  std::filesystem::remove(file);
  const std::string command = "sim " + kScene + " --seconds 0.5 --record " + file.string();
  const PrintedOutcome recorded =
      robotctl(command + " --streams '*/camera/*,-*/pose' --images jpeg --compression zstd");
  EXPECT_EQ(recorded.status, 0) << recorded.text;
  EXPECT_NE(recorded.text.find("messages"), std::string::npos);
  const auto size = std::filesystem::file_size(file);
  EXPECT_GT(size, 10'000U);
  const PrintedOutcome again = robotctl(command);
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.text.find(file.string()), std::string::npos) << again.text;
  EXPECT_EQ(std::filesystem::file_size(file), size);
  std::filesystem::remove(file);
  EXPECT_EQ(robotctl(command + " --layout /no/such.yaml").status, 1);
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(robotctl(command + " --streams a,,b").status, 2);
  EXPECT_EQ(robotctl(command + " --trials 3").status, 2);
  EXPECT_EQ(robotctl("sim " + kScene + " --images jpeg").status, 2);
}

TEST(Robotctl, simKeepsTheSpeedAndPrintsHowFarItIs) {
  const PrintedOutcome outcome = robotctl("sim " + kScene + " --seconds 0.6 --speed 2 --progress --json");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("0.504 s\n"), std::string::npos) << outcome.text;
  const auto figures = nlohmann::json::parse(outcome.text.substr(outcome.text.find('{')));
  EXPECT_GT(figures.at("real_seconds").get<double>(), 0.29);
}

TEST(Robotctl, sceneCheckSaysWhereModelsRestAndWhatIsLeftOut) {
  const std::string folder = ROBOTCONTROL_SOURCE_DIR "/tests/simcore/sdf/models/";
  const PrintedOutcome outcome = robotctl("scene check --json --seconds 1 " + folder + "surface.sdf");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const auto report = nlohmann::json::parse(outcome.text);
  ASSERT_EQ(report.at("models").size(), 2U);
  const auto& model = report.at("models").at(1);
  EXPECT_EQ(model.at("name"), "surface");
  EXPECT_EQ(model.at("touches"), nlohmann::json::array({"floor"}));
  EXPECT_LT(model.at("moved").get<double>(), 0.01);
  EXPECT_NEAR(model.at("end").at("position").at(2).get<double>(), 0.1, 0.01);
  EXPECT_EQ(report.at("left_out").size(), 3U);
  EXPECT_EQ(report.at("left_out").at(0).at("line"), 8);
  EXPECT_EQ(report.at("left_out").at(0).at("object"), "surface/body/solid");
}

TEST(Robotctl, layoutsAreCheckedAndDrawn) {
  EXPECT_EQ(robotctl("layout check " + kLayout).status, 0);
  const PrintedOutcome graph = robotctl("layout graph " + kLayout);
  EXPECT_EQ(graph.status, 0);
  EXPECT_NE(graph.text.find("digraph"), std::string::npos);
  EXPECT_NE(graph.text.find("camera/image"), std::string::npos);
}

TEST(Robotctl, commandsPrintsAllOfTheWorkbenchOneALine) {
  const PrintedOutcome outcome = robotctl("commands");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_THAT(outcome.text, testing::HasSubstr("\nsimulation.start  Runs the simulation\n"));
  EXPECT_THAT(outcome.text,
              testing::HasSubstr("\nsimulation.light <brightness: number> [warmth: number = 0]  "));
  EXPECT_THAT(outcome.text, testing::HasSubstr("\nview.show <view: text>  "));
  EXPECT_THAT(outcome.text, testing::HasSubstr("\nlog.open <source: file or name>  "))
      << "of a kind of platform";
}

TEST(Robotctl, commandsPrintsJsonForPrograms) {
  const PrintedOutcome outcome = robotctl("commands --json");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const auto commands = nlohmann::json::parse(outcome.text);
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [](const auto& command) { return command.at("name") == "remote.limit"; });
  ASSERT_NE(found, commands.end());
  const auto& images = found->at("arguments").at(2);
  EXPECT_EQ(images.at("choices"), nlohmann::json({"auto", "raw", "jpeg", "png"}));
  EXPECT_EQ(images.at("default"), "auto");
  EXPECT_EQ(images.at("optional"), true);
}

TEST(Robotctl, simGoesOnFromASnapshotWithTheSameBytes) {
  const TestFolder folder;
  const std::string file = (folder.path() / "half.snapshot").string();
  const PrintedOutcome whole =
      robotctl("sim " + kScene + " --seconds 1 --digest --snapshot-at 0.48=" + file + " --seed 4");
  ASSERT_EQ(whole.status, 0) << whole.text;
  const PrintedOutcome rest =
      robotctl("sim " + kScene + " --seconds 0.52 --digest --restore " + file + " --programs --seed 9");
  EXPECT_EQ(rest.status, 0) << rest.text;
  EXPECT_EQ(rest.text, whole.text) << "world and programs are those of the snapshot";
  EXPECT_EQ(robotctl("sim " + kScene + " --seconds 0.1 --restore " + file).status, 0);
  const PrintedOutcome other = robotctl("sim pioneer --seconds 0.1 --restore " + file);
  EXPECT_NE(other.status, 0);
  EXPECT_NE(other.text.find("field2002"), std::string::npos) << other.text;
  EXPECT_EQ(robotctl("sim " + kScene + " --snapshot-at soon").status, 2);
  EXPECT_EQ(robotctl("sim " + kScene + " --programs").status, 2) << "it needs --restore";
}

TEST(Robotctl, aSceneWithoutRobotsRuns) {
  const TestFolder folder;
  const auto scene = folder.write(
      "empty.sdf",
      "<sdf version='1.9'><world name='empty'><model name='stone'><pose>0 0 1 0 0 0</pose><link name='l'>"
      "<inertial><mass>1</mass></inertial><collision name='c'><geometry><sphere><radius>0.1</radius></sphere>"
      "</geometry></collision></link></model></world></sdf>");
  const PrintedOutcome outcome = robotctl("sim '" + scene.string() + "' --seconds 0.4 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const auto figures = nlohmann::json::parse(outcome.text);
  EXPECT_EQ(figures.at("robots"), 0);
  EXPECT_EQ(figures.at("steps"), 100);
}
