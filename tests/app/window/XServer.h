// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/prctl.h>

#include <QByteArray>
#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QStringList>
#include <csignal>
#include <memory>

/// An X server with a window manager for a test, for what only these provide: real mouse events and stacking
/// of windows. Must be created before the application object, since the platform plugin connects to it.
class XServer {
 public:
  /// The programs that are missing on this machine; empty if there are none.
  static QStringList missing() {
    QStringList names;
    for (const char* name : {"Xvfb", "openbox", "xdotool", "xprop"}) {
      if (QStandardPaths::findExecutable(QLatin1String(name)).isEmpty()) names << QLatin1String(name);
    }
    return names;
  }

  /// Returns null if the server does not start.
  static std::unique_ptr<XServer> start() {
    auto server = std::unique_ptr<XServer>(new XServer);
    server->server_.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    server->server_.start(
        QStringLiteral("Xvfb"),
        {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"), QStringLiteral("0"),
         QStringLiteral("1920x1080x24"), QStringLiteral("-nolisten"), QStringLiteral("tcp")});
    constexpr int kStartMs = 20000;
    if (!server->server_.waitForReadyRead(kStartMs)) return nullptr;
    const QByteArray number = server->server_.readLine().trimmed();
    qputenv("DISPLAY", ":" + number);
    qputenv("QT_QPA_PLATFORM", "xcb");
    qunsetenv("WAYLAND_DISPLAY");
    qunsetenv("QT_SCALE_FACTOR");
    server->manager_.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    server->manager_.start(QStringLiteral("openbox"), {QStringLiteral("--sm-disable")});
    return server->manager_.waitForStarted(kStartMs) ? std::move(server) : nullptr;
  }

  ~XServer() {
    for (QProcess* process : {&manager_, &server_}) {
      process->terminate();
      process->waitForFinished();
    }
  }

 private:
  /// Ends with the test, also if that crashes: else ctest would wait for its output for ever.
  class Companion final : public QProcess {
    void setupChildProcess() override { ::prctl(PR_SET_PDEATHSIG, SIGTERM); }
  };
  XServer() = default;

  Companion server_;
  Companion manager_;
};
