// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/View.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QSplitter>
#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/base/Registrations.h"
#include "widgets/HeaderState.h"
#include "widgets/ShownText.h"
#include "widgets/SplitterState.h"
#include "widgets/WrittenPicture.h"

namespace widgets {
namespace {

robotlink::Registry<ViewType>& registeredViews() {
  static robotlink::Registry<ViewType> types;
  return types;
}

}  // namespace

View::View(ViewContext& context, QWidget* parent) : QWidget(parent), context_(context) {}

/// Otherwise a field with the focus would report that it was edited while the derived parts of the view are
/// destroyed already.
View::~View() {
  for (QObject* child : findChildren<QObject*>()) child->disconnect(this);
}

QJsonObject View::saveState() const {
  QJsonObject state;
  for (const Kept& kept : kept_) state.insert(kept.name, kept.save());
  return state;
}

void View::restoreState(const QJsonObject& state) {
  for (const Kept& kept : kept_) kept.restore(state.value(kept.name));
}

robotlink::Result<void> View::saveTo(const QString& file) {
  const std::string path = file.toStdString(), suffix = robotlink::fileSuffix(path);
  if (suffix == ".svg") return writeVectorPicture(*this, file);
  if (suffix != ".csv" && suffix != ".txt" && suffix != ".tsv") return writePicture(grab().toImage(), file);
  auto shown = suffix == ".csv" ? shownTable(*this) : suffix == ".txt" ? shownText(*this) : std::nullopt;
  if (!shown) shown = numbers();
  if (!shown)
    return robotlink::failure("view.save", "this view shows no table and no text; save it as .png or .svg",
                              {path, 0, 0});
  if (suffix == ".csv" && !shownTable(*this)) shown = csvOfTabs(*shown);
  return robotlink::writeFileAtomically(path, shown->toStdString());
}

std::optional<QString> View::numbers() {
  if (auto table = shownNumbers(*this)) return table;
  if (auto text = shownText(*this)) return text;
  if (auto values = shownValues(*this)) return values;
  // A table that is hidden as long as it has no rows.
  return findChild<QAbstractItemView*>() != nullptr ? std::optional(QString()) : std::nullopt;
}

QImage View::shownPicture() {
  return grab().toImage();
}

void View::followNames(const Renamed& renamed) {
  for (const Kept& kept : kept_) {
    if (kept.names == Names::kNone) continue;
    const QJsonValue before = kept.save(), now = renamed(before);
    if (now != before) kept.restore(now);
  }
}

void View::keep(const char* name, Save save, Restore restore, Names names) {
  kept_.push_back({QString::fromLatin1(name), std::move(save), std::move(restore), names});
}

void View::keep(const char* name, QAction* toggle) {
  keep(
      name, [toggle] { return QJsonValue(toggle->isChecked()); },
      [toggle, usual = toggle->isChecked()](const QJsonValue& value) {
        toggle->setChecked(value.toBool(usual));
      });
}

void View::keep(const char* name, QLineEdit* text, Names names) {
  keep(
      name, [text] { return QJsonValue(text->text()); },
      [text](const QJsonValue& value) { text->setText(value.toString()); }, names);
}

void View::keep(const char* name, QComboBox* choice) {
  keep(
      name, [choice] { return QJsonValue(choice->currentIndex()); },
      [choice, usual = choice->currentIndex()](const QJsonValue& value) {
        choice->setCurrentIndex(std::clamp(value.toInt(usual), 0, choice->count() - 1));
      });
}

void View::keep(const char* name, QSplitter* splitter) {
  keep(
      name, [splitter] { return splitterState(*splitter); },
      [splitter](const QJsonValue& value) { restoreSplitter(*splitter, value); });
}

void View::keep(const char* name, QHeaderView* columns) {
  keep(
      name, [columns] { return headerState(*columns); },
      [columns](const QJsonValue& value) { restoreHeader(*columns, value); });
}

const std::vector<ViewType>& ViewRegistry::all() {
  return registeredViews().all();
}

const ViewType* ViewRegistry::find(const std::string& id) {
  const auto& types = all();
  const auto found = std::find_if(types.begin(), types.end(), [&](const ViewType& t) { return id == t.id; });
  return found == types.end() ? nullptr : &*found;
}

ViewRegistration::ViewRegistration(ViewType type) {
  const std::string name = std::string("view \"") + type.id + "\"";
  const bool isNew = ViewRegistry::find(type.id) == nullptr;
  registeredViews().add(std::move(type), name,
                        isNew ? "" : "registered twice; identifiers of views are unique");
}

}  // namespace widgets
