// SPDX-License-Identifier: GPL-3.0-or-later
// What a person chooses for the program of a simulated robot: when it is answered, and what it outlives.
#include <gmock/gmock.h>
#include <google/protobuf/message.h>

#include <map>
#include <set>

#include "app/core/program/PresetOverrides.h"
#include "app/core/program/ShippedFiles.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "tests/TestFolder.h"
#include "tests/app/Requests.h"
#include "tests/app/SimulatedRuns.h"

using namespace app::test;
using app::layoutNamed;
using app::SimulatedRun;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

namespace {

/// Parameters of the ball model "last-percept".
std::unique_ptr<google::protobuf::Message> lastPercept() {
  const auto* type = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(
      "robotcontrol.LastPerceptBallParameters");
  return std::unique_ptr<google::protobuf::Message>(
      google::protobuf::MessageFactory::generated_factory()->GetPrototype(type)->New());
}

robotcontrol::Request parameterRequest(double memory) {
  robotcontrol::Request request;
  request.set_robot("red1");
  auto& details = *request.mutable_set_parameters();
  details.set_task("ball-model");
  details.set_solution("last-percept");
  const auto value = lastPercept();
  const auto* field = value->GetDescriptor()->FindFieldByName("memory");
  value->GetReflection()->SetDouble(value.get(), field, memory);
  details.mutable_value()->set_type(value->GetDescriptor()->full_name());
  details.mutable_value()->set_data(value->SerializeAsString());
  return request;
}

/// What a run publishes of red1: its newest solution of a task, parameters of its ball model, and whether it
/// has an own color table.
struct Reported {
  std::map<std::string, std::string> solutions;
  double memory = -1;  // s
  bool ownTable = false;
  std::string frames;                      ///< all that its processes published, as bytes
  std::map<std::uint64_t, bool> accepted;  ///< by id, first answers
  std::vector<std::string> tables;         ///< where color tables in use are from
  std::vector<std::string> texts;          ///< on color tables
  SimulatedRun::Listeners listeners() {
    return {[this](const std::string&, const auto& queue) {
              const robotcontrol::DebugQueue wire = toWire(*queue);
              if (!wire.process().empty()) frames += wire.SerializeAsString();
              for (const auto& message : wire.messages()) hear(message);
            },
            {}};
  }
  void hear(const robotcontrol::DebugMessage& message) {
    if (message.has_result()) accepted.emplace(message.result().id(), message.result().accepted());
    for (const auto& task : message.solutions().tasks()) solutions[task.name()] = task.active();
    if (message.path() == "parameters/ball-model/last-percept") {
      const auto value = lastPercept();
      value->ParseFromString(message.parameters().value().data());
      memory = value->GetReflection()->GetDouble(*value, value->GetDescriptor()->FindFieldByName("memory"));
    }
    if (message.path() == "colors/table") ownTable = true;
    if (message.text().name() == "debug/colors") texts.push_back(message.text().message());
    if (message.path() != "tables/colors") return;
    robotcontrol::ColorTable inUse;
    inUse.ParseFromString(message.package().data());
    EXPECT_TRUE(inUse.cells().empty());
    tables.push_back(inUse.source());
  }
};

/// Everything that a person can choose for a program.
std::vector<robotcontrol::Request> choices() {
  std::vector<robotcontrol::Request> all{selectRequest("red1", "ball-model", "last-percept"),
                                         parameterRequest(0.125), tableRequest(),
                                         keyRequest("red1", "package/colors/table")};
  for (std::size_t i = 0; i < all.size(); ++i) all[i].set_id(i + 1);
  return all;
}

}  // namespace

TEST(SimulatedChoices, requestsInAPauseAreAnsweredAtOnceAndTheRunIsTheSameAsWithoutThePause) {
  Reported paused, other;
  const auto looked = makeRun(simulationOptions(), paused.listeners()),
             unlooked = makeRun(simulationOptions(), other.listeners());
  for (const bool look : {true, false}) {
    SimulatedRun& run = look ? *looked : *unlooked;
    play(run, 0.5);
    for (const auto& request : choices()) {
      ASSERT_TRUE(run.request(request).has_value());
      if (look) run.publishComingAnswers();
    }
    if (look) run.publishComingAnswers();
    play(run, 0.008);  // In the middle of their way to the processes.
    if (look) run.publishComingAnswers();
    play(run, 0.5);
  }
  for (std::uint64_t id = 1; id <= 4; ++id) EXPECT_TRUE(paused.accepted[id]) << id;
  EXPECT_EQ(looked->world().digest(), unlooked->world().digest());
  EXPECT_EQ(paused.frames.size(), other.frames.size());
  EXPECT_TRUE(paused.frames == other.frames);
}

TEST(SimulatedChoices, inAPauseTheTablesAndParametersFollowWhatWasAsked) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  run->publishComingAnswers();
  EXPECT_EQ(reported.solutions["ball-model"], "kalman") << "known before the first step";
  for (const auto& request : choices()) ASSERT_TRUE(run->request(request).has_value());
  run->publishComingAnswers();
  EXPECT_EQ(reported.accepted.size(), 5U) << "the four, and what the run asks for itself";
  EXPECT_EQ(reported.solutions["ball-model"], "last-percept");
  EXPECT_EQ(reported.memory, 0.125);
  EXPECT_EQ(run->world().clock().now(), robotlink::Instant{});
}

TEST(SimulatedChoices, programsStartWithAPreset) {
  const TestFolder home;
  const auto file = home.write("tuned.preset.json", R"({
    "format": "robotcontrol-preset", "version": 1,
    "preset": {
      "keys": {"package/models/ball": "always"},
      "solutions": {"ball-model": "last-percept"},
      "parameters": {"ball-model/last-percept memory": "0.125"},
      "views": {"perspective": "Play"}
    }
  })");
  auto preset = app::presetToStartWith(file.string());
  ASSERT_TRUE(preset) << robotlink::describe(preset.error());
  auto options = simulationOptions();
  options.preset = std::make_shared<const robotlink::Preset>(std::move(*preset));
  Reported reported;
  const auto run = makeRun(options, reported.listeners());
  play(*run, 0.5);
  EXPECT_EQ(reported.solutions["ball-model"], "last-percept");
  EXPECT_EQ(reported.memory, 0.125);
  EXPECT_NE(reported.frames.find("models/ball"), std::string::npos);
  reported = {};
  ASSERT_TRUE(run->reset(1).empty());
  play(*run, 0.5);
  EXPECT_EQ(reported.memory, 0.125) << "after a reset";
}

TEST(SimulatedChoices, aPresetWithWhatNoProgramHasIsRefusedWithAllOfIt) {
  const TestFolder home;
  const auto file = home.write("wrong.preset.json", R"({
    "format": "robotcontrol-preset", "version": 1,
    "preset": {
      "keys": {"ball-model/nothing": "always"},
      "solutions": {"ball-model": "filterd"},
      "parameters": {"ball-model/filtered memori": "1", "ball-model/filtered memory": "long"}
    }
  })");
  const auto preset = app::presetToStartWith(file.string());
  ASSERT_FALSE(preset);
  const std::string text = robotlink::describe(preset.error());
  EXPECT_EQ(preset.error().size(), 4U) << text;
  EXPECT_THAT(text, testing::HasSubstr("there is no debug key 'ball-model/nothing'"));
  EXPECT_THAT(text, testing::HasSubstr("did you mean 'filtered'"));
  EXPECT_THAT(text, testing::HasSubstr("memori does not exist"));
  EXPECT_THAT(text, testing::HasSubstr("memory cannot be 'long'"));
  EXPECT_FALSE(app::presetToStartWith((home / "none.preset.json").string()));
}

TEST(SimulatedChoices, whatAPersonChoseSurvivesResetsAndOtherLayouts) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  play(*run, 0.2);
  for (const auto& request : choices()) ASSERT_TRUE(run->request(request).has_value());
  play(*run, 0.5);
  const auto expectAll = [&](const char* after) {
    reported = {};
    play(*run, 0.5);
    EXPECT_EQ(reported.solutions["ball-model"], "last-percept") << after;
    EXPECT_EQ(reported.memory, 0.125) << after;
    EXPECT_TRUE(reported.ownTable) << after;
    EXPECT_EQ(run->lostChoices(), std::vector<std::string>()) << after;
  };
  ASSERT_TRUE(run->setLayout(layoutNamed("parallel")).empty());
  expectAll("layout");
  ASSERT_TRUE(run->reset(1).empty());
  expectAll("reset");
}

TEST(SimulatedChoices, theColorTableInUseIsSaidAndSurvivesResetsAndOtherLayouts) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  play(*run, 0.5);
  EXPECT_THAT(std::set(reported.tables.begin(), reported.tables.end()), ElementsAre("built-in"));
  EXPECT_THAT(reported.texts, IsEmpty());
  reported = {};
  ASSERT_TRUE(run->request(tableRequest()).has_value());
  play(*run, 0.5);
  EXPECT_THAT(reported.tables, ElementsAre("/home/me/orange.c64"));
  EXPECT_THAT(reported.texts, ElementsAre("The color table is now /home/me/orange.c64"));
  const auto expectKept = [&](const char* after) {
    reported = {};
    play(*run, 0.5);
    EXPECT_THAT(std::set(reported.tables.begin(), reported.tables.end()), ElementsAre("/home/me/orange.c64"))
        << after;
    EXPECT_THAT(reported.texts, IsEmpty()) << after << ": nothing changed";
  };
  ASSERT_TRUE(run->reset(1).empty());
  expectKept("reset");
  ASSERT_TRUE(run->setLayout(layoutNamed("parallel")).empty());
  expectKept("layout");
  robotcontrol::Request back;
  back.set_robot("red1");
  back.mutable_set_color_table();
  reported = {};
  ASSERT_TRUE(run->request(back).has_value());
  play(*run, 0.5);
  EXPECT_THAT(reported.tables, ElementsAre("built-in"));
  EXPECT_THAT(reported.texts, ElementsAre("The color table is now the built-in one"));
}

TEST(SimulatedChoices, aColorTableThatIsGivenBeforeTheFirstFrameIsLoggedToo) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  ASSERT_TRUE(run->request(tableRequest()).has_value());
  play(*run, 0.5);
  EXPECT_THAT(reported.texts, ElementsAre("The color table is now /home/me/orange.c64"));
}

TEST(SimulatedChoices, inAPauseTheColorTableThatWasGivenIsSaidAtOnce) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  run->publishComingAnswers();
  EXPECT_THAT(reported.tables, ElementsAre("built-in")) << "known before the first step";
  ASSERT_TRUE(run->request(tableRequest()).has_value());
  run->publishComingAnswers();
  EXPECT_EQ(reported.tables.back(), "/home/me/orange.c64");
}

TEST(SimulatedChoices, choicesInAPauseSurviveAResetInTheSamePause) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  for (const auto& request : choices()) ASSERT_TRUE(run->request(request).has_value());
  run->publishComingAnswers();
  ASSERT_TRUE(run->reset(1).empty());
  play(*run, 0.5);
  EXPECT_EQ(reported.solutions["ball-model"], "last-percept");
  EXPECT_EQ(reported.memory, 0.125);
}

TEST(SimulatedChoices, whatALayoutCannotFulfillIsSaidAndComesBackWithOneThatCan) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  ASSERT_TRUE(run->request(selectRequest("red1", "self-localisation", "odometry")).has_value());
  play(*run, 0.2);
  ASSERT_TRUE(run->setLayout(layoutNamed("perception")).empty());
  ASSERT_EQ(run->lostChoices().size(), 1U);
  EXPECT_EQ(run->lostChoices()[0],
            "red1 could not keep solution odometry of task self-localisation: "
            "no process of this layout has 'self-localisation'");
  play(*run, 0.2);
  ASSERT_TRUE(run->setLayout(layoutNamed("balanced")).empty());
  EXPECT_TRUE(run->lostChoices().empty());
  play(*run, 0.5);
  EXPECT_EQ(reported.solutions["self-localisation"], "odometry");
}

TEST(SimulatedChoices, whatWasRefusedIsNotAskedForAgain) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  auto wrong = selectRequest("red1", "ball-model", "telepathy");
  wrong.set_id(77);
  ASSERT_TRUE(run->request(wrong).has_value());
  play(*run, 0.2);
  EXPECT_EQ(reported.accepted,
            (std::map<std::uint64_t, bool>{{77, false}, {reported.accepted.rbegin()->first, true}}));
  ASSERT_TRUE(run->reset(1).empty());
  EXPECT_TRUE(run->lostChoices().empty());
}

TEST(SimulatedChoices, inAPauseTheNewestValueOfOneThingTakesThePlaceOfThoseBefore) {
  Reported reported;
  const auto run = makeRun(simulationOptions(), reported.listeners());
  for (std::uint64_t id = 1; id <= 3000; ++id) {
    auto request = parameterRequest(0.001 * static_cast<double>(id));
    request.set_id(id);
    ASSERT_TRUE(run->request(request).has_value()) << id;
    run->publishComingAnswers();
  }
  EXPECT_EQ(reported.accepted.size(), 3001U);
  play(*run, 0.5);
  EXPECT_EQ(reported.memory, 3);
}
