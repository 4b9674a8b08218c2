// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log` as its users call it.
#include <gmock/gmock.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "logplayer/bookmarks/BookmarkStorage.h"
#include "tests/app/robotctl/RobotctlRun.h"
#include "tests/game/Data.h"
#include "tests/game/Log.h"
#include "tests/logplayer/ForeignLog.h"
#include "tests/logplayer/SampleLog.h"

namespace {

using logplayer::SampleLog;
using logplayer::TestFolder;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Outcome = RobotctlOutcome;

class RobotctlLog : public testing::Test {
 protected:
  void SetUp() override { SampleLog{}.write(folder_ / "a.mcap"); }

  /// In the folder.
  Outcome log(const std::string& arguments) const { return runRobotctl(folder_.path(), "log " + arguments); }
  json info(const std::string& file) const {
    const Outcome outcome = log("info --json " + file);
    EXPECT_EQ(outcome.errors, "");
    return json::parse(outcome.out, nullptr, false);
  }
  static json streamOf(const json& info, const std::string& path) {
    for (const auto& stream : info.at("streams")) {
      if (stream.at("path") == path) return stream;
    }
    return {{"count", 0}};
  }

  TestFolder folder_;
};

/// The parameter is the source of a whole log of 2009.
class RobotctlWholeLog : public RobotctlLog, public testing::WithParamInterface<std::string> {
 protected:
  /// The robot's program computes what the log lacks.
  void expectComputedHits(const std::string& file) {
    const Outcome outcome = log("search " + file + " 'models/ball.known >= 0' --json");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("the robot's program computes it: nao/models/ball"));
    const json found = json::parse(outcome.out, nullptr, false);
    EXPECT_EQ(found.at("computed"), json::array({"nao/models/ball"}));
    ASSERT_EQ(found.at("hits").size(), 1U) << found;
    const double image =
        GetParam() == "real" ? 486.749 : robotlink::seconds(game::Log::imageTime(0) - robotlink::Instant());
    EXPECT_NEAR(found.at("hits")[0].at("time").get<double>(), image, 1e-6);
    const Outcome text =
        log("search " + file + " 'models/ball.known >= 0' --solution ball-model=last-percept");
    EXPECT_EQ(text.status, 0) << text.errors;
    EXPECT_THAT(text.out, HasSubstr("1 hit, computed by the program: nao/models/ball"));
    EXPECT_EQ(log("search " + file + " 'models/ball.known' --solution nonsense").status, 2);
  }
};

}  // namespace

TEST_F(RobotctlLog, searchFindsWhereAConditionIsTrue) {
  const Outcome outcome = log("search a.mcap 'models/ball.position_in_robot.x > 49.5' --json");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const json found = json::parse(outcome.out, nullptr, false);
  ASSERT_EQ(found.at("hits").size(), 1U) << found;
  EXPECT_EQ(found.at("hits")[0].at("robot"), "red1");
  EXPECT_DOUBLE_EQ(found.at("hits")[0].at("time"), 2.0);
  EXPECT_FALSE(found.at("hits")[0].contains("until"));
  const Outcome texts = log("search a.mcap 'log.message =~ \"frame [23]0\"'");
  EXPECT_EQ(texts.status, 0) << texts.errors;
  EXPECT_THAT(texts.out, HasSubstr("red1/cognition/test: frame 20"));
  EXPECT_THAT(texts.out, HasSubstr("2 hits"));
}

TEST_F(RobotctlLog, searchSaysWhereAnExpressionIsWrongAndThatHitsWereLeftOut) {
  const Outcome misspelled = log("search a.mcap 'models/bal.known == 1'");
  EXPECT_EQ(misspelled.status, 2);
  EXPECT_THAT(misspelled.errors, HasSubstr("expression:1:1: "));
  EXPECT_THAT(misspelled.errors, HasSubstr("did you mean 'models/ball'"));
  const Outcome limited = log("search a.mcap 'log.message =~ \"frame\"' --limit 3");
  EXPECT_EQ(limited.status, 3);
  EXPECT_THAT(limited.errors, HasSubstr("--limit"));
}

TEST_F(RobotctlLog, wrongUsageIsTwo) {
  for (const char* arguments :
       {"", "fly", "info", "cut a.mcap", "export a.mcap", "export a.mcap --csv red1/log", "merge a.mcap",
        "filter a.mcap b.mcap --compression rar", "cut a.mcap b.mcap --from nowhere",
        "cut a.mcap b.mcap --from 2 --to 1", "merge a.mcap b.mcap --offset c.mcap=1",
        "merge a.mcap b.mcap --offset a.mcap=x"}) {
    const Outcome outcome = log(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.errors, "") << arguments;
  }
  EXPECT_EQ(log("--help").status, 0);
  EXPECT_EQ(log("cut --help").status, 0);
  EXPECT_EQ(folder_.contents(), "a.mcap");
}

TEST_F(RobotctlLog, infoSaysWhatALogHolds) {
  const json object = info("a.mcap");
  EXPECT_EQ(object.at("frames"), 100);
  EXPECT_EQ(object.at("images"), 100);
  EXPECT_EQ(object.at("messages"), 513);
  EXPECT_NEAR(object.at("duration_s").get<double>(), 3.96, 1e-9);
  EXPECT_EQ(streamOf(object, "red1/camera/image").at("type"), "foxglove.RawImage");
  EXPECT_NEAR(streamOf(object, "red1/camera/image").at("rate_hz").get<double>(), 25, 1e-9);
  const Outcome text = log("info a.mcap");
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.out, HasSubstr("red1/camera/image"));
  EXPECT_EQ(text.errors, "");
}

TEST_F(RobotctlLog, infoOfSeveralIsOneObjectAndTheWorstStatus) {
  std::ofstream(folder_ / "no.mcap") << "this is no log";
  const Outcome outcome = log("info --json a.mcap a.mcap no.mcap");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(json::parse(outcome.out).at("files").size(), 2U);
  EXPECT_THAT(outcome.errors, HasSubstr("no.mcap"));
}

TEST_F(RobotctlLog, aLogWhoseWriterWasKilledIsReadWithLossesUntilItIsRepaired) {
  SampleLog{.close = false}.write(folder_ / "killed.mcap");
  for (const char* command : {"info killed.mcap", "verify killed.mcap", "cut killed.mcap cut.mcap --to 1",
                              "export killed.mcap --texts"}) {
    const Outcome outcome = log(command);
    EXPECT_EQ(outcome.status, 3) << command;
    EXPECT_THAT(outcome.errors, HasSubstr("killed.mcap: ")) << command;
  }
  const Outcome repaired = log("repair killed.mcap whole.mcap");
  EXPECT_EQ(repaired.status, 3) << repaired.errors;
  EXPECT_EQ(log("verify whole.mcap").status, 0);
  EXPECT_EQ(info("whole.mcap").at("images"), 100);
}

TEST_F(RobotctlLog, verifyFindsAByteThatWasFlipped) {
  EXPECT_EQ(log("verify a.mcap").status, 0);
  std::fstream file(folder_ / "a.mcap", std::ios::in | std::ios::out | std::ios::binary);
  const std::string text = textOf(folder_ / "a.mcap");
  const auto place = text.find("frame 10,");
  ASSERT_NE(place, std::string::npos);
  file.seekp(static_cast<std::streamoff>(place));
  file.put('F');
  file.close();
  const Outcome outcome = log("verify a.mcap");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.errors, HasSubstr("at byte "));
  EXPECT_THAT(outcome.out, HasSubstr("readable in part"));
  EXPECT_FALSE(json::parse(log("verify --json a.mcap").out).at("whole"));
}

TEST_F(RobotctlLog, whatIsNoLogFails) {
  std::ofstream(folder_ / "no.mcap") << "this is no log";
  for (const char* command :
       {"info no.mcap", "verify no.mcap", "cut no.mcap out.mcap", "repair no.mcap out.mcap",
        "import no.mcap out.mcap", "export no.mcap --texts", "merge a.mcap no.mcap out.mcap",
        "info none.mcap", "import none.log out.mcap"}) {
    const Outcome outcome = log(command);
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_NE(outcome.errors, "") << command;
  }
  EXPECT_EQ(folder_.contents(), "a.mcap no.mcap");
}

TEST_F(RobotctlLog, aCutIsBySecondsByTheLogsTimeOrByBookmarks) {
  using robotlink::Instant;
  using std::chrono::seconds;
  std::filesystem::remove(folder_ / "a.mcap");
  SampleLog{.start = seconds(100)}.write(folder_ / "a.mcap");
  ASSERT_TRUE(logplayer::writeBookmarksBeside(
      folder_ / "a.mcap", {{7, {{7, Instant(seconds(101)), Instant(seconds(102)), "ball missed"}}}}));
  for (const char* range : {"--from 1 --to 2", "--from @101 --to @102",
                            "--from 'ball missed' --to 'ball missed'", "--from 1 --to 'ball missed'"}) {
    const Outcome outcome = log(std::string("cut a.mcap cut.mcap --force ") + range);
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const json object = info("cut.mcap");
    EXPECT_EQ(object.at("begin"), 101) << range;
    EXPECT_EQ(object.at("end"), 102) << range;
    EXPECT_EQ(object.at("frames"), 26) << range;
    EXPECT_EQ(object.at("bookmarks").at(0).at("text"), "ball missed");
    EXPECT_EQ(streamOf(object, "scene").at("count"), 1) << "what holds is at its start";
  }
}

TEST_F(RobotctlLog, nothingIsOverwrittenUnlessItIsForced) {
  ASSERT_EQ(log("cut a.mcap out.mcap --to 1").status, 0);
  const std::string before = textOf(folder_ / "out.mcap");
  for (const char* command :
       {"cut a.mcap out.mcap", "filter a.mcap out.mcap", "merge a.mcap out.mcap", "repair a.mcap out.mcap",
        "export a.mcap --csv red1/log out.mcap", "export a.mcap --texts --output out.mcap"}) {
    const Outcome outcome = log(command);
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_THAT(outcome.errors, HasSubstr("--force")) << command;
  }
  EXPECT_EQ(textOf(folder_ / "out.mcap"), before);
  EXPECT_EQ(log("filter a.mcap out.mcap --force").status, 0);
  EXPECT_NE(textOf(folder_ / "out.mcap"), before);
  EXPECT_EQ(folder_.contents(), "a.mcap out.mcap");
}

TEST_F(RobotctlLog, filterKeepsTheStreamsThatAreNamed) {
  ASSERT_EQ(log("filter a.mcap out.mcap --streams 'red1/*' --exclude '*/camera/image' --exclude '*/joints/*'")
                .status,
            0);
  const json object = info("out.mcap");
  EXPECT_EQ(object.at("images"), 0);
  EXPECT_EQ(object.at("frames"), 100);
  EXPECT_EQ(streamOf(object, "red1/models/ball").at("count"), 100);
  EXPECT_EQ(streamOf(object, "red1/joints/states").at("count"), 0);
  EXPECT_EQ(streamOf(object, "scene").at("count"), 0);
  EXPECT_EQ(log("filter a.mcap none.mcap --streams 'green/*'").status, 1);
}

TEST_F(RobotctlLog, mergePutsLogsOnOneTimeLine) {
  SampleLog{.frames = 10}.write(folder_ / "b.mcap");
  const Outcome outcome = log("merge a.mcap b.mcap out.mcap --offset b.mcap=10");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.out, HasSubstr("b.mcap: red1 is called red1-2"));
  const json object = info("out.mcap");
  EXPECT_EQ(object.at("robots"), json({"red1", "red1-2"}));
  EXPECT_NEAR(object.at("end").get<double>(), 10.36, 1e-9);
}

TEST_F(RobotctlLog, twoCutsAreMergedIntoOneLog) {
  ASSERT_EQ(log("cut a.mcap b.mcap --to 2").status, 0);
  ASSERT_EQ(log("cut a.mcap c.mcap --from 2").status, 0);
  const Outcome outcome = log("merge b.mcap c.mcap out.mcap");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.out, HasSubstr("one after another"));
  const json before = info("a.mcap"), after = info("out.mcap");
  for (const char* figure : {"robots", "messages", "frames", "begin", "end"})
    EXPECT_EQ(after.at(figure), before.at(figure)) << figure;
  const Outcome separate = log("merge --separate b.mcap c.mcap two.mcap");
  EXPECT_THAT(separate.out, HasSubstr("c.mcap: red1 is called red1-2"));
  EXPECT_EQ(log("merge --concatenate a.mcap b.mcap no.mcap").status, 1);
  EXPECT_EQ(log("merge --concatenate --separate b.mcap c.mcap no.mcap").status, 2);
}

TEST_F(RobotctlLog, convertWritesOtherChunksAndCompression) {
  ASSERT_EQ(log("convert a.mcap b.mcap --compression none --chunk-size 2k").status, 0);
  const json before = info("a.mcap"), after = info("b.mcap");
  EXPECT_GT(after.at("chunks"), 5);
  EXPECT_EQ(after.at("compressions").at("none"), after.at("chunks"));
  EXPECT_EQ(after.at("messages"), before.at("messages"));
  ASSERT_EQ(log("convert b.mcap c.mcap").status, 0);
  EXPECT_EQ(info("c.mcap").at("compressions").at("zstd"), info("c.mcap").at("chunks"));
  EXPECT_EQ(log("convert a.mcap d.mcap --chunk-size 0").status, 2);
  EXPECT_EQ(log("convert a.mcap d.mcap --chunk-size many").status, 2);
}

TEST_F(RobotctlLog, aLogIsReadFromStandardInput) {
  EXPECT_EQ(json::parse(log("info --json - <a.mcap").out).at("frames"), 100);
  EXPECT_EQ(log("verify - <a.mcap").status, 0);
  EXPECT_EQ(log("export - --csv red1/log - <a.mcap").out, log("export a.mcap --csv red1/log -").out);
  ASSERT_EQ(log("cut - cut.mcap --from 1 --to 2 <a.mcap").status, 0);
  EXPECT_EQ(info("cut.mcap").at("frames"), 26);
  EXPECT_EQ(log("info - </dev/null").status, 1);
  EXPECT_EQ(runRobotctl(folder_.path(), "run --platform log:- <a.mcap").status, 0);
}

TEST_F(RobotctlLog, bookmarksAreAddedListedAndRemoved) {
  ASSERT_EQ(log("bookmark a.mcap --add 'ball missed' --from 1 --to 2").status, 0);
  ASSERT_EQ(log("bookmark a.mcap --add fell --from @3").status, 0);
  EXPECT_EQ(log("bookmark a.mcap").out, "1.000 s to 2.000 s  ball missed\n3.000 s  fell\n");
  EXPECT_EQ(info("a.mcap").at("bookmarks").size(), 2U);
  ASSERT_EQ(log("bookmark a.mcap --remove fell").status, 0);
  EXPECT_EQ(json::parse(log("bookmark --json a.mcap").out).size(), 1U);
  EXPECT_EQ(log("bookmark a.mcap --remove fell").status, 1);
  EXPECT_EQ(log("bookmark a.mcap --add nowhere").status, 2);
  EXPECT_EQ(log("bookmark - --add x --from 1 <a.mcap").status, 2);
}

TEST_F(RobotctlLog, attachmentsAreAddedListedAndTakenOut) {
  std::ofstream(folder_ / "note.txt") << "a note";
  ASSERT_EQ(log("attachment a.mcap --add note.txt").status, 0);
  EXPECT_EQ(log("attachment a.mcap").out, "note.txt  text/plain  6 bytes\n");
  ASSERT_EQ(log("attachment a.mcap --extract note.txt --output out.txt").status, 0);
  EXPECT_EQ(textOf(folder_ / "out.txt"), "a note");
  EXPECT_EQ(log("attachment a.mcap --extract note.txt").status, 1) << "it exists";
  EXPECT_EQ(log("attachment a.mcap --extract none").status, 1);
  EXPECT_EQ(log("verify a.mcap").status, 0);
}

TEST_F(RobotctlLog, timesOfThisCenturyAreDates) {
  std::filesystem::remove(folder_ / "a.mcap");
  SampleLog{.start = std::chrono::seconds(1'700'000'000)}.write(folder_ / "a.mcap");
  EXPECT_THAT(log("info a.mcap").out,
              HasSubstr("2023-11-14 22:13:20.000 UTC to 2023-11-14 22:13:23.960 UTC, 3.960 s long"));
  EXPECT_EQ(info("a.mcap").at("begin_date"), "2023-11-14 22:13:20.000 UTC");
  EXPECT_THAT(log("export a.mcap --texts").out,
              HasSubstr("2023-11-14 22:13:20.400 UTC  warning  red1/cognition/test: frame 10"));
  ASSERT_EQ(log("cut a.mcap cut.mcap --from 2023-11-14T22:13:21 --to '2023-11-14 22:13:22'").status, 0);
  EXPECT_EQ(info("cut.mcap").at("frames"), 26);
}

TEST_F(RobotctlLog, aRobotsNameIsOneWord) {
  for (const char* name : {"a/b", "''", "'red 1'", "'*'"}) {
    const Outcome outcome = log(std::string("import a.log b.mcap --robot ") + name);
    EXPECT_EQ(outcome.status, 2) << name;
    EXPECT_THAT(outcome.errors, HasSubstr("is not a robot name")) << name;
    EXPECT_EQ(
        runRobotctl(folder_.path(), std::string("run --platform tcp://localhost --robot ") + name).status, 2)
        << name;
  }
}

TEST_F(RobotctlLog, logsOfOtherProgramsAreReadAsFarAsTheyCanBe) {
  ASSERT_TRUE(logplayer::tests::writeForeignLog(folder_ / "foreign.mcap"));
  EXPECT_THAT(log("info foreign.mcap").out, HasSubstr("flatbuffer, not decoded"));
  EXPECT_THAT(log("export foreign.mcap --texts").out, HasSubstr("battery low"));
  const Outcome csv = log("export foreign.mcap --csv a/b/c -");
  EXPECT_EQ(csv.status, 3) << "a row lacks";
  EXPECT_THAT(csv.errors, HasSubstr("1 message of a/b/c could not be read"));
  EXPECT_EQ(log("export foreign.mcap --csv /camera c.csv").status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "c.csv"));
  EXPECT_THAT(log("export foreign.mcap --json /rosout -").out, HasSubstr(R"("message":"battery low")"));
  // It can be played, and nothing runs on it.
  const Outcome played = runRobotctl(folder_.path(), "run --json --platform log:foreign.mcap");
  EXPECT_EQ(json::parse(played.out, nullptr, false).at("packages").size(), 0U) << played.errors;
  EXPECT_THAT(played.errors, HasSubstr("contains no known robot"));
}

TEST_F(RobotctlLog, aFileNameThatIsNoUtf8DoesNotSpoilTheJson) {
  std::filesystem::copy_file(folder_ / "a.mcap", folder_ / "sp\xFCl.mcap");
  const Outcome played = runRobotctl(folder_.path(), "run --json --platform log:sp\xFCl.mcap");
  EXPECT_EQ(played.status, 0) << played.errors;
  EXPECT_THAT(played.out, HasSubstr("sp\xEF\xBF\xBDl.mcap"));
}

TEST_F(RobotctlLog, anOffsetIsNotOutOfTheRangeOfTimes) {
  EXPECT_EQ(runRobotctl(folder_.path(), "run --platform log:a.mcap --offset 1e300").status, 2);
  EXPECT_EQ(log("merge a.mcap a.mcap b.mcap --offset a.mcap=8e9").status, 2);
}

TEST_F(RobotctlLog, exportsImagesTablesAndTexts) {
  const Outcome images = log("export a.mcap --images pictures --from 1 --to 2");
  ASSERT_EQ(images.status, 0) << images.errors;
  EXPECT_THAT(images.out, HasSubstr("26 images"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "pictures/red1-camera-image-0000000001.000000-00026.png"));
  ASSERT_EQ(log("export a.mcap --csv red1/joints/states joints.csv").status, 0);
  EXPECT_THAT(textOf(folder_ / "joints.csv"),
              HasSubstr("log_time,log_process,log_frame,joints[0].name,joints[0].position\r\n"
                        "0.000000000,platform,1,head_pan,0\r\n"));
  EXPECT_EQ(log("export a.mcap --csv red1/joints/states -").out, textOf(folder_ / "joints.csv"));
  const Outcome texts = log("export a.mcap --texts");
  EXPECT_EQ(texts.status, 0);
  EXPECT_THAT(texts.out, HasSubstr("    0.400000  warning  red1/cognition/test: frame 10"));
  EXPECT_EQ(log("export a.mcap --csv red1/none none.csv").status, 1);
}

TEST_F(RobotctlLog, theExampleInPythonPlotsValues) {
  const auto plot = [&](const std::string& arguments) {
    return runShell(folder_.path(), "ROBOTCTL=" ROBOTCTL " /usr/bin/python3 " ROBOTCONTROL_SOURCE_DIR
                                    "/resources/examples/plot_log.py a.mcap " +
                                        arguments + " --output plot.svg");
  };
  const Outcome plotted = plot("red1/models/ball.position_in_robot.x");
  EXPECT_EQ(plotted.status, 0) << plotted.errors;
  EXPECT_THAT(plotted.out, HasSubstr("red1/models/ball.position_in_robot.x: "));
  EXPECT_THAT(textOf(folder_ / "plot.svg"), HasSubstr("</svg>"));
  EXPECT_THAT(plot("red1/models/ball.size").errors, HasSubstr("has no numbers"));
  EXPECT_THAT(plot("red1/models/ball").errors, HasSubstr("has no field"));
  EXPECT_THAT(plot("'red1/models/ball.x[y'").errors, HasSubstr("cannot be read from \"[y\" on"));
}

TEST_P(RobotctlWholeLog, aLogOf2009IsDescribedImportedCutAndExported) {
  const bool real = GetParam() == "real";
  const auto data = game::dataOf(GetParam());
  const std::string file = "'" + (data / "logs/bhuman2009.log").string() + "'",
                    table = "'" + (data / "colour/bhuman2009/tables/default.c64").string() + "'";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "the real log is not in " << data;
  const std::uint64_t images = real ? 160 : game::View::kCount;
  const std::uint64_t frames = real ? 434 : game::Log::kFrames;
  const json original = info(file);
  EXPECT_EQ(original.at("images"), images);
  EXPECT_EQ(original.at("frames"), frames);
  const Outcome imported =
      log("import " + file + " whole.mcap --robot nao5 --color-table " + table + " --json");
  ASSERT_EQ(imported.status, 0) << imported.errors;
  EXPECT_EQ(json::parse(imported.out).at("messages"), real ? 2444U : game::Log::kMessages);
  EXPECT_EQ(json::parse(imported.out).at("imported").at("JPEGImage"), images);
  const json converted = info("whole.mcap");
  EXPECT_EQ(converted.at("robots"), json({"nao5"}));
  EXPECT_EQ(converted.at("frames"), frames);
  const double length = real ? 10 : 0.6;
  ASSERT_EQ(log("cut whole.mcap cut.mcap --from " + std::to_string(0.5 * length) + " --to " +
                std::to_string(1.5 * length))
                .status,
            0);
  EXPECT_NEAR(info("cut.mcap").at("duration_s").get<double>(), length, real ? 0.3 : 0.07);
  EXPECT_EQ(streamOf(info("cut.mcap"), "nao5/colors/table").at("count"), 1);
  const Outcome exported = log("export " + file + " --images pictures");
  ASSERT_EQ(exported.status, 0) << exported.errors;
  EXPECT_THAT(exported.out, HasSubstr(std::to_string(images) + " images"));
  expectComputedHits(file);
}

INSTANTIATE_TEST_SUITE_P(Logs, RobotctlWholeLog, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });
