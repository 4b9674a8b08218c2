// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/language/LanguageMenu.h"

#include <QActionGroup>
#include <utility>

namespace app {

LanguageMenu::LanguageMenu(QWidget* parent) : QMenu(tr("&Language"), parent) {
  setObjectName(QStringLiteral("languageMenu"));
  setToolTipsVisible(true);
  auto* group = new QActionGroup(this);
  // Languages are named in themselves, so that those who speak no other find theirs.
  const std::pair<QString, Language> choices[] = {{tr("Same as the &system"), Language::kSystem},
                                                  {QStringLiteral("&English"), Language::kEnglish},
                                                  {QStringLiteral("&Deutsch"), Language::kGerman}};
  for (const auto& [text, choice] : choices) {
    QAction* action = addAction(text, this, [this, value = choice] { setLanguage(value); });
    action->setObjectName(QStringLiteral("language.") + nameOf(choice));
    action->setToolTip(
        tr("The language of the window from the next start on; commands and scripts do not change"));
    action->setCheckable(true);
    group->addAction(action);
  }
  checkEntry();
}

void LanguageMenu::setLanguage(Language language) {
  const bool isAnother = language != language_;
  language_ = language;
  checkEntry();
  if (isAnother) Q_EMIT chosen(tr("Restart RobotControl to see the window in the chosen language."));
}

void LanguageMenu::checkEntry() {
  if (auto* action = findChild<QAction*>(QStringLiteral("language.") + nameOf(language_)))
    action->setChecked(true);
}

void LanguageMenu::load(const QJsonObject& window) {
  language_ = languageFromName(window.value(QStringLiteral("language")).toString());
  checkEntry();
}

void LanguageMenu::save(QJsonObject& window) const {
  window.insert(QStringLiteral("language"), nameOf(language_));
}

}  // namespace app
