// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl scene check` and what `robotctl sim` says about a scene.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace app {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class RobotctlScene : public testing::Test {
 protected:
  RobotctlOutcome run(const std::string& command, const std::string& contents,
                      const std::string& options = "") const {
    folder_.write("w.sdf", "<sdf version='1.9' xmlns:robotcontrol='urn:robotcontrol:sdf'><world name='w'>\n" +
                               contents + "</world></sdf>");
    return runRobotctl(folder_.path(), command + " w.sdf " + options);
  }
  RobotctlOutcome check(const std::string& contents, const std::string& options = "--seconds 0") const {
    return run("scene check", contents, options);
  }

  const TestFolder folder_;
};

/// A link that hangs on the world by a joint about y.
const std::string kPendulum =
    "<model name='m'><link name='base'/><joint name='w' "
    "type='fixed'><parent>world</parent><child>base</child>"
    "</joint><link name='arm'><pose>0.5 0 0 0 0 0</pose></link><joint name='j' type='revolute'><parent>base"
    "</parent><child>arm</child><pose>-0.5 0 0 0 0 0</pose><axis><xyz>0 1 0</xyz></axis></joint></model>";

TEST_F(RobotctlScene, linksThatSwingAreTold) {
  const RobotctlOutcome text = check(kPendulum, "--seconds 2");
  ASSERT_EQ(text.status, 0) << text.errors;
  EXPECT_THAT(text.out, HasSubstr("model m: moved 0.000 m and turned 0.000 rad; its link arm moved up to "));
  const auto report = nlohmann::json::parse(check(kPendulum, "--seconds 2 --json").out);
  const auto& link = report.at("models").at(0).at("most_moved_link");
  EXPECT_EQ(link.at("name"), "arm");
  EXPECT_GT(link.at("moved").get<double>(), 0.3);
  EXPECT_GT(link.at("turned").get<double>(), 0.6);
}

TEST_F(RobotctlScene, theTimeIsANumber) {
  EXPECT_EQ(check(kPendulum, "--seconds nan").status, 2);
  EXPECT_THAT(check(kPendulum, "--seconds nan").errors, HasSubstr("must be between 0 and 86400, not nan"));
}

TEST_F(RobotctlScene, whatASceneNamesIsThere) {
  const auto errorsOf = [&](const std::string& contents) {
    const RobotctlOutcome outcome = check(contents);
    EXPECT_EQ(outcome.status, 1) << outcome.out;
    return outcome.errors;
  };
  EXPECT_THAT(
      errorsOf("<model name='r'><link name='l'/><robotcontrol:robot>unicorn</robotcontrol:robot></model>"),
      HasSubstr("w.sdf:2: 'r' is a robot 'unicorn', of which there is no description"));
  EXPECT_THAT(errorsOf("<include><uri>model://burger</uri><robotcontrol:layout>nope</robotcontrol:layout>"
                       "</include>"),
              HasSubstr("w.sdf:2: 'burger' has a layout 'nope' that is neither a shipped one nor a file"));
  const std::string game = "\n<robotcontrol:game>1999</robotcontrol:game>";
  const std::string field =
      "\n<model name='f'><static>1</static><link "
      "name='l'/><robotcontrol:field>1999</robotcontrol:field></model>";
  EXPECT_THAT(errorsOf(game),
              HasSubstr("w.sdf:3: w: the <robotcontrol:game> is '1999', but there are no rules"));
  EXPECT_THAT(errorsOf(field), HasSubstr("w.sdf:3: 'f' is the field '1999', of which"));
  EXPECT_THAT(run("sim", game, "--seconds 0").errors,
              HasSubstr("w.sdf:3: w: the <robotcontrol:game> is '1999'"));
  EXPECT_THAT(run("sim", field + "<include><uri>model://burger</uri></include>", "--seconds 0").errors,
              HasSubstr("w.sdf:3: 'f' is the field '1999'"));
}

TEST_F(RobotctlScene, aSimulationSaysHowMuchIsLeftOut) {
  const std::string plugin = "<plugin name='p' filename='p.so'/>";
  EXPECT_THAT(run("sim", kPendulum + plugin, "--seconds 0").errors,
              HasSubstr("1 part of the scene is left out: robotctl scene check w.sdf says which\n"));
  EXPECT_THAT(run("sim", kPendulum + plugin + plugin, "--seconds 0").errors,
              HasSubstr("2 parts of the scene are left out: robotctl scene check w.sdf lists them\n"));
  EXPECT_THAT(run("sim", kPendulum, "--seconds 0").errors, Not(HasSubstr("left out")));
}

TEST_F(RobotctlScene, aScriptAddsAModelBesideIt) {
  folder_.write("stone.sdf", "<sdf version='1.9'><model name='stone'><link name='l'/></model></sdf>");
  folder_.write("broken.sdf", "<sdf version='1.9'>\n<model></sdf>");
  std::filesystem::create_directory(folder_.path() / "scenes");
  folder_.write("scenes/w.sdf", "<sdf version='1.9'><world name='w'>" + kPendulum + "</world></sdf>");
  const auto script = [&](const std::string& lines) {
    folder_.write("s.script", lines);
    return runRobotctl(folder_.path(), "sim scenes/w.sdf --script s.script");
  };
  const RobotctlOutcome added = script("scene.add ./stone.sdf 3 3\nsimulation.step\n");
  EXPECT_EQ(added.status, 0) << added.errors;
  const RobotctlOutcome refused = script("scene.add ./broken.sdf 3 3\n");
  EXPECT_NE(refused.status, 0);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("broken.sdf:2: "), HasSubstr("not well-formed XML")));
}

}  // namespace
}  // namespace app
