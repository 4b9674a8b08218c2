// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/PropertiesModel.h"

#include <QFont>
#include <QGuiApplication>
#include <QStringList>

#include "robotcontrol/World.pb.h"
#include "widgets/Theme.h"
#include "widgets/objects/PropertyRule.h"

namespace widgets {
namespace {

constexpr std::array kPoseNames{"x", "y", "z", "roll", "pitch", "heading"};
constexpr int kPositions = 3;

QString textOf(const robotcontrol::WorldProperty& property) {
  QStringList parts;
  if (!property.text().empty()) parts << QString::fromStdString(property.text());
  for (const double value : property.values()) parts << QString::number(value, 'g', 6);
  return parts.join(QLatin1Char(' '));
}

}  // namespace

PropertiesModel::PropertiesModel(QObject* parent)
    : RowModel({tr("Property"), tr("Value"), tr("Unit")}, parent) {}

QString PropertiesModel::titleOf(const std::string& name) {
  static const std::map<std::string, const char*> kTitles{
      {"x", QT_TR_NOOP("x")},
      {"y", QT_TR_NOOP("y")},
      {"z", QT_TR_NOOP("z")},
      {"roll", QT_TR_NOOP("roll")},
      {"pitch", QT_TR_NOOP("pitch")},
      {"heading", QT_TR_NOOP("heading")},
      {"angles", QT_TR_NOOP("angles")},
      {"angular_damping", QT_TR_NOOP("rotational damping")},
      {"attenuation", QT_TR_NOOP("attenuation")},
      {"axis", QT_TR_NOOP("axis")},
      {"axis_in_link", QT_TR_NOOP("axis in the link")},
      {"azimuth", QT_TR_NOOP("azimuth")},
      {"center_of_mass", QT_TR_NOOP("center of mass")},
      {"color", QT_TR_NOOP("color")},
      {"damping", QT_TR_NOOP("damping")},
      {"delay", QT_TR_NOOP("delay")},
      {"diffuse", QT_TR_NOOP("color: red, green, blue, 0 to 1")},
      {"direction", QT_TR_NOOP("direction")},
      {"dropout", QT_TR_NOOP("fraction of lost readings")},
      {"elevation", QT_TR_NOOP("elevation")},
      {"file", QT_TR_NOOP("file")},
      {"friction", QT_TR_NOOP("friction")},
      {"inertia", QT_TR_NOOP("inertia: ixx, iyy, izz, ixy, ixz, iyz")},
      {"initial_pose", QT_TR_NOOP("initial position")},
      {"intensity", QT_TR_NOOP("intensity")},
      {"length", QT_TR_NOOP("length")},
      {"linear_damping", QT_TR_NOOP("linear damping")},
      {"lower_limit", QT_TR_NOOP("lower limit")},
      {"mass", QT_TR_NOOP("mass")},
      {"maximum", QT_TR_NOOP("maximum of each value")},
      {"maximum_force", QT_TR_NOOP("maximum force")},
      {"maximum_speed", QT_TR_NOOP("maximum speed")},
      {"maximum_torque", QT_TR_NOOP("maximum torque")},
      {"minimum", QT_TR_NOOP("minimum of each value")},
      {"noise", QT_TR_NOOP("noise")},
      {"opening_angle", QT_TR_NOOP("opening angle")},
      {"opening_angles", QT_TR_NOOP("opening angles")},
      {"palette_color", QT_TR_NOOP("color of the palette")},
      {"pixels", QT_TR_NOOP("width, height")},
      {"radius", QT_TR_NOOP("radius")},
      {"range", QT_TR_NOOP("range")},
      {"rate", QT_TR_NOOP("rate")},
      {"restitution", QT_TR_NOOP("restitution")},
      {"shape", QT_TR_NOOP("shape")},
      {"size", QT_TR_NOOP("size")},
      {"team", QT_TR_NOOP("team")},
      {"track", QT_TR_NOOP("track")},
      {"type", QT_TR_NOOP("type")},
      {"upper_limit", QT_TR_NOOP("upper limit")},
      {"wheel_radius", QT_TR_NOOP("wheel radius")},
  };
  const auto found = kTitles.find(name);
  return found == kTitles.end() ? QString::fromStdString(name) : tr(found->second);
}

void PropertiesModel::addRows(const robotcontrol::WorldObject& object, const QString& part, bool isWritable,
                              std::vector<PropertyRow>& rows) const {
  for (const auto& property : object.properties()) {
    PropertyRow row{property.name(), textOf(property), QString::fromStdString(property.unit()), part};
    row.file = property.file();
    row.element.assign(property.element().begin(), property.element().end());
    row.count = property.values_size();
    row.isEditable = isWritable && !row.file.empty();
    for (const auto* edits : {&taken_, &edits_}) {
      const auto edit = edits->find({row.file, row.element});
      if (row.file.empty() || edit == edits->end()) continue;
      row.isChanged = edits == &edits_;
      row.value = QString::fromStdString(edit->second);
    }
    rows.push_back(std::move(row));
  }
}

void PropertiesModel::show(const robotcontrol::WorldObject* object, const std::optional<ObjectPose>& pose,
                           bool isWritable, std::span<const robotcontrol::WorldObject* const> parts) {
  std::vector<PropertyRow> rows;
  for (int i = 0; pose && i < static_cast<int>(pose->size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    PropertyRow row{kPoseNames[at],
                    QString::number((*pose)[at], 'f', 4),
                    i < kPositions ? QStringLiteral("m") : QStringLiteral("rad"),
                    {},
                    i};
    row.isEditable = object != nullptr && object->is_movable();
    rows.push_back(std::move(row));
  }
  if (object != nullptr) addRows(*object, {}, isWritable, rows);
  for (const auto* part : parts) {
    const QString name = QString::fromStdString(part->name());
    const bool isSolid = part->kind() == robotcontrol::WorldObject::SOLID;
    const bool isLink = part->kind() == robotcontrol::WorldObject::LINK;
    addRows(*part, isLink ? name : (isSolid ? tr("solid %1") : tr("visible %1")).arg(name), isWritable, rows);
  }
  replaceRows(std::move(rows), [](const PropertyRow& a, const PropertyRow& b) {
    return a.name == b.name && a.part == b.part && a.element == b.element;
  });
}

std::vector<SceneFileEdit> PropertiesModel::edits() const {
  std::vector<SceneFileEdit> edits;
  for (const auto& [place, value] : edits_) edits.push_back({place.first, place.second, value});
  return edits;
}

void PropertiesModel::addEdit(SceneFileEdit edit) {
  edits_[{std::move(edit.file), std::move(edit.element)}] = std::move(edit.value);
  Q_EMIT editsChanged();
}

void PropertiesModel::clearEdits() {
  edits_.clear();
  Q_EMIT editsChanged();
}

std::vector<SceneFileEdit> PropertiesModel::takeEdits() {
  auto taken = edits();
  for (auto& [place, value] : edits_) taken_[place] = value;
  clearEdits();
  return taken;
}

QVariant PropertiesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const PropertyRow& shown = row(index.row());
  if (role == Qt::DisplayRole || role == Qt::EditRole) {
    if (index.column() == kName) {
      const QString title = titleOf(shown.name);
      return shown.part.isEmpty() ? title : tr("%1 (%2)").arg(title, shown.part);
    }
    return index.column() == kValue ? shown.value : shown.unit;
  }
  if (role == Qt::TextAlignmentRole && index.column() == kValue) return kNumberAlignment;
  if (role == Qt::FontRole && shown.isChanged) {
    QFont font;
    font.setBold(true);
    return font;
  }
  if (role == Qt::ForegroundRole && index.column() == kValue && !shown.isEditable)
    return colorOf(Meaning::kMuted, QGuiApplication::palette());
  if (role != Qt::ToolTipRole) return {};
  if (shown.isChanged)
    return tr("Not in the file yet: Save to file writes it; it takes effect when the scene is opened again");
  if (shown.poseIndex >= 0 && shown.isEditable) return tr("Double click to move the object");
  if (shown.isEditable) return tr("Double click to change it in %1").arg(QString::fromStdString(shown.file));
  if (shown.poseIndex >= 0) return tr("It moves with the object it belongs to");
  return tr("%1 (cannot be changed here: no single number in the scene's files sets it)").arg(shown.value);
}

Qt::ItemFlags PropertiesModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = RowModel::flags(index);
  if (index.isValid() && index.column() == kValue && row(index.row()).isEditable) flags |= Qt::ItemIsEditable;
  return flags;
}

bool PropertiesModel::setText(const PropertyRow& edited, const QString& text) {
  if (text.isEmpty()) return false;
  if (text != edited.value) addEdit({edited.file, edited.element, text.toStdString()});
  return true;
}

bool PropertiesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.column() != kValue) return false;
  const PropertyRow edited = row(index.row());
  if (!edited.isEditable) return false;
  if (edited.count == 0) return setText(edited, value.toString().trimmed());
  const auto numbers =
      propertyNumbers(value.toString(), edited.name, edited.count, titleOf(edited.name), edited.unit);
  if (!numbers) {
    Q_EMIT refused(QString::fromStdString(numbers.error().text));
    return false;
  }
  if (edited.poseIndex >= 0) {
    Q_EMIT poseEdited(edited.poseIndex, numbers->front());
    return true;
  }
  if (value.toString() == edited.value) return true;
  QStringList texts;
  for (const double number : *numbers) texts << QString::number(number, 'g', 12);
  addEdit({edited.file, edited.element, texts.join(QLatin1Char(' ')).toStdString()});
  return true;
}

}  // namespace widgets
