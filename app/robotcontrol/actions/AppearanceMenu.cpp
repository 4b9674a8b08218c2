// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/AppearanceMenu.h"

#include <QActionGroup>
#include <QApplication>
#include <algorithm>
#include <utility>

namespace app {
namespace {

constexpr int kTextSizes[] = {80, 90, 100, 110, 125, 150, 175, 200};  // percent

}  // namespace

AppearanceMenu::AppearanceMenu(QWidget* parent)
    : QMenu(tr("&Appearance"), parent), font_(QApplication::font()) {
  setObjectName(QStringLiteral("appearanceMenu"));
  auto* group = new QActionGroup(this);
  const std::pair<QString, Appearance> choices[] = {{tr("Same as the &system"), Appearance::kSystem},
                                                    {tr("&Light"), Appearance::kLight},
                                                    {tr("&Dark"), Appearance::kDark},
                                                    {tr("&High contrast"), Appearance::kHighContrast}};
  for (const auto& [text, choice] : choices) {
    QAction* action = addAction(text, this, [this, value = choice] { setAppearance(value); });
    action->setObjectName(QStringLiteral("appearance.") + nameOf(choice));
    action->setCheckable(true);
    group->addAction(action);
  }
  addTextSizes();
}

void AppearanceMenu::addTextSizes() {
  addSection(tr("Size of texts"));
  sizes_ = new QActionGroup(this);
  // A size that only a command can choose leaves all entries unchecked.
  sizes_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  for (const int size : kTextSizes) {
    QAction* action = addAction(size == 100 ? tr("100 % (as the system)") : tr("%1 %").arg(size), this,
                                [this, size] { setTextSize(size); });
    action->setObjectName(QStringLiteral("textSize.%1").arg(size));
    action->setData(size);
    action->setCheckable(true);
    sizes_->addAction(action);
  }
}

void AppearanceMenu::setAppearance(Appearance appearance) {
  appearance_ = appearance;
  applyChoices();
}

void AppearanceMenu::setTextSize(int percent) {
  textSize_ = std::clamp(percent, kMinTextSize, kMaxTextSize);
  applyChoices();
}

void AppearanceMenu::applyChoices() {
  app::apply(appearance_, *qApp);
  QFont font = font_;
  if (font.pointSizeF() > 0)
    font.setPointSizeF(font_.pointSizeF() * textSize_ / 100);
  else
    font.setPixelSize(std::max(1, font_.pixelSize() * textSize_ / 100));
  if (font != QApplication::font()) QApplication::setFont(font);
  if (auto* action = findChild<QAction*>(QStringLiteral("appearance.") + nameOf(appearance_)))
    action->setChecked(true);
  for (QAction* action : sizes_->actions()) action->setChecked(action->data().toInt() == textSize_);
  Q_EMIT changed();
}

void AppearanceMenu::load(const QJsonObject& window) {
  appearance_ = appearanceFromName(window.value(QStringLiteral("appearance")).toString());
  setTextSize(window.value(QStringLiteral("text_size")).toInt(100));
}

void AppearanceMenu::save(QJsonObject& window) const {
  window.insert(QStringLiteral("appearance"), nameOf(appearance_));
  window.insert(QStringLiteral("text_size"), textSize_);
}

}  // namespace app
