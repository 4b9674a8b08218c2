// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/ColumnsView.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robotcontrol/World.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/expressions/FieldPath.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"

namespace widgets {
namespace {

const ViewRegistration kColumnsRegistration{
    {"columns", QT_TRANSLATE_NOOP("View", "Column graph"),
     QT_TRANSLATE_NOOP("View", "The values of a list as columns, such as those of a laser"), "samples", true,
     create<ColumnsView>}};

}  // namespace

ColumnsView::ColumnsView(ViewContext& context, QWidget* parent) : View(context, parent) {
  setObjectName(QStringLiteral("columnsView"));
  createViews();
  keep(
      "source", [this] { return QJsonValue(source_->currentText()); },
      [this](const QJsonValue& value) { source_->setEditText(value.toString()); }, Names::kObjects);
  tick();
}

ColumnsView::~ColumnsView() = default;

void ColumnsView::createViews() {
  freeze_ =
      makeToggle(this, "pause", {"columnsFreeze", tr("Freeze"), tr("Keeps what is shown now"), tr("Ctrl+H")});
  source_ = new QComboBox(this);
  source_->setEditable(true);
  source_->setInsertPolicy(QComboBox::NoInsert);
  source_->setMinimumContentsLength(20);
  describe(*source_, {"columnsSource", tr("List whose values are shown"),
                      tr("A sensor of the scene, or a stream, a colon, and a list of its messages: "
                         "red1/range/laser: ranges")});
  canvas_ = new ColumnsCanvas(this);
  hint_ = new EmptyHint(static_cast<QWidget*>(canvas_));
  value_ = new QLabel(this);
  describe(*value_, {"columnsValue", tr("Value under the cursor"), {}});
  value_->setMargin(4);
  auto* row = new QHBoxLayout;
  row->addWidget(source_, 1);
  row->addWidget(makeButton(this, freeze_));
  auto* layout = makeColumn(this, {4, 4, 4, 0}, 4);
  layout->addLayout(row);
  layout->addWidget(canvas_, 1);
  layout->addWidget(value_);
  connect(source_, &QComboBox::currentTextChanged, this, &ColumnsView::tick);
  connect(canvas_, &ColumnsCanvas::pointedAt, this, &ColumnsView::showPointed);
}

robotlink::Result<void> ColumnsView::showSource(const std::string& source) {
  if (source.empty()) return robotlink::failure("columns.show", "no list is named whose values are shown");
  listPorts();
  if (isMissing(source)) {
    std::vector<std::string> known;
    for (int i = 0; i < source_->count(); ++i) known.push_back(source_->itemText(i).toStdString());
    return robotlink::failure(
        "columns.show",
        "there is no sensor " + source + " in this scene" + robotlink::suggestion(source, known), {},
        {source});
  }
  source_->setEditText(QString::fromStdString(source));
  freeze_->setChecked(false);
  return {};
}

void ColumnsView::listPorts() {
  const auto* message = session().store().latest(robotlink::streams::kObjects, session().timeline().newest());
  robotlink::PackagePtr value = message == nullptr ? nullptr : message->value;
  if (value == objects_) return;
  objects_ = std::move(value);
  const QString chosen = source_->currentText();
  const QSignalBlocker blocker(source_);
  source_->clear();
  if (const auto* objects = dynamic_cast<const robotcontrol::WorldObjects*>(objects_.get())) {
    for (const auto& object : objects->objects()) {
      const robotcontrol::WorldPort& port = object.port();
      if (object.has_port() && !port.is_actuator() && port.type() != "image")
        source_->addItem(QString::fromStdString(port.path()));
    }
  }
  source_->setEditText(chosen);
}

const robotcontrol::WorldPort* ColumnsView::port(const std::string& path) const {
  const auto* objects = dynamic_cast<const robotcontrol::WorldObjects*>(objects_.get());
  if (objects == nullptr) return nullptr;
  const auto found = std::ranges::find_if(objects->objects(), [&](const auto& object) {
    return object.has_port() && object.port().path() == path;
  });
  return found == objects->objects().end() ? nullptr : &found->port();
}

bool ColumnsView::isMissing(const std::string& source) const {
  return objects_ != nullptr && source.find(": ") == std::string::npos && port(source) == nullptr;
}

std::optional<ColumnGraph> ColumnsView::graphOfPort(const robotcontrol::WorldPort& port) const {
  const auto* readings = session().store().latestAs<robotcontrol::PortReadings>(robotlink::streams::kPorts,
                                                                                session().timeline().shown());
  if (readings == nullptr) return std::nullopt;
  for (const auto& reading : readings->readings()) {
    if (reading.port() != port.path()) continue;
    ColumnGraph graph;
    const int count = std::min(reading.values_size(), kMaxValues);
    graph.values.assign(reading.values().begin(), reading.values().begin() + count);
    graph.unit = QString::fromStdString(port.unit());
    graph.fit(port.minimum(), port.maximum());
    return graph;
  }
  return std::nullopt;
}

std::optional<ColumnGraph> ColumnsView::graphOfStream(const std::string& source) const {
  const std::size_t colon = source.find(": ");
  if (colon == std::string::npos) return std::nullopt;
  const std::string stream = source.substr(0, colon), field = source.substr(colon + 2);
  const auto shown = session().timeline().shown();
  const auto* message = session().store().latest(stream, shown);
  if (message == nullptr) message = session().store().latest(session().selectedRobot() + "/" + stream, shown);
  if (message == nullptr || !message->value) return std::nullopt;
  const auto count = robotlink::numberAt(*message->value, field);
  if (!count || !(*count >= 0)) return std::nullopt;
  ColumnGraph graph;
  for (int i = 0; i < std::min(*count, double(kMaxValues)); ++i) {
    const auto value = robotlink::numberAt(*message->value, field + "[" + std::to_string(i) + "]");
    graph.values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  graph.fit(0, 0);
  return graph;
}

std::optional<ColumnGraph> ColumnsView::graph() {
  const std::string source = source_->currentText().trimmed().toStdString();
  if (source.empty()) return std::nullopt;
  if (const auto* sensor = port(source)) {
    subscription_.want(session(), {source});
    return graphOfPort(*sensor);
  }
  return graphOfStream(source);
}

void ColumnsView::tick() {
  listPorts();
  if (freeze_->isChecked()) return;
  auto now = graph();
  const QString source = source_->currentText();
  if (std::exchange(limited_, source) != source) limits_ = {};
  if (now) limits_.apply(*now);
  hint_->setHint(now ? QString()
                 : source.isEmpty()
                     ? tr("Choose a sensor of the scene above, or type a stream and a list of its messages.")
                 : isMissing(source.trimmed().toStdString())
                     ? tr("There is no sensor %1 in this scene. Choose another one above.").arg(source)
                     : tr("There are no values of %1 yet.").arg(source));
  canvas_->show(now.value_or(ColumnGraph()));
  showPointed(pointed_);
  Q_EMIT titleChanged(source.isEmpty() ? tr("Column graph") : tr("Column graph: %1").arg(source));
}

void ColumnsView::showPointed(int column) {
  pointed_ = column;
  const auto& values = canvas_->graph().values;
  const bool isThere = column >= 0 && column < static_cast<int>(values.size());
  value_->setText(isThere ? QStringLiteral("[%1]  %2 %3")
                                .arg(column)
                                .arg(values[static_cast<std::size_t>(column)], 0, 'g', 6)
                                .arg(canvas_->graph().unit)
                          : counted(values.size(), tr("1 value"), tr("%1 values")));
}

QString ColumnsView::table(QChar separator) const {
  QString text = tr("index") + separator + tr("value") + QLatin1Char('\n');
  const auto& values = canvas_->graph().values;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += QString::number(i) + separator + QString::number(values[i], 'g', 12) + QLatin1Char('\n');
  return text;
}

std::optional<QString> ColumnsView::numbers() {
  return table(QLatin1Char('\t'));
}

robotlink::Result<void> ColumnsView::saveTo(const QString& file) {
  const std::string path = file.toStdString(), suffix = robotlink::fileSuffix(path);
  if (suffix != ".csv" && suffix != ".txt" && suffix != ".tsv") return View::saveTo(file);
  return robotlink::writeFileAtomically(path,
                                        table(QLatin1Char(suffix == ".csv" ? ',' : '\t')).toStdString());
}

QImage ColumnsView::shownPicture() {
  return canvas_->grab().toImage();
}

}  // namespace widgets
