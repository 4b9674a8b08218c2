// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/ColorClassesView.h"

#include <QAction>
#include <QBoxLayout>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QToolButton>
#include <QTreeView>

#include "colortool/image/ClassPresets.h"
#include "colortool/samples/ClassEdits.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Theme.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFileActions.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/color/samples/TrainingPanel.h"
#include "widgets/processes/BarDelegate.h"

namespace widgets {
namespace {

const ViewRegistration kColorClassesViewRegistration{
    {"color-classes", QT_TRANSLATE_NOOP("View", "Color classes"),
     QT_TRANSLATE_NOOP("View",
                       "Chooses the class of strokes, keeps samples in files, and sets how the color table "
                       "is made from them."),
     "color-classes", false, create<ColorClassesView>}};

constexpr int kMaxMessageLines = 4;

}  // namespace

ColorClassesView::ColorClassesView(ViewContext& context, QWidget* parent)
    : View(context, parent),
      bench_(colorBench(context)),
      files_(colorFiles(context)),
      fileActions_(new ColorFileActions(files_, this)),
      history_(addColorActions(*this, "colorClasses", bench_)) {
  setObjectName(QStringLiteral("colorClassesView"));
  createActions();
  createViews();
  connectSignals();
  keep(
      "training", [this] { return more_->isChecked(); },
      [this](const QJsonValue& value) { more_->setChecked(value.toBool()); });
  keep(
      "folder", [this] { return files_.folder(); },
      [this](const QJsonValue& value) {
        files_.proposeFolder(value.toString());
        showTitle();
      });
  showSamples();
  showMeaning();
  showQuality();
  say(files_.message().text, files_.message().bad);
}

void ColorClassesView::createActions() {
  add_ = makeAction(this, "add", {"classAdd", tr("Add"), tr("Adds a class"), Qt::Key_Insert});
  remove_ = makeAction(this, "remove",
                       {"classRemove", tr("Remove"), tr("Removes the chosen class and its strokes")});
  rename_ = makeAction(this, "edit",
                       {"classRename", tr("Rename"), tr("Edits the name of the chosen class"), Qt::Key_F2});
  up_ = makeAction(
      this, "up",
      {"classUp", tr("Up"), tr("Moves the chosen class up; its key and its number follow"), tr("Alt+Up")});
  down_ = makeAction(this, "down",
                     {"classDown", tr("Down"),
                      tr("Moves the chosen class down; its key and its number follow"), tr("Alt+Down")});
  mustNotBe_ = makeToggle(this, "must-not",
                          {"mustNotBe", tr("Must not be"),
                           tr("The pixels of the next stroke must not be of the chosen class (N)")});
  presets_ = new QMenu(tr("Preset"), this);
  presets_->setObjectName(QStringLiteral("classPresets"));
  fillPresetMenu();
}

void ColorClassesView::fillPresetMenu() {
  for (const colortool::ClassPreset& preset : colortool::classPresets()) {
    QAction* action =
        presets_->addAction(QString::fromUtf8(preset.title.data(), static_cast<int>(preset.title.size())),
                            this, [this, &preset] { usePreset(preset); });
    action->setObjectName(QStringLiteral("preset.") +
                          QLatin1String(preset.name.data(), static_cast<int>(preset.name.size())));
  }
}

void ColorClassesView::createViews() {
  createTree();
  message_ = makeNote(this, "colorMessage", tr("Last message"));
  message_->setTextFormat(Qt::PlainText);
  message_->hide();
  more_ = new QToolButton(this);
  describe(*more_, {"trainingShown", tr("How the table is made"), tr("Shows the method and its options")});
  more_->setText(tr("How the table is made"));
  more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  more_->setArrowType(Qt::RightArrow);
  more_->setCheckable(true);
  more_->setAutoRaise(true);
  training_ = new TrainingPanel(bench_, this);
  training_->hide();
  auto* layout = makeColumn(this, {4, 2, 4, 4}, 3);
  layout->addWidget(createTools());
  layout->addWidget(tree_, 1);
  layout->addWidget(createMeaning());
  layout->addWidget(message_);
  layout->addWidget(more_);
  layout->addWidget(training_);
}

void ColorClassesView::createTree() {
  tree_ =
      makeTree(this, {"classesTree", tr("Color classes"), tr("A click chooses the class of the next stroke")},
               &model_);
  tree_->setRootIsDecorated(false);
  tree_->setIconSize({16, 16});
  tree_->setEditTriggers(QAbstractItemView::DoubleClicked);
  tree_->setItemDelegateForColumn(ColorClassModel::kRecall,
                                  new BarDelegate(ColorClassModel::kShareRole, tree_));
  new ColumnFit(*tree_, {ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kNumber, ColumnKind::kNumber,
                         ColumnKind::kNumber});
}

QWidget* ColorClassesView::createTools() {
  QHBoxLayout* row = makeToolRow(this);
  fileActions_->addTo(row);
  row->addSpacing(6);
  addButtons(row, {history_.undo, history_.redo});
  row->addStretch(1);
  addButtons(row, {add_, remove_, up_, down_});
  row->addWidget(makeMenuButton(
      row->parentWidget(),
      {"classPreset", tr("Preset"), tr("Classes to start with; strokes keep the class of their name")},
      presets_));
  return row->parentWidget();
}

QWidget* ColorClassesView::createMeaning() {
  QHBoxLayout* row = makeToolRow(this);
  row->addWidget(new QLabel(tr("Next stroke:"), row->parentWidget()));
  row->addWidget(makeLabeledButton(row->parentWidget(), mustNotBe_));
  row->addStretch(1);
  auto* label = new QLabel(tr("Weight"), row->parentWidget());
  weight_ = new QDoubleSpinBox(row->parentWidget());
  describe(*weight_, {"strokeWeight", tr("Weight"), tr("How much the next stroke counts")});
  weight_->setRange(colortool::Stroke::kMinWeight, colortool::Stroke::kMaxWeight);
  weight_->setDecimals(1);
  weight_->setKeyboardTracking(false);
  weight_->setSingleStep(0.5);
  weight_->setPrefix(QStringLiteral("× "));
  label->setBuddy(weight_);
  row->addWidget(label);
  row->addSpacing(4);
  row->addWidget(weight_);
  return row->parentWidget();
}

void ColorClassesView::connectSignals() {
  tree_->viewport()->installEventFilter(this);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (current.isValid()) bench_.setCurrentClass(current.row());
          });
  connect(&model_, &ColorClassModel::renameWanted, this, &ColorClassesView::rename);
  connect(add_, &QAction::triggered, this, &ColorClassesView::add);
  connect(remove_, &QAction::triggered, this, &ColorClassesView::remove);
  connect(rename_, &QAction::triggered, this, [this] {
    const QModelIndex name = model_.index(bench_.currentClass(), ColorClassModel::kName);
    if (name.row() > 0) tree_->edit(name);
  });
  connect(up_, &QAction::triggered, this, [this] { move(-1); });
  connect(down_, &QAction::triggered, this, [this] { move(1); });
  connect(mustNotBe_, &QAction::triggered, this, [this](bool on) { bench_.setMustNotBe(on); });
  connect(weight_, qOverload<double>(&QDoubleSpinBox::valueChanged), &bench_, &ColorBench::setWeight);
  connect(more_, &QToolButton::toggled, this, [this](bool on) {
    training_->setVisible(on);
    more_->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
  });
  connect(&bench_, &ColorBench::samplesChanged, this, &ColorClassesView::showSamples);
  connect(&bench_, &ColorBench::meaningChanged, this, &ColorClassesView::showMeaning);
  connect(&bench_, &ColorBench::qualityChanged, this, &ColorClassesView::showQuality);
  connect(&bench_, &ColorBench::failed, this, [this](const QString& reason) { say(reason, true); });
  connect(&files_, &ColorFiles::reported, this, [this](const QString& text) { say(text, false); });
  connect(training_, &TrainingPanel::reported, this, [this](const QString& text) { say(text, false); });
  connect(&files_, &ColorFiles::titleChanged, this, &ColorClassesView::showTitle);
}

void ColorClassesView::showSamples() {
  say({}, false);  // the message was about the former samples
  model_.setSamples(bench_.samples());
  showMeaning();
}

void ColorClassesView::showMeaning() {
  const int current = bench_.currentClass();
  if (tree_->currentIndex().row() != current)
    tree_->setCurrentIndex(model_.index(current, ColorClassModel::kName));
  mustNotBe_->setEnabled(current != 0);
  mustNotBe_->setChecked(bench_.mustNotBe() && current != 0);
  weight_->setValue(bench_.weight());
  remove_->setEnabled(current != 0);
  rename_->setEnabled(current != 0);
  up_->setEnabled(current > 1);
  down_->setEnabled(current != 0 && current + 1 < bench_.samples().classes.size());
}

void ColorClassesView::showQuality() {
  const ColorQuality* quality = bench_.quality();
  std::vector<std::optional<double>> recalls;
  if (quality != nullptr && quality->strokes && quality->classes == bench_.samples().classes) {
    const auto& evaluation = quality->strokes->evaluation;
    const auto& alone = quality->strokes->alone;
    for (int i = 0; i < evaluation.classes(); ++i) {
      const bool known = evaluation.labeled(i) > 0 && std::ranges::find(alone, i) == alone.end();
      recalls.push_back(known ? std::optional(evaluation.recall(i)) : std::nullopt);
    }
  }
  model_.setRecalls(recalls);
}

void ColorClassesView::showTitle() {
  Q_EMIT titleChanged(tr("Color classes: %1").arg(files_.title()));
}

void ColorClassesView::say(const QString& text, bool bad) {
  QStringList lines = text.split(QLatin1Char('\n'));
  message_->setToolTip(lines.size() > kMaxMessageLines ? text : QString());
  if (lines.size() > kMaxMessageLines) {
    lines = lines.mid(0, kMaxMessageLines);
    lines.last() += QStringLiteral(" …");
  }
  showOutcome(*message_, lines.join(QLatin1Char('\n')), bad);
  message_->setVisible(!text.isEmpty());
}

QString ColorClassesView::className(int colorClass) const {
  return QString::fromStdString(bench_.samples().classes.name(colorClass));
}

void ColorClassesView::add() {
  const auto& classes = bench_.samples().classes;
  auto next = colortool::withNewClass(
      bench_.samples(), {colortool::freeClassName(classes), colortool::spareColor(classes.size())});
  if (!next) return say(QString::fromStdString(next.error().text), true);
  bench_.change(tr("Add a class"), std::move(*next));
  const int added = bench_.samples().classes.size() - 1;
  bench_.setCurrentClass(added);
  tree_->edit(model_.index(added, ColorClassModel::kName));
}

void ColorClassesView::remove() {
  const int gone = bench_.currentClass();
  if (gone == 0) return;
  const QString name = className(gone);
  const std::size_t strokes = colortool::strokesOf(bench_.samples(), gone);
  bench_.change(tr("Remove %1").arg(name), colortool::withoutClass(bench_.samples(), gone));
  say(tr("Removed %1 with %2; Undo brings it back").arg(name, strokesText(strokes)), false);
}

void ColorClassesView::move(int by) {
  const int from = bench_.currentClass(), to = from + by;
  if (from == 0 || to < 1 || to >= bench_.samples().classes.size()) return;
  bench_.change(tr("Move %1").arg(className(from)), colortool::withMovedClass(bench_.samples(), from, to));
  bench_.setCurrentClass(to);
}

void ColorClassesView::rename(int colorClass, const QString& name) {
  auto next = colortool::withRenamedClass(bench_.samples(), colorClass, name.toStdString());
  if (!next) return say(tr("Not renamed: %1").arg(QString::fromStdString(next.error().text)), true);
  bench_.change(tr("Rename %1").arg(className(colorClass)), std::move(*next));
}

void ColorClassesView::pickColor(int colorClass) {
  const QColor before = model_.row(colorClass).color;
  const QColor color =
      QColorDialog::getColor(before, this, tr("Color that %1 is shown in").arg(className(colorClass)));
  if (!color.isValid() || color == before || colorClass >= bench_.samples().classes.size()) return;
  const robotlink::Rgb rgb{static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
                           static_cast<std::uint8_t>(color.blue())};
  bench_.change(tr("Color of %1").arg(className(colorClass)),
                colortool::withRecoloredClass(bench_.samples(), colorClass, rgb));
}

void ColorClassesView::usePreset(const colortool::ClassPreset& preset) {
  const QString title = QString::fromUtf8(preset.title.data(), static_cast<int>(preset.title.size()));
  bench_.change(tr("Preset: %1").arg(title), colortool::withClasses(bench_.samples(), preset.classes()));
}

bool ColorClassesView::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::MouseButtonPress || watched != tree_->viewport())
    return View::eventFilter(watched, event);
  const auto* mouse = static_cast<QMouseEvent*>(event);
  const QModelIndex index = tree_->indexAt(mouse->pos());
  const bool onSwatch = index.column() == ColorClassModel::kName &&
                        mouse->x() < tree_->visualRect(index).left() + tree_->iconSize().width() + 6;
  // The first click on a swatch selects its class, as anywhere else in the row.
  if (mouse->button() != Qt::LeftButton || !onSwatch || index.row() == 0 ||
      index.row() != bench_.currentClass())
    return false;
  pickColor(index.row());
  return true;
}

}  // namespace widgets
