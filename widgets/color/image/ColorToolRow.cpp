// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorToolRow.h"

#include <QActionGroup>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QShortcut>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include "widgets/Controls.h"
#include "widgets/color/ColorActions.h"
#include "widgets/color/ColorBench.h"

namespace widgets {
namespace {

constexpr double kMinRadius = 0.5, kMaxRadius = 100;

struct ToolText {
  ColorTool tool;
  const char* icon;
  const char* name;
  const char* text;
  const char* toolTip;
  int key;
};
constexpr ToolText kTools[] = {
    {ColorTool::kPoint, "point", "colorToolPoint", QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Point"),
     QT_TRANSLATE_NOOP("widgets::ColorToolRow", "The clicked pixel belongs to the class"), Qt::Key_P},
    {ColorTool::kBrush, "brush", "colorToolBrush", QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Brush"),
     QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Painted pixels belong to the class"), Qt::Key_B},
    {ColorTool::kRectangle, "rectangle", "colorToolRectangle",
     QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Rectangle"),
     QT_TRANSLATE_NOOP("widgets::ColorToolRow", "The pixels of a rectangle belong to the class"), Qt::Key_R},
    {ColorTool::kLasso, "lasso", "colorToolLasso", QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Lasso"),
     QT_TRANSLATE_NOOP("widgets::ColorToolRow", "The pixels inside a drawn line belong to the class"),
     Qt::Key_L},
    {ColorTool::kWand, "wand", "colorToolWand", QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Magic wand"),
     QT_TRANSLATE_NOOP("widgets::ColorToolRow",
                       "Similar colors around the click, up to an edge, belong to the class"),
     Qt::Key_W},
    {ColorTool::kEraser, "eraser", "colorToolEraser", QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Eraser"),
     QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Removes strokes of this image"), Qt::Key_E},
    {ColorTool::kSelect, "select-area", "colorToolSelect",
     QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Select colors"),
     QT_TRANSLATE_NOOP("widgets::ColorToolRow",
                       "Selects the colors inside a drawn line, here and in the color space"),
     Qt::Key_S},
    {ColorTool::kMove, "grab", "colorToolMove", QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Move"),
     QT_TRANSLATE_NOOP("widgets::ColorToolRow", "Moves the image (also the middle button with any tool)"),
     Qt::Key_M}};

}  // namespace

QIcon classSwatch(const ColorBench& bench, int colorClass) {
  const robotlink::Rgb color =
      colorClass == 0 ? robotlink::Rgb{150, 150, 150} : bench.samples().classes.shownColor(colorClass);
  QPixmap pixmap(14, 14);
  pixmap.fill(QColor(color.r, color.g, color.b));
  return QIcon(pixmap);
}

QString className(const ColorBench& bench, int colorClass) {
  return colorClass == 0 ? ColorToolRow::tr("background")
                         : QString::fromStdString(bench.samples().classes.name(colorClass));
}

ColorToolRow::ColorToolRow(ColorBench& bench, QWidget* owner) : QWidget(owner), bench_(bench) {
  createTools(owner);
  createControls();
  createShortcuts(owner);
  connect(tools_, &QActionGroup::triggered, this, &ColorToolRow::update);
  connect(radius_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ColorToolRow::toolChanged);
  connect(opacity_, &QSlider::valueChanged, this, &ColorToolRow::opacityChanged);
  connect(&bench_, &ColorBench::samplesChanged, this, &ColorToolRow::updateClass);
  connect(&bench_, &ColorBench::meaningChanged, this, &ColorToolRow::updateClass);
  update();
  updateClass();
}

void ColorToolRow::createTools(QWidget* owner) {
  tools_ = new QActionGroup(this);
  for (const ToolText& text : kTools) {
    QAction* action = makeToggle(owner, text.icon, {text.name, tr(text.text), tr(text.toolTip), text.key},
                                 text.tool == ColorTool::kBrush);
    action->setData(static_cast<int>(text.tool));
    tools_->addAction(action);
  }
  careful_ = makeToggle(
      owner, "filter",
      {"colorCareful", tr("Careful brush"),
       tr("The brush snaps to thin lines and skips other colors, such as the field next to a line")},
      true);
  const ColorActions common = addColorActions(*owner, "color", bench_);
  undo_ = common.undo;
  redo_ = common.redo;
}

void ColorToolRow::createControls() {
  class_ = new QToolButton(this);
  describe(*class_, {"colorClass", tr("Class"), tr("Class of the strokes; digit keys also choose it")});
  class_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  class_->setPopupMode(QToolButton::InstantPopup);
  classMenu_ = new QMenu(class_);
  classMenu_->setObjectName(QStringLiteral("colorClassMenu"));
  class_->setMenu(classMenu_);

  radius_ = new QDoubleSpinBox(this);
  describe(*radius_, {"colorRadius", tr("Radius"),
                      tr("Radius of brush and eraser in pixels; [ and ], Ctrl and wheel")});
  radius_->setRange(kMinRadius, kMaxRadius);
  radius_->setDecimals(1);
  radius_->setValue(ColorGesture::Options{}.radius);
  radius_->setSuffix(tr(" px"));
  tolerance_ = new QSpinBox(this);
  describe(*tolerance_, {"colorTolerance", tr("Tolerance"),
                         tr("How far colors may differ for the magic wand to include them")});
  tolerance_->setRange(2, 100);
  tolerance_->setValue(static_cast<int>(colortool::WandOptions{}.tolerance));
  tolerance_->setPrefix(QStringLiteral("± "));
  opacity_ = new QSlider(Qt::Horizontal, this);
  describe(*opacity_, {"colorOpacity", tr("Opacity"), tr("Opacity of the classes over the left picture")});
  opacity_->setRange(0, 100);
  opacity_->setFixedWidth(90);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2, 2, 2, 2);
  row->setSpacing(1);
  row->addWidget(class_);
  for (QAction* action : tools_->actions()) row->addWidget(makeButton(this, action));
  row->addWidget(radius_);
  row->addWidget(makeButton(this, careful_));
  row->addWidget(tolerance_);
  addButtons(row, {undo_, redo_});
  note_ = new QLabel(this);
  describe(*note_, {"colorSent", tr("Whether the robot uses this table"), {}});
  note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  note_->setContentsMargins(10, 0, 10, 0);
  row->addWidget(note_, 1);
  row->addWidget(new QLabel(tr("Overlay"), this));
  row->addWidget(opacity_);
}

void ColorToolRow::createShortcuts(QWidget* owner) {
  const auto shortcut = [&](int key, auto action) {
    auto* made = new QShortcut(QKeySequence(key), owner);
    made->setContext(Qt::WidgetWithChildrenShortcut);
    connect(made, &QShortcut::activated, this, action);
  };
  shortcut(Qt::Key_BracketLeft, [this] { scaleRadius(0.8); });
  shortcut(Qt::Key_BracketRight, [this] { scaleRadius(1.25); });
}

ColorTool ColorToolRow::tool() const {
  const QAction* action = tools_->checkedAction();
  return action == nullptr ? ColorTool::kBrush : static_cast<ColorTool>(action->data().toInt());
}

double ColorToolRow::radius() const {
  return radius_->value();
}

double ColorToolRow::opacity() const {
  return opacity_->value() / 100.0;
}

void ColorToolRow::scaleRadius(double factor) {
  radius_->setValue(radius() * factor);
}

ColorGesture::Options ColorToolRow::options() const {
  ColorGesture::Options options;
  options.tool = tool();
  options.radius = radius();
  options.careful = careful_->isChecked();
  options.wand.tolerance = tolerance_->value();
  options.wand.edge = 1.5 * tolerance_->value();
  return options;
}

void ColorToolRow::update() {
  radius_->setEnabled(tool() == ColorTool::kBrush || tool() == ColorTool::kEraser);
  tolerance_->setEnabled(tool() == ColorTool::kWand);
  careful_->setEnabled(tool() == ColorTool::kBrush);
  Q_EMIT toolChanged();
}

void ColorToolRow::updateClass() {
  const int current = bench_.currentClass();
  const QString name = className(bench_, current);
  class_->setIcon(classSwatch(bench_, current));
  class_->setText(bench_.mustNotBe() && current != 0 ? tr("not %1").arg(name) : name);
  classMenu_->clear();
  for (int i = 0; i < bench_.samples().classes.size(); ++i) {
    const QString text =
        i <= 9 ? QStringLiteral("&%1  %2").arg(i).arg(className(bench_, i)) : className(bench_, i);
    classMenu_->addAction(classSwatch(bench_, i), text, this, [this, i] { bench_.setCurrentClass(i); });
  }
  classMenu_->addSeparator();
  QAction* mustNotBe = classMenu_->addAction(tr("Must &not be (N)"), &bench_, &ColorBench::setMustNotBe);
  mustNotBe->setCheckable(true);
  mustNotBe->setChecked(bench_.mustNotBe());
}

QJsonObject ColorToolRow::saveState() const {
  return {{QStringLiteral("tool"), QLatin1String(toolName(tool()))},
          {QStringLiteral("radius"), radius()},
          {QStringLiteral("careful"), careful_->isChecked()},
          {QStringLiteral("tolerance"), tolerance_->value()},
          {QStringLiteral("opacity"), opacity_->value()}};
}

void ColorToolRow::restoreState(const QJsonObject& state) {
  for (QAction* action : tools_->actions()) {
    const auto tool = static_cast<ColorTool>(action->data().toInt());
    if (state[QStringLiteral("tool")].toString() == QLatin1String(toolName(tool))) action->setChecked(true);
  }
  radius_->setValue(state[QStringLiteral("radius")].toDouble(radius()));
  careful_->setChecked(state[QStringLiteral("careful")].toBool(true));
  tolerance_->setValue(state[QStringLiteral("tolerance")].toInt(tolerance_->value()));
  opacity_->setValue(state[QStringLiteral("opacity")].toInt());
  update();
}

}  // namespace widgets
