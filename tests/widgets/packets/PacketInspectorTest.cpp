// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketInspector.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QProgressBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>

#include "robotlink/arcos/codec/Command.h"
#include "tests/robotlink/arcos/Recordings.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/FieldBench.h"
#include "tests/widgets/drive/DriveBench.h"
#include "widgets/packets/PacketConversation.h"

namespace widgets::test {

using robotlink::arcos::Bytes;
using robotlink::arcos::Command;

namespace {

Bytes command(int id, int argument) {
  return encode(toPacket(Command{static_cast<std::uint8_t>(id), argument}));
}
Bytes bare(int id) {
  return encode(robotlink::arcos::Packet{static_cast<std::uint8_t>(id), {}});
}
/// A short information packet: it ends behind the number of its sonar readings.
Bytes information() {
  return robotlink::arcos::encode(
      {0x32, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 130, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0}});
}

struct ShownInspector : DriveBench {
  ShownInspector() {
    view = open<widgets::PacketInspector>({900, 420});
    table = &child<QTableView>(*view, "packetsTable");
  }
  void pushTalk() {
    pushPackets({{false, command(11, 250)}, {false, command(21, -10)}}, 1);
    pushPackets({{true, information()}}, 1.1);
    auto damaged = bare(0);
    damaged.back() ^= 1U;
    pushPackets({{true, damaged}}, 1.2);
    tick(*view);
  }
  int rows() const { return table->model()->rowCount(); }
  QString cell(int row, int column) const { return table->model()->index(row, column).data().toString(); }
  QString state() { return child<QLabel>(*view, "packetsState").text(); }
  /// The packets that were sent to the robot, in all requests.
  std::vector<std::string> sent() const {
    std::vector<std::string> all;
    for (const auto& request : requests) {
      const auto& packets = request.control_drive().packets();
      all.insert(all.end(), packets.begin(), packets.end());
    }
    return all;
  }
  std::unique_ptr<widgets::PacketInspector> view;
  QTableView* table = nullptr;
};

/// A client that connects, drives for a second, and goes.
std::string conversation() {
  using robotlink::arcos::Conversation;
  Conversation talk;
  const auto add = [&](Conversation::Kind kind, int ms, bool fromRobot, Bytes bytes) {
    Conversation::Event event;
    event.kind = kind;
    event.at = std::chrono::milliseconds(ms);
    event.direction =
        fromRobot ? robotlink::arcos::Direction::kFromRobot : robotlink::arcos::Direction::kFromClient;
    event.bytes = std::move(bytes);
    talk.events.push_back(event);
  };
  using Kind = Conversation::Kind;
  add(Kind::kNewConnection, 0, false, {});
  for (const int sync : {0, 1, 2}) {
    add(Kind::kPacket, 100 * sync, false, bare(sync));
    add(Kind::kPacket, 100 * sync + 10, true, bare(sync));
  }
  add(Kind::kPacket, 300, false, command(1, 1));
  add(Kind::kPacket, 400, true, information());
  add(Kind::kPacket, 500, false, command(4, 1));
  add(Kind::kPacket, 1000, false, command(11, 200));
  add(Kind::kPacket, 1500, false, command(11, 0));
  add(Kind::kPacket, 1600, false, command(2, 1));
  add(Kind::kClosed, 1700, false, {});
  return writeConversation(talk);
}

QString fileOf(const QTemporaryDir& folder, const std::string& text) {
  const QString name = folder.filePath(QStringLiteral("talk.wire"));
  QFile file(name);
  if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), static_cast<qint64>(text.size())) < 0)
    qFatal("no file");
  return name;
}

}  // namespace

class PacketInspectorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theTableForgetsItsOldest() {
    PacketModel model(200);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    std::vector<widgets::PacketEntry> entries;
    const Bytes bytes = bare(0);
    for (int i = 0; i < 150; ++i)
      entries.push_back(widgets::packetEntry(robotlink::Instant(std::chrono::milliseconds(i)), false,
                                             std::string(bytes.begin(), bytes.end())));
    model.append(entries);
    model.append(entries);
    QVERIFY(model.rowCount() <= 200 && model.rowCount() > 150);
    QCOMPARE(model.names().begin()->second, model.rowCount());
    QCOMPARE(model.rowAt(robotlink::Instant(std::chrono::milliseconds(149))), model.rowCount() - 1);
    model.clear();
    QCOMPARE(model.rowCount(), 0);
  }

  void bothDirectionsAreDecoded() {
    ShownInspector s;
    QVERIFY(child<QLabel>(*s.view, "emptyHint").text().contains(QStringLiteral("No packets yet")));
    s.pushTalk();
    QCOMPARE(s.rows(), 4);
    QCOMPARE(s.cell(0, PacketModel::kTime), QStringLiteral("1.000"));
    QCOMPARE(s.cell(0, PacketModel::kName), QStringLiteral("VEL"));
    QVERIFY(s.cell(0, PacketModel::kSummary).contains(QStringLiteral("250")));
    QCOMPARE(s.cell(0, PacketModel::kDirection), QStringLiteral("→ robot"));
    QVERIFY(s.cell(1, PacketModel::kSummary).contains(QStringLiteral("-10")));
    QCOMPARE(s.cell(2, PacketModel::kDirection), QStringLiteral("← robot"));
    QVERIFY(s.cell(3, PacketModel::kName).contains(QStringLiteral("checksum")));
    QCOMPARE(s.cell(3, PacketModel::kBytes), QStringLiteral("6"));
  }

  void timesCountFromTheOriginOfTheTimeline() {
    ShownInspector shown;
    shown.pushTalk();
    QCOMPARE(shown.cell(2, 0), QStringLiteral("1.100"));
    shown.session.timeline().setOrigin(robotlink::Instant(std::chrono::seconds(1)));
    shown.tick(*shown.view);
    QCOMPARE(shown.cell(2, 0), QStringLiteral("0.100"));
  }

  void itAsksForThePacketsByTheirKey() {
    ShownInspector s;
    s.pushKeys({"link/packets"});
    s.tick(*s.view);
    QCOMPARE(s.requests.back().set_key().name(), std::string("package/link/packets"));
  }

  void filtersAddUp() {
    ShownInspector s;
    s.pushTalk();
    auto& from = child<QComboBox>(*s.view, "packetsFrom");
    from.setFocus();
    QTest::keyClick(&from, Qt::Key_End);
    QCOMPARE(s.rows(), 2);
    auto& text = child<QLineEdit>(*s.view, "packetsText");
    text.setFocus();
    QTest::keyClicks(&text, QStringLiteral("rvel"));
    QCOMPARE(s.rows(), 1);
    QCOMPARE(s.state(), QStringLiteral("1 of 4 packets"));
    QTest::keyClick(&text, Qt::Key_Escape);
    QTest::keyClicks(&text, QStringLiteral("0b 3b fa"));  // bytes
    QCOMPARE(s.rows(), 1);
    QTest::keyClick(&text, Qt::Key_Escape);
    from.setFocus();
    QTest::keyClick(&from, Qt::Key_Home);
    click(child<QToolButton>(*s.view, "packetsDamaged"));
    QCOMPARE(s.rows(), 1);
    QVERIFY(s.cell(0, PacketModel::kName).contains(QStringLiteral("checksum")));
  }

  void namesAreHiddenInTheirMenu() {
    ShownInspector s;
    s.pushTalk();
    auto& menu = child<QMenu>(*s.view, "packetsNamesMenu");
    menu.popup({0, 0});
    const auto actions = menu.actions();
    const auto vel = std::find_if(actions.begin(), actions.end(),
                                  [](QAction* a) { return a->text() == QStringLiteral("VEL (1)"); });
    QVERIFY(vel != actions.end());
    QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(*vel).center());
    QCOMPARE(s.rows(), 3);
    QCOMPARE(child<QToolButton>(*s.view, "packetsNames").text(), QStringLiteral("1 name hidden"));
    const QJsonObject state = s.view->saveState();
    ShownInspector other;
    other.view->restoreState(state);
    QCOMPARE(other.view->saveState(), state);
  }

  void thePacketUnderTheCursorIsTakenApart() {
    ShownInspector s;
    s.pushTalk();
    QTest::mouseClick(s.table->viewport(), Qt::LeftButton, {},
                      s.table->visualRect(s.table->model()->index(0, 2)).center());
    auto& details = child<QTreeWidget>(*s.view, "packetDetails");
    QCOMPARE(details.topLevelItem(0)->text(0), QStringLiteral("VEL"));
    bool speed = false;
    for (int i = 0; i < details.topLevelItem(0)->childCount(); ++i) {
      const QTreeWidgetItem* field = details.topLevelItem(0)->child(i);
      speed |= field->text(1) == QStringLiteral("250") && field->text(2) == QStringLiteral("mm/s");
    }
    QVERIFY(speed);
    QCOMPARE(details.topLevelItem(1)->child(0)->text(0),
             QStringLiteral("0000  fa fb 06 0b 3b fa 00 05  ....;..."));
    QVERIFY(!child<QToolButton>(*s.view, "packetsFollow").isChecked());  // who reads is not carried away
    s.table->setFocus();
    QTest::keyClick(s.table, Qt::Key_C, Qt::ControlModifier);
    QVERIFY(QApplication::clipboard()->text().endsWith(QStringLiteral("fa fb 06 0b 3b fa 00 05 3b")));
  }

  void pausedPacketsComeLaterAndClearedOnesDoNot() {
    ShownInspector s;
    click(child<QToolButton>(*s.view, "packetsPause"));
    s.pushTalk();
    QCOMPARE(s.rows(), 0);
    click(child<QToolButton>(*s.view, "packetsPause"));
    s.tick(*s.view);
    QCOMPARE(s.rows(), 4);
    click(child<QToolButton>(*s.view, "packetsClear"));
    s.tick(*s.view);
    QCOMPARE(s.rows(), 0);
    s.session.selectRobot("p3at2");
    s.tick(*s.view);
    s.session.selectRobot("p3at1");
    s.tick(*s.view);
    QCOMPARE(s.rows(), 4);  // the history still has them
  }

  void whatIsSavedIsOpenedAgain() {
    ShownInspector s;
    s.pushTalk();
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("saved.wire"));
    DialogAnswer save = DialogAnswer::file(file);
    click(child<QToolButton>(*s.view, "packetsSave"));
    QVERIFY(save.asked());
    click(child<QToolButton>(*s.view, "packetsClear"));
    DialogAnswer open = DialogAnswer::file(file);
    click(child<QToolButton>(*s.view, "packetsOpen"));
    QVERIFY(open.asked());
    QCOMPARE(child<QLabel>(*s.view, "packetsFile").text(), QStringLiteral("saved.wire"));
    QCOMPARE(s.rows(), 5);  // the connection's beginning is told too
    QCOMPARE(s.cell(1, PacketModel::kName), QStringLiteral("VEL"));
    QCOMPARE(s.cell(3, PacketModel::kTime), QStringLiteral("0.100"));
    s.pushPackets({{true, information()}}, 2);
    s.tick(*s.view);
    QCOMPARE(s.rows(), 5);
    click(child<QToolButton>(*s.view, "packetsLive"));
    QCOMPARE(s.rows(), 1);
  }

  void aFileThatIsNoConversationSaysWhy() {
    ShownInspector s;
    QTemporaryDir folder;
    const QString file = fileOf(folder, "=== new connection\n   1.0 C>S id=0 what\n");
    QString said;
    DialogAnswer answer([&](QDialog& dialog) {
      said = dynamic_cast<QMessageBox&>(dialog).text();
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    QVERIFY(!s.view->openConversation(file));
    QVERIFY2(said.contains(QStringLiteral("talk.wire:2")), qPrintable(said));
  }

  void aClientsHalfIsSaidAgainAtItsTimes() {
    ShownInspector s;
    QTemporaryDir folder;
    QVERIFY(s.view->openConversation(fileOf(folder, conversation())));
    s.pushPackets({}, 10);
    s.tick(*s.view);
    click(child<QToolButton>(*s.view, "packetReplay"));
    const auto at = [&](double time) {
      s.pushPackets({}, time);
      s.tick(*s.view);
      return s.sent().size();
    };
    QCOMPARE(at(10.05), std::size_t{1});  // the PULSE that was its SYNC0; OPEN and CLOSE are left out
    for (double t = 10.1; t < 10.52; t += 0.03) at(t);
    QCOMPARE(at(10.53), std::size_t{1});
    QCOMPARE(at(10.56), std::size_t{2});  // ENABLE, 500 ms after the first
    auto& progress = child<QProgressBar>(*s.view, "packetReplayProgress");
    QCOMPARE(progress.value(), 2);
    QCOMPARE(progress.maximum(), 4);
    // Hidden for a minute, it does not hurry after.
    QCOMPARE(at(70), std::size_t{2});
    for (double t = 70.03; t < 70.3; t += 0.03) at(t);
    QCOMPARE(s.sent().size(), std::size_t{3});
    const Bytes vel = command(11, 200);
    QCOMPARE(s.sent().back(), std::string(vel.begin(), vel.end()));
    click(child<QToolButton>(*s.view, "packetReplayCancel"));
    QCOMPARE(at(80), std::size_t{3});
  }

  void aClientsHalfIsSaidPacketByPacket() {
    ShownInspector s;
    QTemporaryDir folder;
    QVERIFY(s.view->openConversation(fileOf(folder, conversation())));
    s.tick(*s.view);
    auto& step = child<QToolButton>(*s.view, "packetReplayStep");
    for (int i = 1; i <= 4; ++i) {
      click(step);
      QCOMPARE(s.sent().size(), static_cast<std::size_t>(i));
    }
    QVERIFY(child<QLabel>(*s.view, "packetReplayState").text().startsWith(QStringLiteral("Replay finished")));
    click(step);  // starts over
    s.answer(false, "the line is lost");
    s.tick(*s.view);
    QCOMPARE(child<QLabel>(*s.view, "packetReplayState").text(), QStringLiteral("Refused: the line is lost"));
    QVERIFY(!child<QToolButton>(*s.view, "packetReplayCancel").isEnabled());
  }

  void showsAWholeConversation_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("name");
    QTest::newRow("real") << QStringLiteral("real") << QStringLiteral("simpleMotionCommands");
    QTest::newRow("made") << QStringLiteral("made") << QStringLiteral("drive");
  }
  void showsAWholeConversation() {
    QFETCH(QString, source);
    QFETCH(QString, name);
    ShownInspector s;
    const auto found = robotlink::arcos::conversation(source.toStdString(), name.toStdString());
    if (!found) QSKIP("the recorded conversations are not in ../shared/data/arcos/wire");
    QTemporaryDir folder;
    QVERIFY(s.view->openConversation(fileOf(folder, writeConversation(*found))));
    QVERIFY(s.rows() > 100);
    for (int row = 0; row < s.rows(); ++row)
      QVERIFY2(!s.cell(row, PacketModel::kName).isEmpty(), qPrintable(s.cell(row, PacketModel::kSummary)));
    s.tick(*s.view);
    s.table->selectRow(14);
    s.view->resize(1150, 520);
    click(child<QToolButton>(*s.view, "packetReplayStep"));
    keepPicture(*s.view, "packet-inspector");
  }
};

const GuiTest<PacketInspectorTest> kPacketInspectorTest;

}  // namespace widgets::test

#include "PacketInspectorTest.moc"
