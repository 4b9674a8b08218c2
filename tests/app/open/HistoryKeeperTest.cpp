// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/HistoryKeeper.h"

#include <gmock/gmock.h>

#include "robotlink/session/Session.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

constexpr std::uint64_t kGib = std::uint64_t{1} << 30U;

class HistoryKeeperTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "history.json"; }

  const TestFolder folder_;
  robotlink::Session session_;
};

TEST_F(HistoryKeeperTest, keepsAGibibyteInMemoryAndFourOnDiskAtFirst) {
  const HistoryKeeper keeper(session_, file());
  EXPECT_EQ(keeper.memory(), kGib);
  EXPECT_EQ(keeper.disk(), 4 * kGib);
  EXPECT_FALSE(std::filesystem::exists(file())) << "nobody has chosen anything";
}

TEST_F(HistoryKeeperTest, onlyWhatNothingElseKeepsIsPutOnDisk) {
  HistoryKeeper keeper(session_, file());
  EXPECT_EQ(session_.history().archive(), nullptr);
  EXPECT_FALSE(keeper.isLosing());
  keeper.setLive(true);
  const auto* archive = session_.history().archive();
  ASSERT_NE(archive, nullptr);
  keeper.setLive(true);
  EXPECT_EQ(session_.history().archive(), archive) << "what was kept stays";
  keeper.setLive(false);
  EXPECT_EQ(session_.history().archive(), nullptr);
}

TEST_F(HistoryKeeperTest, theSessionOutlivesIt) {
  {
    HistoryKeeper keeper(session_, file());
    keeper.setLive(true);
  }
  EXPECT_EQ(session_.history().archive(), nullptr);
}

TEST_F(HistoryKeeperTest, memoryHasALeastAndAMost) {
  HistoryKeeper keeper(session_, file());
  EXPECT_TRUE(keeper.setMemory(HistoryKeeper::kMinMemory));
  EXPECT_TRUE(keeper.setMemory(HistoryKeeper::kMaxMemory));
  EXPECT_EQ(keeper.setMemory(HistoryKeeper::kMinMemory - 1).error().id, "history.memory");
  EXPECT_FALSE(keeper.setMemory(HistoryKeeper::kMaxMemory + 1));
  EXPECT_EQ(keeper.memory(), HistoryKeeper::kMaxMemory);
}

TEST_F(HistoryKeeperTest, sizesInAFileThatMakeNoSenseAreBroughtIntoTheirRange) {
  folder_.write("history.json", R"({"format": "robotcontrol-settings", "version": 1,
                                    "settings": {"memory_mib": 1, "disk_mib": -5}})");
  HistoryKeeper keeper(session_, file());
  EXPECT_EQ(keeper.memory(), HistoryKeeper::kMinMemory);
  EXPECT_EQ(keeper.disk(), 0U);
  EXPECT_FALSE(keeper.takeProblem());
}

TEST_F(HistoryKeeperTest, aFileThatCannotBeReadIsReportedOnceAndKept) {
  folder_.write("history.json", "rubbish");
  HistoryKeeper keeper(session_, file());
  EXPECT_EQ(keeper.memory(), kGib);
  EXPECT_TRUE(keeper.takeProblem());
  EXPECT_FALSE(keeper.takeProblem());
  EXPECT_EQ(folder_.contents(), "history.json.broken");
}

TEST_F(HistoryKeeperTest, whatCannotBeRememberedCountsAllTheSame) {
  folder_.write("taken", "no folder");
  HistoryKeeper keeper(session_, folder_ / "taken" / "history.json");
  EXPECT_FALSE(keeper.setMemory(2 * kGib));
  EXPECT_EQ(keeper.memory(), 2 * kGib);
}

}  // namespace
}  // namespace app
