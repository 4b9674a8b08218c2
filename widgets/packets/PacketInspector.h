// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/HiddenTick.h"
#include "widgets/PackageSubscription.h"
#include "widgets/TypedStreams.h"
#include "widgets/View.h"
#include "widgets/packets/PacketFilter.h"
#include "widgets/packets/PacketModel.h"

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

/// The packets on the line to the selected robot in both directions, decoded: a table with filters, and the
/// fields and bytes of the current packet. The list can be saved as a conversation (.wire file, see
/// robotlink/arcos/ARCOS.md); one can be opened, and its client's part sent again to the connected robot.
///
/// Registered as "packets". GUI thread.
class PacketInspector final : public View, public HiddenTick {
  Q_OBJECT
 public:
  explicit PacketInspector(ViewContext& context, QWidget* parent = nullptr);

  /// Appends new packets (unless paused) and sends what a replay has due.
  void tick() override;
  void tickHidden() override;

  /// Saves all packets of the list, whatever the filters. False, with a message shown, if that fails.
  bool saveConversation(const QString& file);
  /// The conversation (.wire) without a message box, or a picture of the view (.png).
  robotlink::Result<void> saveTo(const QString& file) override;
  /// Shows a file instead of the live packets. False, with a message shown, if it cannot be read.
  bool openConversation(const QString& file);
  /// Closes the file and shows the live packets again.
  void showLive();

 private:
  void createActions();
  /// Direction, names and text.
  void createFilters();
  void createViews();
  void createTable();
  /// The row with filters and buttons.
  QWidget* createBar();
  /// The row with the file's name and the replay; hidden while the packets are live.
  QWidget* createFileBar();
  void connectSignals();
  /// Connects the controls of the filters with the proxy.
  void connectFilters();
  /// Adds the filters and follow to the saved state.
  void keepChoices();

  /// Starts over when another robot is selected.
  void followRobot();
  /// Appends the packets that were published since the last tick.
  void takeNew();
  /// Connects the table with the live or the recorded packets.
  void showModel(PacketModel& model);
  /// Fills the menu of names that can be hidden.
  void listNames();
  /// Shows the current packet.
  void showDetails();
  /// Requests that the packets are sent to the robot.
  void send(const std::vector<std::string>& packets);
  /// Copies the selected rows with their bytes.
  void copy();
  robotlink::Result<void> writeConversation(const QString& file);
  /// Asks for a file, then saveConversation() or openConversation().
  void save();
  void open();
  /// Updates the counts and the hint of an empty table.
  void showState();
  /// live_ or recorded_.
  PacketModel& shownModel();

  /// The packets of the line, and those of a file.
  PacketModel live_, recorded_;
  PacketFilter* filter_;
  /// Requests that packets are published.
  PackageSubscription subscription_;
  StreamCursor cursor_;
  std::string robot_;
  /// Generation of the store when it was last read.
  std::uint64_t generation_ = 0;
  /// Number of packets that the platform dropped because there were too many.
  std::uint64_t dropped_ = 0;
  /// The instant whose row was selected last.
  robotlink::Instant shown_;
  /// The file that is shown; empty: the packets are live.
  QString file_;
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
