// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/language/Language.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLibraryInfo>
#include <QLocale>
#include <clocale>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"

namespace app {
namespace {

constexpr std::size_t kMaxWindowFile = std::size_t{1} << 24U;  // bytes

}  // namespace

Language languageFromName(const QString& name) {
  for (const Language language : {Language::kEnglish, Language::kGerman}) {
    if (name == nameOf(language)) return language;
  }
  return Language::kSystem;
}

QString nameOf(Language language) {
  switch (language) {
    case Language::kEnglish:
      return QStringLiteral("en");
    case Language::kGerman:
      return QStringLiteral("de");
    case Language::kSystem:
      break;
  }
  return QStringLiteral("system");
}

Language savedLanguage(const std::filesystem::path& windowFile) {
  const auto text = robotlink::readFile(windowFile, kMaxWindowFile);
  if (!text) return Language::kSystem;
  const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  const QJsonObject window = root.value(QStringLiteral("window")).toObject();
  return languageFromName(window.value(QStringLiteral("language")).toString());
}

Language preferredLanguage(const QStringList& preferred) {
  for (const QString& name : preferred) {
    const QLocale::Language language = QLocale(name).language();
    if (language == QLocale::German) return Language::kGerman;
    if (language == QLocale::English) break;
  }
  return Language::kEnglish;
}

void useNumbersWithPoints() {
  QLocale numbers(QLocale::English, QLocale::UnitedStates);
  // Otherwise 1,5 would be read as 15.
  numbers.setNumberOptions(QLocale::RejectGroupSeparator);
  QLocale::setDefault(numbers);
  // Qt has set this to the system's locale, in which libraries independent of Qt would read files, too.
  std::setlocale(LC_NUMERIC, "C");
}

Translation::Translation(Language language) {
  if (language == Language::kSystem) language = preferredLanguage(QLocale::system().uiLanguages());
  if (language == Language::kEnglish) return;
  const QString name = nameOf(language);
  const auto file = robotlink::builtResource("translations/robotcontrol_" + name.toStdString() + ".qm");
  if (!own_.load(QString::fromStdString(file.string())))
    problem_ = QStringLiteral("%1 cannot be read, so texts are in English")
                   .arg(QString::fromStdString(file.string()));
  // If Qt's translations are not installed, only its standard dialogs are in English.
  if (qt_.load(QStringLiteral("qtbase_") + name, QLibraryInfo::location(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&qt_);
  if (problem_.isEmpty()) QCoreApplication::installTranslator(&own_);
}

Translation::~Translation() {
  QCoreApplication::removeTranslator(&own_);
  QCoreApplication::removeTranslator(&qt_);
}

}  // namespace app
