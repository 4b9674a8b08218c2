// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramOverrides.h"

#include <gmock/gmock.h>

namespace app {
namespace {

using robotcontrol::KeyMode;
using robotcontrol::Request;
using testing::ElementsAre;

Request key(const std::string& name, KeyMode::Kind kind) {
  Request request;
  request.mutable_set_key()->set_name(name);
  request.mutable_set_key()->mutable_mode()->set_kind(kind);
  return request;
}
Request solution(const std::string& task, const std::string& name) {
  Request request;
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(name);
  return request;
}
Request parameters(const std::string& task, const std::string& of, const std::string& data) {
  Request request;
  request.mutable_set_parameters()->set_task(task);
  request.mutable_set_parameters()->set_solution(of);
  request.mutable_set_parameters()->mutable_value()->set_data(data);
  return request;
}
Request colors(const std::string& cells) {
  Request request;
  request.mutable_set_color_table()->mutable_table()->set_cells(cells);
  return request;
}

Request packages(const std::vector<std::string>& names) {
  Request request;
  request.mutable_record_packages();
  for (const std::string& name : names) request.mutable_record_packages()->add_packages(name);
  return request;
}

/// "key a", "parameters ball/region 1", ...: what a new program is asked for.
std::vector<std::string> asked(const ProgramOverrides& overrides) {
  std::vector<std::string> lines;
  for (const Request& request : overrides.requests("red1")) {
    EXPECT_EQ(request.robot(), "red1");
    if (request.has_set_key()) lines.push_back("key " + request.set_key().name());
    if (request.has_select_solution())
      lines.push_back(request.select_solution().task() + " by " + request.select_solution().solution());
    if (request.has_set_parameters()) {
      const auto& set = request.set_parameters();
      lines.push_back("parameters " + set.task() + "/" + set.solution() + " " + set.value().data());
    }
    if (request.has_set_color_table()) lines.push_back("colors " + request.set_color_table().table().cells());
    for (const std::string& name : request.record_packages().packages()) lines.push_back("record " + name);
    EXPECT_EQ(request.id(), 0U) << "it is another request than the one of the user";
    if (request.has_send_tables()) lines.emplace_back("tables");
  }
  return lines;
}

TEST(ProgramOverrides, withoutAnyOnlyTheTablesAreAskedFor) {
  EXPECT_THAT(asked({}), ElementsAre("tables"));
}

TEST(ProgramOverrides, ofEachThingTheLastChoiceCounts) {
  ProgramOverrides overrides;
  for (const char* name : {"region", "circle-fit"}) EXPECT_TRUE(overrides.note(solution("ball", name)));
  for (const char* data : {"1", "2"}) EXPECT_TRUE(overrides.note(parameters("ball", "region", data)));
  EXPECT_TRUE(overrides.note(key("a", KeyMode::ALWAYS)));
  EXPECT_TRUE(overrides.note(key("a", KeyMode::EVERY_N)));
  EXPECT_THAT(asked(overrides),
              ElementsAre("key a", "parameters ball/region 2", "ball by circle-fit", "tables"));
  EXPECT_EQ(overrides.keys().at("a").kind(), KeyMode::EVERY_N);
}

TEST(ProgramOverrides, keysThatAreOffOrWereOnForSomeFramesAreForgotten) {
  ProgramOverrides overrides;
  overrides.note(key("off", KeyMode::ALWAYS));
  overrides.note(key("off", KeyMode::OFF));
  overrides.note(key("thrice", KeyMode::N_TIMES));
  overrides.note(key("on", KeyMode::EVERY_MS));
  EXPECT_THAT(asked(overrides), ElementsAre("key on", "tables"));
}

TEST(ProgramOverrides, parametersOfTheActiveSolutionComeAfterItsChoice) {
  ProgramOverrides overrides;
  overrides.note(parameters("ball", "", "of the active one"));
  overrides.note(parameters("ball", "region", "of one"));
  overrides.note(solution("ball", "region"));
  EXPECT_THAT(asked(overrides), ElementsAre("parameters ball/region of one", "ball by region",
                                            "parameters ball/ of the active one", "tables"));
}

TEST(ProgramOverrides, aMotionWithoutATextTakesBackTheOneOfItsNameOnly) {
  ProgramOverrides overrides;
  const auto motion = [](const char* name, const char* text) {
    robotcontrol::Request request;
    request.mutable_set_motion()->mutable_motion()->set_name(name);
    request.mutable_set_motion()->mutable_motion()->set_text(text);
    return request;
  };
  EXPECT_EQ(overrides.motions(), nullptr);
  EXPECT_TRUE(overrides.note(motion("bow", "a")));
  EXPECT_TRUE(overrides.note(motion("nod", "b")));
  EXPECT_TRUE(overrides.note(motion("bow", "c")));
  ASSERT_EQ(overrides.motions()->motions_size(), 2);
  EXPECT_EQ(overrides.motions()->motions(0).text(), "c");
  EXPECT_TRUE(overrides.note(motion("bow", "")));
  ASSERT_EQ(overrides.motions()->motions_size(), 1);
  EXPECT_EQ(overrides.motions()->motions(0).name(), "nod");
}

TEST(ProgramOverrides, aColorTableWithoutCellsTakesBackTheLast) {
  ProgramOverrides overrides;
  auto first = colors("cells");
  first.set_id(7);
  EXPECT_TRUE(overrides.note(first));
  EXPECT_THAT(asked(overrides), ElementsAre("colors cells", "tables"));
  EXPECT_TRUE(overrides.note(colors("")));
  EXPECT_EQ(overrides.colorTable(), nullptr);
  EXPECT_THAT(asked(overrides), ElementsAre("tables"));
}

TEST(ProgramOverrides, recordedPackagesAreAskedForAgainUntilNoneAreWanted) {
  ProgramOverrides overrides;
  EXPECT_TRUE(overrides.note(packages({"models/ball"})));
  EXPECT_TRUE(overrides.note(packages({"models/pose", "percepts/ball"})));
  EXPECT_THAT(overrides.recordedPackages(), ElementsAre("models/pose", "percepts/ball"));
  EXPECT_THAT(asked(overrides), ElementsAre("record models/pose", "record percepts/ball", "tables"));
  EXPECT_TRUE(overrides.note(packages({})));
  EXPECT_THAT(overrides.recordedPackages(), ElementsAre());
  EXPECT_THAT(asked(overrides), ElementsAre("tables"));
}

TEST(ProgramOverrides, whatARequestSetsIsKnownToBeChosenOrNot) {
  ProgramOverrides overrides;
  overrides.note(solution("ball", "region"));
  overrides.note(parameters("ball", "region", "1"));
  EXPECT_TRUE(overrides.contains(solution("ball", "other")));
  EXPECT_FALSE(overrides.contains(solution("motion", "region")));
  EXPECT_TRUE(overrides.contains(parameters("ball", "region", "2")));
  EXPECT_FALSE(overrides.contains(parameters("ball", "", "2")));
  EXPECT_FALSE(overrides.contains({}));
}

TEST(ProgramOverrides, parametersOfTheActiveSolutionAreTheLastOnes) {
  ProgramOverrides overrides;
  overrides.note(parameters("ball", "", "2"));
  overrides.note(parameters("ball", "region", "1"));
  const auto values = overrides.parameters();
  ASSERT_EQ(values.size(), 2U);
  EXPECT_EQ(values[0].solution(), "region");
  EXPECT_EQ(values[1].solution(), "");
}

TEST(ProgramOverrides, whatIsForTheMomentIsNotKept) {
  ProgramOverrides overrides;
  Request goal;
  goal.mutable_set_goal()->set_name("Kitchen");
  EXPECT_FALSE(overrides.note(goal));
  Request tables;
  tables.mutable_send_tables();
  EXPECT_FALSE(overrides.note(tables));
  EXPECT_FALSE(overrides.note({}));
  EXPECT_THAT(asked(overrides), ElementsAre("tables"));
}

}  // namespace
}  // namespace app
