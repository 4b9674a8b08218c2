// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/RunPlan.h"

#include <gtest/gtest.h>

#include <set>

#include "app/robotctl/compare/RunInputs.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

class RunFilesTest : public testing::Test {
 protected:
  static PlannedRun runOn(const std::string& subject, const std::string& variant = "filtered") {
    return {variant, subject, {"run", "log:" + subject}};
  }
  std::string nameOf(const PlannedRun& run) const { return files_.result(run).filename().string(); }

  const TestFolder folder_;
  const RunFiles files_ = RunFiles::in(folder_ / "runs").value();
};

TEST_F(RunFilesTest, filesOfARunLieTogetherAndHaveItsName) {
  const PlannedRun run = runOn("seed 1");
  EXPECT_EQ(nameOf(run), "filtered--seed-1.json");
  EXPECT_EQ(files_.unfinished(run).filename(), "filtered--seed-1.json.part");
  EXPECT_EQ(files_.texts(run).parent_path(), files_.folder());
  EXPECT_TRUE(files_.folder().is_absolute());
}

TEST_F(RunFilesTest, runsThatDifferInASignHaveFilesOfTheirOwn) {
  std::set<std::string> names;
  const std::vector<std::string> logs{"game-1.mcap",     "game 1.mcap",     "game/1.mcap",
                                      "game:1.mcap",     "t\u00fcr.mcap",   "t\u00f6r.mcap",
                                      "/logs/game.mcap", "/other/game.mcap"};
  for (const std::string& log : logs) {
    const std::string name = nameOf(runOn(log));
    EXPECT_EQ(name.find('/'), std::string::npos);
    names.insert(name);
  }
  EXPECT_EQ(names.size(), logs.size());
}

TEST_F(RunFilesTest, theResultOfOneLogIsNotThatOfAnother) {
  const PlannedRun first = runOn("t\u00fcr.mcap"), second = runOn("t\u00f6r.mcap");
  for (const PlannedRun& run : {first, second}) {
    ASSERT_TRUE(files_.prepare(run));
    ASSERT_TRUE(robotlink::writeFileAtomically(files_.unfinished(run), run.subject));
    ASSERT_TRUE(files_.finish(run));
  }
  EXPECT_TRUE(files_.isDone(first));
  EXPECT_TRUE(files_.isDone(second));
  EXPECT_EQ(robotlink::readFile(files_.result(first)).value_or(""), first.subject);
}

TEST_F(RunFilesTest, longNamesAreShortenedAndKeptApart) {
  const std::string folder = "/" + std::string(300, 'a') + "/";
  const PlannedRun first = runOn(folder + "game.mcap", std::string(300, 'v')),
                   second = runOn(folder + "b/game.mcap", std::string(300, 'v')),
                   third = runOn("seed 1", std::string(300, 'w'));
  EXPECT_EQ(std::set<std::string>({nameOf(first), nameOf(second), nameOf(third)}).size(), 3U);
  EXPECT_NE(nameOf(first).find("game.mcap"), std::string::npos) << "people know it by this";
  for (const PlannedRun& run : {first, second, third}) {
    ASSERT_TRUE(files_.prepare(run));
    ASSERT_TRUE(robotlink::writeFileAtomically(files_.unfinished(run), run.subject));
    ASSERT_TRUE(files_.finish(run));
    EXPECT_TRUE(files_.isDone(run));
  }
}

TEST_F(RunFilesTest, aNameLeadsNowhereElse) {
  const PlannedRun run = runOn("../../secret", "..");
  EXPECT_EQ(files_.result(run).parent_path(), files_.folder());
  EXPECT_TRUE(files_.prepare(run));
  EXPECT_EQ(folder_.contents(), "runs");
}

TEST_F(RunFilesTest, aResultWithoutTheCommandThatMadeItDoesNotCount) {
  const PlannedRun run = runOn("seed 1");
  ASSERT_TRUE(robotlink::writeFileAtomically(files_.result(run), "{}"));
  EXPECT_FALSE(files_.isDone(run)) << "nobody knows of what it is";
  ASSERT_TRUE(files_.prepare(run));
  EXPECT_FALSE(files_.isDone(run)) << "it was removed";
}

TEST_F(RunFilesTest, aResultDoesNotCountOnceWhatItDependsOnHasChanged) {
  const std::filesystem::path layout = folder_ / "mine.yaml";
  PlannedRun run = runOn("seed 1");
  run.arguments.push_back("red=" + layout.string());
  ASSERT_TRUE(robotlink::writeFileAtomically(layout, "one"));
  run.inputs = inputsOf(run);
  EXPECT_EQ(inputsOf(run), run.inputs);
  ASSERT_TRUE(files_.prepare(run));
  ASSERT_TRUE(robotlink::writeFileAtomically(files_.unfinished(run), "{}"));
  ASSERT_TRUE(files_.finish(run));
  EXPECT_TRUE(files_.isDone(run));
  ASSERT_TRUE(robotlink::writeFileAtomically(layout, "another"));
  run.inputs = inputsOf(run);
  EXPECT_FALSE(files_.isDone(run));
}

TEST_F(RunFilesTest, jobsInOtherFoldersFindFilesByTheirWholePaths) {
  folder_.write("scene.sdf", "");
  const auto relative = std::filesystem::relative(folder_ / "scene.sdf");
  EXPECT_TRUE(std::filesystem::path(wholePath(relative.string())).is_absolute());
  EXPECT_EQ(wholePath("no-file-but-a-shipped-scene"), "no-file-but-a-shipped-scene");
}

TEST_F(RunFilesTest, anUnfinishedRunIsNoResult) {
  const PlannedRun run = runOn("seed 1");
  ASSERT_TRUE(files_.prepare(run));
  const auto none = files_.finish(run);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text.find("cannot write " + files_.result(run).string()), std::string::npos)
      << none.error().text;
  ASSERT_TRUE(robotlink::writeFileAtomically(files_.unfinished(run), "{}"));
  EXPECT_FALSE(files_.isDone(run));
}

}  // namespace
}  // namespace app
