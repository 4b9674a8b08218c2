// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/PackageSubscription.h"

#include "tests/widgets/Bench.h"

namespace widgets::test {

using robotcontrol::KeyMode;

namespace {

robotcontrol::KeyTable oneKey(KeyMode::Kind kind) {
  robotcontrol::KeyTable table;
  auto& key = *table.add_keys();
  key.set_name("package/behavior/state");
  key.mutable_mode()->set_kind(kind);
  return table;
}

/// A session of red1, whose program has one package.
struct Subscribed : Bench {
  PackageSubscription subscription;

  Subscribed() { publish(KeyMode::OFF); }
  void publish(KeyMode::Kind kind) {
    push("red1/tables/keys", oneKey(kind), 1);
    session.tick();
  }
  /// As a view does in so many ticks.
  void tickTimes(int times) {
    for (int i = 0; i < times; ++i) {
      session.tick();
      subscription.want(session, "red1", {"behavior/state"});
    }
  }
};

}  // namespace

class PackageSubscriptionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aKeyIsRequestedOnceAndStaysOffIfTheUserSwitchesItOff() {
    Subscribed s;
    s.tickTimes(10);
    QCOMPARE(s.requests.size(), std::size_t{1});
    QCOMPARE(s.requests[0].robot(), std::string("red1"));
    s.answer(true);
    s.publish(KeyMode::ALWAYS);
    s.tickTimes(200);
    s.publish(KeyMode::OFF);
    s.tickTimes(200);
    QCOMPARE(s.requests.size(), std::size_t{1});
  }

  void whatIsRefusedIsRequestedAgainAfterAWhileLessAndLessOften() {
    Subscribed s;
    s.tickTimes(1);
    s.answer(false, "the program of red1 does not return");
    s.tickTimes(20);
    QCOMPARE(s.requests.size(), std::size_t{1});
    s.tickTimes(20);
    QCOMPARE(s.requests.size(), std::size_t{2});
    QCOMPARE(s.requests[1].set_key().mode().kind(), KeyMode::ALWAYS);
    s.answer(false);
    s.tickTimes(40);
    QCOMPARE(s.requests.size(), std::size_t{2});
    s.tickTimes(40);
    QCOMPARE(s.requests.size(), std::size_t{3});
    s.answer(true);
    s.tickTimes(400);
    QCOMPARE(s.requests.size(), std::size_t{3});
  }
};

const GuiTest<PackageSubscriptionTest> kPackageSubscriptionTest;

}  // namespace widgets::test

#include "PackageSubscriptionTest.moc"
