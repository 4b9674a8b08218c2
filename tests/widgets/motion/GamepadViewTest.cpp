// SPDX-License-Identifier: GPL-3.0-or-later
// What the axes and buttons of a gamepad do, as the user has bound them.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableWidget>

#include "tests/widgets/Bench.h"
#include "widgets/motion/GamepadDialog.h"
#include "widgets/motion/GamepadSettings.h"
#include "widgets/motion/MotionView.h"

namespace widgets::test {

class GamepadViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aButtonRunsItsCommandWhenItIsPressed() {
    Bench bench;
    int runs = 0;
    robotlink::CommandTable::Command count;
    count.name = "test.count";
    count.help = "Counts";
    count.run = [&](const robotlink::CommandTable::Values&) {
      ++runs;
      return robotlink::Result<void>();
    };
    bench.commands.add(count);
    Gamepad::State pad;
    const auto step = [&](MotionView& shown) {
      bench.tick(shown);
      QApplication::processEvents();
    };
    auto view = bench.open<MotionView>({760, 560});
    view->setGamepad([&] { return pad; });
    pad.connected = true;
    pad.commands = {{"x", "test.count"}};
    step(*view);
    step(*view);
    QCOMPARE(runs, 1);
    pad.commands.clear();
    step(*view);
    pad.commands = {{"x", "test.count"}, {"y", "test.nothing"}};
    step(*view);
    QCOMPARE(runs, 2);
    step(*view);
    QVERIFY(child<QLabel>(*view, "gamepadState").text().startsWith(QStringLiteral("test.nothing: ")));
    bench.session.selectRobot("blue1");
    step(*view);
    step(*view);
    QCOMPARE(runs, 2);  // the button is still held
  }

  void whatTheGamepadDoesIsChosenInADialog() {
    Bench bench;
    GamepadSettings settings;
    GamepadDialog dialog(settings, bench.commands, nullptr);
    dialog.show();
    auto& buttons = child<QTableWidget>(dialog, "gamepadButtons");
    buttons.item(2, 1)->setText(QStringLiteral("no.such command"));
    QVERIFY(child<QLabel>(dialog, "gamepadResult").text().contains(QStringLiteral("no.such")));
    QCOMPARE(settings.bindings().buttons.at("x"), std::string("no.such command"));
    buttons.item(1, 1)->setText(QStringLiteral("-"));
    QCOMPARE(settings.bindings().buttons.at("b"), std::string());
    auto& axes = child<QTableWidget>(dialog, "gamepadAxes");
    static_cast<QComboBox*>(axes.cellWidget(3, 1))->setCurrentIndex(3);
    static_cast<QDoubleSpinBox*>(axes.cellWidget(3, 2))->setValue(0.4);
    QCOMPARE(settings.bindings().axes[3].deadZone, 0.4);
    QVERIFY(settings.bindings().axes[3].use == GamepadBindings::Axis::Use::kTurn);
    click(child<QWidget>(dialog, "gamepadReset"));
    QVERIFY(settings.bindings() == GamepadBindings());
    QCOMPARE(buttons.item(1, 1)->text(), QString());
  }
};

const GuiTest<GamepadViewTest> kGamepadViewTest;

}  // namespace widgets::test

#include "GamepadViewTest.moc"
