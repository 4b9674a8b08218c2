// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/RobotChoice.h"

#include <QTest>

#include "robotlink/session/Session.h"
#include "tests/widgets/GuiTest.h"

namespace widgets::test {

class RobotChoiceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whereNoRobotIsSelectedNoneIsChosen() {
    const robotlink::Session empty;
    RobotChoice choice("choice");
    QVERIFY(choice.robots(empty).empty());
    choice.setChoice(QStringLiteral("red1"));
    QVERIFY(choice.robots(empty) == std::vector<std::string>{"red1"});
  }

  void aRobotElsewhereIsListedWithItsState() {
    robotlink::Session session;
    session.setRobots({"red1", "red2"});
    const auto show = [&session](bool connected, const std::string& state) {
      session.setRemoteRobots({{"red2", {"ws://hall:8765", connected, state}}});
    };
    RobotChoice choice("choice");
    show(false, "silent for 3 s: the line is cut");
    choice.refresh(session);
    QCOMPARE(choice.itemText(3), QStringLiteral("red2 (silent for 3 s)"));
    QVERIFY(choice.itemData(3, Qt::ToolTipRole).toString().contains(QStringLiteral("the line is cut")));
    QCOMPARE(choice.itemText(2), QStringLiteral("red1"));
    show(true, "connected, 12 ms");
    choice.refresh(session);
    QCOMPARE(choice.itemText(3), QStringLiteral("red2"));
  }
};

const GuiTest<RobotChoiceTest> kRobotChoiceTest;

}  // namespace widgets::test

#include "RobotChoiceTest.moc"
