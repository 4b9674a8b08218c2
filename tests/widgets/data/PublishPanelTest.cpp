// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/PublishPanel.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <algorithm>

#include "tests/widgets/Bench.h"
#include "tests/widgets/GuiTest.h"
#include "tests/widgets/data/DataFixture.h"
#include "widgets/data/DataView.h"
#include "widgets/data/RequestText.h"

namespace widgets::test {
namespace {

using robotcontrol::Request;

/// The view with its panel for messages, and the kind of message that is chosen in it.
void openPanel(DataView& view, const char* kind) {
  child<QAction>(view, "dataPublishAction").trigger();
  auto& kinds = child<QComboBox>(view, "publishKind");
  kinds.setCurrentIndex(kinds.findText(QLatin1String(kind)));
}

void write(DataView& view, const char* json) {
  child<QPlainTextEdit>(view, "publishText").setPlainText(QLatin1String(json));
}

QString said(DataView& view) {
  return child<QLabel>(view, "publishState").text();
}

}  // namespace

class PublishPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void allRequestsThatAreTextHaveATemplateThatCanBeRead() {
    const auto forms = requestForms();
    QVERIFY(forms.size() >= 12);
    for (const RequestForm& form : forms) {
      QVERIFY2(form.json.find('{') == 0, form.title.c_str());
      const auto read = readRequest(form.what, "red1", form.json);
      // Some of the defaults name nothing that exists; all are JSON of their type.
      QVERIFY2(read || read.error().text.find("Cannot find field") == std::string::npos, form.title.c_str());
    }
    const auto has = [&forms](Request::WhatCase what) {
      return std::ranges::find(forms, what, &RequestForm::what) != forms.end();
    };
    QVERIFY(has(Request::kSetGoal) && has(Request::kMotion) && has(Request::kPlaceModel));
    QVERIFY(!has(Request::kSetColorTable) && !has(Request::kSetParameters));
  }

  void simulationsAreAskedForAllRobots() {
    const auto placed =
        readRequest(Request::kPlaceModel, "red1", R"({"model": "ball", "pose_in_field": {"x": 1}})");
    QVERIFY(placed && placed->robot().empty() && placed->place_model().model() == "ball");
    QVERIFY(!readRequest(Request::kSetGoal, "red1", ""));
    const auto goal = readRequest(Request::kSetGoal, "red1", R"({"pose_in_field": {}})");
    QVERIFY(goal && goal->robot() == "red1");
    QVERIFY(!readRequest(Request::kSetGoal, "red1", R"({"pose_in_field": {"x": "NaN"}})"));
    const auto wrong = readRequest(Request::kSetGoal, "red1", R"({"pose": 1})");
    QVERIFY(!wrong && wrong.error().text.find("pose") != std::string::npos);
    QVERIFY(!readRequest(Request::kSetGoal, "red1", std::string(2U << 20U, ' ')));
  }

  void aMessageIsSentByItsNameAndItsFields() {
    Bench bench;
    QVERIFY(publish(bench.session, "set-goal", R"({"pose_in_field": {"x": 2}})", ""));
    QCOMPARE(bench.requests.back().robot(), std::string("red1"));
    QCOMPARE(bench.requests.back().set_goal().pose_in_field().x(), 2.0);
    QVERIFY(publish(bench.session, "set goal", R"({"cancelled": true})", "blue1"));
    QCOMPARE(bench.requests.back().robot(), std::string("blue1"));
    QVERIFY(bench.requests.back().set_goal().cancelled());
    const auto unknown = publish(bench.session, "set-gaol", "", "");
    QVERIFY(!unknown);
    QVERIFY(unknown.error().text.find("'set-goal'") != std::string::npos);
    QVERIFY(!publish(bench.session, "set-goal", "{", ""));
    QVERIFY(!publish(bench.session, "set-goal", "", "nobody"));
    QCOMPARE(bench.requests.size(), std::size_t{2});
  }

  void aMessageIsFilledInAndSentOnce() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.tick(*view);
    QVERIFY(!child<QWidget>(*view, "publishPanel").isVisible());
    openPanel(*view, "set goal");
    QVERIFY(
        child<QPlainTextEdit>(*view, "publishText").toPlainText().contains(QStringLiteral("\"heading\": 0")));
    write(*view, R"({"pose_in_field": {"x": 1.5, "y": -0.5}})");
    auto& text = child<QPlainTextEdit>(*view, "publishText");
    QVERIFY(text.hasFocus());
    QTest::keyClick(&text, Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY2(bench.requests.size() == 1, qPrintable(said(*view)));
    QCOMPARE(bench.requests.back().set_goal().pose_in_field().x(), 1.5);
    QCOMPARE(QString::fromStdString(bench.requests.back().robot()), QStringLiteral("red1"));
    bench.answer(true);
    bench.tick(*view);
    QCOMPARE(said(*view), QStringLiteral("1 message sent, 1 accepted"));
  }

  void whatIsNoMessageIsSaidAndNotSent() {
    Bench bench;
    auto view = bench.open<DataView>();
    openPanel(*view, "set goal");
    write(*view, R"({"pose_in_field": {"z": 1}})");
    child<QAction>(*view, "publishSendAction").trigger();
    QVERIFY(bench.requests.empty());
    QVERIFY2(said(*view).startsWith(QStringLiteral("Not sent: ")) && said(*view).contains(QLatin1Char('z')),
             qPrintable(said(*view)));
    child<QAction>(*view, "publishRepeatAction").trigger();
    QVERIFY(!child<QAction>(*view, "publishRepeatAction").isChecked());
  }

  void itIsRepeatedUntilItIsRefusedOrHidden() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.tick(*view);
    openPanel(*view, "set goal");
    auto& repeat = child<QAction>(*view, "publishRepeatAction");
    child<QDoubleSpinBox>(*view, "publishRate").setValue(50);
    repeat.trigger();
    QTRY_VERIFY(bench.requests.size() >= 3);
    bench.answer(false, "no task of this layout drives to goals");
    bench.tick(*view);
    QVERIFY(!repeat.isChecked());
    QCOMPARE(said(*view), QStringLiteral("Refused: no task of this layout drives to goals"));
    repeat.trigger();
    QVERIFY(repeat.isChecked());
    child<QAction>(*view, "dataPublishAction").trigger();
    QVERIFY(!repeat.isChecked());
  }

  void aPackageIsSentHeldAndReleasedAndTheViewSaysSo() {
    using robotcontrol::SetPackage;
    Bench bench;
    auto view = bench.open<DataView>();
    robotcontrol::ProcessTable table;
    auto& port = *table.add_processes()->add_senders();
    port.set_package("models/ball");
    bench.push("red1/tables/processes", table, 1);
    bench.tick(*view);
    openPanel(*view, "package models/ball");
    auto& held = child<QLabel>(*view, "publishHeld");
    auto& release = child<QAction>(*view, "publishReleaseAction");
    QVERIFY(child<QPlainTextEdit>(*view, "publishText").toPlainText().contains(QStringLiteral("\"known\"")));
    QVERIFY(held.text().isEmpty() && !release.isEnabled());
    write(*view, R"({"known": true})");
    child<QAction>(*view, "publishSendAction").trigger();
    QCOMPARE(bench.requests.back().set_package().mode(), SetPackage::ONCE);
    child<QAction>(*view, "publishHoldAction").trigger();
    QCOMPARE(bench.requests.back().robot(), std::string("red1"));
    QCOMPARE(bench.requests.back().set_package().mode(), SetPackage::HOLD);
    QCOMPARE(bench.requests.back().set_package().value().type(), std::string("robotcontrol.BallModel"));
    port.set_held(true);
    bench.push("red1/tables/processes", table, 2);
    bench.tick(*view);
    QVERIFY(release.isEnabled());
    QCOMPARE(held.text(), QStringLiteral("Held at red1: models/ball"));
    release.trigger();
    QCOMPARE(bench.requests.back().set_package().mode(), SetPackage::RELEASE);
    write(*view, R"({"know": true})");
    child<QAction>(*view, "publishHoldAction").trigger();
    QVERIFY2(said(*view).contains(QStringLiteral("know")), qPrintable(said(*view)));
    QCOMPARE(bench.requests.size(), std::size_t{3});
  }

  void onlyPackagesOfTheProgramCanBeChosen() {
    Bench bench;
    auto view = bench.open<DataView>();
    robotcontrol::ProcessTable table;
    table.add_processes()->add_senders()->set_package("models/ball");
    bench.push("red1/tables/processes", table, 1);
    child<QAction>(*view, "dataPublishAction").trigger();
    bench.tick(*view);
    auto& kinds = child<QComboBox>(*view, "publishKind");
    const auto isEnabled = [&kinds](const char* kind) {
      const QModelIndex index = kinds.model()->index(kinds.findText(QLatin1String(kind)), 0);
      return index.flags().testFlag(Qt::ItemIsEnabled);
    };
    QVERIFY(isEnabled("package models/ball") && isEnabled("set goal") && !isEnabled("package models/pose"));
    child<QComboBox>(*view, "publishKind").setCurrentText(QStringLiteral("set goal"));
    QVERIFY(!child<QAction>(*view, "publishHoldAction").isEnabled());
  }

  void whatWasTypedIsRemembered() {
    Bench bench;
    auto view = bench.open<DataView>();
    openPanel(*view, "set goal");
    write(*view, R"({"cancelled": true})");
    child<QComboBox>(*view, "publishKind").setCurrentText(QStringLiteral("stop"));
    const QJsonObject state = view->saveState();
    auto other = bench.open<DataView>();
    other->restoreState(state);
    QVERIFY(child<QWidget>(*other, "publishPanel").isVisible());
    QCOMPARE(child<QComboBox>(*other, "publishKind").currentText(), QStringLiteral("stop"));
    child<QComboBox>(*other, "publishKind").setCurrentText(QStringLiteral("set goal"));
    auto& text = child<QPlainTextEdit>(*other, "publishText");
    QCOMPARE(text.toPlainText(), QStringLiteral(R"({"cancelled": true})"));
    child<QAction>(*other, "publishResetAction").trigger();
    QVERIFY(text.toPlainText().contains(QStringLiteral("heading")));
    QVERIFY(!child<QAction>(*other, "publishResetAction").isEnabled());
  }
};

const GuiTest<PublishPanelTest> kPublishPanelTest;

}  // namespace widgets::test

#include "PublishPanelTest.moc"
