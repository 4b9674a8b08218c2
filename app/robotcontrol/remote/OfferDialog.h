// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace robotlink {
class CommandTable;
}

namespace app {

class SessionOffer;

/// Offers the session to others, and shows who is connected. Not modal; its owner calls tick() in each tick
/// of the session. GUI thread; commands and offer must outlive it.
class OfferDialog final : public QDialog {
  Q_OBJECT
 public:
  OfferDialog(robotlink::CommandTable& commands, const SessionOffer& offer, QWidget* parent = nullptr);

  /// The address in the fields, "127.0.0.1:8765", at which the session is offered.
  QString address() const;
  /// Ignores text that is not an address.
  void setAddress(const QString& address);
  /// Shows who is connected.
  void tick();

 private:
  void createFields();
  QLayout* createTokens();
  void createClients();
  /// Offers, or ends that.
  void toggle();
  void showOffer();
  void showClients();

  robotlink::CommandTable& commands_;
  const SessionOffer& offer_;
  QLineEdit* host_ = nullptr;
  QSpinBox* port_ = nullptr;
  QLineEdit* url_ = nullptr;
  QPushButton *copy_ = nullptr, *offerButton_ = nullptr;
  QPushButton *copyControl_ = nullptr, *copyWatch_ = nullptr;
  QLabel *state_ = nullptr, *notes_ = nullptr, *refused_ = nullptr;
  QTreeWidget* clients_ = nullptr;
  /// Whether what the dialog shows was offered when it was last looked at.
  bool wasOffered_ = false;
};

}  // namespace app
