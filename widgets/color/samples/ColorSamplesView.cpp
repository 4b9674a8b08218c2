// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/ColorSamplesView.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSplitter>
#include <QTreeView>
#include <QUndoView>
#include <algorithm>

#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorClassModel.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/color/samples/ShareDelegate.h"
#include "widgets/color/samples/StrokeOrder.h"
#include "widgets/log/OpenLogs.h"

namespace widgets {
namespace {

const ViewRegistration kColorSamplesViewRegistration{
    {"color-samples", QT_TRANSLATE_NOOP("View", "Samples"),
     QT_TRANSLATE_NOOP(
         "View", "Lists the strokes that the color table is made from, and the history of their changes."),
     "samples", false, create<ColorSamplesView>}};

constexpr double kWeights[] = {0.5, 1, 2, 5};

/// The time in an image's name ("red1/camera/image 12.340 s [0a1b2c3d]"), plus half a millisecond because of
/// rounding, so that the image is not later.
std::optional<robotlink::Instant> timeOf(const colortool::SampleImage& image) {
  static const QRegularExpression kTime(QStringLiteral(" (-?\\d+\\.\\d{3}) s \\["));
  const auto match = kTime.match(QString::fromStdString(image.name));
  if (!match.hasMatch()) return std::nullopt;
  return robotlink::Instant(robotlink::fromSeconds(match.captured(1).toDouble() + 0.0005));
}

}  // namespace

ColorSamplesView::ColorSamplesView(ViewContext& context, QWidget* parent)
    : View(context, parent),
      bench_(colorBench(context)),
      sorted_(new StrokeOrder(model_, this)),
      history_(addColorActions(*this, "colorSamples", bench_)) {
  setObjectName(QStringLiteral("colorSamplesView"));
  createActions();
  createViews();
  connectSignals();
  keep("splitter", splitter_);
  keep("header", tree_->header());
  showSamples();
  showQuality();
}

void ColorSamplesView::createActions() {
  remove_ = makeAction(this, "remove",
                       {"samplesRemove", tr("Remove"), tr("Removes the selected strokes"), Qt::Key_Delete});
  lighting_ = makeAction(
      this, "light",
      {"samplesLighting", tr("Lighting…"), tr("Names the lighting of the images of the selected strokes")});
}

void ColorSamplesView::createTree() {
  tree_ = makeTree(this, {"samplesTree", tr("Strokes"), tr("A double click shows the image of a stroke")},
                   sorted_);
  tree_->viewport()->installEventFilter(this);
  tree_->setRootIsDecorated(false);
  tree_->setIconSize({30, 26});
  tree_->setSortingEnabled(true);
  tree_->sortByColumn(StrokeModel::kClass, Qt::AscendingOrder);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  tree_->setItemDelegateForColumn(StrokeModel::kRight, new ShareDelegate(StrokeModel::kShareRole, tree_));
  using enum ColumnKind;
  new ColumnFit(*tree_, {kName, kNumber, kNumber, kNumber, kNumber, kNumber, kName, kName, kText});
  hint_ = new EmptyHint(tree_);
  hint_->setHint(tr("There are no strokes yet. Choose a class and draw in the view Color image."));
}

void ColorSamplesView::createHistory() {
  steps_ = new QUndoView(&bench_.undoStack(), this);
  describe(*steps_, {"samplesHistory", tr("History"), tr("A click goes to the state after that change")});
  steps_->setEmptyLabel(tr("At first"));
  steps_->setFrameShape(QFrame::NoFrame);
}

void ColorSamplesView::createViews() {
  createTree();
  createHistory();
  splitter_ = makeSplitter(this, "samplesSplitter", Qt::Horizontal, {{tree_, 4}, {steps_, 1}});
  splitter_->setSizes({760, 190});
  QHBoxLayout* row = makeToolRow(this);
  addButtons(row, {history_.undo, history_.redo});
  row->addSpacing(6);
  addButtons(row, {remove_, lighting_});
  row->addStretch(1);
  count_ = addLabel(row, "samplesCount", tr("Number of strokes"));
  auto* layout = makeColumn(this, {4, 2, 4, 0}, 3);
  layout->addWidget(row->parentWidget());
  layout->addWidget(splitter_, 1);
}

bool ColorSamplesView::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Enter) sorted_->freeze();
  // The menu of a stroke covers it only while it is open.
  if (event->type() == QEvent::Leave && QApplication::activePopupWidget() == nullptr) sorted_->thaw();
  return View::eventFilter(watched, event);
}

void ColorSamplesView::connectSignals() {
  connect(remove_, &QAction::triggered, this, &ColorSamplesView::remove);
  connect(lighting_, &QAction::triggered, this, &ColorSamplesView::askLighting);
  connect(tree_, &QTreeView::customContextMenuRequested, this, &ColorSamplesView::openMenu);
  connect(tree_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
    if (index.flags() & Qt::ItemIsEditable) return tree_->edit(index);
    if (index.column() != StrokeModel::kMustNotBe)
      showImage(*model_.image(sorted_->mapToSource(index).row()));
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ColorSamplesView::updateCount);
  connect(&model_, &StrokeModel::mustNotBeWanted, this, [this](std::uint64_t stroke, bool on) {
    restate(tr("Must not be"), chosen(stroke), [on](auto& meaning) { meaning.mustNotBe = on; });
  });
  connect(&model_, &StrokeModel::weightWanted, this,
          [this](std::uint64_t stroke, double weight) { setWeight(chosen(stroke), weight); });
  connect(&model_, &StrokeModel::lightingWanted, this,
          [this](std::uint64_t stroke, const QString& lighting) { setLighting(chosen(stroke), lighting); });
  connect(&bench_, &ColorBench::samplesChanged, this, &ColorSamplesView::showSamples);
  connect(&bench_, &ColorBench::qualityChanged, this, &ColorSamplesView::showQuality);
}

void ColorSamplesView::showSamples() {
  const std::vector<std::uint64_t> before = chosen();
  const QModelIndex current = tree_->currentIndex();
  const std::uint64_t held = current.isValid() ? model_.stroke(sorted_->mapToSource(current).row()).id : 0;
  const int column = current.column(), top = tree_->visualRect(current).top();
  model_.setSamples(bench_.samples());
  // A model reset has cleared the selection.
  if (!before.empty() && !tree_->selectionModel()->hasSelection()) {
    for (int row = 0; row < model_.rowCount(); ++row) {
      if (std::ranges::find(before, model_.stroke(row).id) == before.end()) continue;
      tree_->selectionModel()->select(sorted_->mapFromSource(model_.index(row, 0)),
                                      QItemSelectionModel::Select | QItemSelectionModel::Rows);
    }
  }
  hold(held, column, top);
  hint_->setVisible(model_.rowCount() == 0);
  updateCount();
}

void ColorSamplesView::hold(std::uint64_t stroke, int column, int top) {
  for (int row = 0; stroke != 0 && row < model_.rowCount(); ++row) {
    if (model_.stroke(row).id != stroke) continue;
    const QModelIndex index = sorted_->mapFromSource(model_.index(row, column));
    tree_->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    // The tree scrolls by rows or by pixels, depending on the style.
    const int off = tree_->visualRect(index).top() - top;
    const bool byRows = tree_->verticalScrollMode() == QAbstractItemView::ScrollPerItem;
    const int height = std::max(1, tree_->visualRect(index).height());
    tree_->verticalScrollBar()->setValue(tree_->verticalScrollBar()->value() + (byRows ? off / height : off));
    return;
  }
}

void ColorSamplesView::showQuality() {
  std::unordered_map<std::uint64_t, double> right;
  if (const ColorQuality* quality = bench_.quality(); quality != nullptr && quality->strokes) {
    for (const auto& [stroke, share] : quality->strokes->strokes) right[stroke] = share;
    for (int row = 0; row < model_.rowCount(); ++row) {
      const colortool::Stroke& stroke = model_.stroke(row);
      if (std::ranges::find(quality->strokes->alone, stroke.colorClass) != quality->strokes->alone.end())
        right.erase(stroke.id);
    }
  }
  model_.setRight(std::move(right));
}

void ColorSamplesView::updateCount() {
  const auto selected = static_cast<int>(chosen().size());
  const int all = model_.rowCount();
  count_->setText(selected > 1 ? tr("%1 of %2 strokes").arg(selected).arg(all)
                               : strokesText(static_cast<std::size_t>(all)));
  remove_->setEnabled(selected > 0);
  lighting_->setEnabled(selected > 0);
}

std::vector<std::uint64_t> ColorSamplesView::chosen(std::uint64_t also) const {
  std::vector<std::uint64_t> ids;
  for (const QModelIndex& index : tree_->selectionModel()->selectedRows())
    ids.push_back(model_.stroke(sorted_->mapToSource(index).row()).id);
  if (also != 0 && std::ranges::find(ids, also) == ids.end()) return {also};
  return ids;
}

void ColorSamplesView::restate(const QString& text, const std::vector<std::uint64_t>& ids,
                               const std::function<void(colortool::StrokeMeaning&)>& change) {
  colortool::Samples next = bench_.samples();
  for (const colortool::StrokePtr& stroke : bench_.samples().strokes) {
    if (std::ranges::find(ids, stroke->id) == ids.end()) continue;
    colortool::StrokeMeaning meaning{stroke->colorClass, stroke->mustNotBe, stroke->weight};
    change(meaning);
    if (meaning.colorClass == colortool::ColorClasses::kNone) meaning.mustNotBe = false;
    colortool::restate(next, {stroke->id}, meaning);
  }
  bench_.change(text, std::move(next));
}

void ColorSamplesView::remove() {
  const auto ids = chosen();
  if (ids.empty()) return;
  colortool::Samples next = bench_.samples();
  colortool::removeStrokes(next, ids);
  bench_.change(tr("Remove %1").arg(strokesText(ids.size())), std::move(next));
}

void ColorSamplesView::setWeight(const std::vector<std::uint64_t>& ids, double weight) {
  restate(tr("Weight %1").arg(weight), ids, [weight](auto& meaning) { meaning.weight = weight; });
}

void ColorSamplesView::setLighting(const std::vector<std::uint64_t>& ids, const QString& lighting) {
  colortool::Samples next = bench_.samples();
  for (const colortool::StrokePtr& stroke : next.strokes) {
    if (std::ranges::find(ids, stroke->id) == ids.end()) continue;
    const auto image = std::ranges::find(next.images, stroke->image, &colortool::SampleImage::id);
    if (image != next.images.end()) image->lighting = lighting.toStdString();
  }
  bench_.change(tr("Lighting %1").arg(lighting), std::move(next));
}

void ColorSamplesView::askLighting() {
  const auto ids = chosen();
  if (ids.empty()) return;
  QStringList known;
  for (const colortool::SampleImage& image : bench_.samples().images) {
    const QString word = QString::fromStdString(image.lighting);
    if (!word.isEmpty() && !known.contains(word)) known << word;
  }
  bool accepted = false;
  const QString word =
      QInputDialog::getItem(this, tr("Lighting"), tr("The light that these images were taken in:"), known, 0,
                            true, &accepted)
          .trimmed();
  if (accepted) setLighting(ids, word);
}

void ColorSamplesView::showImage(const colortool::SampleImage& image) {
  for (const CollectedFrame& collected : bench_.collected()) {
    if (collected.frame->place().name == image.name) {
      Q_EMIT bench_.frameWanted(collected.frame);
      return;
    }
  }
  if (const auto file = ColorFrame::fileOfName(image.name); !file.empty())
    return colorFiles(context()).openPictures({file});
  const auto time = timeOf(image);
  ReplayControl& replay = openLogs(context()).replay();
  const auto newest = session().timeline().newest() + std::chrono::milliseconds(1);
  if (time && replay.open() && *time >= replay.begin() &&
      *time <= replay.end() + std::chrono::milliseconds(1)) {
    Q_EMIT bench_.frameWanted(nullptr);
    replay.jumpTo(*time);
  } else if (time && !replay.open() && *time <= newest) {
    Q_EMIT bench_.frameWanted(nullptr);
    session().history().show(*time);
  } else {
    Q_EMIT bench_.failed(tr("The image %1 is not available: it was not collected, and its time is not on the "
                            "timeline. Open its log to see it.")
                             .arg(QString::fromStdString(image.name)));
  }
}

void ColorSamplesView::fillClassMenu(QMenu& menu) {
  const auto& classes = bench_.samples().classes;
  for (int i = 0; i < classes.size(); ++i) {
    const robotlink::Rgb rgb = classes.shownColor(i);
    const QString name = i == 0 ? tr("background") : QString::fromStdString(classes.name(i));
    menu.addAction(swatch(i == 0 ? QColor() : QColor(rgb.r, rgb.g, rgb.b)), name, this,
                   [this, i, name] {
                     restate(tr("Class %1").arg(name), chosen(),
                             [i](auto& meaning) { meaning.colorClass = static_cast<std::uint8_t>(i); });
                   })
        ->setObjectName(QStringLiteral("class.%1").arg(i));
  }
}

void ColorSamplesView::openMenu(const QPoint& at) {
  const QModelIndex index = tree_->indexAt(at);
  if (!index.isValid()) return;
  const int row = sorted_->mapToSource(index).row();
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("samplesMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Show its &image"), this, [this, row] { showImage(*model_.image(row)); })
      ->setObjectName(QStringLiteral("showImage"));
  fillClassMenu(*menu->addMenu(tr("&Class")));
  QMenu* weights = menu->addMenu(tr("&Weight"));
  for (const double weight : kWeights)
    weights->addAction(QStringLiteral("× %1").arg(weight), this,
                       [this, weight] { setWeight(chosen(), weight); });
  const bool on = !model_.stroke(row).mustNotBe;
  menu->addAction(on ? tr("Must &not be of its class") : tr("Is of its class"), this, [this, on] {
    restate(tr("Must not be"), chosen(), [on](auto& meaning) { meaning.mustNotBe = on; });
  });
  menu->addSeparator();
  menu->addAction(lighting_);
  menu->addAction(remove_);
  menu->popup(tree_->viewport()->mapToGlobal(at));
}

}  // namespace widgets
