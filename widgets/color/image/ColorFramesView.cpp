// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorFramesView.h"

#include <QAction>
#include <QBoxLayout>
#include <QHeaderView>
#include <QJsonArray>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>

#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"
#include "widgets/Icon.h"
#include "widgets/Theme.h"
#include "widgets/color/ColorActions.h"

namespace widgets {
namespace {

const ViewRegistration kColorFramesViewRegistration{
    {"color-frames", QT_TRANSLATE_NOOP("View", "Find frames"),
     QT_TRANSLATE_NOOP("View", "Finds the images of a log where the color table looks most suspicious"),
     "color-frames", false, create<ColorFramesView>}};

constexpr QSize kThumbnail(72, 54);
constexpr int kProgressSteps = 1000;
constexpr int kMaxChoices = 256;  // there are no more classes

}  // namespace

ColorFramesView::ColorFramesView(ViewContext& context, QWidget* parent)
    : View(context, parent),
      bench_(colorBench(context)),
      finder_(colorFrameFinder(context)),
      sorted_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("colorFramesView"));
  createActions();
  createViews();
  connectSignals();
  keep(
      "classes", [this] { return QJsonArray::fromStringList(finder_.choices()); },
      [this](const QJsonValue& value) {
        finder_.setChoices(value.toVariant().toStringList().mid(0, kMaxChoices));
      });
  keep("columns", table_->horizontalHeader());
  tick();
}

ColorFramesView::~ColorFramesView() = default;

void ColorFramesView::createActions() {
  search_ = makeAction(this, "search",
                       {"colorFramesSearch", tr("Search"),
                        tr("Searches all images for those where the table looks suspicious"),
                        QKeySequence(tr("Ctrl+Shift+F"))});
  cancel_ =
      makeAction(this, "close",
                 {"colorFramesCancel", tr("Cancel"), tr("Stops the search"), QKeySequence(Qt::Key_Escape)});
  live_ = makeAction(
      this, "play",
      {"colorFramesLive", tr("Live"), tr("Returns to the newest images, from those of the history")});
  addColorActions(*this, "colorFrames", bench_);
}

QWidget* ColorFramesView::createToolRow() {
  QHBoxLayout* row = makeToolRow(this);
  classMenu_ = new QMenu(this);
  classMenu_->setObjectName(QStringLiteral("colorFramesClassMenu"));
  auto* classes =
      makeMenuButton(row->parentWidget(),
                     {"colorFramesClasses", tr("Classes"),
                      tr("Which classes are searched: those of objects, but not ground and walls")},
                     classMenu_);
  classes->setIcon(icon("filter"));
  classes->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  liveButton_ = makeLabeledButton(row->parentWidget(), live_);
  for (QToolButton* button : {makeLabeledButton(row->parentWidget(), search_),
                              makeLabeledButton(row->parentWidget(), cancel_), classes, liveButton_})
    row->addWidget(button);
  row->addStretch(1);
  stale_ = new QLabel(tr("⚠ The table has changed"), row->parentWidget());
  stale_->setObjectName(QStringLiteral("colorFramesStale"));
  stale_->setToolTip(tr("These frames were found with an older table; search again (Ctrl+Shift+F)"));
  setMeaning(*stale_, Meaning::kWarning);
  row->addWidget(stale_);
  return row->parentWidget();
}

QWidget* ColorFramesView::createFooter() {
  QHBoxLayout* footer = makeFooter(this);
  state_ = addLabel(footer, "colorFramesState", tr("What was searched, and what was found"));
  state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  footer->setStretchFactor(state_, 1);
  progress_ = new QProgressBar(footer->parentWidget());
  describe(*progress_, {"colorFramesProgress", tr("Progress"), {}});
  progress_->setRange(0, kProgressSteps);
  progress_->setMaximumWidth(200);
  footer->addWidget(progress_);
  return footer->parentWidget();
}

void ColorFramesView::createViews() {
  sorted_->setSourceModel(&finder_.model());
  sorted_->setSortRole(SuspiciousFrameModel::kSortRole);
  table_ = makeTable(
      this, {"colorFramesTable", tr("Suspicious images"), tr("A click or Enter shows an image")}, sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(SuspiciousFrameModel::kScore, Qt::DescendingOrder);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setIconSize(kThumbnail);
  table_->verticalHeader()->setDefaultSectionSize(kThumbnail.height() + 4);
  new ColumnFit(*table_, {ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kText, ColumnKind::kNumber,
                          ColumnKind::kNumber, ColumnKind::kNumber, ColumnKind::kNumber});
  hint_ = new EmptyHint(table_);
  problem_ = makeNote(this, "colorFramesProblem", tr("What went wrong"));
  problem_->setMargin(4);
  setMeaning(*problem_, Meaning::kBad);
  problem_->hide();

  auto* layout = makeColumn(this);
  layout->addWidget(createToolRow());
  layout->addWidget(problem_);
  layout->addWidget(table_, 1);
  layout->addWidget(createFooter());
}

void ColorFramesView::connectSignals() {
  connect(search_, &QAction::triggered, this, &ColorFramesView::search);
  connect(cancel_, &QAction::triggered, &finder_, &ColorFrameFinder::cancel);
  connect(live_, &QAction::triggered, this, [this] {
    session().history().goLive();
    tick();
  });
  connect(classMenu_, &QMenu::aboutToShow, this, &ColorFramesView::listClasses);
  connect(&finder_, &ColorFrameFinder::changed, this, &ColorFramesView::showState);
  connect(table_, &QTableView::clicked, this, &ColorFramesView::showFrame);
  connect(table_, &QTableView::activated, this, &ColorFramesView::showFrame);
}

void ColorFramesView::search() {
  const auto begun = finder_.search();
  problem_->setVisible(!begun);
  if (!begun) problem_->setText(QString::fromStdString(begun.error().describe()));
}

void ColorFramesView::showFrame(const QModelIndex& index) {
  finder_.show(sorted_->mapToSource(index).row());
  tick();
}

void ColorFramesView::listClasses() {
  classMenu_->clear();
  const auto& classes = bench_.samples().classes;
  for (int i = 1; i < classes.size(); ++i) {
    QAction* action = classMenu_->addAction(QString::fromStdString(classes.name(i)));
    QPixmap swatch(16, 16);
    const robotlink::Rgb shown = classes.shownColor(i);
    swatch.fill(QColor(shown.r, shown.g, shown.b));
    action->setIcon(swatch);
    action->setCheckable(true);
    action->setChecked(finder_.looksAt(i));
    connect(action, &QAction::toggled, this, [this, i](bool on) { finder_.setLooksAt(i, on); });
  }
}

QString ColorFramesView::stateText() const {
  const FrameSearch::Progress& progress = finder_.progress();
  if (!finder_.searched()) return {};
  if (progress.seen == 0 && !progress.ended) return tr("%1: reading").arg(finder_.place());
  QString text = tr("%1: %2, suspicious: %3")
                     .arg(finder_.place(), counted(progress.seen, tr("1 image"), tr("%1 images")))
                     .arg(progress.suspicious);
  if (progress.suspicious > FrameSearch::kMaxKept)
    text += tr(" (the %1 worst are listed)").arg(FrameSearch::kMaxKept);
  if (progress.damaged > 0) text += tr(", unreadable: %1").arg(progress.damaged);
  if (progress.canceled) text += tr(", canceled");
  return text;
}

void ColorFramesView::showState() {
  const FrameSearch::Progress& progress = finder_.progress();
  const bool busy = finder_.busy();
  search_->setText(finder_.searched() ? tr("Search again") : tr("Search"));
  cancel_->setEnabled(busy);
  progress_->setVisible(busy);
  const double done = progress.total > 0
                          ? static_cast<double>(progress.seen) / static_cast<double>(progress.total)
                          : progress.opening;
  progress_->setFormat(progress.total > 0 ? tr("%p %") : tr("opening: %p %"));
  progress_->setValue(qRound(kProgressSteps * done));
  stale_->setVisible(finder_.stale());
  state_->setText(stateText());
  state_->setToolTip(stateText());
  if (!progress.failure.empty()) {
    problem_->setText(QString::fromStdString(progress.failure));
    problem_->show();
  }
  hint_->setHint(finder_.model().rowCount() > 0 ? QString()
                 : busy                         ? tr("Searching…")
                 : finder_.searched()
                     ? tr("Nothing suspicious was found.")
                     : tr("Search lists the images with the most suspicious pixels first:\nspecks, ambiguous "
                          "colors, and areas enclosed by another color."));
}

void ColorFramesView::tick() {
  liveButton_->setVisible(!session().timeline().live());
  finder_.model().setOrigin(session().timeline().origin());
  showState();
}

}  // namespace widgets
