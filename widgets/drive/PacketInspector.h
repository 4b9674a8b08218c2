// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/PackageWish.h"
#include "widgets/View.h"
#include "widgets/models/PacketFilter.h"
#include "widgets/models/PacketModel.h"
#include "widgets/models/TypedStreams.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QTableView;
class QToolButton;

namespace widgets {

class EmptyHint;
class PacketDetails;
class PacketReplayBar;

/// What goes over the line to the selected robot, both ways, decoded: a table with filters, a packet's fields
/// and bytes. Saves it as a conversation, opens one, and says its client's half again to the robot that is
/// connected.
class PacketInspector final : public View {
  Q_OBJECT
 public:
  explicit PacketInspector(ViewContext& context, QWidget* parent = nullptr);

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

  /// False, with a message shown, if that fails.
  bool saveConversation(const QString& file);
  bool openConversation(const QString& file);
  void showLive();

 private:
  void createActions();
  void createFilters();
  void createViews();
  void createTable();
  QWidget* createBar();
  QWidget* createFileBar();
  void connectSignals();
  void connectFilters();

  void followRobot();
  void takeNew();
  void showModel(PacketModel& model);
  void listNames();
  void showDetails();
  void send(const std::vector<std::string>& packets);
  void copy();
  void save();
  void open();
  void showState();
  PacketModel& shownModel();

  PacketModel live_, recorded_;
  PacketFilter* filter_;
  PackageWish wish_;
  StreamCursor cursor_;
  std::string robot_;
  std::uint64_t generation_ = 0;
  std::uint64_t dropped_ = 0;
  robotlink::Instant shown_;
  QString file_;  // that is shown; empty: it is live
  QComboBox* from_ = nullptr;
  QToolButton* names_ = nullptr;
  QMenu* namesMenu_ = nullptr;
  QLineEdit* text_ = nullptr;
  QTableView* table_ = nullptr;
  PacketDetails* details_ = nullptr;
  PacketReplayBar* replay_ = nullptr;
  QWidget* fileBar_ = nullptr;
  QLabel *fileName_ = nullptr, *state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction *damaged_ = nullptr, *follow_ = nullptr, *pause_ = nullptr, *copy_ = nullptr, *clear_ = nullptr;
  QAction *save_ = nullptr, *open_ = nullptr, *goLive_ = nullptr;
};

}  // namespace widgets
