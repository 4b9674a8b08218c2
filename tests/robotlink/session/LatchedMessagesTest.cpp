// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/LatchedMessages.h"

#include <gtest/gtest.h>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Perception.pb.h"

using namespace robotlink;

namespace {

StreamMessage message(const std::string& path, PackagePtr value, int ms, const std::string& process = {}) {
  return {path, Instant(std::chrono::milliseconds(ms)), std::move(value), process};
}

std::vector<std::string> paths(const LatchedMessages& held) {
  std::vector<std::string> result;
  for (const StreamMessage& each : held.all()) result.push_back(each.path);
  return result;
}

}  // namespace

TEST(LatchedMessages, keepTheNewestOfEachStreamAndProcessThatHolds) {
  LatchedMessages held;
  held.take(message("scene", std::make_shared<foxglove::SceneUpdate>(), 1));
  held.take(message("red1/drawings/field/ball", std::make_shared<foxglove::SceneUpdate>(), 1));
  held.take(message("red1/program", std::make_shared<robotcontrol::ProgramSetup>(), 1));
  held.take(message("red1/colors/table", std::make_shared<robotcontrol::ColorTable>(), 1));
  held.take(message("red1/plots/x", std::make_shared<robotcontrol::PlotValue>(), 1));
  held.take(message("red1/tables/keys", std::make_shared<robotcontrol::KeyTable>(), 1, "debug"));
  held.take(message("red1/tables/keys", std::make_shared<robotcontrol::KeyTable>(), 7, "debug"));
  held.take(message("red1/tables/keys", nullptr, 9, "debug"));
  EXPECT_EQ(paths(held),
            (std::vector<std::string>{"red1/colors/table", "red1/program", "red1/tables/keys", "scene"}));
  EXPECT_EQ(held.all()[2].time, Instant(std::chrono::milliseconds(7)));
}

TEST(LatchedMessages, forgetARobotWhoseProgramStartsAnew) {
  LatchedMessages held;
  held.take(message("scene", std::make_shared<foxglove::SceneUpdate>(), 1));
  held.take(message("red1/program", std::make_shared<robotcontrol::ProgramSetup>(), 1));
  held.take(message("red10/program", std::make_shared<robotcontrol::ProgramSetup>(), 1));
  held.forget("red1");
  EXPECT_EQ(paths(held), (std::vector<std::string>{"red10/program", "scene"}));
}
