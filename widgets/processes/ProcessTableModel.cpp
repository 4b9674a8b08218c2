// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/ProcessTableModel.h"

#include <QGuiApplication>

#include "widgets/Theme.h"

namespace widgets {

ProcessTableModel::ProcessTableModel(QObject* parent)
    : RowModel({tr("Process"), tr("State"), tr("Hz"), tr("Frames"), tr("Period"), tr("Nice"), tr("Missed"),
                tr("Dropped"), tr("Tasks")},
               parent) {}

void ProcessTableModel::setGraph(const ProcessGraph& graph) {
  replaceRows(graph.nodes, [](const auto& a, const auto& b) { return a.name == b.name; });
}

QVariant ProcessTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ProcessGraph::Node& node = row(index.row());
  const bool number = index.column() >= kRate && index.column() <= kDropped;
  if (role == Qt::TextAlignmentRole && number) return kNumberAlignment;
  if (role == Qt::ToolTipRole && index.column() == kState) return node.state;
  if (role == Qt::ToolTipRole && index.column() == kMissed && node.missed() > 0) {
    return node.fallsBehind() ? tr("The process does not keep up: it waits for each package, and loses some")
                              : tr("Replaced by newer ones before they were read, as the layout intends");
  }
  if (role == Qt::ForegroundRole) {
    if (node.failed) return colorOf(Meaning::kBad, QGuiApplication::palette());
    const bool lost =
        (index.column() == kMissed && node.fallsBehind()) || (index.column() == kDropped && node.dropped > 0);
    return lost ? colorOf(Meaning::kWarning, QGuiApplication::palette()) : QVariant();
  }
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kName:
      return node.name;
    case kState:
      return node.state.isEmpty() ? tr("platform") : node.state;
    case kRate:
      return QString::number(node.rate, 'f', 1);
    case kFrames:
      return node.frames;
    case kPeriod:
      return node.period > 0 ? tr("%1 ms").arg(node.period * 1000) : tr("events");
    case kPriority:
      return node.priority;
    case kMissed:
      return node.missed();
    case kDropped:
      return node.dropped;
    default:
      return node.tasks.join(QStringLiteral(", "));
  }
}

}  // namespace widgets
