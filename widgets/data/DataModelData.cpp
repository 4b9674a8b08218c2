// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <QBuffer>
#include <QGuiApplication>
#include <QMimeData>

#include "robotlink/debugging/Streams.h"
#include "widgets/Theme.h"
#include "widgets/TypedStreams.h"
#include "widgets/data/DataModel.h"
#include "widgets/data/FieldJson.h"
#include "widgets/plots/PlotTreeModel.h"
#include "widgets/world/FieldUnits.h"

// The contents of the cells of a DataModel.
namespace widgets {

namespace {

constexpr int kPreviewSize = 320;  // pixels
constexpr double kDegreesPerRadian = 57.29577951308232;
constexpr double kHighlight = 0.28;  // share of the color in the background of what differs

/// Plot values have no field, only a unit of their own.
const google::protobuf::FieldDescriptor* plotValueField(const DataNode& node) {
  if (node.kind != DataNode::Kind::kField || node.parent->kind != DataNode::Kind::kStream ||
      node.field->containing_type()->full_name() != "robotcontrol.PlotValue" || node.field->name() != "value")
    return nullptr;
  return node.field;
}

QString unitOfRow(const DataNode& node) {
  const DataNode* stream = node.stream();
  if (node.field == nullptr || stream->value == nullptr || !holdsNumbers(*node.field)) return {};
  if (plotValueField(node) != nullptr) {
    const auto* unit = stream->value->GetDescriptor()->FindFieldByName("unit");
    return valueText({stream->value.get(), unit});
  }
  return unitOf(stream->value->GetDescriptor()->full_name(), fieldPathOf(node));
}

bool isNumber(const DataNode& node) {
  const bool isValue = node.kind == DataNode::Kind::kElement ||
                       (node.kind == DataNode::Kind::kField && !node.field->is_repeated());
  return isValue && holdsNumbers(*node.field);
}

QString picture(const QImage& image) {
  QByteArray png;
  QBuffer buffer(&png);
  image.scaled(kPreviewSize, kPreviewSize, Qt::KeepAspectRatio, Qt::SmoothTransformation)
      .save(&buffer, "PNG");
  return QStringLiteral("<br><img src='data:image/png;base64,%1'>").arg(QString::fromLatin1(png.toBase64()));
}

}  // namespace

QVariant DataModel::data(const QModelIndex& index, int role) const {
  const DataNode* row = node(index);
  if (row == nullptr) return {};
  switch (role) {
    case kPathRole:
      return pathTextOf(*row);
    case kRowRole:
      return rowKeyOf(*row);
    case kSourceRole:
      return sourceOf(*row);
    case kFieldRole:
      return row->field == nullptr || (holdsMessages(*row->field) && !row->isList())
                 ? QString()
                 : QString::fromStdString(fieldPathOf(*row));
    case kKeyRole:
      return QString::fromStdString(row->key);
    case kFoundRole:
      return row->kind != DataNode::Kind::kRobot && filter_.finds(searched(*row));
    case kChangedRole:
      return isChanged(*row);
    case Qt::ToolTipRole:
      return toolTip(*row);
    case Qt::ForegroundRole:
    case Qt::BackgroundRole:
      return colorOfRow(*row, role);
    case kFullValueRole:
      if (row->kind == DataNode::Kind::kField || row->kind == DataNode::Kind::kElement) {
        const QString text = valueText(placesOf(*row).own, Precision::kFull);
        if (!text.isEmpty()) return text;
      }
      return this->index(index.row(), kValue, index.parent()).data();
    default:
      break;
  }
  if (row->kind == DataNode::Kind::kRobot) {
    if (role != Qt::DisplayRole || index.column() != kName) return {};
    return row->name.empty() ? tr("Session") : QString::fromStdString(row->name);
  }
  return row->kind == DataNode::Kind::kStream ? streamData(*row, index.column(), role)
                                              : fieldData(*row, index.column(), role);
}

QVariant DataModel::streamData(const DataNode& node, int column, int role) const {
  if (role == Qt::DecorationRole && column == kValue) {
    const QImage image = thumbnails_.of(node.name, shownMessage(node.name), kThumbnailHeight);
    return image.isNull() ? QVariant() : image;
  }
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kName:
      return labelOf(node);
    case kValue:
      return streamState(node);
    default:
      return {};
  }
}

QVariant DataModel::fieldData(const DataNode& node, int column, int role) const {
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kName:
      return labelOf(node);
    case kValue:
      return valueOf(node);
    case kUnit:
      return unitOfRow(node);
    default:
      return otherValueOf(node);
  }
}

bool DataModel::isHeld(const DataNode& stream) const {
  const std::string robot = robotlink::streams::robotOf(stream.name);
  const auto held = held_.find(robot);
  return held != held_.end() && held->second.contains(stream.name.substr(robot.size() + 1));
}

QString DataModel::streamState(const DataNode& node) const {
  const QString state = arrivalState(node);
  return isHeld(node) ? tr("held – %1").arg(state) : state;
}

QString DataModel::arrivalState(const DataNode& node) const {
  if (!node.key.empty()) return tr("off – click to switch on");
  const auto* message = store_->latest(node.name, shown_);
  if (message == nullptr) return tr("no message yet");
  const auto* stream = store_->find(node.name);
  const QString age = tr("%1 s ago").arg(robotlink::seconds(shown_ - message->time), 0, 'f', 2);
  return stream->rate > 0 ? tr("%1 Hz, %2").arg(stream->rate, 0, 'f', 1).arg(age) : age;
}

QString DataModel::valueOf(const DataNode& node) const {
  const FieldPlace place = placesOf(node).own;
  if (place.holder == nullptr) return {};
  if (node.isList()) {
    const DataNode& stream = *node.stream();
    auto& computed = node.computed;
    if (computed.own != stream.value || computed.other != stream.other)
      computed = {stream.value, stream.other, {}, {}};
    if (!computed.text)
      computed.text =
          statisticsText(place, node.first, node.kind == DataNode::Kind::kRange ? node.count : place.size());
    return *computed.text;
  }
  if (!place.isSet()) return node.kind == DataNode::Kind::kField ? tr("not set") : QString();
  const auto* message = place.message();
  return message != nullptr ? summaryText(*message) : valueText(place);
}

QString DataModel::otherValueOf(const DataNode& node) const {
  if (node.stream()->other == nullptr) return {};
  const FieldPlace place = placesOf(node).other;
  if (node.kind == DataNode::Kind::kRange) return {};
  if (!place.isSet()) return tr("not set");
  if (node.isList()) return statisticsText(place, 0, place.size());
  const auto* message = place.message();
  return message != nullptr ? summaryText(*message) : valueText(place);
}

bool DataModel::isChanged(const DataNode& node) const {
  const DataNode* stream = node.stream();
  if (stream == nullptr || comparison_.with == DataComparison::With::kNothing) return false;
  // A stream that is folded has no message of its own.
  const bool isStream = node.kind == DataNode::Kind::kStream;
  const robotlink::PackagePtr own = isStream ? shownMessage(node.name) : stream->value;
  const robotlink::PackagePtr other = isStream ? otherMessage(node.name) : stream->other;
  if (own == nullptr || other == nullptr) return false;
  auto& computed = node.computed;
  if (computed.own != own || computed.other != other) computed = {own, other, {}, {}};
  if (!computed.isChanged) {
    const NodePlaces places = isStream ? NodePlaces() : placesOf(node);
    computed.isChanged = isStream ? areDifferent(*own, *other)
                         : node.kind == DataNode::Kind::kRange
                             ? areDifferent(places.own, places.other, node.first, node.count)
                             : areDifferent(places.own, places.other);
  }
  return *computed.isChanged;
}

QVariant DataModel::colorOfRow(const DataNode& node, int role) const {
  const QPalette palette = QGuiApplication::palette();
  if (role == Qt::BackgroundRole) {
    if (!isChanged(node)) return {};
    return mixed(palette.color(QPalette::Base), colorOf(Meaning::kWarning, palette), kHighlight);
  }
  if (node.kind == DataNode::Kind::kStream && isHeld(node)) return colorOf(Meaning::kWarning, palette);
  const bool isMuted = node.kind == DataNode::Kind::kStream
                           ? !node.key.empty()
                           : node.field != nullptr && !placesOf(node).own.isSet();
  return isMuted ? colorOf(Meaning::kMuted, palette) : QVariant();
}

QString DataModel::sourceOf(const DataNode& node) const {
  if (!isNumber(node)) return {};
  const std::string field = plotValueField(node) != nullptr ? std::string() : fieldPathOf(node);
  return PlotSource{node.stream()->name, field}.text();
}

QString DataModel::toolTip(const DataNode& node) const {
  if (node.kind == DataNode::Kind::kRobot) return {};
  const QString path = pathTextOf(node).toHtmlEscaped();
  if (!node.key.empty())
    return tr("%1<br>The debug key %2 is off. Click to switch it on.")
        .arg(path, QString::fromStdString(node.key).toHtmlEscaped());
  if (node.kind == DataNode::Kind::kStream) {
    const robotlink::PackagePtr message = shownMessage(node.name);
    if (message == nullptr) return path;
    const QString type = QString::fromStdString(message->GetDescriptor()->full_name());
    const QImage image = imageOf(*message);
    return path + QStringLiteral("<br>") + type.toHtmlEscaped() +
           (image.isNull() ? QString() : picture(image));
  }
  QStringList lines{path, typeText(*node.field).toHtmlEscaped()};
  const NodePlaces places = placesOf(node);
  const auto own = numberOf(places.own), other = numberOf(places.other);
  if (own && unitOfRow(node) == QStringLiteral("rad"))
    lines << tr("%1°").arg(*own * kDegreesPerRadian, 0, 'f', 1);
  if (own && other) lines << tr("difference: %1").arg(*own - *other, 0, 'g', 6);
  return lines.join(QStringLiteral("<br>"));
}

QVariant DataModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kName:
      return tr("Name");
    case kValue:
      return tr("Value");
    case kUnit:
      return tr("Unit");
    default:
      return tr("Compared with");
  }
}

Qt::ItemFlags DataModel::flags(const QModelIndex& index) const {
  const DataNode* row = node(index);
  if (row == nullptr) return Qt::NoItemFlags;
  const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return isNumber(*row) ? flags | Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren : flags;
}

QStringList DataModel::mimeTypes() const {
  return {QString::fromLatin1(PlotTreeModel::kMimeType)};
}

QMimeData* DataModel::mimeData(const QModelIndexList& indexes) const {
  QStringList sources;
  for (const QModelIndex& index : indexes) {
    const QString source = index.data(kSourceRole).toString();
    if (!source.isEmpty() && !sources.contains(source)) sources << source;
  }
  auto* data = new QMimeData;
  data->setData(QString::fromLatin1(PlotTreeModel::kMimeType), sources.join(QLatin1Char('\n')).toUtf8());
  data->setText(sources.join(QLatin1Char('\n')));
  return data;
}

}  // namespace widgets
