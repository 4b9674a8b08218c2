// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

class QMimeData;

namespace widgets {

class SceneBench;

/// The objects that can be added to the scene: simple shapes, a wall, a lamp, a camera, and the models that
/// the scene finds. They are dragged from here to a place, or added where the view looks by a double click or
/// Enter. A window of its own next to the view. Object name "scenePalette". GUI thread.
class ScenePalette final : public QListWidget {
  Q_OBJECT
 public:
  /// The kinds of SceneLanguage::newObject() with their names for users.
  struct Entry {
    QString kind, title;
  };
  static std::vector<Entry> entries(const SceneBench& bench);
  /// The kind that is dragged; empty: something else is.
  static QString kindIn(const QMimeData& data);

  explicit ScenePalette(QWidget* parent);
  /// Lists what there is now.
  void fill(const SceneBench& bench);

 Q_SIGNALS:
  void chosen(const QString& kind);

 protected:
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QList<QListWidgetItem*> items) const override;
};

}  // namespace widgets
