// SPDX-License-Identifier: GPL-3.0-or-later
// "Program: here" in Connect…: the program of a robot whose body is remote, also over an encrypted line.
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "app/platforms/body/BodyFeed.h"
#include "app/platforms/body/BodyProgram.h"
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

/// The body of a remote simulated robot.
class BodyHall {
 public:
  explicit BodyHall(ServeOptions options = {}) : options_(std::move(options)) { start(); }
  void start() {
    hall_.reset();
    options_.bodies = std::make_shared<BodyInbox>();
    RunOptions bodies = defaultSimulation();
    bodies.instead = BodyProgram::maker({.inbox = options_.bodies});
    hall_ = std::make_unique<ServedHall>(options_, SimulationFeed::opening(bodies));
    options_.address = hall_->address();
  }
  void stop() { hall_.reset(); }
  QString url() const { return QString::fromStdString(hall_->url()); }

 private:
  ServeOptions options_;
  std::unique_ptr<ServedHall> hall_;
};

/// A desk that hosts the program of such a body.
class HostDesk : public EmptyDesk {
 public:
  using EmptyDesk::EmptyDesk;

  /// As a person does.
  void host(const QString& url) {
    choose("remote.connect");
    find<QComboBox>("remoteUrl").setEditText(url);
    auto& program = find<QComboBox>("remoteProgram");
    program.setFocus();
    QTest::keyClick(&program, Qt::Key_Down);
    QTest::mouseClick(&find<QPushButton>("remoteConnect"), Qt::LeftButton);
  }
  bool isHosting() {
    const auto* loaded = workbench.loaded();
    return loaded != nullptr && loaded->adapter == BodyFeed::kAdapter && !workbench.loading();
  }
  /// The time of the newest one; 0: none has come.
  robotlink::Instant newestImage() {
    const auto* image = workbench.session().store().latest("red1/camera/image", robotlink::Instant::max());
    return image == nullptr ? robotlink::Instant() : image->time;
  }
  template <typename W>
  W* visible(const char* name) {
    auto* found = window.findChild<W*>(QLatin1String(name));
    return found != nullptr && found->isVisible() ? found : nullptr;
  }
  void press(const char* name) { QTest::mouseClick(visible<QPushButton>(name), Qt::LeftButton); }
};

}  // namespace

class BodyGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    WindowTest::init();
    qputenv("XDG_STATE_HOME", QByteArray::fromStdString((home_ / "state").string()));
  }
  void cleanup() { qunsetenv("XDG_STATE_HOME"); }

  void theProgramOfABodyElsewhereRunsHereAndThatIsRemembered() {
    BodyHall hall;
    {
      HostDesk desk(home_ / "desk");
      desk.choose("remote.connect");
      desk.find<QDoubleSpinBox>("remoteLimit").setValue(5000);
      desk.host(hall.url());
      QTRY_VERIFY_WITH_TIMEOUT(desk.isHosting(), kWaitMs);
      QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QDialog>("remoteDialog").isVisible(), kWaitMs);
      QCOMPARE(desk.find<QComboBox>("robotBox").currentText(), QStringLiteral("red1"));
      QTRY_VERIFY_WITH_TIMEOUT(desk.workbench.session().store().find("red1/camera/image") != nullptr,
                               kWaitMs);
      QVERIFY(desk.window.close());
    }
    // After a restart the dialog offers the same again.
    HostDesk desk(home_ / "desk");
    desk.choose("remote.connect");
    QCOMPARE(desk.find<QComboBox>("remoteUrl").currentText(), hall.url());
    QCOMPARE(desk.find<QComboBox>("remoteProgram").currentIndex(), 1);
    QCOMPARE(desk.find<QDoubleSpinBox>("remoteLimit").value(), 5000.0);
    QTest::mouseClick(&desk.find<QPushButton>("remoteConnect"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(desk.isHosting(), kWaitMs);
  }

  void whereNoBodyIsTheDialogSaysSo() {
    ServedHall hall;  // its program runs there
    HostDesk desk(home_ / "desk");
    desk.host(QString::fromStdString(hall.url()));
    auto& state = desk.find<QLabel>("remoteState");
    QTRY_VERIFY_WITH_TIMEOUT(state.text().contains(QStringLiteral("program: there")), kWaitMs);
    QVERIFY(desk.find<QDialog>("remoteDialog").isVisible());
    QVERIFY(!desk.isHosting());
  }

  void aNewCertificateAndATokenAreAskedForAndRemembered() {
    ServeOptions options = secure();
    const auto tokens = websocket::loadOrMakeTokens(options.access.tokenFile).value().tokens;
    BodyHall hall(options);
    HostDesk desk(home_ / "desk");
    desk.host(hall.url());
    QTRY_VERIFY_WITH_TIMEOUT(desk.visible<QDialog>("trustDialog") != nullptr, kWaitMs);
    QCOMPARE(desk.visible<QLineEdit>("trustFingerprint")->text(), fingerprint(options));
    QVERIFY(desk.find<QLabel>("remoteState").text().contains(QStringLiteral("has a question")));
    QVERIFY(websocket::KnownServers().read().value().empty());
    desk.press("trustAccept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.visible<QDialog>("tokenDialog") != nullptr, kWaitMs);
    QTest::keyClicks(desk.visible<QLineEdit>("tokenField"), QStringLiteral("wrong"));
    desk.visible<QCheckBox>("tokenRemember")->setChecked(true);
    desk.press("tokenAccept");
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.visible<QLabel>("tokenText") != nullptr &&
            desk.visible<QLabel>("tokenText")->text().contains(QStringLiteral("does not accept")),
        kWaitMs);
    QVERIFY(!RemoteRobots::hasToken(hall.url().toStdString()));
    QTest::keyClicks(desk.visible<QLineEdit>("tokenField"), QString::fromStdString(tokens.control));
    desk.visible<QCheckBox>("tokenRemember")->setChecked(true);
    desk.press("tokenAccept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.isHosting(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(RemoteRobots::hasToken(hall.url().toStdString()), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QDialog>("remoteDialog").isVisible(), kWaitMs);
    // The next time nobody is asked.
    HostDesk again(home_ / "again");
    again.host(hall.url());
    QTRY_VERIFY_WITH_TIMEOUT(again.isHosting(), kWaitMs);
  }

  void whoDoesNotTrustItGetsNoProgramAndAnotherCertificateIsRefused() {
    ServeOptions options = secure();
    const auto tokens = websocket::loadOrMakeTokens(options.access.tokenFile).value().tokens;
    BodyHall hall(options);
    HostDesk desk(home_ / "desk");
    desk.host(hall.url());
    QTRY_VERIFY_WITH_TIMEOUT(desk.visible<QDialog>("trustDialog") != nullptr, kWaitMs);
    desk.press("trustReject");
    QTRY_VERIFY_WITH_TIMEOUT(desk.visible<QDialog>("trustDialog") == nullptr, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.find<QLabel>("remoteState").text().contains(QStringLiteral("does not run here")), kWaitMs);
    QVERIFY(!desk.isHosting());
    QVERIFY(websocket::KnownServers().read().value().empty());
    // Somebody else was at this place before.
    const std::string url = hall.url().toStdString();
    QVERIFY(websocket::KnownServers().add(url.substr(6), "SHA256:other").has_value());
    QVERIFY(websocket::RememberedTokens().add(url, tokens.control).has_value());
    QTest::mouseClick(&desk.find<QPushButton>("remoteConnect"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(desk.visible<QLineEdit>("trustKnown") != nullptr, kWaitMs);
    QCOMPARE(desk.visible<QLineEdit>("trustKnown")->text(), QStringLiteral("SHA256:other"));
    QVERIFY(!desk.visible<QPushButton>("trustAccept")->isEnabled());
    QVERIFY(!desk.isHosting());
    desk.visible<QCheckBox>("trustSure")->setChecked(true);
    desk.press("trustAccept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.isHosting(), kWaitMs);
  }

  void anotherCertificateIsAskedForWhileTheProgramRunsHere() {
    const ServeOptions options = secure();
    BodyHall hall(options);
    HostDesk desk(home_ / "desk");
    hostTrusted(desk, hall, options);
    const QString before = fingerprint(options);
    setUpAnew(hall, options);
    QTRY_VERIFY_WITH_TIMEOUT(desk.visible<QLineEdit>("trustKnown") != nullptr, kWaitMs);
    QCOMPARE(desk.visible<QLineEdit>("trustKnown")->text(), before);
    QCOMPARE(desk.visible<QLineEdit>("trustFingerprint")->text(), fingerprint(options));
    QVERIFY2(desk.isHosting(), "the program waits, the robot stands");
    const auto newest = desk.newestImage();
    desk.visible<QCheckBox>("trustSure")->setChecked(true);
    desk.press("trustAccept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.newestImage() > newest, kWaitMs);
    QVERIFY(desk.isHosting());
    QVERIFY(desk.visible<QDialog>("trustDialog") == nullptr);
  }

  void whoDoesNotTrustAnotherCertificateEndsTheProgramHere() {
    const ServeOptions options = secure();
    BodyHall hall(options);
    HostDesk desk(home_ / "desk");
    hostTrusted(desk, hall, options);
    const auto known = websocket::KnownServers().read().value();
    setUpAnew(hall, options);
    QTRY_VERIFY_WITH_TIMEOUT(desk.visible<QDialog>("trustDialog") != nullptr, kWaitMs);
    desk.press("trustReject");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.isHosting() && !desk.workbench.loading(), kWaitMs);
    QVERIFY(desk.visible<QDialog>("trustDialog") == nullptr);
    QVERIFY(websocket::KnownServers().read().value() == known);
  }

  void anotherTokenIsAskedForWhileTheProgramRunsHere() {
    const ServeOptions options = secure();
    BodyHall hall(options);
    HostDesk desk(home_ / "desk");
    hostTrusted(desk, hall, options);
    hall.stop();
    std::filesystem::remove(options.access.tokenFile);
    hall.start();
    QTRY_VERIFY_WITH_TIMEOUT(desk.visible<QDialog>("tokenDialog") != nullptr, kWaitMs);
    QVERIFY(desk.isHosting());
    const auto tokens = websocket::loadOrMakeTokens(options.access.tokenFile).value().tokens;
    QTest::keyClicks(desk.visible<QLineEdit>("tokenField"), QString::fromStdString(tokens.control));
    desk.visible<QCheckBox>("tokenRemember")->setChecked(true);
    desk.press("tokenAccept");
    // As soon as the robot accepts it.
    QTRY_VERIFY_WITH_TIMEOUT(websocket::RememberedTokens().find(hall.url().toStdString()) == tokens.control,
                             kWaitMs);
    QVERIFY(desk.isHosting());
    QVERIFY(desk.visible<QDialog>("tokenDialog") == nullptr);
  }

 private:
  /// A robot that nobody asks about.
  static void hostTrusted(HostDesk& desk, const BodyHall& hall, const ServeOptions& options) {
    const std::string url = hall.url().toStdString();
    const auto tokens = websocket::loadOrMakeTokens(options.access.tokenFile).value().tokens;
    QVERIFY(websocket::KnownServers().add(url.substr(6), fingerprint(options).toStdString()).has_value());
    QVERIFY(websocket::RememberedTokens().add(url, tokens.control).has_value());
    desk.host(hall.url());
    QTRY_VERIFY_WITH_TIMEOUT(desk.isHosting() && desk.newestImage() > robotlink::Instant(), kWaitMs);
  }
  /// It comes back with another certificate.
  static void setUpAnew(BodyHall& hall, const ServeOptions& options) {
    hall.stop();
    std::filesystem::remove(options.access.certificateFile);
    hall.start();
  }
  ServeOptions secure() const {
    ServeOptions options;
    options.access.isSecure = true;
    options.access.tokenFile = home_ / "robot/tokens";
    options.access.certificateFile = home_ / "robot/certificate.pem";
    return options;
  }
  static QString fingerprint(const ServeOptions& options) {
    return QString::fromStdString(
        websocket::loadOrMakeCertificate(options.access.certificateFile).value().fingerprint);
  }
};

const widgets::test::GuiTest<BodyGuiTest> kBodyGuiTest;

}  // namespace app::test

#include "BodyGuiTest.moc"
