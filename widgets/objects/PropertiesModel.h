// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVariant>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "widgets/RowModel.h"
#include "widgets/world/ObjectPose.h"
#include "widgets/world/SceneFileEdit.h"

namespace robotcontrol {
class WorldObject;
}

namespace widgets {

/// A row of the properties of an object.
struct PropertyRow {
  /// "mass"; of a pose "x", "y", "z", "roll", "pitch", "heading".
  std::string name;
  QString value, unit;
  /// The part of the object to which it belongs, such as "visible box"; empty: to the object itself.
  QString part = {};
  /// Its place among the six numbers of the pose; -1: it is not part of the pose.
  int poseIndex = -1;
  /// The place of the property in a file; empty: it cannot be changed there.
  std::string file = {};
  std::vector<std::string> element = {};
  /// Whether the user changed it, which is not in the file yet.
  bool isChanged = false;
  bool isEditable = false;
  /// The number of its numbers; 0: it is a text.
  int count = 1;
};

/// The properties of an object of a scene, and the user's changes of all objects. Numbers that are edited
/// are announced; the model keeps those that are for files until they are taken. GUI thread.
class PropertiesModel final : public RowModel<PropertyRow> {
  Q_OBJECT
 public:
  enum Column { kName, kValue, kUnit, kColumns };

  explicit PropertiesModel(QObject* parent = nullptr);

  /// Shows an object at its pose; null: none. `parts` are objects whose properties are shown as its own, too.
  /// `isWritable`: whether files can be changed.
  void show(const robotcontrol::WorldObject* object, const std::optional<ObjectPose>& pose, bool isWritable,
            std::span<const robotcontrol::WorldObject* const> parts = {});
  /// The changes for files, in the order of files and elements.
  std::vector<SceneFileEdit> edits() const;
  /// Keeps one; that of the same element before is replaced.
  void addEdit(SceneFileEdit edit);
  void clearEdits();
  /// Returns the changes for files, which are shown as they are until forgetTaken(), but are no longer
  /// edits.
  std::vector<SceneFileEdit> takeEdits();
  void forgetTaken() { taken_.clear(); }

  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

 Q_SIGNALS:
  /// A number of the pose was edited; m or rad.
  void poseEdited(int index, double value);
  /// Emitted when typed text is not accepted, with the reason.
  void refused(const QString& reason);
  /// A change for a file was added, or all were cleared.
  void editsChanged();

 private:
  using Place = std::pair<std::string, std::vector<std::string>>;
  static QString titleOf(const std::string& name);
  bool setText(const PropertyRow& edited, const QString& text);
  /// Adds the properties of an object, each with the part that it belongs to.
  void addRows(const robotcontrol::WorldObject& object, const QString& part, bool isWritable,
               std::vector<PropertyRow>& rows) const;

  /// The new texts by file and element.
  std::map<Place, std::string> edits_;
  /// The same of those that were taken.
  std::map<Place, std::string> taken_;
};

}  // namespace widgets
