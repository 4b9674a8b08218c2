// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/HeadlessRun.h"

#include <gmock/gmock.h>

#include <sstream>

#include "app/core/platform/PlatformAdapter.h"

using namespace app;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

/// A platform that nothing but the registration below knows.
HeadlessPlatform echoPlatform() {
  return {
      .help = "echo:WORD",
      .usage = "echo:WORD",
      .options = {{.name = "echo-loud",
                   .kind = PlatformField::Kind::kFlag,
                   .initial = false,
                   .option = "--echo-loud"}},
      .optionsAreMine = "--echo-loud is for echoes",
      .prepare = [](const HeadlessChoices& choices) -> robotlink::Result<HeadlessPlatform::Run> {
        if (choices.platform == "echo:") return robotlink::failure("usage", "there is nothing to echo");
        return [choices](const HeadlessConsole& console) -> tl::expected<HeadlessSummary, robotlink::Errors> {
          console.errors << "echoes " << choices.platform.substr(5);
          return HeadlessSummary{"{}", flagOf(choices.options.values, "echo-loud") ? "ECHO" : "echo", kDone};
        };
      }};
}

const PlatformRegistration kEchoRegistration{
    {.name = "echo",
     .sources = "a word",
     .time = TimeKind::kReal,
     .opens = [](const std::string& source) { return source.starts_with("echo:"); },
     .order = 9,
     .open = [](const PlatformChoices&) -> robotlink::Result<PlatformOpening> {
       return robotlink::failure("echo", "echoes cannot be seen");
     },
     .headless = echoPlatform}};

std::string refusalOf(const HeadlessChoices& choices) {
  const auto platform = headlessPlatformFor(choices);
  if (!platform) return platform.error().text;
  const auto run = platform->prepare(choices);
  return run ? "" : run.error().text;
}

HeadlessChoices choicesWith(const std::string& platform, const std::string& option, FormValue value) {
  HeadlessChoices choices{.platform = platform};
  choices.options.lists[option] = {std::move(value)};
  return choices;
}

}  // namespace

TEST(HeadlessRun, aPlatformRunsByItsRegistrationAlone) {
  HeadlessChoices choices{.platform = "echo:hello"};
  choices.options.values["echo-loud"] = true;
  const auto platform = headlessPlatformFor(choices);
  ASSERT_TRUE(platform.has_value()) << platform.error().text;
  const auto run = platform->prepare(choices);
  ASSERT_TRUE(run.has_value()) << run.error().text;
  std::ostringstream errors;
  const auto summary = (*run)({errors, [] { return false; }, [](double) { return true; }, {}});
  ASSERT_TRUE(summary.has_value());
  EXPECT_EQ(summary->text, "ECHO");
  EXPECT_EQ(errors.str(), "echoes hello");
}

TEST(HeadlessRun, whatNothingRunsIsRefusedWithAllThatCouldBe) {
  EXPECT_EQ(
      refusalOf({.platform = "sim:x.sdf"}),
      "--platform is echo:WORD, or a log file or log:FILE,log:FILE..., or a robot's address: tcp://HOST:PORT "
      "or serial://DEVICE?baud=RATE, or a camera: camera:///dev/video0, or a remote body: ws://HOST:PORT; "
      "'robotctl sim' runs simulated robots");
}

TEST(HeadlessRun, anOptionOfAnotherPlatformIsRefused) {
  EXPECT_EQ(refusalOf(choicesWith("tcp://localhost:8101", "package", std::string("percepts/ball=logged"))),
            "--offset, --package, --color-table and --patience are for logs");
  HeadlessChoices choices{.platform = "log:a.mcap"};
  choices.options.values["echo-loud"] = true;
  EXPECT_EQ(refusalOf(choices), "--echo-loud is for echoes");
}

TEST(HeadlessRun, anOptionOfARobotDoesNotMatterToALog) {
  HeadlessChoices choices{.platform = "log:a.mcap"};
  choices.options.values["texts"] = true;
  EXPECT_EQ(refusalOf(choices), "");
}

TEST(HeadlessRun, whatIsWrongWithTheChoicesOfALogIsSaidBeforeItIsOpened) {
  EXPECT_EQ(refusalOf({.platform = "log:"}), "--platform names no file after 'log:'");
  EXPECT_EQ(refusalOf({.platform = "log:a.mcap,log:"}), "--platform names no file after 'log:'");
  HeadlessChoices shifted = choicesWith("log:a.mcap", "offset", 1.0);
  EXPECT_EQ(refusalOf(shifted), "");
  shifted.options.lists["offset"].push_back(2.0);
  EXPECT_EQ(refusalOf(shifted), "there are more --offset than logs");
  EXPECT_EQ(refusalOf(choicesWith("log:a.mcap", "package", std::string("percepts/ball=maybe"))),
            "--package takes PACKAGE=logged or PACKAGE=recomputed, not 'percepts/ball=maybe'");
}

TEST(HeadlessRun, aLogThatIsMissingEndsTheRunWithItsName) {
  const HeadlessChoices choices{.platform = "log:/no/such.mcap"};
  const auto run = headlessPlatformFor(choices)->prepare(choices);
  ASSERT_TRUE(run.has_value());
  std::ostringstream errors;
  const auto summary = (*run)({errors, [] { return false; }, [](double) { return true; },
                               [](const std::string& source) { return std::filesystem::path(source); }});
  ASSERT_FALSE(summary.has_value());
  EXPECT_THAT(robotlink::describe(summary.error()), HasSubstr("/no/such.mcap"));
}
