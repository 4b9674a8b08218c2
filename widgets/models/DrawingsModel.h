// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QJsonObject>
#include <QStringList>
#include <vector>

namespace robotlink {
class StreamStore;
}

namespace widgets {

/// The drawings that a view can show, by name and whatever the robot: "image/ball-percept/circle". A row is
/// checked if it is shown; what is lower in the list is painted later and so on top. New drawings are shown:
/// somebody switched them on. What the user hid or moved stays so, also while the drawing does not exist (its
/// row is grey then). GUI thread.
class DrawingsModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { kIdRole = Qt::UserRole, kExistsRole };

  /// `kinds`: "image"; or "field" and "robot".
  explicit DrawingsModel(QStringList kinds, QObject* parent = nullptr);

  /// Adds what is new in the store; cheap while its list of streams is the same.
  void refresh(const robotlink::StreamStore& store);
  /// The ids of the drawings to be shown, lowest first.
  QStringList shown() const;
  void setAllShown(bool shown);
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
  };
  QString title(const QString& id) const;
  Row* find(const QString& id);
  void addIfNew(const QString& id);

  QStringList kinds_;
  std::vector<Row> rows_;
  quint64 listVersion_ = ~0ULL;
};

}  // namespace widgets
