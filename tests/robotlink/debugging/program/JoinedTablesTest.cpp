// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/JoinedTables.h"

#include <gtest/gtest.h>

#include "robotlink/debugging/SharedDebugQueue.h"

namespace robotlink {
namespace {

using robotcontrol::KeyMode;
using robotcontrol::KeyTable;
using robotcontrol::SolutionTable;

/// A table with one key.
KeyTable tableOf(const std::string& name, KeyMode::Kind mode, bool inUse, const std::string& solution) {
  KeyTable table;
  KeyTable::Key& key = *table.add_keys();
  key.set_name(name);
  key.mutable_mode()->set_kind(mode);
  key.set_in_use(inUse);
  key.add_solutions(solution);
  return table;
}

SolutionTable tasks(std::initializer_list<const char*> names) {
  SolutionTable table;
  for (const char* name : names) table.add_tasks()->set_name(name);
  return table;
}

TEST(JoinedTables, aKeyOfSeveralProcessesIsOnAndInUseIfItIsInOne) {
  JoinedTables tables;
  tables.setKeys("cognition", tableOf("key", KeyMode::OFF, false, "a/one"));
  tables.setKeys("motion", tableOf("key", KeyMode::ALWAYS, false, "b/two"));
  tables.setKeys("path", tableOf("key", KeyMode::EVERY_N, true, "c/three"));
  tables.setKeys("first", tableOf("another", KeyMode::OFF, false, "d/four"));
  KeyTable joined;
  tables.fillKeys(joined);
  ASSERT_EQ(joined.keys_size(), 2);
  EXPECT_EQ(joined.keys(0).name(), "another") << "sorted by name";
  EXPECT_FALSE(joined.keys(0).in_use());
  EXPECT_EQ(joined.keys(1).mode().kind(), KeyMode::ALWAYS) << "the first that is on";
  EXPECT_TRUE(joined.keys(1).in_use());
  EXPECT_EQ(joined.keys(1).solutions_size(), 3);
  EXPECT_FALSE(tables.takeKeysChanged());
}

TEST(JoinedTables, solutionsComeInTheOrderOfTheProcesses) {
  JoinedTables tables;
  tables.setSolutions("cognition", tasks({"ball", "behavior"}));
  tables.setSolutions("motion", tasks({"walk"}));
  SolutionTable joined;
  tables.fillSolutions({"motion", "none", "cognition"}, joined);
  ASSERT_EQ(joined.tasks_size(), 3);
  EXPECT_EQ(joined.tasks(0).name(), "walk");
  EXPECT_EQ(joined.tasks(2).name(), "behavior");
}

TEST(JoinedTables, aQueueReplacesTheTablesOfItsProcess) {
  JoinedTables tables;
  tables.setSolutions("motion", tasks({"walk"}));
  SharedDebugQueue queue;
  queue.process = "motion";
  queue.add<robotcontrol::PlotValue>("plots/x");
  tables.notice(queue);
  EXPECT_FALSE(tables.takeKeysChanged() || tables.takeSolutionsChanged());
  queue.add<SolutionTable>("tables/solutions") = tasks({"run", "stand"});
  queue.add<KeyTable>("tables/keys");
  tables.notice(queue);
  EXPECT_TRUE(tables.takeSolutionsChanged());
  EXPECT_FALSE(tables.takeSolutionsChanged());
  EXPECT_TRUE(tables.takeKeysChanged());
  SolutionTable joined;
  tables.fillSolutions({"motion"}, joined);
  EXPECT_EQ(joined.tasks_size(), 2);
}

}  // namespace
}  // namespace robotlink
