// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/PlatformAdapter.h"

#include <gtest/gtest.h>

#include "app/core/Workbench.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/TestFolder.h"
#include "tests/app/ServedWorld.h"
#include "tests/app/TickUntil.h"

using namespace app;

namespace {

std::string opensIt(const std::string& source) {
  const PlatformAdapter* adapter = adapterFor(source);
  return adapter != nullptr ? adapter->name : "";
}

std::string drivingOf(Workbench& workbench) {
  const auto* table = workbench.session().store().latestAs<robotcontrol::SolutionTable>(
      "p3at1/tables/solutions", workbench.session().timeline().newest());
  for (int i = 0; table != nullptr && i < table->tasks_size(); ++i) {
    if (table->tasks(i).name() == "driving") return table->tasks(i).active();
  }
  return {};
}

}  // namespace

TEST(PlatformAdapter, filesAndAddressesAreOpenedByWhoeverIsRegisteredForThem) {
  ASSERT_EQ(platformAdapters().size(), 3U);
  EXPECT_EQ(opensIt("field2002.sdf"), "simulation");
  EXPECT_EQ(opensIt("/home/somebody/house.map"), "simulation");
  EXPECT_EQ(opensIt("/media/DISK/HOUSE.MAP"), "simulation");
  EXPECT_EQ(opensIt("Arena.World"), "simulation");
  EXPECT_EQ(opensIt("tcp://localhost:8101"), "pioneer");
  EXPECT_EQ(opensIt("serial:///dev/ttyUSB0"), "pioneer");
  EXPECT_EQ(opensIt("localhost:8101"), "pioneer");
  EXPECT_EQ(opensIt("game.mcap"), "log");
  EXPECT_EQ(opensIt("no-such-file"), "log") << "which is told to be none when it is opened";
}

TEST(PlatformAdapter, whatAPersonChoseForARobotHoldsWhenItIsConnectedAgain) {
  const ServedWorld world;
  const TestFolder home;
  Workbench workbench(home.path());
  std::string errors;
  workbench.onErrors([&](const robotlink::Errors& reported) { errors += robotlink::describe(reported); });
  const auto connect = [&] {
    workbench.connectRobot({.url = world.url()});
    return test::tickUntil(workbench, [&] {
      return !workbench.loading() && workbench.loaded() != nullptr && !drivingOf(workbench).empty();
    });
  };
  ASSERT_TRUE(connect()) << errors;
  EXPECT_TRUE(workbench.loaded()->isReal());
  EXPECT_EQ(workbench.loaded()->field, nullptr) << "no soccer field for a robot in a house";
  ASSERT_NE(drivingOf(workbench), "wander");
  robotcontrol::Request request;
  request.set_robot("p3at1");
  request.mutable_select_solution()->set_task("driving");
  request.mutable_select_solution()->set_solution("wander");
  workbench.ask(request);
  ASSERT_TRUE(test::tickUntil(workbench, [&] { return drivingOf(workbench) == "wander"; })) << errors;
  workbench.close();
  ASSERT_TRUE(test::tickUntil(workbench, [&] { return !workbench.loaded()->time; })) << errors;
  ASSERT_TRUE(connect()) << errors;
  EXPECT_TRUE(test::tickUntil(workbench, [&] { return drivingOf(workbench) == "wander"; })) << errors;
}
