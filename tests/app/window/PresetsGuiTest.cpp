// SPDX-License-Identifier: GPL-3.0-or-later
// Presets in the workbench: saved, compared, loaded, renamed and deleted as a person does it.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>

#include "app/robotcontrol/presets/PresetActions.h"
#include "app/robotcontrol/presets/PresetsDialog.h"
#include "app/robotcontrol/presets/SweepDialog.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "widgets/solutions/ParameterEdits.h"
#include "widgets/solutions/ParameterSweep.h"

namespace app::test {
namespace {

using robotlink::Preset;

constexpr char kKey[] = "package/models/ball";

struct PresetDesk : Desk {
  explicit PresetDesk(const std::filesystem::path& home) : Desk(home) {
    workbench.session().setRefusalHandler([this](const std::string&, const std::string& reason) {
      refusals << QString::fromStdString(reason);
    });
  }
  PresetActions& actions() {
    auto* found = window.findChild<PresetActions*>();
    if (found == nullptr) qFatal("there are no presets");
    return *found;
  }
  /// The error's text; empty: none.
  QString run(const QString& line) {
    const auto done = workbench.commands().runLine(line.toStdString());
    return done ? QString() : QString::fromStdString(done.error().describe());
  }
  bool isOn(const char* key) { return robotlink::keysThatAreOn(workbench.session()).contains(key); }
  bool hasTables() { return !robotlink::activeSolutions(workbench.session()).empty(); }
  QStringList refusals;
};

}  // namespace

class PresetsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aPresetIsSavedComparedLoadedRenamedAndDeleted() {
    PresetDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.hasTables(), kWaitMs);
    QCOMPARE(desk.run(QStringLiteral("robot.key package/models/ball")), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.isOn(kKey), kWaitMs);
    PresetsDialog dialog(desk.actions(), &desk.window);
    dialog.show();
    auto& list = child<QListWidget>(dialog, "presetsList");
    auto& differences = child<QPlainTextEdit>(dialog, "presetsDifferences");
    auto& name = child<QLineEdit>(dialog, "presetsName");
    QCOMPARE(list.count(), 0);
    name.setText(QStringLiteral("mine"));
    click(child<QPushButton>(dialog, "presetsSave"));
    QTRY_COMPARE_WITH_TIMEOUT(list.count(), 1, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(differences.toPlainText().contains(QStringLiteral("match this preset")),
                             kWaitMs);
    QCOMPARE(desk.run(QStringLiteral("robot.key package/models/ball off")), QString());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.isOn(kKey), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(
        differences.toPlainText().contains(QStringLiteral("keys: package/models/ball is off, not always")),
        kWaitMs);
    widgets::test::keepPicture(dialog, "presets");
    click(child<QPushButton>(dialog, "presetsLoad"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.isOn(kKey), kWaitMs);
    name.setText(QStringLiteral("yours"));
    click(child<QPushButton>(dialog, "presetsRename"));
    QCOMPARE(list.item(0)->text(), QStringLiteral("yours"));
    QVERIFY(desk.has("preset.yours"));
    click(child<QPushButton>(dialog, "presetsDelete"));
    QCOMPARE(list.count(), 0);
    QCOMPARE(desk.refusals, QStringList());
  }

  void parametersAndViewsBelongToAPreset() {
    PresetDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.hasTables(), kWaitMs);
    auto* edits = desk.window.findChild<widgets::ParameterEdits*>();
    const auto changes = [&] {
      std::optional<widgets::ParameterEdits::Changes> found;
      edits->requestChanges(
          [&](const auto& result) { found = result.value_or(widgets::ParameterEdits::Changes()); });
      [&] { QTRY_VERIFY_WITH_TIMEOUT(found.has_value(), kWaitMs); }();
      return found.value_or(widgets::ParameterEdits::Changes());
    };
    desk.window.docks().open(QStringLiteral("plots"));
    QCOMPARE(desk.run(QStringLiteral("robot.parameter ball-model/filtered memory 3")), QString());
    QTRY_COMPARE_WITH_TIMEOUT(changes().size(), std::size_t{1}, kWaitMs);
    QCOMPARE(desk.run(QStringLiteral("preset.save tuned parameters,views")), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("preset.tuned"), kWaitMs);
    QCOMPARE(desk.run(QStringLiteral("parameters.reset")), QString());
    QTRY_VERIFY_WITH_TIMEOUT(changes().empty(), kWaitMs);
    desk.window.docks().close(QStringLiteral("plots"));
    QCOMPARE(desk.run(QStringLiteral("preset.diff tuned")), QString());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.refusals.isEmpty(), kWaitMs);
    QVERIFY(desk.refusals.takeFirst().contains(QStringLiteral("memory is the default, not 3")));
    QCOMPARE(desk.run(QStringLiteral("preset.load tuned")), QString());
    QTRY_COMPARE_WITH_TIMEOUT(changes().size(), std::size_t{1}, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.window.docks().isOpen(QStringLiteral("plots")), kWaitMs);
    QCOMPARE(desk.refusals, QStringList());
  }

  void settingsOfTheCameraAreLoaded() {
    PresetDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.hasTables(), kWaitMs);
    Preset dark;
    dark.parts[Preset::kCamera] = Preset::Values{{"exposure", "0.5"}};
    QVERIFY(desk.actions().presets().save("dark", dark));
    QCOMPARE(desk.run(QStringLiteral("preset.load dark")), QString());
    QCOMPARE(desk.run(QStringLiteral("robot.key package/camera/settings")), QString());
    QCOMPARE(desk.run(QStringLiteral("simulation.start")), QString());
    const auto isLoaded = [&desk, &dark] {
      return robotlink::cameraSettings(desk.workbench.session()) == dark.parts[Preset::kCamera];
    };
    QTRY_VERIFY_WITH_TIMEOUT(isLoaded(), kWaitMs);
    QCOMPARE(desk.run(QStringLiteral("preset.diff dark")), QString());
    QCOMPARE(desk.refusals, QStringList());
  }

  void whatIsNoPresetIsReported() {
    PresetDesk desk(home_);
    QVERIFY(desk.run(QStringLiteral("preset.load nothing")).contains(QStringLiteral("nothing")));
    QVERIFY(desk.run(QStringLiteral("preset.save a/../b wings")).contains(QStringLiteral("wings")));
    QVERIFY(!desk.run(QStringLiteral("preset.save ''")).isEmpty());
    QVERIFY(!desk.run(QStringLiteral("preset.delete nothing")).isEmpty());
  }

  void aParameterIsSwept() {
    PresetDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.hasTables(), kWaitMs);
    QCOMPARE(desk.run(QStringLiteral("simulation.speed 0")), QString());
    QCOMPARE(desk.run(QStringLiteral("simulation.start")), QString());
    auto* sweep = desk.window.findChild<widgets::ParameterSweep*>();
    auto* edits = desk.window.findChild<widgets::ParameterEdits*>();
    SweepDialog dialog(*sweep, *edits, &desk.window);
    dialog.show();
    child<QComboBox>(dialog, "sweepTask").setCurrentText(QStringLiteral("ball-model/filtered"));
    child<QComboBox>(dialog, "sweepPath").setCurrentText(QStringLiteral("memory"));
    child<QLineEdit>(dialog, "sweepValues").setText(QStringLiteral("2,3"));
    child<QLineEdit>(dialog, "sweepFigure").setText(QStringLiteral("simulation.time"));
    child<QDoubleSpinBox>(dialog, "sweepSeconds").setValue(0.5);
    click(child<QPushButton>(dialog, "sweepStart"));
    QVERIFY(sweep->isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(!sweep->isRunning(), kWaitMs);
    auto& table = child<QTableWidget>(dialog, "sweepTable");
    QCOMPARE(table.rowCount(), 2);
    QVERIFY(table.item(1, 2)->text().toDouble() > table.item(0, 2)->text().toDouble());
    widgets::test::keepPicture(dialog, "sweep");
  }
};

const widgets::test::GuiTest<PresetsGuiTest> kPresetsGuiTest;

}  // namespace app::test

#include "PresetsGuiTest.moc"
