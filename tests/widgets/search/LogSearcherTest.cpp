// SPDX-License-Identifier: GPL-3.0-or-later
// What the thread of a search reports; SearchViewTest has what is seen of it.
#include "widgets/search/LogSearcher.h"

#include <QtTest>
#include <map>

#include "foxglove/Robot.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/session/Session.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/widgets/GuiTest.h"
#include "tests/widgets/streams/StoredMessages.h"

namespace widgets::test {
namespace {

robotlink::PackagePtr spokenText(const std::string& message,
                                 foxglove::Log::Level level = foxglove::Log::INFO) {
  auto log = std::make_shared<foxglove::Log>();
  log->set_message(message);
  log->set_level(level);
  return log;
}

/// Writes a log whose robot "nao" says these texts, one each second from 10 s on.
std::filesystem::path spokenLog(const TestFolder& folder, const char* name,
                                const std::vector<std::string>& texts) {
  auto writer = logplayer::LogWriter::create(folder / name, {});
  if (!writer) qFatal("the log cannot be written");
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const auto time = atSeconds(10.0 + static_cast<double>(i));
    if (!(*writer)->write({{"nao/log", time, spokenText(texts[i]), "cognition"}}))
      qFatal("the log cannot be written");
  }
  if (!(*writer)->container().close()) qFatal("the log cannot be written");
  return folder / name;
}

/// All that a search reports until it is done.
LogSearcher::News allNews(LogSearcher& searcher) {
  LogSearcher::News all;
  const bool isDone = eventually([&] {
    LogSearcher::News news = searcher.take();
    all.hits.insert(all.hits.end(), news.hits.begin(), news.hits.end());
    news.hits.swap(all.hits);
    all = std::move(news);
    return all.isDone;
  });
  if (!isDone) qFatal("the search does not end");
  return all;
}

LogSearcher::News found(LogSearcher::Plan plan) {
  LogSearcher searcher;
  searcher.begin(std::move(plan));
  return allNews(searcher);
}

LogSearcher::News textsFound(const std::vector<LogSearcher::Log>& logs, const char* wanted) {
  return found({logs, wanted, true});
}

}  // namespace

class LogSearcherTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hitsOfSeveralLogsHaveTheirNumberTimeAndRobot() {
    const TestFolder folder;
    const auto first = spokenLog(folder, "first.mcap", {"the ball", "the goal"});
    const auto second = spokenLog(folder, "second.mcap", {"no", "a Ball again"});
    const auto news =
        textsFound({{first, {}, {"red1"}}, {second, std::chrono::seconds(100), {"blue1"}}}, "ball");
    QVERIFY(!news.failure && news.losses.empty() && !news.isCut);
    QCOMPARE(news.hits.size(), std::size_t{2});
    QCOMPARE(news.hits[0].log, std::size_t{0});
    QCOMPARE(news.hits[0].robot, std::string("red1"));
    QCOMPARE(news.hits[0].from, atSeconds(10));
    QCOMPARE(news.hits[0].text, std::string("the ball"));
    QCOMPARE(news.hits[1].log, std::size_t{1});
    QCOMPARE(news.hits[1].robot, std::string("blue1"));
    QCOMPARE(news.hits[1].from, atSeconds(111));
    QCOMPARE(news.hits[1].until, std::optional(atSeconds(111)));
  }

  void charactersThatMeanSomethingInExpressionsAreFoundInTexts() {
    const TestFolder folder;
    const auto log = spokenLog(folder, "log.mcap", {"say \"no\"", "C:\\robots\\", "a.b", "a-b", "(x)"});
    const auto texts = [&](const char* wanted) {
      QStringList all;
      const auto news = textsFound({{log, {}, {"nao"}}}, wanted);
      if (news.failure) return QString::fromStdString(news.failure->text);
      for (const auto& hit : news.hits) all << QString::fromStdString(hit.text);
      return all.join(QLatin1Char('|'));
    };
    QCOMPARE(texts("\"no\""), QStringLiteral("say \"no\""));
    QCOMPARE(texts("\\\"no"), QStringLiteral("say \"no\""));
    QCOMPARE(texts("a.b"), QStringLiteral("a.b|a-b"));
    QCOMPARE(texts("a\\.b"), QStringLiteral("a.b"));
    QCOMPARE(texts("\\(x\\)"), QStringLiteral("(x)"));
    QCOMPARE(texts("robots\\\\"), QStringLiteral("C:\\robots\\"));
    QVERIFY2(texts("robots\\").contains(QStringLiteral("regular expression")), qPrintable(texts("robots\\")));
  }

  void aLogThatCannotBeReadIsALossBesideOthers() {
    const TestFolder folder;
    const auto fine = spokenLog(folder, "fine.mcap", {"the ball"});
    const auto broken = folder.write("broken.mcap", "this is no log");
    const auto news = textsFound({{broken, {}, {}}, {fine, {}, {"nao"}}}, "ball");
    QVERIFY(!news.failure);
    QCOMPARE(news.hits.size(), std::size_t{1});
    QCOMPARE(news.hits[0].log, std::size_t{1});
    QCOMPARE(news.losses.size(), std::size_t{1});
    const auto alone = textsFound({{broken, {}, {}}}, "ball");
    QVERIFY(alone.failure && alone.hits.empty());
    QCOMPARE(alone.failure->text, news.losses[0]);
    QVERIFY(textsFound({{folder / "missing.mcap", {}, {}}}, "ball").failure);
  }

  void aLogWithoutTextsSaysSo() {
    const TestFolder folder;
    auto writer = logplayer::LogWriter::create(folder / "log.mcap", {});
    QVERIFY(writer);
    QVERIFY((*writer)->write(
        {{"nao/models/ball", atSeconds(1), std::make_shared<const robotcontrol::BallModel>()}}));
    QVERIFY((*writer)->container().close());
    const auto news = textsFound({{folder / "log.mcap", {}, {"nao"}}}, "ball");
    QVERIFY(news.failure);
    QCOMPARE(news.failure->text, std::string("the log holds no texts"));
  }

  void nobodyHasSaidAnything() {
    robotlink::Session session;
    const auto history = LogSearcher::historyOf(session, "ball", true);
    QVERIFY(!history);
    QCOMPARE(history.error().text, std::string("there are no messages yet"));
  }

  void textsInMemoryAreThoseOfAllRobotsAndOfTheWorld() {
    robotlink::Session session;
    session.setRobots({"red1", "blue1"});
    session.push({"red1/log", atSeconds(1), spokenText("red ball", foxglove::Log::WARNING)});
    session.push({"blue1/log", atSeconds(2), spokenText("blue ball")});
    session.push({"rosout", atSeconds(3), spokenText("ball of nobody")});
    session.push({"red1/models/ball", atSeconds(4), std::make_shared<const robotcontrol::BallModel>()});
    session.tick();
    const auto history = LogSearcher::historyOf(session, "ball", true);
    QVERIFY(history);
    QCOMPARE(history->textStreams, (std::set<std::string>{"log", "rosout"}));
    QCOMPARE(history->pieces.size(), std::size_t{3});
    const auto news = found({{}, "ball", true, *history});
    QVERIFY2(!news.failure, news.failure ? news.failure->text.c_str() : "");
    QCOMPARE(news.hits.size(), std::size_t{3});
    QCOMPARE(news.hits[0].text, std::string("red ball"));
    QCOMPARE(news.hits[0].robot, std::string("red1"));
    QCOMPARE(news.hits[0].level, static_cast<int>(foxglove::Log::WARNING));
    QCOMPARE(news.hits[2].robot, std::string());
  }

  void aConditionOnStreamsThatAreNotThereFails() {
    robotlink::Session session;
    session.setRobots({"red1"});
    session.push({"red1/models/ball", atSeconds(1), std::make_shared<const robotcontrol::BallModel>()});
    session.tick();
    for (const auto& [wanted, fails] : {std::pair("models/ball.known > 0", false),
                                        {"models/bal.known > 0", true},
                                        {"models/ball.known >", true}}) {
      const auto history = LogSearcher::historyOf(session, wanted, false);
      QCOMPARE(!history.has_value(), fails);
      if (history) QVERIFY(!found({{}, wanted, false, *history}).failure);
    }
  }

  void aMisspelledStreamOfLiveRobotsIsCorrected() {
    robotlink::Session session;
    session.setRobots({"red1"});
    session.push({"red1/models/ball", atSeconds(1), std::make_shared<const robotcontrol::BallModel>()});
    session.tick();
    for (const auto& [wanted, meant] :
         {std::pair("models/bal.known > 0", "there is no stream models/bal; did you mean 'models/ball'?"),
          {"red1/models/bal.known > 0",
           "there is no stream red1/models/bal; did you mean 'red1/models/ball'?"}}) {
      const auto history = LogSearcher::historyOf(session, wanted, false);
      QVERIFY(!history);
      QCOMPARE(history.error().text, std::string(meant));
    }
  }

  void textsOfRobotsAreFoundBesideAStreamOfTheSameNameWithoutARobot() {
    robotlink::Session session;
    session.setRobots({"red1", "blue1"});
    session.push({"log", atSeconds(1), spokenText("ball of nobody")});
    session.push({"red1/log", atSeconds(2), spokenText("red ball")});
    session.push({"blue1/log", atSeconds(3), spokenText("blue ball")});
    session.tick();
    const auto history = LogSearcher::historyOf(session, "ball", true);
    QVERIFY(history);
    const auto robots = [](const LogSearcher::News& news) {
      std::map<std::string, std::string> robotOfText;
      for (const auto& hit : news.hits) robotOfText[hit.text] = hit.robot;
      return robotOfText;
    };
    const std::map<std::string, std::string> all{
        {"ball of nobody", ""}, {"red ball", "red1"}, {"blue ball", "blue1"}};
    QCOMPARE(robots(found({{}, "ball", true, *history})), all);

    const TestFolder folder;
    auto writer = logplayer::LogWriter::create(folder / "log.mcap", {});
    QVERIFY(writer);
    QVERIFY((*writer)->write({{"log", atSeconds(1), spokenText("ball of nobody")},
                              {"nao/log", atSeconds(2), spokenText("red ball"), "cognition"}}));
    QVERIFY((*writer)->container().close());
    const auto logged = textsFound({{folder / "log.mcap", {}, {"red1"}}}, "ball");
    QCOMPARE(robots(logged),
             (std::map<std::string, std::string>{{"ball of nobody", ""}, {"red ball", "red1"}}));
  }

  void textsAreFoundBesideOtherMessagesOfTheSameNameWithoutARobot() {
    robotlink::Session session;
    session.setRobots({"red1"});
    session.push({"log", atSeconds(1), std::make_shared<const robotcontrol::BallModel>()});
    session.push({"red1/log", atSeconds(2), spokenText("red ball")});
    session.tick();
    const auto history = LogSearcher::historyOf(session, "ball", true);
    QVERIFY(history);
    const auto news = found({{}, "ball", true, *history});
    QVERIFY2(!news.failure, news.failure ? news.failure->text.c_str() : "");
    QCOMPARE(news.hits.size(), std::size_t{1});
    QCOMPARE(news.hits[0].robot, std::string("red1"));
  }

  void aSearchThatIsDoneHasSearchedAll() {
    const TestFolder folder;
    const auto log = spokenLog(folder, "log.mcap", {"the ball"});
    const auto broken = folder.write("broken.mcap", "this is no log");
    QCOMPARE(textsFound({{log, {}, {"nao"}}, {log, {}, {"nao"}}}, "ball").progress, 1.0);
    QCOMPARE(textsFound({{log, {}, {"nao"}}, {broken, {}, {}}}, "ball").progress, 1.0);
    robotlink::Session session;
    session.push({"log", atSeconds(1), spokenText("ball")});
    session.tick();
    const auto history = LogSearcher::historyOf(session, "ball", true);
    QVERIFY(history);
    QCOMPARE(found({{}, "ball", true, *history}).progress, 1.0);
  }

  void aSearchWithTooManyHitsIsCut() {
    robotlink::Session session;
    session.setRobots({"red1"});
    for (std::size_t i = 0; i <= LogSearcher::kMaxHits; ++i) {
      session.push({"red1/log", atSeconds(0.01 * static_cast<double>(i)), spokenText("ball")});
      if (i % 1000 == 0) session.tick();
    }
    session.tick();
    const auto history = LogSearcher::historyOf(session, "ball", true);
    QVERIFY(history);
    const auto news = found({{}, "ball", true, *history});
    QVERIFY(news.isCut && !news.failure);
    QCOMPARE(news.hits.size(), LogSearcher::kMaxHits);
  }

  void aNewerSearchReplacesTheOneBeforeAndACanceledOneIsDone() {
    const TestFolder folder;
    const auto log = spokenLog(folder, "log.mcap", {"the ball", "the goal"});
    LogSearcher searcher;
    searcher.begin({{{log, {}, {"nao"}}}, "ball", true});
    searcher.begin({{{log, {}, {"nao"}}}, "goal", true});
    const auto news = allNews(searcher);
    QCOMPARE(news.hits.size(), std::size_t{1});
    QCOMPARE(news.hits[0].text, std::string("the goal"));
    searcher.begin({{{log, {}, {"nao"}}}, "ball", true});
    searcher.cancel();
    QVERIFY(searcher.take().isDone);
    QVERIFY(searcher.take().hits.empty());
  }
};

const GuiTest<LogSearcherTest> kLogSearcherTest;

}  // namespace widgets::test

#include "LogSearcherTest.moc"
