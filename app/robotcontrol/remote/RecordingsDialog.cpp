// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/RecordingsDialog.h"

#include <QComboBox>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/remote/DialogParts.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"
#include "widgets/Icon.h"

namespace app {
namespace {

using Kind = RecordingJobs::Kind;

/// While the dialog is visible.
constexpr qint64 kAskEveryMs = 2000;
constexpr int kRecordingLines = 8;
enum RecordingColumn { kRecordingName, kRecordingSize, kRecordingTime, kRecordingState, kRecordingHere };

QString sizeText(std::uint64_t bytes) {
  return RecordingsDialog::tr("%1 MB").arg(1e-6 * static_cast<double>(bytes), 0, 'f', 2);
}

/// The robots of a connection with its URL.
QString titleOf(const RemoteRobots::Connection& connection) {
  QStringList robots;
  for (const std::string& robot : connection.robots) robots << QString::fromStdString(robot);
  const QString url = QString::fromStdString(connection.url);
  return robots.isEmpty() ? url
                          : RecordingsDialog::tr("%1 at %2").arg(robots.join(QStringLiteral(", ")), url);
}

}  // namespace

RecordingsDialog::RecordingsDialog(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QDialog(parent), workbench_(workbench), actions_(actions) {
  setObjectName(QStringLiteral("recordingsDialog"));
  setWindowTitle(tr("Recordings at the robot"));
  setWindowIcon(widgets::icon("record"));
  new QVBoxLayout(this);
  createTop();
  createList();
  createTarget();
  createProgress();
  createButtons();
  connectSignals();
  setMinimumWidth(fontMetrics().averageCharWidth() * 112);
  enableButtons();
}

void RecordingsDialog::createTop() {
  auto* row = new QHBoxLayout;
  robot_ = new QComboBox(this);
  widgets::describe(*robot_, {"recordingsRobot", tr("Robot"), tr("Whose recordings are shown")});
  start_ = makePushButton(this,
                          {"recordingsStart", tr("&Start recording"),
                           tr("The robot records into its own storage, even if the connection is lost")},
                          "record");
  stop_ = makePushButton(
      this, {"recordingsStop", tr("S&top recording"), tr("Ends the recording at the robot")}, "record-end");
  addLabeled(row, tr("&Robot:"), robot_);
  row->addWidget(start_);
  row->addWidget(stop_);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void RecordingsDialog::createList() {
  using Kind = widgets::ColumnKind;
  list_ = makeList(this, {"recordingsList", tr("Recordings at the robot"), {}},
                   {{tr("Recording"), Kind::kName},
                    {tr("Size"), Kind::kNumber, QStringLiteral("10000.00 MB")},
                    {tr("Last written"), Kind::kName},
                    {tr("At the robot"), Kind::kName, tr("is being recorded")},
                    {tr("Here"), Kind::kText}},
                   kRecordingLines);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  hint_ = new widgets::EmptyHint(list_);
  hint_->setObjectName(QStringLiteral("recordingsHint"));
  static_cast<QVBoxLayout*>(layout())->addWidget(list_, 1);
}

void RecordingsDialog::showHint() {
  const bool isEmpty = isListed_ && list_->topLevelItemCount() == 0;
  hint_->setHint(robot_->count() == 0 ? tr("No remote robot is connected. Robot > Connect… connects one.")
                 : isEmpty ? tr("The robot has no recordings yet. Start recording makes one, in its own "
                                "storage.")
                           : QString());
}

void RecordingsDialog::createTarget() {
  auto* row = new QHBoxLayout;
  folder_ = new QLineEdit(QString::fromStdString(workbench_.recording().folder().string()), this);
  widgets::describe(*folder_, {"recordingsFolder", tr("Folder"), tr("Folder for downloaded recordings")});
  browse_ = makePushButton(this, {"recordingsBrowse", tr("&Browse…"), tr("Chooses the folder")}, "open");
  addLabeled(row, tr("Fetch &into:"), folder_);
  row->addWidget(browse_);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void RecordingsDialog::createProgress() {
  auto* row = new QHBoxLayout;
  progress_ = new QProgressBar(this);
  progress_->setObjectName(QStringLiteral("recordingsProgress"));
  progress_->setRange(0, 1000);
  cancel_ = makePushButton(this, {"recordingsCancel", tr("&Cancel"),
                                  tr("Stops the download; the next one resumes where it stopped")});
  hideInPlace(*progress_);
  hideInPlace(*cancel_);
  row->addWidget(progress_, 1);
  row->addWidget(cancel_);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  state_ = makeState(this, "recordingsState", 2);
  layout()->addWidget(state_);
}

void RecordingsDialog::createButtons() {
  auto* buttons = new QDialogButtonBox(this);
  const auto add = [&](const char* name, const char* icon, const QString& text, const QString& help) {
    auto* button = buttons->addButton(text, QDialogButtonBox::ActionRole);
    button->setIcon(widgets::icon(icon));
    widgets::describe(*button, {name, QString(text).remove(QLatin1Char('&')), help});
    return button;
  };
  fetch_ = add("recordingsFetch", "down", tr("&Fetch"),
               tr("Downloads the selected recordings from the robot, and verifies their checksums"));
  fetch_->setDefault(true);
  open_ = add("recordingsOpen", "time-line", tr("&Open"),
              tr("Opens the selected recording as a log, instead of what is open here"));
  delete_ =
      add("recordingsDelete", "remove", tr("&Delete…"), tr("Deletes the selected recordings at the robot"));
  buttons->addButton(QDialogButtonBox::Close);
  layout()->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void RecordingsDialog::connectSignals() {
  connect(start_, &QPushButton::clicked, this, [this] { jobs()->start(); });
  connect(stop_, &QPushButton::clicked, this, [this] { jobs()->stop(); });
  connect(cancel_, &QPushButton::clicked, this, [this] { jobs()->cancel(); });
  connect(browse_, &QPushButton::clicked, this, &RecordingsDialog::chooseFolder);
  connect(fetch_, &QPushButton::clicked, this, &RecordingsDialog::fetch);
  connect(open_, &QPushButton::clicked, this, &RecordingsDialog::openSelected);
  connect(delete_, &QPushButton::clicked, this, &RecordingsDialog::remove);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &RecordingsDialog::enableButtons);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, [this] {
    open_->isEnabled() ? openSelected() : fetch_->isEnabled() ? fetch() : void();
  });
  connect(robot_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    entries_.clear();
    isListed_ = false;
    list_->clear();
    sinceAsked_.invalidate();
    state_->clear();
  });
}

void RecordingsDialog::showEvent(QShowEvent* event) {
  sinceAsked_.invalidate();
  QDialog::showEvent(event);
}

// ---- What is shown

RecordingJobs* RecordingsDialog::jobs() const {
  return workbench_.recordingsAt(robot_->currentData().toString().toStdString());
}

void RecordingsDialog::tick() {
  if (!isVisible()) return;
  listRobots();
  RecordingJobs* jobs = this->jobs();
  if (jobs != nullptr) {
    showOutcomes(*jobs);
    showRecordings(*jobs);
    showProgress(*jobs);
  } else {
    progress_->hide();
    cancel_->hide();
  }
  showHint();
  enableButtons();
}

void RecordingsDialog::listRobots() {
  const auto connections = workbench_.remote().connections();
  const QString chosen = robot_->currentData().toString();
  bool isSame = robot_->count() == static_cast<int>(connections.size());
  for (int i = 0; isSame && i < robot_->count(); ++i) {
    const auto& connection = connections[static_cast<std::size_t>(i)];
    isSame = robot_->itemData(i).toString() == QString::fromStdString(connection.url);
    if (isSame && robot_->itemText(i) != titleOf(connection)) robot_->setItemText(i, titleOf(connection));
  }
  if (isSame) return;
  robot_->clear();
  for (const auto& connection : connections)
    robot_->addItem(titleOf(connection), QString::fromStdString(connection.url));
  robot_->setCurrentIndex(std::max(robot_->findData(chosen), robot_->count() > 0 ? 0 : -1));
}

void RecordingsDialog::showRecordings(RecordingJobs& jobs) {
  if (!sinceAsked_.isValid() || sinceAsked_.elapsed() > kAskEveryMs) {
    const auto connections = workbench_.remote().connections();
    const auto& connection = connections[static_cast<std::size_t>(robot_->currentIndex())];
    if (connection.state.isConnected() && !connection.hasRecordings && !connection.robots.empty()) {
      widgets::showOutcome(*state_,
                           tr("This robot's program keeps no recordings. Restart it with "
                              "--recordings FOLDER."),
                           true);
      return;
    }
    jobs.list();
    sinceAsked_.start();
  }
  const auto recordings = jobs.recordings();
  if (!recordings) return;
  isListed_ = true;
  entries_ = *recordings;
  const int count = static_cast<int>(entries_.size());
  while (list_->topLevelItemCount() > count) delete list_->takeTopLevelItem(count);
  while (list_->topLevelItemCount() < count) new QTreeWidgetItem(list_);
  const QStringList chosen = selected();
  for (int i = 0; i < count; ++i)
    showRecording(*list_->topLevelItem(i), entries_[static_cast<std::size_t>(i)]);
  // A new recording is the first one, and moves the others down.
  if (chosen == selected()) return;
  for (int i = 0; i < count; ++i)
    list_->topLevelItem(i)->setSelected(chosen.contains(list_->topLevelItem(i)->text(kRecordingName)));
}

void RecordingsDialog::showRecording(QTreeWidgetItem& row, const RecordingFetch::Entry& entry) const {
  row.setText(kRecordingName, QString::fromStdString(entry.name));
  row.setToolTip(kRecordingName, row.text(kRecordingName));
  row.setText(kRecordingSize, sizeText(entry.bytes));
  row.setTextAlignment(kRecordingSize, Qt::AlignRight | Qt::AlignVCenter);
  row.setText(kRecordingTime, QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(entry.modified * 1000))
                                  .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")));
  row.setText(kRecordingState, entry.isRecording ? tr("is being recorded")
                               : entry.isWhole   ? tr("whole")
                                                 : tr("was cut off"));
  row.setToolTip(kRecordingState, entry.isRecording || entry.isWhole
                                      ? QString()
                                      : tr("The robot's program ended before it could finish this "
                                           "recording; it is readable up to there"));
  const QFileInfo file = fileOf(row.text(kRecordingName));
  const QFileInfo part(file.filePath() + QStringLiteral(".part"));
  const double share = entry.bytes == 0 ? 0 : static_cast<double>(part.size()) / double(entry.bytes);
  row.setText(kRecordingHere, isHere(entry)   ? tr("fetched")
                              : part.exists() ? tr("%1 % fetched").arg(static_cast<int>(100 * share))
                              : file.exists() ? tr("another file")
                                              : QString());
}

void RecordingsDialog::showOutcomes(RecordingJobs& jobs) {
  for (const RecordingJobs::Outcome& outcome : jobs.takeOutcomes()) showOutcome(outcome);
}

void RecordingsDialog::showOutcome(const RecordingJobs::Outcome& outcome) {
  const QString name = QString::fromStdString(outcome.name);
  if (outcome.error && outcome.error->id == "canceled") {
    return widgets::showOutcome(
        *state_, tr("The download of %1 was canceled. The next one resumes where it stopped.").arg(name),
        false);
  }
  if (outcome.error)
    return widgets::showOutcome(*state_, QString::fromStdString(outcome.error->describe()), true);
  const QString resumed =
      outcome.fetched.resumedAt == 0
          ? QString()
          : tr(", %1 of them from an earlier download").arg(sizeText(outcome.fetched.resumedAt));
  const QString text = outcome.kind == Kind::kFetch
                           ? tr("%1 was downloaded: %2%3; the checksum matches the robot's.")
                                 .arg(name, sizeText(outcome.fetched.bytes), resumed)
                       : outcome.kind == Kind::kRemove ? tr("%1 was deleted on the robot.").arg(name)
                       : outcome.kind == Kind::kStart  ? tr("The robot is recording.")
                                                       : tr("The recording at the robot has ended.");
  widgets::showOutcome(*state_, text, false);
}

void RecordingsDialog::showProgress(RecordingJobs& jobs) {
  const auto fetching = jobs.fetching();
  progress_->setVisible(fetching.has_value());
  cancel_->setVisible(fetching.has_value());
  if (!fetching) return;
  progress_->setValue(static_cast<int>(fetching->share * 1000));
  progress_->setFormat(QStringLiteral("%1: %p %").arg(QString::fromStdString(fetching->name)));
}

void RecordingsDialog::enableButtons() {
  const bool isRecording = std::ranges::any_of(entries_, &RecordingFetch::Entry::isRecording);
  start_->setEnabled(isListed_ && !isRecording);
  stop_->setEnabled(isListed_ && isRecording);
  const QStringList chosen = selected();
  fetch_->setEnabled(!chosen.isEmpty());
  const auto* entry = chosen.size() == 1 ? entryOf(chosen.front()) : nullptr;
  open_->setEnabled(entry != nullptr && isHere(*entry));
  delete_->setEnabled(!chosen.isEmpty() && std::ranges::none_of(chosen, [this](const QString& name) {
    const auto* one = entryOf(name);
    return one == nullptr || one->isRecording;
  }));
}

// ---- What the user does

QFileInfo RecordingsDialog::fileOf(const QString& name) const {
  return QFileInfo(QDir(folder_->text()), name);
}

QStringList RecordingsDialog::selected() const {
  QStringList names;
  for (const QTreeWidgetItem* row : list_->selectedItems()) names << row->text(kRecordingName);
  return names;
}

bool RecordingsDialog::isHere(const RecordingFetch::Entry& entry) const {
  const QFileInfo file = fileOf(QString::fromStdString(entry.name));
  return file.isFile() && static_cast<std::uint64_t>(file.size()) == entry.bytes;
}

const RecordingFetch::Entry* RecordingsDialog::entryOf(const QString& name) const {
  const auto found = std::ranges::find(entries_, name.toStdString(), &RecordingFetch::Entry::name);
  return found == entries_.end() ? nullptr : &*found;
}

void RecordingsDialog::chooseFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder for fetched recordings"), folder_->text());
  if (!folder.isEmpty()) folder_->setText(folder);
}

void RecordingsDialog::fetch() {
  if (!QFileInfo(folder_->text()).isDir())
    return widgets::showOutcome(*state_,
                                tr("There is no folder %1. Choose another one.").arg(folder_->text()), true);
  for (const QString& name : selected()) {
    const QFileInfo file = fileOf(name);
    const bool replaces = file.exists();
    if (replaces &&
        QMessageBox::question(this, tr("Replace the file?"),
                              tr("%1 exists already. Fetch the recording again, and replace the file?")
                                  .arg(QDir::toNativeSeparators(file.filePath()))) != QMessageBox::Yes)
      continue;
    state_->clear();
    if (RecordingJobs* robot = jobs())
      robot->fetch(name.toStdString(), file.filePath().toStdString(), replaces);
  }
}

void RecordingsDialog::openSelected() {
  const QStringList chosen = selected();
  if (chosen.size() != 1) return;
  hide();
  actions_.run(QStringLiteral("log.open"), {fileOf(chosen.front()).absoluteFilePath().toStdString()});
}

void RecordingsDialog::remove() {
  const QStringList chosen = selected();
  const bool isSafe = std::ranges::all_of(chosen, [this](const QString& name) {
    const auto* entry = entryOf(name);
    return entry != nullptr && isHere(*entry);
  });
  const QString what = chosen.size() == 1 ? chosen.front() : tr("these %1 recordings").arg(chosen.size());
  const QString text = isSafe
                           ? tr("Delete %1 on the robot? The copy here stays.").arg(what)
                           : tr("Delete %1 on the robot? There is no copy here; it will be lost.").arg(what);
  if (QMessageBox::question(this, tr("Delete on the robot?"), text) != QMessageBox::Yes) return;
  for (const QString& name : chosen)
    if (RecordingJobs* robot = jobs()) robot->remove(name.toStdString());
}

}  // namespace app
