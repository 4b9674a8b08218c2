// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <string>

#include "tests/app/window/Desk.h"

namespace app::test {

/// A desk at which a remote robot is connected.
class RemoteDesk : public EmptyDesk {
 public:
  using EmptyDesk::EmptyDesk;

  /// Connects as a person does.
  void join(const std::string& url) {
    choose("remote.connect");
    auto* address = find<QComboBox>("remoteUrl").lineEdit();
    address->setFocus();
    address->selectAll();
    QTest::keyClicks(address, QString::fromStdString(url));
    QTest::mouseClick(&find<QPushButton>("remoteConnect"), Qt::LeftButton);
  }
  void run(const std::string& line) {
    const auto done = workbench.commands().runLine(line);
    QVERIFY2(done.has_value(), done ? "" : done.error().text.c_str());
  }
  template <typename T>
  const T* newest(const std::string& stream) {
    return workbench.session().store().latestAs<T>(stream, robotlink::Instant::max());
  }
  /// How many messages of a stream have come.
  std::uint64_t count(const std::string& stream) {
    const auto* found = workbench.session().store().find(stream);
    return found == nullptr ? 0 : found->count;
  }
  QString robot() { return find<QComboBox>("robotBox").currentText(); }
  /// What the status bar says of the first connection.
  QString state() {
    auto* button = window.findChild<QToolButton*>(QStringLiteral("statusRemote1"));
    return button == nullptr || button->isHidden() ? QString() : button->toolTip();
  }
};

}  // namespace app::test
