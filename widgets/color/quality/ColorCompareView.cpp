// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/quality/ColorCompareView.h"

#include <QAction>
#include <QBoxLayout>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "colortool/table/ColorTable.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"
#include "widgets/Icon.h"
#include "widgets/color/ColorActions.h"
#include "widgets/color/ColorReferences.h"

namespace widgets {
namespace {

const ViewRegistration kColorCompareViewRegistration{
    {"color-compare", QT_TRANSLATE_NOOP("View", "Compare tables"),
     QT_TRANSLATE_NOOP("View", "Compares the color table with another one, or with itself some steps ago"),
     "color-compare", false, create<ColorCompareView>}};

constexpr std::size_t kStepsListed = 30;

}  // namespace

ColorCompareView::ColorCompareView(ViewContext& context, QWidget* parent)
    : View(context, parent),
      bench_(colorBench(context)),
      files_(colorFiles(context)),
      trainer_([this](const Step& step, const std::stop_token&) {
        trainer_.publish({step.number, trainedReference(step.samples, step.name)});
      }) {
  setObjectName(QStringLiteral("colorCompareView"));
  createActions();
  createViews();
  connectSignals();
  keep(
      "folder", [this] { return files_.folder(); },
      [this](const QJsonValue& value) { files_.proposeFolder(value.toString()); });
  keep("columns", table_->horizontalHeader());
  tick();
}

ColorCompareView::~ColorCompareView() = default;

void ColorCompareView::createActions() {
  open_ = makeAction(
      this, "open",
      {"colorCompareOpen", tr("File…"), tr("Compares with a table in a file, even another team's")});
  now_ = makeAction(
      this, "camera",
      {"colorCompareNow", tr("Now"), tr("Keeps the table as it is now, to compare later ones with it")});
  none_ = makeAction(this, "close", {"colorCompareNone", tr("None"), tr("Stops comparing")});
  showInImage_ = makeAction(this, "two-pictures",
                            {"colorCompareShow", tr("In the image"),
                             tr("Shows next to the image which of its pixels have another class")});
  deselect_ = makeAction(this, "check-none",
                         {"colorCompareDeselect", tr("Deselect"), tr("Clears the selection of cells"),
                          QKeySequence(Qt::Key_Escape)});
  addColorActions(*this, "colorCompare", bench_);
}

QWidget* ColorCompareView::createToolRow() {
  QHBoxLayout* row = makeToolRow(this);
  stepMenu_ = new QMenu(this);
  stepMenu_->setObjectName(QStringLiteral("colorCompareStepMenu"));
  auto* steps = makeMenuButton(
      row->parentWidget(),
      {"colorCompareSteps", tr("Step"), tr("Compares with the table as it was some steps ago")}, stepMenu_);
  steps->setIcon(icon("undo"));
  steps->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  for (QAction* action : {open_, now_}) row->addWidget(makeLabeledButton(row->parentWidget(), action));
  row->addWidget(steps);
  row->addStretch(1);
  addButtons(row, {showInImage_, deselect_, none_});
  return row->parentWidget();
}

void ColorCompareView::createViews() {
  table_ = makeTable(this,
                     {"colorCompareTable", tr("What each class gained and lost, in cells"),
                      tr("A click selects the cells that changed")},
                     &model_);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setFrameShape(QFrame::NoFrame);
  // The columns of origins and destinations take the remaining room.
  new ColumnFit(*table_, {ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kText, ColumnKind::kNumber,
                          ColumnKind::kText, ColumnKind::kNumber, ColumnKind::kNumber});
  hint_ = new EmptyHint(table_);

  auto* layout = makeColumn(this);
  layout->addWidget(createToolRow());
  name_ = new QLabel(this);
  name_->setObjectName(QStringLiteral("colorCompareName"));
  name_->setMargin(4);
  layout->addWidget(name_);
  problem_ = makeNote(this, "colorCompareProblem", tr("What went wrong"));
  problem_->setMargin(4);
  layout->addWidget(problem_);
  layout->addWidget(table_, 1);
  QHBoxLayout* footer = makeFooter(this);
  sums_ = addLabel(footer, "colorCompareSums", tr("How many cells and pixels differ"));
  footer->addStretch(1);
  layout->addWidget(footer->parentWidget());
  report({});
}

void ColorCompareView::connectSignals() {
  connect(open_, &QAction::triggered, this, &ColorCompareView::askForFile);
  connect(now_, &QAction::triggered, this, [this] { takeStep(bench_.document().position()); });
  connect(none_, &QAction::triggered, &bench_, [this] {
    awaited_ = false;
    bench_.setReference({});
  });
  connect(showInImage_, &QAction::triggered, &bench_, &ColorBench::differenceWanted);
  connect(deselect_, &QAction::triggered, &bench_, &ColorBench::clearSelection);
  connect(stepMenu_, &QMenu::aboutToShow, this, &ColorCompareView::listSteps);
  const auto changed = [this] { dirty_ = true; };
  connect(&bench_, &ColorBench::colorsChanged, this, changed);
  connect(&bench_, &ColorBench::referenceChanged, this, changed);
  connect(table_, &QTableView::clicked, this, &ColorCompareView::selectCells);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& current) { selectCells(current); });
}

void ColorCompareView::report(const QString& problem) {
  showOutcome(*problem_, problem, true);
  problem_->setToolTip(problem);
  problem_->setVisible(!problem.isEmpty());
  // The label may have no room for all of it.
  problem.isEmpty() ? Q_EMIT bench_.settled() : Q_EMIT bench_.failed(problem);
}

// The reference.

void ColorCompareView::askForFile() {
  auto* dialog = new QFileDialog(this, tr("Compare with a color table"), files_.folder(),
                                 tr("Color tables (*.c64 *.tm *.raw *.cal *.lut *.bz2);;All files (*)"));
  dialog->setObjectName(QStringLiteral("colorCompareDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &ColorCompareView::useFile);
  dialog->open();
}

void ColorCompareView::useFile(const QString& file) {
  const auto read = files_.importReference(file.toStdString());
  report(read ? QString() : QString::fromStdString(read.error().describe()));
  if (read) awaited_ = false;
  tick();
}

void ColorCompareView::takeStep(std::size_t position) {
  const colortool::SampleDocument& document = bench_.document();
  report({});
  if (position == document.position() && bench_.upToDate()) {
    awaited_ = false;
    bench_.setReference(referenceOfNow(bench_));
  } else {
    // Some training methods take a second.
    awaited_ = true;
    trainer_.post({++step_, document.samplesAt(position), stepName(document, position)});
  }
  tick();
}

void ColorCompareView::listSteps() {
  const colortool::SampleDocument& document = bench_.document();
  stepMenu_->clear();
  const std::size_t steps = document.steps();
  for (std::size_t i = 0; i <= std::min(steps, kStepsListed); ++i) {
    const std::size_t position = steps - i;
    QString text = stepName(document, position);
    if (position == document.position()) text = tr("%1 (now)").arg(text);
    stepMenu_->addAction(text, this, [this, position] { takeStep(position); });
  }
}

void ColorCompareView::takeTrained() {
  const auto trained = trainer_.take();
  if (!awaited_ || !trained || trained->first != step_) return;
  awaited_ = false;
  bench_.setReference(trained->second);
}

// The comparison.

void ColorCompareView::tick() {
  takeTrained();
  hint_->setHint(awaited_             ? tr("The table of that step is being made…")
                 : bench_.reference() ? QString()
                                      : tr("There is no table to compare with.\nOpen one from a file, or "
                                           "keep the current one and continue drawing."));
  if (std::exchange(dirty_, false)) compare();
}

void ColorCompareView::compare() {
  const ReferenceTable& reference = bench_.givenReference();
  const LearnedColors* colors = bench_.colors();
  for (QAction* action : {none_, showInImage_}) action->setEnabled(reference.table != nullptr);
  name_->setVisible(reference.table != nullptr);
  if (!reference.table || colors == nullptr) {
    model_.setDifference(nullptr);
    sums_->clear();
    return;
  }
  name_->setText(tr("Compared with %1").arg(reference.name));
  name_->setToolTip(reference.name);
  // A selection made here follows the new difference, unless something else was selected since.
  const bool follows = selected_ && bench_.hasSelection() && bench_.selection() == *selected_;
  model_.setDifference(std::make_shared<const colortool::TableDifference>(
      *reference.table, reference.classes, *colors->table, colors->samples.classes));
  showSums();
  if (follows) selectCells(table_->currentIndex());
}

std::optional<double> ColorCompareView::changedPixels() const {
  const LearnedColors& colors = *bench_.colors();
  if (!colors.classes || colors.classes->data.empty()) return std::nullopt;
  robotlink::Image before;
  bench_.reference()->classify(colors.seen(), before);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < std::min(before.data.size(), colors.classes->data.size()); ++i)
    changed += before.data[i] != colors.classes->data[i] ? 1 : 0;
  return static_cast<double>(changed) / static_cast<double>(before.data.size());
}

void ColorCompareView::showSums() {
  const double changed = static_cast<double>(model_.difference()->changed());
  const double share = 100 * changed / static_cast<double>(colortool::ColorTable::kCellCount);
  QString text =
      changed == 0
          ? tr("No cell differs")
          : tr("%1 (%2 %)")
                .arg(counted(model_.difference()->changed(), tr("1 cell differs"), tr("%1 cells differ")))
                .arg(share, 0, 'f', 2);
  if (const auto pixels = changedPixels())
    text += tr(", of this image's pixels %1 %").arg(100 * *pixels, 0, 'f', 2);
  sums_->setText(text);
}

void ColorCompareView::selectCells(const QModelIndex& index) {
  if (!index.isValid()) return;
  const colortool::CellSet cells = model_.cellsOf(index);
  selected_ = cells;
  if (!bench_.hasSelection() || !(bench_.selection() == cells)) bench_.select(cells);
}

}  // namespace widgets
