// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/FoundRobots.h"

#include <QKeyEvent>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/robotcontrol/remote/DialogParts.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"

namespace app {
namespace {

enum FoundColumn { kFoundNames, kFoundKinds, kFoundRuns, kFoundAddress, kFoundAge };

constexpr int kFoundLines = 3;
/// Announcements arrive within this time.
constexpr robotlink::Duration kFirstAnswers = std::chrono::seconds(3);

/// Each text once, in their order.
template <typename TextOf>
QString listed(const std::vector<robotlink::dds::AnnouncedRobot>& robots, TextOf textOf) {
  QStringList texts;
  for (const auto& robot : robots) {
    const QString text = textOf(robot);
    if (!text.isEmpty() && !texts.contains(text)) texts << text;
  }
  return texts.join(QStringLiteral(", "));
}

QString runsText(const robotlink::dds::AnnouncedRobot& robot) {
  if (robot.isBody) return FoundRobots::tr("body only: its program can run on this computer");
  return robot.layout.empty() ? QString()
                              : FoundRobots::tr("layout %1").arg(QString::fromStdString(robot.layout));
}

void showCell(QTreeWidgetItem& row, int column, const QString& text, const QString& toolTip) {
  // The text is escaped, since anybody in the network may have sent it.
  const QString escaped = QStringLiteral("<span>%1</span>").arg(toolTip.toHtmlEscaped());
  if (row.text(column) != text) row.setText(column, text);
  if (row.toolTip(column) != escaped) row.setToolTip(column, escaped);
}

}  // namespace

QString ageText(robotlink::Duration age) {
  const auto seconds = static_cast<int>(robotlink::seconds(age));
  if (seconds < 60) return FoundRobots::tr("%1 s").arg(seconds);
  return seconds < 3600 ? FoundRobots::tr("%1 min").arg(seconds / 60)
                        : FoundRobots::tr("%1 h").arg(seconds / 3600);
}

FoundRobots::FoundRobots(QWidget* parent) : QWidget(parent) {
  using Kind = widgets::ColumnKind;
  tree_ = makeList(this, {"foundRobots", tr("Robots on the network"), {}},
                   {{tr("On the network"), Kind::kName, QStringLiteral("red1, red2")},
                    {tr("Kind"), Kind::kName, QStringLiteral("ers210")},
                    {tr("Runs"), Kind::kText},
                    {tr("Address"), Kind::kName, QStringLiteral("wss://192.168.100.100:8765")},
                    {tr("Heard for"), Kind::kNumber}},
                   kFoundLines);
  hint_ = new widgets::EmptyHint(tree_);
  hint_->setObjectName(QStringLiteral("foundHint"));
  widgets::makeColumn(this)->addWidget(tree_);
  setFocusProxy(tree_);
  connect(tree_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) {
    if (const Announced* robots = at(tree_->indexOfTopLevelItem(row))) Q_EMIT picked(Announced(*robots));
  });
  tree_->installEventFilter(this);
  connect(tree_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* row) {
    if (const Announced* robots = at(tree_->indexOfTopLevelItem(row))) Q_EMIT wanted(Announced(*robots));
  });
  connect(tree_, &QTreeWidget::itemSelectionChanged, this, [this] {
    // A row that is selected by keys counts as one that was clicked.
    if (const auto robots = selected(); robots && tree_->hasFocus() && !isShowing_) Q_EMIT picked(*robots);
  });
}

bool FoundRobots::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const auto robots = selected();
    if (robots && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
      // The default button of the dialog must not be pressed, too.
      Q_EMIT wanted(*robots);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

const FoundRobots::Announced* FoundRobots::at(int row) const {
  return row < 0 || row >= static_cast<int>(shown_.size()) ? nullptr : &shown_[static_cast<std::size_t>(row)];
}

std::optional<FoundRobots::Announced> FoundRobots::selected() const {
  const auto rows = tree_->selectedItems();
  const Announced* robots = rows.isEmpty() ? nullptr : at(tree_->indexOfTopLevelItem(rows.front()));
  return robots == nullptr ? std::nullopt : std::optional(*robots);
}

void FoundRobots::show(const RobotSearch::State& state, const std::function<bool(const Announced&)>& isOwn) {
  std::vector<RobotSearch::Found> found = state.found;
  std::erase_if(found, [&](const RobotSearch::Found& one) { return isOwn(one.robots); });
  const auto urlOf = [](const Announced& robots) { return robots.url(); };
  isShowing_ = true;
  // A row is removed with its robots, so that the others keep their selection.
  for (int row = static_cast<int>(shown_.size()) - 1; row >= 0; --row) {
    const std::string url = shown_[static_cast<std::size_t>(row)].url();
    if (std::ranges::any_of(found, [&](const auto& one) { return urlOf(one.robots) == url; })) continue;
    // Deselected, so that no other row is selected in its place.
    if (tree_->topLevelItem(row)->isSelected()) tree_->setCurrentItem(nullptr);
    delete tree_->takeTopLevelItem(row);
    shown_.erase(shown_.begin() + row);
  }
  for (const RobotSearch::Found& one : found) {
    auto place = std::ranges::find(shown_, one.robots.url(), urlOf);
    if (place == shown_.end()) {
      place = std::ranges::find_if(
          shown_, [&](const Announced& other) { return one.robots.names() < other.names(); });
      place = shown_.insert(place, one.robots);
      tree_->insertTopLevelItem(static_cast<int>(place - shown_.begin()), new QTreeWidgetItem);
    }
    *place = one.robots;
    showRow(static_cast<int>(place - shown_.begin()), one);
  }
  showHint(state);
  isShowing_ = false;
}

void FoundRobots::showRow(int row, const RobotSearch::Found& found) {
  QTreeWidgetItem& item = *tree_->topLevelItem(row);
  const Announced& robots = found.robots;
  const QString names = QString::fromStdString(robots.names());
  const QString kinds =
      listed(robots.robots, [](const auto& robot) { return QString::fromStdString(robot.kind); });
  const QString runs = listed(robots.robots, runsText);
  const QString url = QString::fromStdString(robots.url());
  showCell(item, kFoundNames, names, names);
  showCell(item, kFoundKinds, kinds, kinds);
  showCell(item, kFoundRuns, runs, runs);
  showCell(item, kFoundAddress, url,
           robots.isEncrypted
               ? tr("Encrypted. The announced fingerprint is %1; the real one is shown when you connect")
                     .arg(QString::fromStdString(robots.fingerprint))
               : tr("Not encrypted"));
  showCell(item, kFoundAge, ageText(found.age), tr("Time since the robot was first found"));
}

void FoundRobots::showHint(const RobotSearch::State& state) {
  if (!shown_.empty()) return hint_->setHint({});
  if (!state.problem.empty()) return hint_->setHint(QString::fromStdString(state.problem));
  if (!state.isListening || state.age < kFirstAnswers)
    return hint_->setHint(tr("Listening for robots on the network…"));
  hint_->setHint(
      tr("No robots found. Robots announce themselves if they were started with --listen and a network "
         "address, such as --listen 0.0.0.0:8765."));
}

}  // namespace app
