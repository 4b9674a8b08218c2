// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QTranslator>
#include <filesystem>

namespace app {

/// Languages of the window's texts. kSystem follows the desktop, as far as it speaks one of the others;
/// otherwise it is English. Names of commands, files and streams, logs, and what is printed are English in
/// any case.
enum class Language { kSystem, kEnglish, kGerman };

/// The inverse of nameOf(); kSystem for unknown names.
Language languageFromName(const QString& name);
/// The name in settings and commands: "system", "en", "de".
QString nameOf(Language language);

/// The language that was saved in the window's file (window.json); kSystem if there is none. It is read
/// before the window exists, whose texts are in it.
Language savedLanguage(const std::filesystem::path& windowFile);

/// Returns the language that kSystem means: English or German, by the user's preference. `preferred` are
/// names of languages in the order of preference, as QLocale::uiLanguages() has them: "de-AT", "en".
Language preferredLanguage(const QStringList& preferred);

/// Lets numbers read and write the same in all languages: with a point, as files and scripts have them.
/// Affects the whole process of the operating system; called once, after the QApplication was created.
void useNumbersWithPoints();

/// The texts of the application in one language, while this exists: ours, and those of Qt's own dialogs.
/// Widgets that were created before keep the texts that they have. GUI thread; outlived by the application.
class Translation {
 public:
  /// If files are missing, their texts are in English.
  explicit Translation(Language language);
  ~Translation();
  Translation(const Translation&) = delete;
  Translation& operator=(const Translation&) = delete;

  /// Empty, or which file could not be used.
  const QString& problem() const { return problem_; }

 private:
  QTranslator own_, qt_;
  QString problem_;
};

}  // namespace app
