// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/ConnectDialog.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSpinBox>

#include "tests/widgets/FieldBench.h"
#include "tests/widgets/drive/DriveBench.h"

namespace widgets::test {
namespace {

struct ShownDialog : DriveBench {
  using Values = std::vector<robotlink::CommandTable::Value>;

  explicit ShownDialog(QStringList recent = {}) {
    commands.add({"robot.connect",
                  "",
                  {{"address", robotlink::CommandTable::Type::kText, ""},
                   {"layout", robotlink::CommandTable::Type::kText, ""},
                   {"map", robotlink::CommandTable::Type::kText, ""}},
                  [this](const Values& values) -> robotlink::Result<void> {
                    asked.clear();
                    for (const auto& value : values)
                      asked << QString::fromStdString(std::get<std::string>(value));
                    if (!refusal.empty()) return robotlink::failure("test", refusal);
                    return {};
                  }});
    widgets::ConnectDialog::Choices choices;
    choices.recent = std::move(recent);
    choices.serialPorts = [this] { return ports; };
    choices.layouts = {{QStringLiteral("pioneer"), QStringLiteral("pioneer")}};
    dialog = std::make_unique<widgets::ConnectDialog>(session, commands, choices);
    dialog->show();
    if (!QTest::qWaitForWindowActive(dialog.get())) qFatal("the dialog never became active");
    address = child<QComboBox>(*dialog, "connectAddress").lineEdit();
  }
  void type(const QString& text) {
    address->setFocus();
    address->selectAll();
    QTest::keyClicks(address, text);
  }
  QString text(const char* label) { return child<QLabel>(*dialog, label).text(); }
  QPushButton& button() { return child<QPushButton>(*dialog, "connectButton"); }
  void publish(robotcontrol::LinkStatus::State state, const std::string& words) {
    robotcontrol::LinkStatus status;
    status.set_state(state);
    status.set_address(asked.first().toStdString());
    status.set_robot_name("MobileSim");
    status.set_text(words);
    push("p3at1/link/status", status, time += 1);
    session.tick();
    dialog->tick();
  }

  std::vector<robotlink::arcos::SerialPort> ports{{"/dev/ttyUSB0", "FTDI adapter"},
                                                  {"/dev/ttyS0", "built-in serial port"}};
  QStringList asked;
  std::string refusal;
  double time = 0;
  std::unique_ptr<widgets::ConnectDialog> dialog;
  QLineEdit* address = nullptr;
};

}  // namespace

class ConnectDialogTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anAddressIsReadWhileItIsTyped() {
    ShownDialog s;
    QCOMPARE(s.address->text(), QStringLiteral("tcp://localhost:8101"));
    QCOMPARE(s.text("connectMeaning"), QStringLiteral("over the network: localhost, port 8101"));
    s.type(QStringLiteral("tcp://10.0.0.7:8103"));
    QCOMPARE(child<QLineEdit>(*s.dialog, "connectHost").text(), QStringLiteral("10.0.0.7"));
    QCOMPARE(child<QSpinBox>(*s.dialog, "connectPort").value(), 8103);
    s.type(QStringLiteral("tcp://10.0.0.7:81030"));
    QVERIFY(s.text("connectMeaning").contains(QStringLiteral("1 to 65535")));
    QVERIFY(!s.button().isEnabled());
    s.type(QStringLiteral("serial:///dev/ttyUSB0?baud=38400"));
    QVERIFY(child<QRadioButton>(*s.dialog, "connectSerial").isChecked());
    QCOMPARE(child<QComboBox>(*s.dialog, "connectBaud").currentText(), QStringLiteral("38400"));
    QVERIFY(s.button().isEnabled());
  }

  void theFieldsMakeTheAddress() {
    ShownDialog s;
    auto& port = child<QSpinBox>(*s.dialog, "connectPort");
    port.setFocus();
    QTest::keyClick(&port, Qt::Key_Up);
    QCOMPARE(s.address->text(), QStringLiteral("tcp://localhost:8102"));
    auto& host = child<QLineEdit>(*s.dialog, "connectHost");
    host.setFocus();
    host.selectAll();
    QTest::keyClick(&host, Qt::Key_Backspace);
    QVERIFY(s.text("connectMeaning").contains(QStringLiteral("host is missing")));
    auto& serial = child<QRadioButton>(*s.dialog, "connectSerial");
    QTest::mouseClick(&serial, Qt::LeftButton, {}, {8, serial.height() / 2});
    QVERIFY2(s.address->text().startsWith(QStringLiteral("serial:///dev/ttyUSB0")),
             qPrintable(s.address->text()));
    auto& device = child<QComboBox>(*s.dialog, "connectDevice");
    device.setFocus();
    QTest::keyClick(&device, Qt::Key_Down);
    QVERIFY(s.address->text().contains(QStringLiteral("/dev/ttyS0")));
  }

  void portsThatWerePluggedInAreFoundAgain() {
    ShownDialog s;
    s.ports = {{"/dev/ttyUSB7", "adapter"}};
    QTest::mouseClick(&child<QRadioButton>(*s.dialog, "connectSerial"), Qt::LeftButton, {}, {8, 8});
    click(child<QWidget>(*s.dialog, "connectLookAgain"));
    QVERIFY(child<QComboBox>(*s.dialog, "connectDevice").findText(QStringLiteral("/dev/ttyUSB7")) >= 0);
  }

  void connectingRunsTheCommandAndTellsHowItGoes() {
    ShownDialog s({QStringLiteral("tcp://localhost:8105"), QStringLiteral("tcp://robot:8101")});
    QCOMPARE(s.address->text(), QStringLiteral("tcp://localhost:8105"));
    s.type(QStringLiteral("tcp://robot"));
    auto& map = child<QLineEdit>(*s.dialog, "connectMap");
    map.setFocus();
    QTest::keyClicks(&map, QStringLiteral("/maps/office.map"));
    auto& layout = child<QComboBox>(*s.dialog, "connectLayout");
    layout.setFocus();
    QTest::keyClick(&layout, Qt::Key_Down);
    QSignalSpy connected(s.dialog.get(), &widgets::ConnectDialog::connected);
    click(s.button());
    QCOMPARE(s.asked, QStringList({QStringLiteral("tcp://robot:8101"), QStringLiteral("pioneer"),
                                   QStringLiteral("/maps/office.map")}));
    QCOMPARE(s.dialog->recent(),
             QStringList({QStringLiteral("tcp://robot:8101"), QStringLiteral("tcp://localhost:8105")}));
    QVERIFY(child<QProgressBar>(*s.dialog, "connectProgress").isVisible());
    QVERIFY(!s.button().isEnabled());
    s.publish(robotcontrol::LinkStatus::LOST, "nobody listens at tcp://robot:8101; it is tried again in 2 s");
    QVERIFY(s.text("connectState").contains(QStringLiteral("nobody listens")));
    keepPicture(*s.dialog, "connect-dialog");
    s.publish(robotcontrol::LinkStatus::CONNECTING, "waits for the robot's answer to SYNC1");
    QVERIFY(s.dialog->isVisible());
    s.publish(robotcontrol::LinkStatus::CONNECTED, "");
    QCOMPARE(connected.size(), 1);
    QVERIFY(!s.dialog->isVisible());
  }

  void anAddressNeedsNoSchemeWhereItIsClear() {
    ShownDialog s;
    s.type(QStringLiteral("localhost:8291"));
    QCOMPARE(s.text("connectMeaning"), QStringLiteral("over the network: localhost, port 8291"));
    QVERIFY(s.button().isEnabled());
    click(s.button());
    QCOMPARE(s.asked.first(), QStringLiteral("tcp://localhost:8291"));
  }

  void whileItWaitsItCanBeToldToTryAtOnce() {
    ShownDialog s;
    int now = 0;
    s.commands.add({"robot.connect-now", "", {}, [&](const auto&) -> robotlink::Result<void> {
                      ++now;
                      return {};
                    }});
    auto& button = child<QPushButton>(*s.dialog, "connectNow");
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
    s.refusal = "there is no layout of this name";
    click(s.button());
    QCOMPARE(s.text("connectState"), QStringLiteral("there is no layout of this name"));
    QVERIFY(s.button().isEnabled());
    s.refusal.clear();
    click(s.button());
    s.dialog->fail(QStringLiteral("office.map:3: this is no map"));  // found out later
    QVERIFY(s.text("connectState").contains(QStringLiteral("no map")));
    QVERIFY(s.button().isEnabled());
  }
};

const GuiTest<ConnectDialogTest> kConnectDialogTest;

}  // namespace widgets::test

#include "ConnectDialogTest.moc"
