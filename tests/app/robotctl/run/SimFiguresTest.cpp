// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/SimFigures.h"

#include <gmock/gmock.h>

#include "app/platforms/simulated/SimulatedRun.h"
#include "tests/app/SimulatedRuns.h"

namespace app {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

/// The figures of a game that was played.
json game() {
  return {{"scene", "/scenes/field2002.sdf"},
          {"layout", "/layouts/compact.yaml"},
          {"layouts", {{"blue1", "/layouts/compact.yaml"}, {"red1", "/layouts/compact.yaml"}}},
          {"seed", 7},
          {"robots", 2},
          {"simulated_seconds", 12.5},
          {"real_seconds", 2.5},
          {"real_time_factor", 5.0},
          {"steps", 3125},
          {"images", 312},
          {"ms_per_step", 0.5},
          {"ms_per_image", 1.25},
          {"ball_contacts", 1},
          {"goals", {{"blue", 0}, {"red", 2}}},
          {"digest", "00ff"}};
}

/// The figures of a Pioneer that clients drove.
json served() {
  return {{"scene", "pioneer.sdf"},
          {"seed", 1},
          {"kinematic", true},
          {"simulated_seconds", 3700.0},
          {"real_seconds", 3700.25},
          {"real_time_factor", 1.0},
          {"steps", 925'000},
          {"ms_per_step", 0.004},
          {"ms_per_step_of_controllers", 0.02},
          {"latest_step_seconds", 0.015},
          {"real_time_lost_seconds", 0.25},
          {"robots",
           {{{"name", "p3at1"},
             {"contacts", 2},
             {"contact_seconds", 0.5},
             {"url", "tcp://localhost:8101"},
             {"clients", 1},
             {"refused_clients", 1},
             {"packets_received", 1234},
             {"checksum_errors", 3},
             {"skipped_bytes", 12},
             {"packets_sent", 40},
             {"packets_dropped", 5},
             {"messages_not_shown", 6}}}},
          {"contacts", 2}};
}

TEST(SimFigures, robotsWithOtherLayoutsAreNamed) {
  json figures = game();
  figures["layouts"] = {
      {"blue1", "/a/soccer.yaml"}, {"red1", "/a/parallel.yaml"}, {"red2", "/a/parallel.yaml"}};
  EXPECT_THAT(figuresText(figures),
              HasSubstr("robots      2, in the layouts parallel (red1, red2) and soccer (blue1)\n"));
}

TEST(SimFigures, aGameHasALineForEachSubject) {
  EXPECT_EQ(figuresText(game()),
            "scene       field2002.sdf, seed 7\n"
            "robots      2, in the layout compact\n"
            "time        12.5 s simulated in 2.50 s: 5.00 times real time\n"
            "physics     3,125 steps, 0.500 ms each\n"
            "images      312, 1.25 ms each\n"
            "ball        touched once\n"
            "goals       red 2, blue 0\n"
            "digest      00ff\n");
}

TEST(SimFigures, whatDidNotHappenHasNoLine) {
  json quiet = game();
  quiet["images"] = 0;
  quiet["ball_contacts"] = 0;
  quiet.erase("goals");
  quiet.erase("digest");
  quiet["layouts"] = {{"blue1", ""}, {"red1", ""}};
  EXPECT_EQ(figuresText(quiet),
            "scene       field2002.sdf, seed 7\n"
            "robots      2\n"
            "time        12.5 s simulated in 2.50 s: 5.00 times real time\n"
            "physics     3,125 steps, 0.500 ms each\n");
}

TEST(SimFigures, aServedRobotHasALineWithItsClients) {
  EXPECT_EQ(
      figuresText(served()),
      "scene       pioneer.sdf, seed 1\n"
      "movement    by odometry, without forces\n"
      "time        1:01:40 h simulated in 1:01:40 h: 1.00 times real time\n"
      "            250 ms behind real time, because steps took too long; a step was late by 15.0 ms at most\n"
      "physics     925,000 steps, 0.004 ms each\n"
      "robots      0.020 ms a step for their controllers and sensors\n"
      "p3at1       tcp://localhost:8101: 1 client (1 refused), 1,234 packets received (3 with wrong "
      "checksums, 12 bytes of no packet), 40 sent, 5 dropped, 6 messages of clients not shown; "
      "touched something 2 times, for 500 ms in all\n");
}

TEST(SimFigures, whatIsInOrderIsNotMentioned) {
  json good = served();
  for (const char* name : {"refused_clients", "checksum_errors", "skipped_bytes", "packets_dropped",
                           "messages_not_shown", "contacts"})
    good["robots"][0][name] = 0;
  good["robots"][0]["clients"] = 2;
  good["robots"][0]["contacts"] = 0;
  good["real_time_lost_seconds"] = 0.0;
  const std::string text = figuresText(good);
  EXPECT_THAT(text, HasSubstr("p3at1       tcp://localhost:8101: 2 clients, 1,234 packets received, 40 sent; "
                              "touched nothing\n"));
  EXPECT_THAT(text, Not(HasSubstr("behind real time")));
}

TEST(SimFigures, numbersAreRoundedWithoutJumpingAUnit) {
  const auto seconds = [](double value) {
    json figures = game();
    figures["simulated_seconds"] = value;
    const std::string text = figuresText(figures);
    const std::size_t begin = text.find("time        ") + 12;
    return text.substr(begin, text.find(" simulated") - begin);
  };
  EXPECT_EQ(seconds(0), "0.000 s");
  EXPECT_EQ(seconds(0.0005), "0.500 ms");
  EXPECT_EQ(seconds(0.0999), "99.9 ms");
  EXPECT_EQ(seconds(0.9994), "999 ms");
  EXPECT_EQ(seconds(0.9999), "1.00 s");
  EXPECT_EQ(seconds(9.996), "10.0 s");
  EXPECT_EQ(seconds(599.4), "599 s");
  EXPECT_EQ(seconds(600), "0:10:00 h");
  EXPECT_EQ(seconds(86'400), "24:00:00 h");
}

TEST(SimFigures, aRunHasExactNumbersUnderStableNames) {
  const auto run = test::makeRun(test::simulationOptions(5));
  ASSERT_TRUE(run);
  test::play(*run, 0.4);
  const json figures = figuresOf(*run, 0.2);
  EXPECT_THAT(figures["scene"].get<std::string>(), HasSubstr("field2002.sdf"));
  EXPECT_EQ(figures["seed"], 5);
  EXPECT_EQ(figures["robots"], 1);
  EXPECT_NEAR(figures["simulated_seconds"].get<double>(), 0.4, 1e-9);
  EXPECT_NEAR(figures["real_time_factor"].get<double>(), 2, 1e-9);
  EXPECT_GT(figures["steps"].get<int>(), 0);
  EXPECT_GT(figures["images"].get<int>(), 0);
  EXPECT_THAT(figures["digest"].get<std::string>(), MatchesRegex("[0-9a-f]{16}"));
  EXPECT_EQ(figuresOf(*run, 0)["real_time_factor"], 0) << "no time was measured";
  EXPECT_THAT(figuresText(figures), HasSubstr("400 ms simulated in 200 ms: 2.00 times real time"));
}

}  // namespace
}  // namespace app
