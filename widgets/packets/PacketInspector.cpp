// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketInspector.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/packets/PacketDetails.h"
#include "widgets/packets/PacketReplayBar.h"

namespace widgets {
namespace {

const ViewRegistration kPacketInspectorRegistration{
    {"packets", QT_TRANSLATE_NOOP("View", "Packets"),
     QT_TRANSLATE_NOOP("View",
                       "Shows the decoded packets from and to a robot; saves and replays conversations."),
     "link-packets", false, create<PacketInspector>}};

}  // namespace

PacketInspector::PacketInspector(ViewContext& context, QWidget* parent)
    : View(context, parent), filter_(new PacketFilter(this)) {
  setObjectName(QStringLiteral("packetInspector"));
  createActions();
  createFilters();
  createViews();
  connectSignals();
  connectFilters();
  keepChoices();
  showState();
}

void PacketInspector::createActions() {
  damaged_ = makeToggle(
      this, "warning",
      {"packetsDamaged", tr("Damaged only"), tr("Shows only damaged packets"), tr("Ctrl+Shift+D")});
  follow_ =
      makeToggle(this, "follow",
                 {"packetsFollow", tr("Follow"), tr("Keeps the newest packet in view"), tr("Ctrl+E")}, true);
  pause_ = makeToggle(this, "pause",
                      {"packetsPause", tr("Pause"),
                       tr("Stops adding packets until it continues; none are lost"), tr("Ctrl+T")});
  copy_ = makeAction(
      this, "copy",
      {"packetsCopy", tr("Copy"), tr("Copies the selected rows with their bytes"), QKeySequence::Copy});
  clear_ =
      makeAction(this, "clear", {"packetsClear", tr("Clear"), tr("Empties the list"), tr("Ctrl+Shift+X")});
  save_ = makeAction(this, "save",
                     {"packetsSave", tr("Save conversation..."),
                      tr("Saves all packets of the list, regardless of the filters, as a .wire file"),
                      QKeySequence(QStringLiteral("Ctrl+Shift+E"))});
  open_ = makeAction(this, "open",
                     {"packetsOpen", tr("Open conversation..."),
                      tr("Opens a .wire file, whose client packets can be replayed")});
  goLive_ = makeAction(
      this, "close",
      {"packetsLive", tr("Back to the line"), tr("Closes the file and shows the line's current packets")});
}

void PacketInspector::createFilters() {
  from_ = new QComboBox(this);
  describe(*from_, {"packetsFrom", tr("Direction"), tr("Shows packets from the robot, to it, or both")});
  from_->addItems({tr("both ways"), tr("from the robot"), tr("to the robot")});
  namesMenu_ = new QMenu(this);
  namesMenu_->setObjectName(QStringLiteral("packetsNamesMenu"));
  names_ = makeMenuButton(this, {"packetsNames", tr("Names"), tr("Which packets are shown, by their names")},
                          namesMenu_);
  names_->setText(tr("all names"));
  text_ = makeSearchField(
      this, {"packetsText", tr("Filter"),
             tr("Shows only packets whose name, text or bytes (as hexadecimal digits) contain this")});
}

QWidget* PacketInspector::createBar() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(from_);
  layout->addWidget(names_);
  layout->addWidget(text_, 1);
  layout->addWidget(makeButton(bar, damaged_));
  layout->addSpacing(8);
  for (QAction* action : {follow_, pause_, copy_, clear_, save_, open_})
    layout->addWidget(makeButton(bar, action));
  return bar;
}

QWidget* PacketInspector::createFileBar() {
  fileBar_ = new QWidget(this);
  fileName_ = new QLabel(fileBar_);
  describe(*fileName_, {"packetsFile", tr("Conversation"), {}});
  QFont bold = fileName_->font();
  bold.setBold(true);
  fileName_->setFont(bold);
  replay_ = new PacketReplayBar(fileBar_);
  auto* layout = new QHBoxLayout(fileBar_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(fileName_);
  layout->addWidget(replay_, 1);
  layout->addWidget(makeLabeledButton(fileBar_, goLive_));
  fileBar_->hide();
  return fileBar_;
}

void PacketInspector::createTable() {
  filter_->setSourceModel(&live_);
  table_ = makeEventTable(this, {"packetsTable", tr("Packets"), {}}, filter_);
  new ColumnFit(*table_, {ColumnKind::kNumber, ColumnKind::kNumber, ColumnKind::kName, ColumnKind::kText,
                          ColumnKind::kNumber});
  hint_ = new EmptyHint(table_);
}

void PacketInspector::createViews() {
  createTable();
  details_ = new PacketDetails(this);
  auto* splitter = makeSplitter(this, "packetsSplitter", Qt::Horizontal, {{table_, 3}, {details_, 2}});
  splitter->setSizes({680, 270});
  state_ = new QLabel(this);
  describe(*state_, {"packetsState", tr("Number of packets"), {}});
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(createBar());
  layout->addWidget(createFileBar());
  layout->addWidget(splitter, 1);
  layout->addWidget(state_);
}

void PacketInspector::connectSignals() {
  connect(copy_, &QAction::triggered, this, &PacketInspector::copy);
  connect(save_, &QAction::triggered, this, &PacketInspector::save);
  connect(open_, &QAction::triggered, this, &PacketInspector::open);
  connect(goLive_, &QAction::triggered, this, &PacketInspector::showLive);
  connect(clear_, &QAction::triggered, this, [this] {
    if (!file_.isEmpty()) showLive();
    live_.clear();
    showState();
  });
  connect(follow_, &QAction::toggled, this, [this](bool on) {
    if (on) table_->scrollToBottom();
  });
  followEnd(*table_, *follow_);
  connect(table_, &QTableView::clicked, this, [this] { follow_->setChecked(false); });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &PacketInspector::showDetails);
  connect(replay_, &PacketReplayBar::send, this, &PacketInspector::send);
}

void PacketInspector::connectFilters() {
  connect(from_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
    filter_->setFrom(static_cast<PacketFilter::From>(index));
    showState();
  });
  connect(text_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->setText(text);
    showState();
  });
  connect(damaged_, &QAction::toggled, this, [this](bool only) {
    filter_->setDamagedOnly(only);
    showState();
  });
  connect(namesMenu_, &QMenu::aboutToShow, this, &PacketInspector::listNames);
}

PacketModel& PacketInspector::shownModel() {
  return file_.isEmpty() ? live_ : recorded_;
}

void PacketInspector::tickHidden() {
  if (!pause_->isChecked()) takeNew();
  replay_->tick(session().timeline().newest());
}

void PacketInspector::tick() {
  followRobot();
  subscription_.want(session(), robot_, {robotlink::kLinkPackets.name});
  tickHidden();
  const auto& timeline = session().timeline();
  live_.setOrigin(timeline.origin());
  if (timeline.live() || timeline.shown() == shown_ || !file_.isEmpty()) return;
  shown_ = timeline.shown();
  const int row = live_.rowAt(shown_);
  const QModelIndex index = row < 0 ? QModelIndex() : filter_->mapFromSource(live_.index(row, 0));
  if (!index.isValid()) return;
  table_->setCurrentIndex(index);
  table_->scrollTo(index);
}

void PacketInspector::followRobot() {
  const std::uint64_t generation = session().store().generation();
  if (session().selectedRobot() == robot_ && generation == generation_) return;
  generation_ = generation;
  robot_ = session().selectedRobot();
  cursor_ = {};
  dropped_ = 0;
  live_.clear();
  replay_->setRobot(robot_);
  showState();
}

void PacketInspector::takeNew() {
  const auto* stream = session().store().find(robot_ + '/' + robotlink::kLinkPackets.name);
  if (stream == nullptr) return;
  std::vector<PacketEntry> entries;
  const auto news = cursor_.take(*stream);
  if (news.restarted) live_.clear();
  for (const auto* message : news.messages) {
    const auto* reported = dynamic_cast<const robotcontrol::LinkPackets*>(message->value.get());
    if (reported == nullptr) continue;
    dropped_ = reported->dropped();
    for (const auto& packet : reported->packets()) {
      const auto time = packet.has_timestamp() ? robotlink::instant(packet.timestamp()) : message->time;
      entries.push_back(packetEntry(time, packet.from_robot(), packet.bytes(), packet.damaged()));
    }
  }
  if (entries.empty()) return;
  live_.append(std::move(entries));
  if (file_.isEmpty() && follow_->isChecked() && session().timeline().live()) table_->scrollToBottom();
  showState();
}

void PacketInspector::listNames() {
  namesMenu_->clear();
  const auto hide = [this](QSet<QString> hidden) {
    filter_->setHiddenNames(std::move(hidden));
    showState();
  };
  namesMenu_->addAction(tr("All"), this, [hide] { hide({}); })
      ->setObjectName(QStringLiteral("packetsAllNames"));
  namesMenu_->addSeparator();
  for (const auto& [name, count] : shownModel().names()) {
    QAction* action = namesMenu_->addAction(tr("%1 (%2)").arg(name, QString::number(count)));
    action->setCheckable(true);
    action->setChecked(!filter_->hiddenNames().contains(name));
    connect(action, &QAction::toggled, this, [this, hide, name = name](bool shown) {
      QSet<QString> hidden = filter_->hiddenNames();
      if (shown) {
        hidden.remove(name);
      } else {
        hidden.insert(name);
      }
      hide(std::move(hidden));
    });
  }
}

void PacketInspector::showDetails() {
  const QModelIndex index = filter_->mapToSource(table_->currentIndex());
  details_->show(index.isValid() ? &shownModel().entry(index.row()) : nullptr);
}

void PacketInspector::send(const std::vector<std::string>& packets) {
  robotcontrol::Request request;
  for (const std::string& bytes : packets) request.mutable_control_drive()->add_packets(bytes);
  ask(session(), robot_, std::move(request), this, [this](bool accepted, const QString& reason) {
    if (!accepted) replay_->fail(reason);
  });
}

void PacketInspector::copy() {
  copyRows(*table_, [this](const QModelIndex& row) {
    const PacketEntry& packet = shownModel().entry(filter_->mapToSource(row).row());
    return firstTexts(row, PacketModel::kBytes) << hexText(packet.bytes);
  });
}

bool PacketInspector::saveConversation(const QString& file) {
  const auto written = writeConversation(file);
  if (written) return true;
  QMessageBox::warning(this, tr("Save conversation"),
                       QString::fromStdString(robotlink::describe({written.error()})));
  return false;
}

robotlink::Result<void> PacketInspector::writeConversation(const QString& file) {
  return robotlink::writeFileAtomically(file.toStdString(),
                                        robotlink::arcos::writeConversation(conversationOf(shownModel())));
}

robotlink::Result<void> PacketInspector::saveTo(const QString& file) {
  return file.endsWith(QLatin1String(".wire"), Qt::CaseInsensitive) ? writeConversation(file)
                                                                    : View::saveTo(file);
}

bool PacketInspector::openConversation(const QString& file) {
  const auto conversation = robotlink::arcos::readConversationFile(file.toStdString());
  if (!conversation) {
    QMessageBox::warning(this, tr("Open conversation"),
                         QString::fromStdString(robotlink::describe({conversation.error()})));
    return false;
  }
  file_ = file;
  recorded_.clear();
  recorded_.append(entriesOf(*conversation));
  const QString name = QFileInfo(file).fileName();
  fileName_->setText(name);
  fileName_->setToolTip(file);
  replay_->setSource([this] { return clientHalf(recorded_); }, name);
  fileBar_->show();
  showModel(recorded_);
  return true;
}

void PacketInspector::showLive() {
  file_.clear();
  replay_->setSource({}, {});
  fileBar_->hide();
  showModel(live_);
  recorded_.clear();
  if (follow_->isChecked()) table_->scrollToBottom();
}

void PacketInspector::showModel(PacketModel& model) {
  details_->show(nullptr);
  filter_->setSourceModel(&model);
  if (!file_.isEmpty()) table_->scrollToTop();
  showState();
}

void PacketInspector::save() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save conversation"), QStringLiteral("conversation.wire"), tr("Conversations (*.wire)"));
  if (!file.isEmpty()) saveConversation(file);
}

void PacketInspector::open() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open conversation"), {},
                                                    tr("Conversations (*.wire);;All files (*)"));
  if (!file.isEmpty()) openConversation(file);
}

void PacketInspector::showState() {
  const int all = shownModel().rowCount(), shown = filter_->rowCount();
  QString text = shown < all ? tr("%1 of %2 packets").arg(shown).arg(all)
                             : counted(all, tr("1 packet"), tr("%1 packets"));
  if (file_.isEmpty() && dropped_ > 0) text += tr("; %1 arrived too fast to keep").arg(dropped_);
  if (pause_->isChecked()) text += tr("; paused");
  state_->setText(text);
  const int hidden = filter_->hiddenNames().size();
  names_->setText(hidden == 0 ? tr("all names")
                              : counted(hidden, tr("1 name hidden"), tr("%1 names hidden")));
  save_->setEnabled(all > 0);
  if (all == 0) {
    const QString name = QString::fromStdString(robot_);
    hint_->setHint(robot_.empty()
                       ? tr("No robot. Connect to one (menu Robot), or open a recorded conversation.")
                       : tr("No packets yet to or from %1. They appear when its line is open; a recorded "
                            "conversation can be opened.")
                             .arg(name));
  } else {
    hint_->setHint(shown == 0 ? tr("No packet passes the filters. Clear the filter, or show all names.")
                              : QString());
  }
}

void PacketInspector::keepChoices() {
  keep("from", from_);
  keep("text", text_);
  keep("damaged", damaged_);
  keep("follow", follow_);
  keep(
      "hiddenNames",
      [this] {
        QStringList hidden = filter_->hiddenNames().values();
        hidden.sort();
        return QJsonArray::fromStringList(hidden);
      },
      [this](const QJsonValue& value) {
        const QStringList hidden = value.toVariant().toStringList();
        filter_->setHiddenNames(QSet<QString>(hidden.begin(), hidden.end()));
        showState();
      });
}

}  // namespace widgets
