// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/FieldEditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>

#include "tests/widgets/Bench.h"

namespace app::test {
namespace {

using widgets::test::child;
using widgets::test::click;
using Kind = PlatformField::Kind;

/// One field of the form "connect", as its user sees it.
struct ShownField {
  explicit ShownField(PlatformField described) : field(std::move(described)) {
    window.show();
    if (!QTest::qWaitForWindowActive(&window)) qFatal("the window never became active");
  }
  template <typename W>
  W& find(const char* name) {
    return child<W>(window, name);
  }
  void type(QWidget& widget, const char* text) {
    widget.setFocus();
    QTest::keyClicks(&widget, QLatin1String(text));
  }

  const PlatformField field;
  QWidget window;
  const std::unique_ptr<FieldEditor> editor = std::make_unique<FieldEditor>(field, "connect", &window);
  QSignalSpy changes{editor.get(), &FieldEditor::changed};
};

FormValue text(const char* value) {
  return std::string(value);
}

PlatformField::Items twoPorts() {
  return {{"USB adapter", "/dev/ttyUSB0", "of the robot"}, {"Built in", "/dev/ttyS0"}};
}

PlatformField portField() {
  return {.name = "port", .kind = Kind::kChoice, .label = "&Port:", .items = twoPorts};
}

}  // namespace

class FieldEditorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aTextIsWhatWasTypedWithoutSpacesAround() {
    ShownField shown(
        {.name = "host", .label = "&Host name:", .help = "Where it is", .emptyText = "this one"});
    auto& line = shown.find<QLineEdit>("connectHost");
    QCOMPARE(line.placeholderText(), QStringLiteral("this one"));
    QCOMPARE(line.toolTip(), QStringLiteral("Where it is"));
    QCOMPARE(line.accessibleName(), QStringLiteral("Host name"));
    shown.type(line, " robot ");
    QVERIFY(shown.editor->value() == text("robot"));
    QCOMPARE(shown.changes.count(), 7);
    QCOMPARE(shown.editor->wideWidget(), &line);
    QCOMPARE(shown.editor->focusWidget(), &line);
  }

  void whatTheProgramSetsIsNoChangeOfTheUser() {
    ShownField shown({.name = "host", .initial = std::string("localhost")});
    QVERIFY(shown.editor->value() == text("localhost"));
    shown.editor->setValue(text("robot"));
    QVERIFY(shown.editor->value() == text("robot"));
    QCOMPARE(shown.changes.count(), 0);
  }

  void aNumberStaysInItsRange() {
    ShownField shown({.name = "speed",
                      .kind = Kind::kNumber,
                      .initial = 1.0,
                      .min = 0,
                      .max = 10,
                      .decimals = 2,
                      .unit = "m/s",
                      .emptyText = "none"});
    auto& box = shown.find<QDoubleSpinBox>("connectSpeed");
    QCOMPARE(box.text(), QStringLiteral("1.00 m/s"));
    box.selectAll();
    shown.type(box, "0.25");
    QVERIFY(shown.editor->value() == FormValue(0.25));
    QVERIFY(shown.changes.count() > 0);
    shown.editor->setValue(99.0);
    QVERIFY(shown.editor->value() == FormValue(10.0));
    shown.editor->setValue(0.0);
    QCOMPARE(box.text(), QStringLiteral("none"));
    QVERIFY(shown.editor->wideWidget() == nullptr);
  }

  void aNumberWithoutDecimalsIsWhole() {
    ShownField shown({.name = "robots", .kind = Kind::kNumber, .initial = 2.0, .max = 11});
    auto& box = shown.find<QSpinBox>("connectRobots");
    QCOMPARE(box.maximum(), 11);
    QTest::keyClick(&box, Qt::Key_Up);
    QVERIFY(shown.editor->value() == FormValue(3.0));
    QCOMPARE(shown.changes.count(), 1);
  }

  void aFlagIsABoxWithItsText() {
    ShownField shown({.name = "own", .kind = Kind::kFlag, .label = "In its own process", .initial = true});
    auto& box = shown.find<QCheckBox>("connectOwn");
    QCOMPARE(box.text(), QStringLiteral("In its own process"));
    QVERIFY(shown.editor->value() == FormValue(true));
    click(box);
    QVERIFY(shown.editor->value() == FormValue(false));
    QCOMPARE(shown.changes.count(), 1);
  }

  void aChoiceShowsTitlesAndMeansValues() {
    ShownField shown(portField());
    auto& box = shown.find<QComboBox>("connectPort");
    QVERIFY(!box.isEditable());
    QCOMPARE(box.itemText(1), QStringLiteral("Built in"));
    QCOMPARE(box.itemData(0, Qt::ToolTipRole).toString(), QStringLiteral("of the robot"));
    QVERIFY(shown.editor->value() == text("/dev/ttyUSB0"));
    QTest::keyClick(&box, Qt::Key_Down);
    QVERIFY(shown.editor->value() == text("/dev/ttyS0"));
    QCOMPARE(shown.changes.count(), 1);
  }

  void aValueThatIsNoChoiceAnyMoreIsKeptAsOne() {
    ShownField shown(portField());
    auto& box = shown.find<QComboBox>("connectPort");
    shown.editor->setValue(text("/dev/ttyACM7"));
    QVERIFY(shown.editor->value() == text("/dev/ttyACM7"));
    QCOMPARE(box.count(), 3);
    shown.editor->setItems({{"Built in", "/dev/ttyS0"}});
    QVERIFY2(shown.editor->value() == text("/dev/ttyACM7"), "the value stays when choices are listed again");
    QCOMPARE(shown.changes.count(), 0);
  }

  void whatIsTypedIntoAChoiceIsAValueOrTheTitleOfOne() {
    PlatformField field = portField();
    field.editable = true;
    field.emptyText = "a port";
    ShownField shown(field);
    auto& line = *shown.find<QComboBox>("connectPort").lineEdit();
    QCOMPARE(line.placeholderText(), QStringLiteral("a port"));
    line.clear();
    shown.type(line, " /dev/mine ");
    QVERIFY(shown.editor->value() == text("/dev/mine"));
    line.clear();
    shown.type(line, "Built in");
    QVERIFY(shown.editor->value() == text("/dev/ttyS0"));
    shown.editor->setValue(text("/dev/ttyUSB0"));
    QCOMPARE(line.text(), QStringLiteral("USB adapter"));
    shown.editor->setValue(text("/dev/other"));
    QCOMPARE(line.text(), QStringLiteral("/dev/other"));
    QVERIFY(shown.editor->wideWidget() != nullptr);
  }

  void choicesThatMayComeLaterAreListedAgainByAButton() {
    static PlatformField::Items found;
    found = {};
    PlatformField field = portField();
    field.items = [] { return found; };
    field.listAgain = "Looks for ports again";
    ShownField shown(field);
    QVERIFY(shown.editor->value() == text(""));
    found = twoPorts();
    auto& again = shown.find<QToolButton>("connectPortAgain");
    QCOMPARE(again.toolTip(), QStringLiteral("Looks for ports again"));
    click(again);
    QVERIFY2(shown.editor->value() == text("/dev/ttyUSB0"), "what was found is better than nothing");
    shown.editor->setValue(text("/dev/ttyS0"));
    click(again);
    QVERIFY2(shown.editor->value() == text("/dev/ttyS0"), "what was chosen stays");
  }

  void buttonsAreNamedByTheirValues() {
    PlatformField field{
        .name = "way", .kind = Kind::kChoice, .initial = std::string("serial"), .buttons = true};
    field.items = [] {
      return PlatformField::Items{{"By &network", "network", "over TCP"}, {"By cable", "serial"}};
    };
    ShownField shown(field);
    auto& network = shown.find<QRadioButton>("connectNetwork");
    auto& cable = shown.find<QRadioButton>("connectSerial");
    QCOMPARE(network.accessibleName(), QStringLiteral("By network"));
    QCOMPARE(network.toolTip(), QStringLiteral("over TCP"));
    QVERIFY(cable.isChecked());
    click(network);
    QVERIFY(shown.editor->value() == text("network"));
    QVERIFY(!cable.isChecked());
    QCOMPARE(shown.changes.count(), 1);
    shown.editor->setValue(text("serial"));
    QVERIFY(cable.isChecked());
  }

  void aFieldWithABoxCountsOnlyWhileThatIsTicked() {
    ShownField shown({.name = "ports",
                      .kind = Kind::kNumber,
                      .label = "First port:",
                      .initial = 8101.0,
                      .min = 1,
                      .max = 65535,
                      .toggle = "Can be driven"});
    auto& box = shown.find<QCheckBox>("connectPortsOn");
    auto& number = shown.find<QSpinBox>("connectPorts");
    QCOMPARE(shown.editor->toggle(), &box);
    QVERIFY(!box.isChecked());
    QVERIFY(shown.editor->value() == FormValue(0.0));
    QCOMPARE(number.value(), 8101);
    shown.editor->setEnabled(true);
    QVERIFY(!number.isEnabled() && box.isEnabled());
    click(box);
    QVERIFY(shown.editor->value() == FormValue(8101.0));
    QCOMPARE(shown.changes.count(), 1);
    shown.editor->setEnabled(true);
    QVERIFY(number.isEnabled());
    shown.editor->setEnabled(false);
    QVERIFY(!number.isEnabled() && !box.isEnabled());
    shown.editor->setValue(0.0);
    QVERIFY(!box.isChecked());
    QCOMPARE(number.value(), 8101);
    shown.editor->setValue(9000.0);
    QVERIFY(box.isChecked());
    QVERIFY(shown.editor->value() == FormValue(9000.0));
  }

  void whatBelongsToAFieldIsHiddenAndShownWithIt() {
    ShownField shown({.name = "map", .kind = Kind::kFile, .files = "Maps (*.map)"});
    auto& note = *new QLabel(QStringLiteral("a map of 2 MB"), &shown.window);
    shown.editor->addCompanion(&note);
    auto& browse = shown.find<QToolButton>("connectMapBrowse");
    QVERIFY(shown.find<QLineEdit>("connectMap").isClearButtonEnabled());
    shown.editor->setVisible(false);
    QVERIFY(note.isHidden() && browse.isHidden());
    shown.editor->setVisible(true);
    QVERIFY(!note.isHidden() && !browse.isHidden());
    shown.editor->setEnabled(false);
    QVERIFY(!note.isEnabled() && !browse.isEnabled());
  }
};

const widgets::test::GuiTest<FieldEditorTest> kFieldEditorTest;

}  // namespace app::test

#include "FieldEditorTest.moc"
