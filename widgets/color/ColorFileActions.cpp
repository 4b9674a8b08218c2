// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorFileActions.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenu>
#include <QMessageBox>
#include <QToolButton>

#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFiles.h"

namespace widgets {
namespace {

struct ColorFileText {
  Q_DECLARE_TR_FUNCTIONS(widgets::ColorFileActions)
};
QString sampleFiles() {
  return ColorFileText::tr("Samples of colors (*.samples);;All files (*)");
}
QString tableFiles() {
  return ColorFileText::tr("Color tables (*.c64)");
}
QString anyTables() {
  return ColorFileText::tr("Color tables (*.c64 *.tm *.raw *.cal *.lut *.bz2);;All files (*)");
}

/// Asks for a file to write, in the last folder; empty: canceled.
std::filesystem::path fileToWrite(const ColorFiles& files, QWidget* parent, const QString& title,
                                  const QString& filter, const QString& suffix) {
  QFileDialog dialog(parent, title, files.folder(), filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  if (!files.file().empty())
    dialog.selectFile(QString::fromStdString(files.file().stem().string()) + QLatin1Char('.') + suffix);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
  return dialog.selectedFiles().first().toStdString();
}

/// Reports a failure by the bench's failed(). True: success.
bool report(const ColorFiles& files, const robotlink::Result<void>& done) {
  if (!done) Q_EMIT files.bench().failed(QString::fromStdString(done.error().describe()));
  return done.has_value();
}

bool saveTo(ColorFiles& files, const std::filesystem::path& file) {
  return !file.empty() && report(files, files.saveAs(file));
}

bool askAndSave(ColorFiles& files, QWidget* parent) {
  return saveTo(files, fileToWrite(files, parent, ColorFileText::tr("Save samples"), sampleFiles(),
                                   QStringLiteral("samples")));
}

}  // namespace

bool saveSamples(ColorFiles& files, QWidget* parent) {
  return files.file().empty() ? askAndSave(files, parent) : saveTo(files, files.file());
}

bool mayLoseSamples(ColorFiles& files, QWidget* parent) {
  if (!files.changed()) return true;
  QMessageBox box(
      QMessageBox::Warning, ColorFileText::tr("Color samples"),
      files.file().empty()
          ? ColorFileText::tr("The samples of the new color table were not saved yet.")
          : ColorFileText::tr("The samples in %1 were changed and not saved.").arg(files.title().chopped(1)),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
  box.setObjectName(QStringLiteral("unsavedSamples"));
  box.setInformativeText(ColorFileText::tr("Save them?"));
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return saveSamples(files, parent);
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

ColorFileActions::ColorFileActions(ColorFiles& files, QWidget* view)
    : QObject(view), files_(files), view_(view) {
  createActions();
  connectSignals();
}

void ColorFileActions::createActions() {
  new_ = makeAction(view_, "file-new",
                    {"colorNew", tr("New"), tr("Starts new samples, with the classes of 2002")});
  open_ = makeAction(view_, "open", {"colorOpen", tr("Open…"), tr("Opens samples from a file")});
  save_ = makeAction(view_, "save",
                     {"colorSave", tr("Save"), tr("Saves the samples to their file"), QKeySequence::Save});
  menu_ = new QMenu(tr("Files"), view_);
  menu_->setObjectName(QStringLiteral("colorFileMenu"));
  menu_->setToolTipsVisible(true);
}

void ColorFileActions::connectSignals() {
  connect(new_, &QAction::triggered, this, &ColorFileActions::startAnew);
  connect(open_, &QAction::triggered, this, &ColorFileActions::open);
  connect(save_, &QAction::triggered, this, &ColorFileActions::save);
  const auto add = [this](const char* name, const char* iconName, const QString& text,
                          const QString& toolTip) {
    QAction* action = menu_->addAction(icon(iconName), text);
    action->setObjectName(QLatin1String(name));
    action->setToolTip(toolTip);
    return action;
  };
  connect(add("colorSaveAs", "save", tr("Save &as…"), tr("Saves the samples to another file")),
          &QAction::triggered, this, &ColorFileActions::saveAs);
  connect(add("colorMerge", "add", tr("&Merge samples…"), tr("Adds the samples of another file to these")),
          &QAction::triggered, this, &ColorFileActions::merge);
  menu_->addSeparator();
  connect(add("colorExport", "export", tr("&Export table…"),
              tr("Writes the table to a .c64 file, with the names of its classes in a file next to it")),
          &QAction::triggered, this, &ColorFileActions::exportTable);
  several_ = add("colorSeveral", "layers", tr("Exported cells may have &several classes"),
                 tr("Where classes are close, an exported cell belongs to all of them"));
  several_->setCheckable(true);
  menu_->addSeparator();
  connect(add("colorImport", "open", tr("&Compare with table…"),
              tr("Reads a table to compare with; yours does not change")),
          &QAction::triggered, this, &ColorFileActions::importReference);
}

void ColorFileActions::addTo(QHBoxLayout* row) const {
  addButtons(row, {new_, open_, save_});
  auto* more = makeMenuButton(row->parentWidget(),
                              {"colorFiles", tr("More file actions"),
                               tr("Save as, merge, export the table, read a table to compare with")},
                              menu_);
  more->setText(tr("More"));
  row->addWidget(more);
}

void ColorFileActions::read(const QString& title, const QString& filter, const Use& use) {
  const QString file = QFileDialog::getOpenFileName(view_, title, files_.folder(), filter);
  if (!file.isEmpty()) report(files_, use(file.toStdString()));
}

void ColorFileActions::startAnew() {
  if (mayLoseSamples(files_, view_)) files_.startAnew();
}

void ColorFileActions::open() {
  if (!mayLoseSamples(files_, view_)) return;
  read(tr("Open samples"), sampleFiles(), [this](const auto& file) { return files_.open(file); });
}

void ColorFileActions::save() {
  saveSamples(files_, view_);
}

void ColorFileActions::saveAs() {
  askAndSave(files_, view_);
}

void ColorFileActions::merge() {
  read(tr("Merge samples"), sampleFiles(), [this](const auto& file) { return files_.merge(file); });
}

void ColorFileActions::exportTable() {
  const auto file = fileToWrite(files_, view_, tr("Export color table"), tableFiles(), QStringLiteral("c64"));
  if (!file.empty()) report(files_, files_.exportTable(file, several_->isChecked()));
}

void ColorFileActions::importReference() {
  read(tr("Compare with table"), anyTables(),
       [this](const auto& file) { return files_.importReference(file); });
}

}  // namespace widgets
