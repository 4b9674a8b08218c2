// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterModel.h"

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include <QBrush>
#include <QFont>
#include <QGuiApplication>
#include <algorithm>
#include <functional>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/ParameterRules.h"
#include "robotlink/debugging/ParameterText.h"
#include "widgets/Theme.h"
#include "widgets/solutions/MessageFields.h"

namespace widgets {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

struct ParameterModel::Node {
  FieldPath path;
  Node* parent = nullptr;
  int row = 0;
  std::vector<std::unique_ptr<Node>> children;
};

struct ParameterModel::Values {
  google::protobuf::DescriptorPool pool;  // descriptors of types that are not compiled in
  google::protobuf::DynamicMessageFactory factory;
  std::unique_ptr<Message> now;
  std::unique_ptr<Message> standard;
  std::unique_ptr<Message> builtIn;  // null: unknown
  std::vector<robotcontrol::ParameterLimits> limits;

  const Message* prototype(const robotcontrol::ParameterValues& from) {
    const std::string& type = from.value().type();
    const auto* known = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(type);
    if (known != nullptr) return google::protobuf::MessageFactory::generated_factory()->GetPrototype(known);
    google::protobuf::FileDescriptorSet files;
    if (!files.ParseFromString(from.descriptors())) return nullptr;
    for (const auto& file : files.file()) pool.BuildFile(file);
    const Descriptor* described = pool.FindMessageTypeByName(type);
    return described != nullptr ? factory.GetPrototype(described) : nullptr;
  }
};

namespace {

QByteArray bytesOf(const Message& message) {
  return QByteArray::fromStdString(message.SerializeAsString());
}

bool parse(Message& message, const QByteArray& bytes) {
  return message.ParseFromArray(bytes.constData(), bytes.size());
}

/// The sizes of all lists in a message, in order: two messages of a type with equal ones have equal rows.
void addListSizes(const Message& message, std::vector<int>& sizes) {
  const auto& reflection = *message.GetReflection();
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor* field = message.GetDescriptor()->field(i);
    const bool group = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (!field->is_repeated()) {
      if (group) addListSizes(reflection.GetMessage(message, field), sizes);
      continue;
    }
    const int size = reflection.FieldSize(message, field);
    sizes.push_back(size);
    for (int element = 0; group && element < size; ++element)
      addListSizes(reflection.GetRepeatedMessage(message, field, element), sizes);
  }
}

bool haveEqualRows(const Message& one, const Message& other) {
  std::vector<int> oneSizes, otherSizes;
  addListSizes(one, oneSizes);
  addListSizes(other, otherSizes);
  return oneSizes == otherSizes;
}

bool isNumber(const QVariant& value) {
  return value.isValid() && value.type() != QVariant::Bool && value.type() != QVariant::String;
}

QString shown(const QVariant& value) {
  if (value.type() == QVariant::Double) return QString::number(value.toDouble(), 'g', 9);
  return value.toString();
}

}  // namespace

ParameterModel::ParameterModel(QObject* parent)
    : QAbstractItemModel(parent), root_(std::make_unique<Node>()) {}
ParameterModel::~ParameterModel() = default;

void ParameterModel::clear() {
  beginResetModel();
  root_ = std::make_unique<Node>();
  values_.reset();
  endResetModel();
}

bool ParameterModel::setParameters(const robotcontrol::ParameterValues& from) {
  auto values = std::make_unique<Values>();
  const Message* prototype = values->prototype(from);
  if (prototype == nullptr) {
    clear();
    return false;
  }
  values->now.reset(prototype->New());
  values->standard.reset(prototype->New());
  const bool reported = from.has_defaults() && values->standard->ParseFromString(from.defaults().data());
  if (!values->now->ParseFromString(from.value().data())) {
    clear();
    return false;
  }
  if (!reported) values->standard->CopyFrom(*values->now);
  values->builtIn.reset(from.has_built_in() ? prototype->New() : nullptr);
  if (values->builtIn && !values->builtIn->ParseFromString(from.built_in().data())) values->builtIn.reset();
  values->limits.assign(from.limits().begin(), from.limits().end());
  beginResetModel();
  root_ = std::make_unique<Node>();  // destroyed before the descriptors to which its paths point
  values_ = std::move(values);
  build();
  endResetModel();
  return true;
}

QByteArray ParameterModel::value() const {
  return values_ ? bytesOf(*values_->now) : QByteArray();
}
QByteArray ParameterModel::defaults() const {
  return values_ ? bytesOf(*values_->standard) : QByteArray();
}
bool ParameterModel::isChanged() const {
  return values_ != nullptr && differs(*root_);
}
tl::expected<std::string, robotlink::Errors> ParameterModel::inFile(const std::optional<std::string>& text,
                                                                    const std::string& file) const {
  if (values_ == nullptr) return std::string();
  if (!text) return robotlink::parameterText(*values_->now);
  return robotlink::editedParameterText(*text, file, *values_->standard, *values_->now);
}
std::string ParameterModel::typeName() const {
  return values_ ? values_->now->GetTypeName() : std::string();
}

void ParameterModel::setValue(const QByteArray& value) {
  if (values_ == nullptr) return;
  std::unique_ptr<Message> parsed(values_->now->New());
  if (!parse(*parsed, value)) return;
  if (!haveEqualRows(*values_->now, *parsed)) {
    beginResetModel();
    root_ = std::make_unique<Node>();
    values_->now = std::move(parsed);
    build();
    endResetModel();
    return;
  }
  values_->now->CopyFrom(*parsed);
  const std::function<void(const QModelIndex&)> notify = [&](const QModelIndex& parent) {
    const int rows = rowCount(parent);
    if (rows == 0) return;
    Q_EMIT dataChanged(index(0, 0, parent), index(rows - 1, kColumns - 1, parent));
    for (int row = 0; row < rows; ++row) notify(index(row, 0, parent));
  };
  notify({});
}

void ParameterModel::build() {
  addFields(*root_);
}

void ParameterModel::addFields(Node& node) {
  const auto add = [&](FieldPath path) {
    auto& child = node.children.emplace_back(std::make_unique<Node>());
    child->path = std::move(path);
    child->parent = &node;
    child->row = static_cast<int>(node.children.size()) - 1;
    if (isMessage(child->path)) addFields(*child);
  };
  const Message& message = messageAt(*values_->now, node.path);
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor* field = message.GetDescriptor()->field(i);
    FieldPath path = node.path;
    path.push_back({field, -1});
    if (!field->is_repeated()) {
      add(path);
      continue;
    }
    for (int element = 0; element < message.GetReflection()->FieldSize(message, field); ++element) {
      path.back().element = element;
      add(path);
    }
  }
}

const ParameterModel::Node& ParameterModel::nodeOf(const QModelIndex& index) const {
  const auto* node = static_cast<const Node*>(index.internalPointer());  // null for an invalid index
  return node == nullptr ? *root_ : *node;
}

bool ParameterModel::differs(const Node& node) const {
  if (node.children.empty())
    return valueAt(*values_->now, node.path) != valueAt(*values_->standard, node.path);
  return std::any_of(node.children.begin(), node.children.end(),
                     [this](const auto& child) { return differs(*child); });
}

const robotcontrol::ParameterLimits* ParameterModel::limitsOf(const Node& node) const {
  const auto found = std::ranges::find(values_->limits, pathText(node.path).toStdString(),
                                       &robotcontrol::ParameterLimits::path);
  return found == values_->limits.end() ? nullptr : &*found;
}

QString ParameterModel::toolTipOf(const Node& node) const {
  QString text = QStringLiteral("%1: %2").arg(pathText(node.path), widgets::typeName(node.path));
  if (const auto* limits = limitsOf(node)) {
    const robotlink::ParameterRange range{limits->minimum(), limits->maximum(), limits->above()};
    text += QStringLiteral(", ") + QString::fromStdString(range.describe());
  }
  if (node.children.empty() && differs(node))
    text += QLatin1Char('\n') + tr("changed from %1").arg(shown(valueAt(*values_->standard, node.path)));
  return text;
}

void ParameterModel::resetInto(const Node& node, Values& values) const {
  const QVariant standard = node.children.empty() ? valueAt(*values_->standard, node.path) : QVariant();
  if (standard.isValid()) setValueAt(*values.now, node.path, standard);
  for (const auto& child : node.children) resetInto(*child, values);
}

void ParameterModel::reset(const QModelIndex& index) {
  if (values_ == nullptr) return;
  Values copy;
  copy.now.reset(values_->now->New());
  copy.now->CopyFrom(*values_->now);
  resetInto(nodeOf(index), copy);
  const QByteArray after = bytesOf(*copy.now);
  if (after == value()) return;
  const QString what = index.isValid() ? pathText(nodeOf(index).path) : tr("all");
  Q_EMIT edited(value(), after, tr("reset %1").arg(what));
}

QModelIndex ParameterModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, nodeOf(parent).children[static_cast<std::size_t>(row)].get());
}

QModelIndex ParameterModel::parent(const QModelIndex& child) const {
  if (!child.isValid()) return {};
  Node* parent = nodeOf(child).parent;
  return parent == root_.get() ? QModelIndex() : createIndex(parent->row, 0, parent);
}

int ParameterModel::rowCount(const QModelIndex& parent) const {
  return parent.column() > 0 ? 0 : static_cast<int>(nodeOf(parent).children.size());
}

int ParameterModel::columnCount(const QModelIndex&) const {
  return kColumns;
}

QVariant ParameterModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Node& node = nodeOf(index);
  const QVariant value = valueAt(*values_->now, node.path);
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == kDefault) return shown(valueAt(*values_->standard, node.path));
      if (index.column() == kBuiltIn)
        return values_->builtIn ? shown(valueAt(*values_->builtIn, node.path)) : QVariant();
      if (index.column() == kValue) return value.type() == QVariant::Bool ? QVariant() : shown(value);
      return pathText({node.path.back()});
    case Qt::EditRole:
      return index.column() == kValue ? shown(value) : QVariant();
    case Qt::CheckStateRole:
      if (index.column() != kValue || value.type() != QVariant::Bool) return {};
      return value.toBool() ? Qt::Checked : Qt::Unchecked;
    case kChoicesRole:
      return choicesAt(node.path);
    case kChangedRole:
      return differs(node);
    case kPathRole:
      return pathText(node.path);
    case Qt::ToolTipRole:
      return toolTipOf(node);
    case kNumberRole:
      return isNumber(value) ? value : QVariant();
    case kMinRole:
    case kMaxRole: {
      const auto* limits = limitsOf(node);
      if (limits == nullptr) return {};
      return role == kMinRole ? limits->minimum() : limits->maximum();
    }
    case Qt::BackgroundRole: {
      if (index.column() != kValue || !node.children.empty() || !differs(node)) return {};
      const QPalette palette = QGuiApplication::palette();
      return QBrush(mixed(palette.color(QPalette::Base), colorOf(Meaning::kNote, palette), 0.25));
    }
    case Qt::FontRole: {
      QFont font;
      font.setBold(index.column() <= kValue && differs(node));
      return font;
    }
    case Qt::ForegroundRole:
      return index.column() > kValue ? colorOf(Meaning::kMuted, QGuiApplication::palette()) : QVariant();
    default:
      return {};
  }
}

QVariant ParameterModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString titles[kColumns] = {tr("Parameter"), tr("Value"), tr("In the file"), tr("Built in")};
  return titles[section];
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractItemModel::flags(index);
  if (!index.isValid() || index.column() != kValue) return flags;
  const QVariant value = valueAt(*values_->now, nodeOf(index).path);
  if (value.type() == QVariant::Bool) return flags | Qt::ItemIsUserCheckable;
  return value.isValid() ? flags | Qt::ItemIsEditable : flags;
}

bool ParameterModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != kValue || (role != Qt::EditRole && role != Qt::CheckStateRole))
    return false;
  const Node& node = nodeOf(index);
  std::unique_ptr<Message> changed(values_->now->New());
  changed->CopyFrom(*values_->now);
  const QVariant wanted = role == Qt::CheckStateRole ? QVariant(value.toInt() == Qt::Checked) : value;
  if (!setValueAt(*changed, node.path, wanted)) return false;
  const QByteArray after = bytesOf(*changed);
  const QByteArray before = this->value();
  if (after != before) Q_EMIT edited(before, after, pathText(node.path));
  return true;
}

}  // namespace widgets
