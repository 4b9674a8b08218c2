// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QJsonObject>
#include <QStringList>
#include <functional>
#include <string>
#include <vector>

#include "robotlink/process/Link.h"

namespace robotlink {
class Session;
class StreamStore;
}  // namespace robotlink

namespace widgets {

/// The drawings that a view can show, by name and independent of the robot: "image/ball-percept/circle". A
/// row is checked if the drawing is shown; what is lower in the list is painted later and therefore on top.
/// New drawings are checked, since someone switched them on. What the user unchecked or moved stays so even
/// while the drawing does not exist (its row is gray then).
///
/// Drawings whose debug key is off on the robot are listed, too, unchecked; checking one requests its key.
/// The stream says where a key draws. GUI thread.
class DrawingsModel : public QAbstractListModel {
  Q_OBJECT
 public:
  /// kIdRole: the drawing's id (QString).
  /// kExistsRole: whether some robot has drawn it (bool).
  /// kOffRole: whether its debug key is off on the robot (bool).
  enum Role { kIdRole = Qt::UserRole, kExistsRole, kOffRole };

  /// Ids of streams that are shown themselves, without being drawings, begin with this.
  static constexpr char kStreams[] = "stream/";
  using StreamFilter = std::function<bool(const std::string& path, const std::string& type)>;

  /// `kinds`: the kinds to list, "image", or "field" and "robot".
  explicit DrawingsModel(QStringList kinds, QObject* parent = nullptr);

  /// Lists streams, too, for which the filter is true.
  void listStreams(StreamFilter filter) { lists_ = std::move(filter); }
  /// Adds new drawings of all robots and the keys with which `robot` could draw; returns early if nothing
  /// changed. The session must outlive the model.
  void refresh(robotlink::Session& session, const std::string& robot);
  /// Ids of the checked drawings, lowest first.
  QStringList shown() const;
  /// Checks or unchecks all rows without switching any key.
  void setAllShown(bool shown);
  /// Checks or unchecks what has this id, or this name without its kind ("ball-percept/circle"), as a click
  /// does. False if there is no such row.
  bool setShown(const QString& name, bool shown);
  /// The names of all rows without their kinds.
  QStringList names() const;
  /// Requests the drawing's debug key on or off; a refusal is shown in the tooltip.
  void switchKey(int row, bool on);
  /// Moves a row by `by` rows of this model; -1 is up. Ignored at the ends.
  void move(int row, int by);

  /// At most this many drawings of a saved state are restored, the first in its order. No robot
  /// draws nearly as many.
  static constexpr int kMaxRestored = 1000;
  /// {"order": [id, ...], "hidden": [id, ...]}.
  QJsonObject saveState() const;
  void restoreState(const QJsonObject& state);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// Checks or unchecks a row; checking one that is off requests its key.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// shown() returns something else now.
  void shownChanged();

 private:
  /// A drawing, whether or not it exists at present.
  struct Row {
    QString id;
    /// Checked by the user.
    bool shown = true;
    /// Some robot's stream of this name is in the store.
    bool exists = false;
    /// Its debug key is off on the robot.
    bool off = false;
    /// The key was requested and is not yet on.
    bool asked = false;
    QString help = {};
    /// The reason why the robot refused the key; empty: it did not.
    QString refusal = {};
  };
  /// Updates `exists` from the store's streams.
  void refreshStreams(const robotlink::StreamStore& store);
  /// Updates `off` and `help` from the robot's key table.
  void refreshKeys();
  /// Handles the reply to a request for a key.
  void onAnswer(const QString& id, bool accepted, const QString& reason);
  QString toolTip(const Row& row) const;
  QString title(const QString& id) const;
  /// Null if there is none. Valid until the next change of the rows.
  Row* find(const QString& id);
  void addIfNew(const QString& id, bool off);

  QStringList kinds_;
  StreamFilter lists_;
  std::vector<Row> rows_;
  /// The store's version of its list of streams, as of the last refresh.
  quint64 listVersion_ = ~0ULL;
  robotlink::Session* session_ = nullptr;
  std::string robot_;
  /// The key table that was read last.
  robotlink::PackagePtr keys_;
};

}  // namespace widgets
