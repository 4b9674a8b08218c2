// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/plots/CurveModel.h"

namespace widgets::test {
namespace {

PlotSource read(const char* text) {
  return PlotSource::fromText(QString::fromUtf8(text));
}

const std::vector<std::string> kStreamNames{"red1/models/ball", "red1/models/pose", "blue1/models/ball",
                                            "simulation"};
const std::vector<std::string> kRobotNames{"red1", "blue1"};

robotlink::Result<PlotSource> complete(const char* text) {
  return completed(read(text), "red1", kStreamNames, kRobotNames);
}

/// A session that gets messages and processes them at once.
struct Published {
  template <typename T>
  void push(const std::string& path, double time, const T& message) {
    session.push(
        {path, robotlink::Instant(robotlink::fromSeconds(time)), std::make_shared<const T>(message)});
    session.tick();
  }
  void pushBall(double time, double x) {
    robotcontrol::BallModel ball;
    ball.mutable_position_in_robot()->set_x(x);
    push("red1/models/ball", time, ball);
  }
  void pushKey(const char* name, robotcontrol::KeyMode::Kind kind) {
    auto& key = *table.add_keys();
    key.set_name(name);
    key.mutable_mode()->set_kind(kind);
    push("red1/tables/keys", 1, table);
  }
  std::string keyOf(const std::string& stream) {
    return keyFor(session.store(), stream, session.timeline().newest());
  }

  robotlink::Session session;
  robotcontrol::KeyTable table;
};

TEST(PlotSource, isReadFromTheTextThatItHas) {
  for (const char* text :
       {"plots/ball-model/age", "red1/models/ball: position_in_robot.x",
        "red1/models/ball: position_in_robot.x | derivative", "= sqrt(red1/models/ball.position.x^2)",
        "= 2 * red1/models/ball.age | average 0.5 over red1/models/pose: pose.x"}) {
    EXPECT_EQ(read(text).text().toStdString(), text);
  }
}

TEST(PlotSource, knowsItsParts) {
  const PlotSource source = read(
      "red1/joints/states: joints[name=\"head.pan\"].position | low pass 2 over "
      "red1/models/pose: pose.x");
  EXPECT_EQ(source.stream, "red1/joints/states");
  EXPECT_EQ(source.field, "joints[name=\"head.pan\"].position");
  EXPECT_EQ(source.filter, "low pass 2");
  EXPECT_EQ(source.across, "red1/models/pose: pose.x");
  EXPECT_TRUE(source.expression.empty());
}

TEST(PlotSource, separatorsWithinQuotesArePartsOfNames) {
  const PlotSource source = read("red1/texts: list[name=\"a | b over c\"].value");
  EXPECT_EQ(source.field, "list[name=\"a | b over c\"].value");
  EXPECT_TRUE(source.filter.empty());
  EXPECT_TRUE(source.across.empty());
}

TEST(PlotSource, aTextWithValuesIsAnExpressionAlsoWithoutItsSign) {
  EXPECT_EQ(read("red1/models/ball.age * 2").expression, "red1/models/ball.age * 2");
  EXPECT_TRUE(read("").isEmpty());
  EXPECT_TRUE(read("   ").isEmpty());
  EXPECT_FALSE(read("plots/age").isEmpty());
}

TEST(PlotSource, aTextThatIsOneValueIsItsStreamAndField) {
  EXPECT_EQ(read("red1/models/ball.age"), read("red1/models/ball: age"));
  EXPECT_EQ(read("red1/models/ball.age | derivative"), read("red1/models/ball: age | derivative"));
  EXPECT_EQ(read("red1/joints/states.joints[headPan].position").field, "joints[headPan].position");
  EXPECT_EQ(read("= red1/models/ball.age").expression, "red1/models/ball.age") << "as in saved layouts";
  EXPECT_EQ(complete("models/ball.age")->text(), QStringLiteral("red1/models/ball: age"));
  EXPECT_EQ(complete("models/ball: age")->text(), QStringLiteral("red1/models/ball: age"));
  EXPECT_EQ(complete("blue1/models/ball.age")->stream, "blue1/models/ball");
  const auto dotted = completed(read("red1/my.topic.x"), "red1", {"red1/my.topic"}, {"red1"});
  EXPECT_EQ(dotted->text(), QStringLiteral("red1/my.topic: x"));
}

TEST(PlotSource, theTypeIsNotCompared) {
  PlotSource a{"red1/models/ball", "age", "robotcontrol.BallModel"}, b{"red1/models/ball", "age"};
  EXPECT_EQ(a, b);
  b.filter = "derivative";
  EXPECT_NE(a, b);
}

TEST(PlotSource, streamsWithoutARobotAreThoseOfTheSelectedOne) {
  EXPECT_EQ(complete("= models/ball.age + 1")->expression, "red1/models/ball.age + 1");
  EXPECT_EQ(complete("= blue1/models/ball.age")->expression, "blue1/models/ball.age");
  EXPECT_EQ(complete("= simulation.time * 2")->expression, "simulation.time * 2");
  EXPECT_EQ(complete("red1/models/ball: age over = models/pose.pose.x")->across, "= red1/models/pose.pose.x");
}

TEST(PlotSource, whatIsWrongIsSaid) {
  EXPECT_FALSE(complete(""));
  EXPECT_FALSE(complete("= 1 +"));
  const auto constant = complete("= 1 + 1");
  ASSERT_FALSE(constant);
  EXPECT_NE(constant.error().text.find("no value"), std::string::npos);
  EXPECT_FALSE(complete("red1/models/ball: age | no such filter"));
  EXPECT_FALSE(complete("red1/models/ball: age over = 2"));
}

TEST(StateNames, nameNumbersAndGiveThemColorsInTheirOrder) {
  StateNames names;
  EXPECT_TRUE(names.isEmpty());
  names.add(7, QStringLiteral("STAND"));
  names.add(2, QStringLiteral("WALK"));
  names.add(7, QStringLiteral("another"));
  EXPECT_EQ(names.size(), 2U);
  EXPECT_EQ(names.name(7), QStringLiteral("STAND"));
  EXPECT_EQ(names.name(0.25), QStringLiteral("0.25"));
  EXPECT_EQ(names.color(7), 0);
  EXPECT_EQ(names.color(2), 1);
  const double none = std::numeric_limits<double>::quiet_NaN();
  names.add(none, QStringLiteral("nothing"));
  EXPECT_EQ(names.size(), 2U);
  EXPECT_EQ(names.name(none), QStringLiteral("nan"));
  EXPECT_EQ(names.color(none), 0);
  StateNames others;
  others.add(3, QStringLiteral("KICK"));
  names.merge(others);
  EXPECT_EQ(names.name(3), QStringLiteral("KICK"));
  EXPECT_EQ(names.color(3), 2);
}

TEST(StateNames, areBounded) {
  StateNames names;
  for (std::size_t i = 0; i < StateNames::kMax + 100; ++i)
    names.add(static_cast<double>(i), QString::number(i));
  EXPECT_EQ(names.size(), StateNames::kMax);
}

TEST(PlotReader, takesEachValueOnce) {
  Published published;
  PlotReader reader(read("red1/models/ball: position_in_robot.x"));
  EXPECT_FALSE(reader.problem(published.session.store()).isEmpty());
  published.pushBall(1, 0.5);
  published.pushBall(2, 0.75);
  const auto news = reader.take(published.session.store());
  ASSERT_EQ(news.points.size(), 2U);
  EXPECT_EQ(news.points.back(), (robotlink::Series::Point{2, 0.75}));
  EXPECT_TRUE(reader.take(published.session.store()).points.empty());
  EXPECT_EQ(reader.last(), 0.75);
  EXPECT_EQ(reader.unit(), QStringLiteral("m"));
  EXPECT_TRUE(reader.problem(published.session.store()).isEmpty());
}

TEST(PlotReader, skipsMessagesWithoutTheField) {
  Published published;
  PlotReader reader(read("red1/models/ball: no.such.field"));
  published.pushBall(1, 0.5);
  EXPECT_TRUE(reader.take(published.session.store()).points.empty());
  EXPECT_FALSE(reader.last().has_value());
}

TEST(PlotReader, saysWhichElementIsNotThere) {
  foxglove::JointStates states;
  states.add_joints()->set_name("headPan");
  for (const char* source : {"red1/joints/states: joints[head.pan].position",
                             "= 2 * red1/joints/states.joints[head.pan].position"}) {
    Published published;
    PlotReader reader(read(source));
    published.push("red1/joints/states", 1, states);
    EXPECT_TRUE(reader.take(published.session.store()).points.empty());
    EXPECT_EQ(reader.problem(published.session.store()), QStringLiteral("no element is named head.pan"));
  }
  Published published;
  PlotReader reader(read("red1/joints/states: joints[headPan].angle"));
  published.push("red1/joints/states", 1, states);
  EXPECT_TRUE(reader.take(published.session.store()).points.empty());
  EXPECT_TRUE(reader.problem(published.session.store()).contains(QStringLiteral("no field angle")));
}

TEST(PlotReader, computesExpressionsOfTheNewestValues) {
  Published published;
  PlotReader reader(read("= red1/models/ball.position_in_robot.x * 2"));
  ASSERT_EQ(reader.streams(), std::vector<std::string>{"red1/models/ball"});
  published.pushBall(1, 0.5);
  published.pushBall(2, 3);
  const auto news = reader.take(published.session.store());
  ASSERT_EQ(news.points.size(), 2U);
  EXPECT_EQ(news.points.front(), (robotlink::Series::Point{1, 1}));
  EXPECT_EQ(reader.last(), 6);
}

TEST(PlotReader, valuesEndWithTheLogThatHadThem) {
  for (const char* source :
       {"red1/models/ball: position_in_robot.x", "= red1/models/ball.position_in_robot.x"}) {
    Published published;
    PlotReader reader(read(source));
    published.pushBall(1, 0.5);
    EXPECT_FALSE(reader.take(published.session.store()).restarted);
    published.session.restart();
    published.session.tick();
    const auto news = reader.take(published.session.store());
    EXPECT_TRUE(news.restarted);
    EXPECT_TRUE(news.points.empty());
    EXPECT_FALSE(reader.last().has_value());
    published.pushBall(2, 0.75);
    EXPECT_EQ(reader.take(published.session.store()).points.size(), 1U);
    EXPECT_EQ(reader.last(), 0.75);
  }
}

TEST(PlotReader, readsStreamsWhoseNamesBeginWithASlash) {
  EXPECT_EQ(PlotSource::fromText(QStringLiteral("/odom.pose.x")).stream, "/odom");
  EXPECT_EQ(PlotReader(read("/odom.pose.x")).streams(), std::vector<std::string>{"/odom"});
}

TEST(CurveTitles, valuesOfSensorsAreNamedAfterTheirSensor) {
  const auto port = [](const char* path, int value) {
    return QStringLiteral("ports: readings[port=\"%1\"].values[%2]").arg(QLatin1String(path)).arg(value);
  };
  const QString ball = QStringLiteral("red1/models/ball: position.x");
  const QString ratio = QStringLiteral("= 2 * ports.readings[port=\"red1/pan\"].values[0]");
  const auto titles = curveTitles({port("red1/headPan.position", 0), port("red1/laser", 0),
                                   port("red1/laser", 7) + QStringLiteral(" | mean 5"), ball, ratio});
  EXPECT_EQ(titles[0], QStringLiteral("red1/headPan.position"));
  EXPECT_EQ(titles[1], QStringLiteral("red1/laser [0]"));
  EXPECT_EQ(titles[2], QStringLiteral("red1/laser [7] | mean 5"));
  EXPECT_EQ(titles[3], ball);
  EXPECT_EQ(titles[4], QStringLiteral("= 2 * red1/pan"));
  EXPECT_EQ(curveTitles({port("red1/laser", 3)}).front(), QStringLiteral("red1/laser [3]"));
  EXPECT_TRUE(curveTitles({}).empty());
}

TEST(CurveTitles, theLegendShowsThemWithTheWholeSourceAsTip) {
  CurveModel curves;
  const auto source = read("ports: readings[port=\"red1/laser\"].values[0]");
  ASSERT_TRUE(curves.add(source));
  const auto name = [&](int row) { return curves.index(row, CurveModel::kName).data().toString(); };
  EXPECT_EQ(name(0), QStringLiteral("red1/laser"));
  EXPECT_TRUE(curves.index(0, 0).data(Qt::ToolTipRole).toString().contains(source.text()));
  ASSERT_TRUE(curves.add(read("ports: readings[port=\"red1/laser\"].values[1]")));
  EXPECT_EQ(name(0), QStringLiteral("red1/laser [0]"));
  curves.remove(1);
  EXPECT_EQ(name(0), QStringLiteral("red1/laser"));
}

TEST(PlotKeys, aStreamThatIsOffHasTheKeyThatPublishesIt) {
  Published published;
  EXPECT_TRUE(published.keyOf("red1/models/ball").empty());
  published.pushKey("package/models/ball", robotcontrol::KeyMode::OFF);
  published.pushKey("package/models/pose", robotcontrol::KeyMode::ALWAYS);
  EXPECT_EQ(published.keyOf("red1/models/ball"), "package/models/ball");
  EXPECT_TRUE(published.keyOf("red1/models/pose").empty());
  EXPECT_TRUE(published.keyOf("simulation").empty());
}

TEST(PlotKeys, aPlotHasTheMostSpecificKey) {
  Published published;
  published.pushKey("ball-model", robotcontrol::KeyMode::OFF);
  published.pushKey("ball-model/age", robotcontrol::KeyMode::OFF);
  EXPECT_EQ(published.keyOf("red1/plots/ball-model/age"), "ball-model/age");
  EXPECT_EQ(published.keyOf("red1/plots/ball-model/age/mean"), "ball-model/age");
  EXPECT_EQ(published.keyOf("red1/plots/ball-model/other"), "ball-model");
}

}  // namespace
}  // namespace widgets::test
