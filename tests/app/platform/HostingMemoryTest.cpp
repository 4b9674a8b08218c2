// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/HostingMemory.h"

#include <gtest/gtest.h>

#include "tests/TestFolder.h"

namespace app {
namespace {

TEST(HostingMemory, choicesAreThereAgainInTheNextRun) {
  const TestFolder folder;
  const HostingChoices choices{true, {"red2"}, false};
  {
    HostingMemory memory(folder / "hosting.json");
    EXPECT_EQ(memory.choices("simulation"), HostingChoices());
    memory.choose("simulation", choices);
    memory.choose("pioneer", {.threads = true});
    EXPECT_TRUE(memory.save());
  }
  const HostingMemory memory(folder / "hosting.json");
  EXPECT_EQ(memory.choices("simulation"), choices);
  EXPECT_TRUE(memory.choices("simulation").isOwn("red1"));
  EXPECT_FALSE(memory.choices("simulation").isOwn("red2"));
  EXPECT_TRUE(memory.choices("pioneer").threads);
}

TEST(HostingMemory, whatTeamsOfASceneRunIsThereAgain) {
  const TestFolder folder;
  const TeamPrograms programs{{{"burger", "/d.yaml"}},
                              {{"red", "/layouts/a b.yaml"}, {"blue2", "/c.yaml"}, {"burger", "/e.yaml"}},
                              {{"blue", {{"behavior", "stand"}, {"motion", "crawl"}}}}};
  {
    HostingMemory memory(folder / "hosting.json");
    EXPECT_FALSE(memory.teamPrograms("/scenes/a.sdf"));
    memory.chooseTeamPrograms("/scenes/b.sdf", {});
    EXPECT_FALSE(memory.teamPrograms("/scenes/b.sdf")) << "nothing was chosen";
    memory.chooseTeamPrograms("/scenes/a.sdf", programs);
    EXPECT_TRUE(memory.save());
  }
  HostingMemory memory(folder / "hosting.json");
  EXPECT_EQ(memory.teamPrograms("/scenes/a.sdf"), programs);
  EXPECT_FALSE(memory.teamPrograms("/scenes/b.sdf"));
  memory.chooseTeamPrograms("/scenes/a.sdf", {});
  EXPECT_EQ(memory.teamPrograms("/scenes/a.sdf"), TeamPrograms());
}

TEST(HostingMemory, aDamagedFileIsPutAside) {
  const TestFolder folder;
  folder.write("hosting.json", "nonsense");
  HostingMemory memory(folder / "hosting.json");
  EXPECT_EQ(memory.choices("simulation"), HostingChoices());
  memory.choose("simulation", {.ownProcesses = true});
  EXPECT_TRUE(memory.save());
  EXPECT_TRUE(HostingMemory(folder / "hosting.json").choices("simulation").ownProcesses);
}

TEST(HostingMemory, whatCannotBeWrittenIsSaidOnce) {
  const TestFolder folder;
  folder.write("file", "");
  HostingMemory memory(folder / "file/hosting.json");
  memory.choose("simulation", {.threads = true});
  EXPECT_FALSE(memory.save());
  EXPECT_TRUE(memory.save());
}

}  // namespace
}  // namespace app
