// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogs that are made from what the adapters of platforms declare: that of a robot at the end of a
// line, that of a simulation, and that of a platform that only this test knows.
#include "app/robotcontrol/actions/PlatformDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSpinBox>

#include "app/core/platform/PlatformAdapter.h"
#include "app/robotcontrol/actions/FormMemory.h"
#include "robotcontrol/Driving.pb.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/Bench.h"

namespace app::test {
namespace {

using widgets::test::Bench;
using widgets::test::child;
using widgets::test::click;
using Values = std::vector<FormValue>;

/// The form of a registered adapter.
PlatformForm formOfAdapter(const char* name) {
  for (const auto& adapter : platformAdapters()) {
    if (std::string(adapter.name) == name) return formOf(adapter);
  }
  qFatal("there is no adapter %s", name);
}

/// A dialog that is shown, and what it ran.
struct ShownForm : Bench {
  ShownForm(PlatformForm form, const QJsonObject& kept) {
    std::vector<robotlink::CommandTable::Argument> arguments;
    for (const auto* field : form.arguments()) {
      arguments.push_back(
          {field->name, static_cast<robotlink::CommandTable::Type>(field->initial.index()), ""});
    }
    commands.add({form.command, "", arguments, [this](const Values& values) -> robotlink::Result<void> {
                    ran = values;
                    if (!reason.empty()) return robotlink::failure("test", reason);
                    return {};
                  }});
    session.setRobots({"p3at1"});
    memory.load(kept);
    name = form.name;
    dialog = std::make_unique<PlatformDialog>(std::move(form), session, commands, memory);
    dialog->show();
    if (!QTest::qWaitForWindowActive(dialog.get())) qFatal("the dialog never became active");
  }
  template <typename W>
  W& find(const char* field) {
    return child<W>(*dialog, (name + field).c_str());
  }
  QString text(const char* label) { return find<QLabel>(label).text(); }
  QPushButton& button() { return find<QPushButton>("Button"); }

  FormMemory memory;
  std::string name, reason;
  Values ran;
  std::unique_ptr<PlatformDialog> dialog;
};

/// The form of a robot at the end of a line, on a computer with two serial ports.
struct ShownDialog : ShownForm {
  explicit ShownDialog(const QStringList& recent = {})
      : ShownForm(withPorts(defaultPorts()),
                  {{QStringLiteral("recent_robots"), QJsonArray::fromStringList(recent)}}) {
    address = find<QComboBox>("Address").lineEdit();
  }
  static PlatformField::Items defaultPorts() {
    return {{"/dev/ttyUSB0", "/dev/ttyUSB0", "FTDI adapter"},
            {"/dev/ttyS0", "/dev/ttyS0", "built-in serial port"}};
  }
  static PlatformForm withPorts(const PlatformField::Items& found) {
    ports = found;
    PlatformForm form = formOfAdapter("pioneer");
    for (auto& field : form.fields) {
      if (field.name == "device") field.items = [] { return ports; };
    }
    return form;
  }
  void type(const QString& text) {
    address->setFocus();
    address->selectAll();
    QTest::keyClicks(address, text);
  }
  QStringList asked() const {
    QStringList texts;
    for (const auto& value : ran) texts << QString::fromStdString(std::get<std::string>(value));
    return texts;
  }
  void publish(robotcontrol::LinkStatus::State state, const std::string& words) {
    robotcontrol::LinkStatus status;
    status.set_state(state);
    status.set_address(asked().first().toStdString());
    status.set_robot_name("MobileSim");
    status.set_text(words);
    push("p3at1/link/status", status, time += 1);
    session.tick();
    dialog->tick();
  }

  static inline PlatformField::Items ports;
  double time = 0;
  QLineEdit* address = nullptr;
};

}  // namespace

class PlatformDialogTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void anAddressIsReadWhileItIsTyped() {
    ShownDialog s;
    QCOMPARE(s.address->text(), QStringLiteral("tcp://localhost:8101"));
    QCOMPARE(s.text("AddressNote"), QStringLiteral("over the network: localhost, port 8101"));
    s.type(QStringLiteral("tcp://10.0.0.7:8103"));
    QCOMPARE(s.find<QLineEdit>("Host").text(), QStringLiteral("10.0.0.7"));
    QCOMPARE(s.find<QSpinBox>("Port").value(), 8103);
    s.type(QStringLiteral("tcp://10.0.0.7:81030"));
    QVERIFY(s.text("AddressNote").contains(QStringLiteral("1 to 65535")));
    QVERIFY(!s.button().isEnabled());
    s.type(QStringLiteral("serial:///dev/ttyUSB0?baud=38400"));
    QVERIFY(s.find<QRadioButton>("Serial").isChecked());
    QCOMPARE(s.find<QComboBox>("Baud").currentText(), QStringLiteral("38400"));
    QVERIFY(s.button().isEnabled());
  }

  void theFieldsMakeTheAddress() {
    ShownDialog s;
    auto& port = s.find<QSpinBox>("Port");
    port.setFocus();
    QTest::keyClick(&port, Qt::Key_Up);
    QCOMPARE(s.address->text(), QStringLiteral("tcp://localhost:8102"));
    auto& host = s.find<QLineEdit>("Host");
    host.setFocus();
    host.selectAll();
    QTest::keyClick(&host, Qt::Key_Backspace);
    QVERIFY(s.text("AddressNote").contains(QStringLiteral("host is missing")));
    auto& serial = s.find<QRadioButton>("Serial");
    QTest::mouseClick(&serial, Qt::LeftButton, {}, {8, serial.height() / 2});
    QVERIFY2(s.address->text().startsWith(QStringLiteral("serial:///dev/ttyUSB0")),
             qPrintable(s.address->text()));
    auto& device = s.find<QComboBox>("Device");
    device.setFocus();
    QTest::keyClick(&device, Qt::Key_Down);
    QVERIFY(s.address->text().contains(QStringLiteral("/dev/ttyS0")));
  }

  void portsThatWerePluggedInAreFoundAgain() {
    ShownDialog s;
    ShownDialog::ports = {{"/dev/ttyUSB7", "/dev/ttyUSB7", "adapter"}};
    QTest::mouseClick(&s.find<QRadioButton>("Serial"), Qt::LeftButton, {}, {8, 8});
    click(s.find<QWidget>("DeviceAgain"));
    QVERIFY(s.find<QComboBox>("Device").findText(QStringLiteral("/dev/ttyUSB7")) >= 0);
  }

  void connectingRunsTheCommandAndShowsItsProgress() {
    ShownDialog s({QStringLiteral("tcp://localhost:8105"), QStringLiteral("tcp://robot:8101")});
    QCOMPARE(s.address->text(), QStringLiteral("tcp://localhost:8105"));
    s.type(QStringLiteral("tcp://robot"));
    auto& map = s.find<QLineEdit>("Map");
    map.setFocus();
    QTest::keyClicks(&map, QStringLiteral("/maps/office.map"));
    auto& layout = s.find<QComboBox>("Layout");
    layout.setFocus();
    QTest::keyClick(&layout, Qt::Key_Down);
    QSignalSpy connected(s.dialog.get(), &PlatformDialog::connected);
    click(s.button());
    QCOMPARE(s.asked(), QStringList({QStringLiteral("tcp://robot:8101"), QStringLiteral("pioneer-mapping"),
                                     QStringLiteral("/maps/office.map")}));
    QJsonObject kept;
    s.memory.save(kept);
    QCOMPARE(kept.value(QStringLiteral("robot_map")).toString(), QStringLiteral("/maps/office.map"));
    QCOMPARE(kept.value(QStringLiteral("recent_robots")).toVariant().toStringList(),
             QStringList({QStringLiteral("tcp://robot:8101"), QStringLiteral("tcp://localhost:8105")}));
    QVERIFY(s.find<QProgressBar>("Progress").isVisible());
    QVERIFY(!s.button().isEnabled());
    s.publish(robotcontrol::LinkStatus::LOST, "nobody listens at tcp://robot:8101; it is tried again in 2 s");
    QVERIFY(s.text("State").contains(QStringLiteral("nobody listens")));
    s.publish(robotcontrol::LinkStatus::CONNECTING, "waits for the robot's answer to SYNC1");
    QVERIFY(s.dialog->isVisible());
    s.publish(robotcontrol::LinkStatus::CONNECTED, "");
    QCOMPARE(connected.size(), 1);
    QVERIFY(!s.dialog->isVisible());
  }

  void anAddressNeedsNoSchemeWhereItIsClear() {
    ShownDialog s;
    s.type(QStringLiteral("localhost:8291"));
    QCOMPARE(s.text("AddressNote"), QStringLiteral("over the network: localhost, port 8291"));
    QVERIFY(s.button().isEnabled());
    click(s.button());
    QCOMPARE(s.asked().first(), QStringLiteral("tcp://localhost:8291"));
  }

  void whileItWaitsTheUserCanLetItTryAtOnce() {
    ShownDialog s;
    int now = 0;
    s.commands.add({"robot.connect-now", "", {}, [&](const auto&) -> robotlink::Result<void> {
                      ++now;
                      return {};
                    }});
    auto& button = s.find<QPushButton>("Now");
    QVERIFY(!button.isVisible());
    click(s.button());
    QVERIFY(!button.isVisible());
    s.publish(robotcontrol::LinkStatus::LOST, "waits 16 s before it connects again");
    QVERIFY(button.isVisible());
    click(button);
    QCOMPARE(now, 1);
    s.publish(robotcontrol::LinkStatus::CONNECTING, "opens the line");
    QVERIFY(!button.isVisible());
  }

  void whatIsRefusedIsSaid() {
    ShownDialog s;
    s.reason = "there is no layout of this name";
    click(s.button());
    QCOMPARE(s.text("State"), QStringLiteral("there is no layout of this name"));
    QVERIFY(s.button().isEnabled());
    s.reason.clear();
    click(s.button());
    s.dialog->fail(QStringLiteral("office.map:3: this is no map"));  // found out later
    QVERIFY(s.text("State").contains(QStringLiteral("no map")));
    QVERIFY(s.button().isEnabled());
  }

  void aSimulationIsSetUpWithTheChoicesOfTheLastTime() {
    // As the window's file had them before forms were declared by adapters.
    const QJsonArray last{QStringLiteral("house"), QStringLiteral("burger"), 3, true, 8200, false,
                          QStringLiteral("both")};
    ShownForm s(formOfAdapter("simulation"), {{QStringLiteral("simulation_setup"), last}});
    QCOMPARE(s.find<QComboBox>("Scene").currentText(), QStringLiteral("house"));
    QCOMPARE(s.find<QComboBox>("Kind").currentText(), QStringLiteral("TurtleBot 3 Burger"));
    QCOMPARE(s.find<QSpinBox>("Robots").value(), 3);
    QVERIFY(s.find<QCheckBox>("Kinematic").isChecked());
    QVERIFY(s.find<QCheckBox>("PortOn").isChecked());
    QCOMPARE(s.find<QSpinBox>("Port").value(), 8200);
    QVERIFY(!s.find<QComboBox>("Teams").isEnabled());  // burgers play in none
    click(s.find<QCheckBox>("PortOn"));
    QVERIFY(!s.find<QSpinBox>("Port").isEnabled());
    QVERIFY(!s.find<QCheckBox>("Network").isEnabled());
    click(s.button());
    QCOMPARE(s.dialog->result(), static_cast<int>(QDialog::Accepted));
    const Values expected{std::string("house"),
                          std::string("burger"),
                          3.0,
                          true,
                          0.0,
                          false,
                          std::string("both"),
                          true,
                          std::string(),
                          0.0};
    QVERIFY(s.dialog->arguments() == expected);
    QJsonObject kept;
    s.memory.save(kept);
    QJsonArray next = last;
    next.replace(4, 0);
    // Noise, folders of models and threads, which earlier versions did not ask for.
    next.append(true);
    next.append(QString());
    next.append(0);
    QCOMPARE(kept.value(QStringLiteral("simulation_setup")).toArray(), next);
  }

  void aMapGetsARobotAndSaysSoIfItGetsNone() {
    ShownForm s(formOfAdapter("simulation"), {});
    QCOMPARE(s.find<QComboBox>("Kind").currentText(),
             QStringLiteral("Sony Aibo ERS-210"));  // as in the scene
    QCOMPARE(s.find<QSpinBox>("Robots").value(), 0);
    s.find<QComboBox>("Scene").setEditText(QStringLiteral("house"));
    QCOMPARE(s.find<QComboBox>("Kind").currentText(), QStringLiteral("Pioneer 3-AT"));
    QCOMPARE(s.find<QSpinBox>("Robots").value(), 1);
    s.find<QSpinBox>("Robots").setValue(0);
    QVERIFY(s.text("State").contains(QStringLiteral("contains no robots")));
    s.find<QComboBox>("Scene").setEditText(QString());
    QVERIFY(!s.button().isEnabled());
  }

  void aFormThatNobodyKnowsIsShownWithAllItsFields() {
    using Kind = PlatformField::Kind;
    PlatformForm form{.name = "remote", .command = "remote.open", .title = "Remote robot", .accept = "&Open"};
    form.fields = {
        {.name = "host", .label = "&Host:", .initial = std::string("robot"), .isSource = true},
        {.name = "speed",
         .kind = Kind::kNumber,
         .label = "Speed:",
         .initial = 0.5,
         .max = 2,
         .decimals = 2,
         .unit = "m/s",
         .group = "Limits",
         .remembered = "remote/0"},
        {.name = "slow", .kind = Kind::kFlag, .label = "Slowly", .initial = false, .group = "Limits"},
        {.name = "team",
         .kind = Kind::kChoice,
         .label = "Team:",
         .initial = std::string("blue"),
         .items = [] {
           return PlatformField::Items{{"Red", "red"}, {"Blue", "blue"}};
         }}};
    form.follow = [](FormState& state, const std::string&) {
      if (flagOf(state.values, "slow")) state.disabled.insert("speed");
      if (textOf(state.values, "team") == "red") state.hidden.insert("speed");
    };
    ShownForm s(form, {});
    auto& speed = s.find<QDoubleSpinBox>("Speed");
    QCOMPARE(speed.text(), QStringLiteral("0.50 m/s"));
    QCOMPARE(qobject_cast<QGroupBox*>(speed.parentWidget()->parentWidget())->title(),
             QStringLiteral("Limits"));
    speed.setValue(9);
    QCOMPARE(speed.value(), 2.0);
    QTest::mouseClick(&s.find<QCheckBox>("Slow"), Qt::LeftButton, {}, {8, 8});
    QVERIFY(!speed.isEnabled());
    s.find<QComboBox>("Team").setCurrentIndex(0);
    QVERIFY(!speed.isVisible());
    click(s.button());
    const Values expected{std::string("robot"), 2.0, true, std::string("red")};
    QVERIFY(s.dialog->arguments() == expected);
  }
};

const widgets::test::GuiTest<PlatformDialogTest> kPlatformDialogTest;

}  // namespace app::test

#include "PlatformDialogTest.moc"
