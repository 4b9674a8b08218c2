// SPDX-License-Identifier: GPL-3.0-or-later
// What a person is asked about remote robots that encrypt and demand tokens.
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedPointer>
#include <QSpinBox>
#include <QTreeWidget>

#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/Connector.h"
#include "robotlink/foxglove/security/Certificate.h"
#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/security/RememberedTokens.h"
#include "robotlink/foxglove/security/Tokens.h"
#include "tests/app/served/ServedHall.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

namespace websocket = robotlink::websocket;

/// A robot with a certificate and tokens, and the desk of somebody who has never seen it.
class TrustBench {
 public:
  explicit TrustBench(const std::filesystem::path& home) : home_(home) {
    qputenv("XDG_STATE_HOME", QByteArray::fromStdString((home / "state").string()));
    options_.access.isSecure = true;
    options_.access.tokenFile = home / "robot/tokens";
    options_.access.certificateFile = home / "robot/certificate.pem";
    tokens_ = websocket::loadOrMakeTokens(options_.access.tokenFile).value().tokens;
    start();
    desk = std::make_unique<EmptyDesk>(home / "desk");
  }
  ~TrustBench() { qunsetenv("XDG_STATE_HOME"); }
  TrustBench(const TrustBench&) = delete;
  TrustBench& operator=(const TrustBench&) = delete;

  void start() {
    hall_.reset();
    hall_.reset(new ServedHall(options_));
    options_.address = hall_->address();
  }
  /// The robot is set up again, at the same place.
  void renew() {
    hall_.reset();
    std::filesystem::remove(options_.access.certificateFile);
    start();
  }
  void connect(const std::string& token = {}) {
    QVERIFY(desk->workbench.commands().run("remote.connect", {url(), token}).has_value());
  }
  std::string url() const { return hall_->url(); }
  QString fingerprint() const {
    return QString::fromStdString(
        websocket::loadOrMakeCertificate(options_.access.certificateFile).value().fingerprint);
  }
  const websocket::Tokens& tokens() const { return tokens_; }
  template <typename W>
  W* find(const char* name) {
    auto* found = desk->window.findChild<W*>(QLatin1String(name));
    return found != nullptr && found->isVisible() ? found : nullptr;
  }
  void press(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
  bool isConnected() const {
    const auto connections = desk->workbench.remote().connections();
    return connections.size() == 1 && connections.front().state.isConnected();
  }

  std::unique_ptr<EmptyDesk> desk;

 private:
  std::filesystem::path home_;
  ServeOptions options_;
  websocket::Tokens tokens_;
  QScopedPointer<ServedHall> hall_;
};

}  // namespace

class RemoteTrustGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aNewRobotIsTrustedByItsFingerprint() {
    TrustBench bench(home_);
    bench.connect(bench.tokens().control);
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QDialog>("trustDialog") != nullptr, kWaitMs);
    QCOMPARE(bench.find<QLineEdit>("trustFingerprint")->text(), bench.fingerprint());
    QVERIFY(!bench.isConnected());
    QVERIFY(websocket::KnownServers().read().value().empty());
    widgets::test::keepPicture(*bench.find<QDialog>("trustDialog"), "trust-new");
    bench.press("trustAccept");
    QTRY_VERIFY_WITH_TIMEOUT(bench.isConnected(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QDialog>("trustDialog") == nullptr, kWaitMs);
    QCOMPARE(websocket::KnownServers().read().value().size(), std::size_t{1});
  }

  void whoDoesNotTrustItIsNotConnected() {
    TrustBench bench(home_);
    bench.connect(bench.tokens().control);
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QDialog>("trustDialog") != nullptr, kWaitMs);
    bench.press("trustReject");
    QTRY_VERIFY_WITH_TIMEOUT(bench.desk->workbench.remote().empty(), kWaitMs);
    QVERIFY(websocket::KnownServers().read().value().empty());
  }

  void anotherCertificateIsReplacedOnlyOnReflection() {
    TrustBench bench(home_);
    bench.connect(bench.tokens().control);
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QDialog>("trustDialog") != nullptr, kWaitMs);
    bench.press("trustAccept");
    QTRY_VERIFY_WITH_TIMEOUT(bench.isConnected(), kWaitMs);
    const QString before = bench.fingerprint();
    bench.renew();
    QVERIFY(before != bench.fingerprint());
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QLineEdit>("trustKnown") != nullptr, kWaitMs);
    QCOMPARE(bench.find<QLineEdit>("trustKnown")->text(), before);
    QCOMPARE(bench.find<QLineEdit>("trustFingerprint")->text(), bench.fingerprint());
    QVERIFY(bench.find<QLabel>("trustFile")->text().contains(QStringLiteral("known_robots")));
    QVERIFY(!bench.find<QPushButton>("trustAccept")->isEnabled());
    widgets::test::keepPicture(*bench.find<QDialog>("trustDialog"), "trust-changed");
    bench.find<QCheckBox>("trustSure")->setChecked(true);
    bench.press("trustAccept");
    QTRY_VERIFY_WITH_TIMEOUT(bench.isConnected(), kWaitMs);
  }

  void aTokenIsAskedForRememberedAndForgotten() {
    TrustBench bench(home_);
    bench.connect();
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QDialog>("trustDialog") != nullptr, kWaitMs);
    bench.press("trustAccept");
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QDialog>("tokenDialog") != nullptr, kWaitMs);
    QVERIFY(bench.find<QLabel>("tokenText")->text().contains(QStringLiteral("only accepts")));
    widgets::test::keepPicture(*bench.find<QDialog>("tokenDialog"), "token");
    QTest::keyClicks(bench.find<QLineEdit>("tokenField"), QStringLiteral("wrong"));
    bench.find<QCheckBox>("tokenRemember")->setChecked(true);
    bench.press("tokenAccept");
    QTRY_VERIFY_WITH_TIMEOUT(
        bench.find<QLabel>("tokenText") != nullptr &&
            bench.find<QLabel>("tokenText")->text().contains(QStringLiteral("does not accept")),
        kWaitMs);
    QVERIFY(!RemoteRobots::hasToken(bench.url()));  // a wrong one is not remembered
    QTest::keyClicks(bench.find<QLineEdit>("tokenField"), QString::fromStdString(bench.tokens().control));
    bench.find<QCheckBox>("tokenRemember")->setChecked(true);
    bench.press("tokenAccept");
    QTRY_VERIFY_WITH_TIMEOUT(bench.isConnected(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(RemoteRobots::hasToken(bench.url()), kWaitMs);
    // The next time nobody is asked.
    QVERIFY(bench.desk->workbench.commands().run("remote.disconnect", {bench.url()}).has_value());
    bench.connect();
    QTRY_VERIFY_WITH_TIMEOUT(bench.isConnected(), kWaitMs);
    bench.desk->choose("remote.connect");
    auto& url = bench.desk->find<QComboBox>("remoteUrl");
    url.setEditText(QString::fromStdString(bench.url()));
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("remoteForgetToken") != nullptr, kWaitMs);
    bench.press("remoteForgetToken");
    QVERIFY(!RemoteRobots::hasToken(bench.url()));
    QVERIFY(bench.find<QPushButton>("remoteForgetToken") == nullptr);
  }

  void whoOffersASessionToOtherMachinesGetsItsTokens() {
    qputenv("XDG_STATE_HOME", QByteArray::fromStdString((home_ / "state").string()));
    EmptyDesk desk(home_ / "desk");
    desk.choose("session.offer");
    QVERIFY(!desk.find<QPushButton>("offerCopyControl").isEnabled());
    desk.find<QLineEdit>("offerAddress").setText(QStringLiteral("0.0.0.0"));
    desk.find<QSpinBox>("offerPort").setValue(0);
    QTest::mouseClick(&desk.find<QPushButton>("offerButton"), Qt::LeftButton);
    // Nobody can connect to 0.0.0.0.
    auto url = websocket::parseServerUrl(desk.find<QLineEdit>("offerUrl").text().toStdString());
    QVERIFY(url.has_value());
    QVERIFY(url->host != "0.0.0.0");
    const auto tokens = websocket::loadOrMakeTokens(home_ / "state/robotcontrol/tokens").value().tokens;
    const QLabel& note = desk.find<QLabel>("offerNotes");
    const QString notes = note.text();
    for (const std::string& said : {tokens.control, tokens.watch, std::string("SHA256:")})
      QVERIFY2(notes.contains(QString::fromStdString(said)), qPrintable(notes));
    // The fingerprint, its last line, is not cut off.
    QTRY_VERIFY_WITH_TIMEOUT(note.height() >= note.heightForWidth(note.width()), kWaitMs);
    QTest::mouseClick(&desk.find<QPushButton>("offerCopyControl"), Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text().toStdString(), tokens.control);
    QTest::mouseClick(&desk.find<QPushButton>("offerCopyWatch"), Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text().toStdString(), tokens.watch);
    widgets::test::keepPicture(desk.find<QDialog>("offerDialog"), "offer-secure");
    // What was copied lets somebody watch.
    const auto client = std::make_shared<websocket::Client>(websocket::ClientHandlers{});
    websocket::Connector::Options options;
    options.url = {true, "127.0.0.1", url->port, "/"};
    options.token = tokens.watch;
    options.name = "guest";
    options.isTrusted = [](const std::string&, const std::string&) { return true; };
    const websocket::Connector connector(client, options);
    auto& clients = desk.find<QTreeWidget>("offerClients");
    QTRY_COMPARE_WITH_TIMEOUT(clients.topLevelItemCount(), 1, kWaitMs);
    QCOMPARE(clients.topLevelItem(0)->text(0), QStringLiteral("guest (watch only)"));
    qunsetenv("XDG_STATE_HOME");
  }
};

const widgets::test::GuiTest<RemoteTrustGuiTest> kRemoteTrustGuiTest;

}  // namespace app::test

#include "RemoteTrustGuiTest.moc"
