// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QJsonObject>
#include <QStringList>
#include <string>
#include <vector>

namespace robotlink {
class Session;
class StreamStore;
}  // namespace robotlink

namespace widgets {

/// The drawings that a view can show, by name and whatever the robot: "image/ball-percept/circle". A row is
/// checked if it is shown; what is lower in the list is painted later and so on top. New drawings are shown:
/// somebody switched them on. What the user hid or moved stays so, also while the drawing does not exist (its
/// row is grey then).
///
/// Drawings whose debug key is off on the robot are listed, too, unchecked: to check one switches its key on.
/// That a key draws, and where, its help says: "(drawn in the image)". GUI thread.
class DrawingsModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { kIdRole = Qt::UserRole, kExistsRole, kOffRole };

  /// `kinds`: "image"; or "field" and "robot".
  explicit DrawingsModel(QStringList kinds, QObject* parent = nullptr);

  /// Adds what is new: drawings of all robots, and what this robot could draw; cheap while nothing is. The
  /// session must outlive the model's use.
  void refresh(robotlink::Session& session, const std::string& robot);
  /// The ids of the drawings to be shown, lowest first.
  QStringList shown() const;
  void setAllShown(bool shown);
  /// Asks the robot to switch a drawing's debug key on or off.
  void switchKey(int row, bool on);
  /// Up is -1. Rows are those of this model.
  void move(int row, int by);

  QJsonObject saveState() const;
  void restoreState(const QJsonObject& state);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// What shown() answers changed.
  void shownChanged();

 private:
  struct Row {
    QString id;
    bool shown = true;
    bool exists = false;
    bool off = false;    ///< its debug key is, on the robot
    bool asked = false;  ///< the robot was asked to switch it on, and has not done so yet
    QString help = {};
    QString refusal = {};  ///< why it did not
  };
  void refreshStreams(const robotlink::StreamStore& store);
  void refreshKeys();
  void onAnswer(const QString& id, bool accepted, const QString& reason);
  QString toolTip(const Row& row) const;
  QString title(const QString& id) const;
  Row* find(const QString& id);
  void addIfNew(const QString& id, bool off);

  QStringList kinds_;
  std::vector<Row> rows_;
  quint64 listVersion_ = ~0ULL;
  robotlink::Session* session_ = nullptr;
  std::string robot_;
  const void* keys_ = nullptr;  ///< the robot's table of keys that was taken over
};

}  // namespace widgets
