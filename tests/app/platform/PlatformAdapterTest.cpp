// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PlatformAdapter.h"

#include <gtest/gtest.h>

#include <set>

#include "app/core/Workbench.h"
#include "app/platforms/pioneer/PioneerOptions.h"
#include "app/platforms/real/RealFeed.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/TestFolder.h"
#include "tests/app/TickUntil.h"
#include "tests/app/served/ServedWorld.h"

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

TEST(PlatformAdapter, formsAreWhole) {
  const TestFolder home;
  Workbench workbench(home.path());
  for (const PlatformAdapter& adapter : platformAdapters()) {
    const PlatformForm form = formOf(adapter);
    if (adapter.command != nullptr) {
      EXPECT_NE(workbench.commands().find(adapter.command), nullptr) << adapter.command;
    }
    if (form.name.empty()) continue;
    EXPECT_NE(workbench.commands().find(form.command), nullptr) << form.command;
    std::set<std::string> names, places;
    int sources = 0;
    for (const PlatformField& field : form.fields) {
      EXPECT_TRUE(names.insert(field.name).second) << field.name;
      EXPECT_TRUE(field.remembered.empty() || places.insert(field.remembered).second) << field.remembered;
      EXPECT_EQ(problemOf(field, field.initial), "") << field.name;
      EXPECT_FALSE(field.isArgument && field.help.empty()) << field.name;
      sources += field.isSource ? 1 : 0;
    }
    EXPECT_EQ(sources, 1) << adapter.name;
  }
}

TEST(PlatformAdapter, whatIsWrongWithAChoiceIsSaidBeforeAnythingIsOpened) {
  const TestFolder home;
  Workbench workbench(home.path());
  const auto problem = [&](const std::string& line) {
    const auto done = workbench.commands().runLine(line);
    return done ? std::string() : done.error().text;
  };
  EXPECT_EQ(problem("simulation.setup house p3at 101 off 0 off both"),
            "the number of robots must be a whole number between 0 and 100");
  EXPECT_EQ(problem("simulation.setup house dog 1 off 0 off both"),
            "the kind of robots must be burger, ers210, p3at, p3dx or peoplebot, not 'dog'");
  EXPECT_EQ(problem("simulation.setup house p3at 1 off 70000 off both"),
            "the first port must be a whole number between 1 and 65435, or 0 for none");
  EXPECT_EQ(problem("simulation.setup house p3at 1 off 0 off green"),
            "the teams must be both, red or blue, not 'green'");
  EXPECT_FALSE(workbench.loading());
  EXPECT_EQ(openingOf({.sources = {"game.mcap", "house.map"}}).error().text,
            "house.map cannot be opened together with game.mcap, which is of another kind");
  EXPECT_EQ(openingOf({.sources = {"a.sdf", "b.sdf"}}).error().text,
            "b.sdf cannot be opened together with a.sdf; only logs can be opened together");
}

TEST(PlatformAdapter, aRobotGoesOnIfAnotherOneCannotBeOpened) {
  const ServedWorld world;
  const TestFolder home;
  Workbench workbench(home.path());
  std::string errors;
  workbench.onErrors([&](const robotlink::Errors& reported) { errors += robotlink::describe(reported); });
  workbench.open(RealFeed::opening(pioneerOptions(world.url())));
  ASSERT_TRUE(test::tickUntil(workbench, [&] { return !drivingOf(workbench).empty(); })) << errors;
  RealRobotOptions lost = pioneerOptions("tcp://localhost:1");
  lost.program.layout = "no-such-layout.yaml";
  workbench.open(RealFeed::opening(lost));
  ASSERT_TRUE(test::tickUntil(workbench, [&] { return !errors.empty(); }));
  EXPECT_EQ(workbench.loaded()->title, world.url());
  const auto publishedUntil = [&] { return workbench.session().timeline().newest(); };
  const robotlink::Instant before = publishedUntil();
  EXPECT_TRUE(test::tickUntil(workbench, [&] { return publishedUntil() > before; }))
      << "the first robot still publishes";
}

TEST(PlatformAdapter, theFirstWordOfARobotIsThatItsPlatformWasSetUp) {
  const ServedWorld world;
  const TestFolder home;
  Workbench workbench(home.path());
  workbench.open(RealFeed::opening(pioneerOptions(world.url())));
  const auto texts = [&] {
    std::string all;
    const auto* stream = workbench.session().store().find("p3at1/log");
    if (stream == nullptr) return all;
    for (const auto& message : stream->messages) {
      const auto* log = dynamic_cast<const foxglove::Log*>(message.value.get());
      if (log != nullptr) all += log->name() + ": " + log->message() + "\n";
    }
    return all;
  };
  EXPECT_TRUE(test::tickUntil(workbench, [&] {
    return texts().find("platform: The platform was set up in ") == 0;
  })) << texts();
}

TEST(PlatformAdapter, whatAPersonChoseForARobotHoldsWhenItIsConnectedAgain) {
  const ServedWorld world;
  const TestFolder home;
  Workbench workbench(home.path());
  std::string errors;
  workbench.onErrors([&](const robotlink::Errors& reported) { errors += robotlink::describe(reported); });
  const auto connect = [&] {
    workbench.open(RealFeed::opening(pioneerOptions(world.url())));
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
  ASSERT_EQ(workbench.loaded()->ended.size(), 1U);
  EXPECT_TRUE(workbench.loaded()->ended.front().starts_with("p3at1: The platform was shut down in "));
  ASSERT_TRUE(connect()) << errors;
  EXPECT_TRUE(test::tickUntil(workbench, [&] { return drivingOf(workbench) == "wander"; })) << errors;
}
