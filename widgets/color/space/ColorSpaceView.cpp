// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceView.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <algorithm>

#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"
#include "widgets/ShownText.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/space/ColorSpaceCanvas.h"
#include "widgets/color/space/ColorSpacePanel.h"

namespace widgets {
namespace {

const ViewRegistration kColorSpaceViewRegistration{
    {"color-space", QT_TRANSLATE_NOOP("View", "Color space"),
     QT_TRANSLATE_NOOP("View", "Pixels, samples and the table's classes in the three dimensions of color"),
     "color-space", true, create<ColorSpaceView>}};

constexpr int kTicksBetweenImages = 3;  // images are followed at 10 Hz
constexpr int kPanelWidth = 150;        // pixels
constexpr int kMaxHidden = 256;         // there are no more classes

QString rangeOf(int cell) {
  const int first = cell * static_cast<int>(colortool::ColorTable::kCellSize);
  return QStringLiteral("%1-%2").arg(first).arg(first + static_cast<int>(colortool::ColorTable::kCellSize) -
                                                1);
}

std::size_t pixelsIn(const ColorCloud& cloud, const colortool::CellSet& cells) {
  std::size_t pixels = 0;
  for (const CloudPoint& point : cloud.points) {
    if (cells.contains(colortool::ColorTable::cellOf(point.color))) pixels += point.pixels;
  }
  return pixels;
}

}  // namespace

ColorSpaceView::ColorSpaceView(ViewContext& context, QWidget* parent)
    : PictureView(context, "colorSpace", "color-space.png", parent), bench_(colorBench(context)) {
  createActions();
  createViews();
  connectSignals();
  connectBench();
  keep("pixels", pixels_);
  keep("samples", samplesShown_);
  keep("table", tableShown_);
  tick();
}

ColorSpaceView::~ColorSpaceView() = default;

void ColorSpaceView::createActions() {
  pixels_ = makeToggle(
      this, "color-pixels",
      {"colorSpacePixels", tr("Pixels"), tr("Shows the colors of the image's pixels"), Qt::Key_P}, true);
  samplesShown_ = makeToggle(this, "color-samples",
                             {"colorSpaceSamples", tr("Samples"),
                              tr("Shows the colors that strokes touched, in their class's color"), Qt::Key_S},
                             true);
  tableShown_ = makeToggle(
      this, "color-surfaces",
      {"colorSpaceTable", tr("Table"), tr("Shows the surfaces of the table's classes"), Qt::Key_T}, true);
  showPanel_ = makeToggle(this, "settings",
                          {"colorSpaceSettings", tr("Classes and cut"),
                           tr("Chooses which classes are shown, and where the space is cut"), Qt::Key_D},
                          true);
  reset_ = makeAction(this, "reset", {"colorSpaceReset", tr("Reset"), tr("Resets the view"), Qt::Key_R});
  clear_ = makeAction(
      this, "clear",
      {"colorSpaceClear", tr("Clear selection"), tr("Clears the selection (Escape in the picture)")});
}

void ColorSpaceView::createViews() {
  canvas_ = new ColorSpaceCanvas(this);
  hint_ = new EmptyHint(canvas_);
  panel_ = new ColorSpacePanel;
  auto* scroll = makeScrollArea(this, panel_);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(std::max(kPanelWidth, panel_->minimumSizeHint().width() + 18));
  assemble({createToolRow()}, canvas_, {scroll, showPanel_, kPanelWidth}, {createFooter()});
}

QWidget* ColorSpaceView::createToolRow() {
  QHBoxLayout* row = makeToolRow(this);
  space_ = new QComboBox(row->parentWidget());
  widgets::describe(*space_, {"colorSpaceChoice", tr("Color space"), tr("In which space colors are shown")});
  for (const colortool::ColorSpace space : colortool::kColorSpaces)
    space_->addItem(QLatin1String(colortool::nameOf(space)));
  row->addWidget(space_);
  addButtons(row, {pixels_, samplesShown_, tableShown_});
  row->addStretch(1);
  selection_ = addLabel(row, "colorSpaceSelection", tr("What is selected"));
  addButtons(row, {clear_, reset_, showPanel_});
  return row->parentWidget();
}

QWidget* ColorSpaceView::createFooter() {
  QHBoxLayout* footer = makeFooter(this);
  swatch_ = addLabel(footer, "colorSpaceSwatch", tr("Color under the cursor"));
  swatch_->setFixedSize(22, 14);
  pointed_ = addLabel(footer, "colorSpacePointed", tr("Cell under the cursor"));
  pointed_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  pointed_->setMinimumHeight(fontMetrics().lineSpacing() + 2);  // keeps its height without a text
  footer->setStretchFactor(pointed_, 1);
  return footer->parentWidget();
}

void ColorSpaceView::connectSignals() {
  connect(space_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    panel_->setLook(look());
    updateLook();
  });
  for (QAction* action : {pixels_, samplesShown_, tableShown_})
    connect(action, &QAction::toggled, this, &ColorSpaceView::updateLook);
  connect(panel_, &ColorSpacePanel::lookChanged, this, &ColorSpaceView::updateLook);
  connect(reset_, &QAction::triggered, canvas_, [this] { canvas_->setCamera({}); });
  connect(clear_, &QAction::triggered, &bench_, &ColorBench::clearSelection);
  connect(canvas_, &ColorSpaceCanvas::clearWanted, &bench_, &ColorBench::clearSelection);
  connect(canvas_, &ColorSpaceCanvas::cellsChosen, this, &ColorSpaceView::select);
  connect(canvas_, &ColorSpaceCanvas::pointedCellChanged, this, &ColorSpaceView::updatePointed);
  connect(canvas_, &ColorSpaceCanvas::pictureShown, this, &ColorSpaceView::updateSelection);
}

void ColorSpaceView::connectBench() {
  connect(&bench_, &ColorBench::selectionChanged, this, [this] { changed(Due::kNow); });
  connect(&bench_, &ColorBench::referenceChanged, this, [this] { changed(Due::kNow); });
  connect(&bench_, &ColorBench::pointedChanged, this, [this] {
    const auto& color = bench_.pointed();
    canvas_->setMarkedCell(color ? std::optional(colortool::ColorTable::cellOf(*color)) : std::nullopt);
  });

  connect(&bench_, &ColorBench::colorsChanged, this, [this] {
    const LearnedColors& colors = *bench_.colors();
    const bool sameTable = contents_->table == colors.table && contents_->samples == colors.samples;
    const bool sameImage = contents_->frame == colors.frame && contents_->corrected == colors.corrected;
    changed(!sameTable ? Due::kNow : sameImage ? Due::kNothing : Due::kSoon);
    updatePointed();
  });
}

void ColorSpaceView::changed(Due due) {
  due_ = std::max(due_, due);
}

void ColorSpaceView::tick() {
  ++ticks_;
  if (due_ == Due::kNow || (due_ == Due::kSoon && ticks_ >= kTicksBetweenImages)) updateContents();
  canvas_->tick();
}

void ColorSpaceView::updateContents() {
  due_ = Due::kNothing;
  ticks_ = 0;
  auto contents = std::make_shared<ColorSpaceContents>();
  if (const LearnedColors* colors = bench_.colors()) {
    contents->frame = colors->frame;
    contents->corrected = colors->corrected;
    contents->table = colors->table;
    contents->samples = colors->samples;
  } else {
    contents->samples = bench_.samples();
  }
  contents->reference = bench_.reference();
  if (bench_.hasSelection()) contents->selection = std::make_shared<colortool::CellSet>(bench_.selection());
  contents_ = contents;
  panel_->setClasses(contents->samples.classes);
  panel_->setHasReference(contents->reference != nullptr);
  canvas_->setContents(std::move(contents));
  clear_->setEnabled(bench_.hasSelection());
  updateHint();
  updateSelection();
}

std::optional<QString> ColorSpaceView::numbers() {
  if (contents_ == nullptr) return std::nullopt;
  const ColorSpaceLook shown = look();
  QStringList titles{QStringLiteral("of")};
  for (const char* channel : colortool::channelNames(shown.space)) titles << QLatin1String(channel);
  TabTable table(titles << QStringLiteral("pixels") << QStringLiteral("class"));
  const auto& classes = contents_->samples.classes;
  const auto add = [&](const char* of, robotlink::YCbCr color, const QString& pixels, int colorClass) {
    QStringList cells{QLatin1String(of)};
    for (const float channel : colortool::channelsIn(shown.space, colortool::valueOf(color)))
      cells << QString::number(channel, 'f', 4);
    const bool hasClass = colorClass > 0 && colorClass < static_cast<int>(classes.size());
    table.add(cells << pixels << (hasClass ? QString::fromStdString(classes.name(colorClass)) : QString()));
  };
  const auto* learned = contents_->table.get();
  if (shown.pixels && contents_->frame != nullptr) {
    const auto cloud = CloudMaker().cloudOf(contents_->pixels());
    for (const CloudPoint& point : cloud->points)
      add("image", point.color, QString::number(point.pixels),
          learned == nullptr ? 0 : learned->classOf(point.color));
  }
  if (shown.table && learned != nullptr) {
    const auto middle = [](std::size_t part) { return static_cast<std::uint8_t>((part & 63U) * 4 + 2); };
    const auto& cells = learned->cells();
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      if (cells[cell] != 0)
        add("table", {middle(cell >> 12U), middle(cell >> 6U), middle(cell)}, {}, cells[cell]);
  }
  return table.text();
}

void ColorSpaceView::updateHint() {
  const bool nothing =
      contents_->frame == nullptr && contents_->samples.strokes.empty() &&
      (contents_->table == nullptr ||
       std::ranges::all_of(contents_->table->cells(), [](std::uint8_t cell) { return cell == 0; }));
  hint_->setHint(nothing
                     ? tr("There are no colors yet.\nOpen a color image and draw strokes in it: its pixels, "
                          "the strokes' samples and the table that is made from them appear here.")
                     : QString());
}

ColorSpaceLook ColorSpaceView::look() const {
  ColorSpaceLook look;
  look.space = colortool::kColorSpaces[static_cast<std::size_t>(std::max(0, space_->currentIndex()))];
  look.pixels = pixels_->isChecked();
  look.samples = samplesShown_->isChecked();
  look.table = tableShown_->isChecked();
  panel_->addTo(look);
  return look;
}

void ColorSpaceView::updateLook() {
  canvas_->setLook(look());
}

void ColorSpaceView::updatePointed() {
  const auto cell = canvas_->pointedCell();
  pointed_->setText(cell ? describe(*cell) : QString());
  pointed_->setToolTip(pointed_->text());  // for narrow views
  if (!cell) return swatch_->clear();
  const auto middle = [](std::size_t part) { return static_cast<std::uint8_t>((part & 63U) * 4 + 2); };
  const robotlink::Rgb color = robotlink::toRgb({middle(*cell >> 12U), middle(*cell >> 6U), middle(*cell)});
  QPixmap pixmap(22, 14);
  pixmap.fill(QColor(color.r, color.g, color.b));
  swatch_->setPixmap(pixmap);
}

QString ColorSpaceView::describe(std::size_t cell) const {
  QStringList parts{tr("Y %1  Cb %2  Cr %3")
                        .arg(rangeOf(static_cast<int>(cell >> 12U)),
                             rangeOf(static_cast<int>(cell >> 6U & 63U)),
                             rangeOf(static_cast<int>(cell & 63U)))};
  const auto classIn = [&](const colortool::ColorTable& table) {
    const std::uint8_t colorClass = table.cells()[cell];
    const auto& classes = contents_->samples.classes;
    const bool none = colorClass == colortool::ColorClasses::kNone || colorClass >= classes.size();
    return none ? tr("background") : QString::fromStdString(classes.name(colorClass));
  };
  if (contents_->table != nullptr) parts << classIn(*contents_->table);
  if (contents_->reference != nullptr) parts << tr("reference: %1").arg(classIn(*contents_->reference));
  const LearnedColors* colors = bench_.colors();
  if (colors != nullptr && colors->margins != nullptr)
    parts << tr("margin %1 %").arg(qRound((*colors->margins)[cell] / 2.55));
  if (canvas_->picture().cloud != nullptr)
    parts << tr("pixels: %1").arg(canvas_->picture().cloud->pixelsIn(cell));
  return parts.join(QStringLiteral("   "));
}

void ColorSpaceView::updateSelection() {
  if (contents_ == nullptr || contents_->selection == nullptr) return selection_->clear();
  const auto& cloud = canvas_->picture().cloud;
  QString text = counted(contents_->selection->size(), tr("1 cell"), tr("%1 cells"));
  if (cloud != nullptr)
    text += QStringLiteral(", ") +
            counted(pixelsIn(*cloud, *contents_->selection), tr("1 pixel"), tr("%1 pixels"));
  selection_->setText(text);
}

void ColorSpaceView::select(const colortool::CellSet& cells, SelectionChange change) {
  colortool::CellSet selection = cells;
  if (change != SelectionChange::kReplace && bench_.hasSelection()) {
    for (std::size_t row = 0; row < colortool::CellSet::kRows; ++row) {
      const auto before = bench_.selection().row(row);
      selection.row(row) =
          change == SelectionChange::kAdd ? before | cells.row(row) : before & ~cells.row(row);
    }
  } else if (change == SelectionChange::kTakeAway) {
    return;
  }
  selection.empty() ? bench_.clearSelection() : bench_.select(selection);
}

QJsonObject ColorSpaceView::saveState() const {
  const ColorSpaceLook shown = look();
  QJsonArray hidden;
  for (const std::string& name : shown.hidden) hidden.append(QString::fromStdString(name));
  QJsonObject state = PictureView::saveState();
  state[QStringLiteral("space")] = QLatin1String(colortool::nameOf(shown.space));
  state[QStringLiteral("surfaces")] = static_cast<int>(shown.surfaces);
  state[QStringLiteral("opacity")] = shown.opacity;
  state[QStringLiteral("hidden")] = hidden;
  state[QStringLiteral("cut")] = static_cast<int>(shown.cut.along);
  state[QStringLiteral("cutAt")] = shown.cut.at;
  state[QStringLiteral("cutOther")] = shown.cut.other;
  state[QStringLiteral("camera")] = stateOf(canvas_->camera());
  return state;
}

void ColorSpaceView::restoreState(const QJsonObject& state) {
  PictureView::restoreState(state);
  ColorSpaceLook wanted;
  space_->setCurrentIndex(std::max(0, space_->findText(state[QStringLiteral("space")].toString())));
  wanted.space = look().space;
  const int surfaces = state[QStringLiteral("surfaces")].toInt();
  if (surfaces >= 0 && surfaces <= static_cast<int>(SurfacesOf::kDifference))
    wanted.surfaces = static_cast<SurfacesOf>(surfaces);
  wanted.opacity = std::clamp(state[QStringLiteral("opacity")].toDouble(wanted.opacity), 0.0, 1.0);
  const QJsonArray hidden = state[QStringLiteral("hidden")].toArray();
  for (int i = 0; i < std::min(hidden.size(), kMaxHidden); ++i)
    wanted.hidden.push_back(hidden.at(i).toString().toStdString());
  const int along = state[QStringLiteral("cut")].toInt();
  if (along >= 0 && along <= static_cast<int>(ColorSpaceCut::Along::kThird))
    wanted.cut.along = static_cast<ColorSpaceCut::Along>(along);
  wanted.cut.at = std::clamp(state[QStringLiteral("cutAt")].toDouble(wanted.cut.at), 0.0, 1.0);
  wanted.cut.other = state[QStringLiteral("cutOther")].toBool();
  panel_->setLook(wanted);
  canvas_->setCamera(colorSpaceCameraOf(state[QStringLiteral("camera")].toObject()));
  updateLook();
}

}  // namespace widgets
