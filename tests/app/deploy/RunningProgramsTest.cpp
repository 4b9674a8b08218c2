// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/RunningPrograms.h"

#include <gmock/gmock.h>

namespace app {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RunningPrograms, eachRobotWaitsForWhatItsProgramReadsAtItsStart) {
  RunningPrograms programs;
  programs.set({{"red1", "ers210", "compact.yaml"}, {"p3at1", "p3at", "drive.yaml"}});
  for (const char* path :
       {"layouts/compact.yaml", "layouts/other.yaml", "parameters/ers210/motion.a.textproto",
        "motions/sit.mof", "colortables/red1.c64", "presets/red1.preset.json", "presets/red2.preset.json"})
    programs.noteWritten(path);
  auto all = programs.programs();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].robot, "p3at1");
  EXPECT_THAT(all[0].waiting, ElementsAre("motions/sit.mof"));
  EXPECT_THAT(all[1].waiting,
              ElementsAre("layouts/compact.yaml", "motions/sit.mof", "parameters/ers210/motion.a.textproto",
                          "presets/red1.preset.json"));
  programs.noteStarted("red1");
  EXPECT_THAT(programs.programs()[1].waiting, IsEmpty());
  EXPECT_THAT(programs.programs()[0].waiting, ElementsAre("motions/sit.mof"));
  // What is written later is not read yet; in another layout, that one counts.
  programs.set({{"red1", "ers210", "other.yaml"}});
  programs.noteWritten("layouts/other.yaml");
  EXPECT_THAT(programs.programs()[0].waiting, ElementsAre("layouts/other.yaml"));
}

}  // namespace
}  // namespace app
