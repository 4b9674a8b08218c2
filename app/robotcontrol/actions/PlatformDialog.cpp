// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/PlatformDialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "app/robotcontrol/actions/FieldEditor.h"
#include "app/robotcontrol/actions/FormFields.h"
#include "app/robotcontrol/actions/FormMemory.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/TypedStreams.h"
#include "widgets/drive/LinkWords.h"

namespace app {
namespace {

using widgets::Meaning;

PlatformField::Items itemsOf(const QStringList& texts) {
  PlatformField::Items items;
  for (const QString& text : texts) items.push_back({text.toStdString(), text.toStdString()});
  return items;
}

/// The text of the first field that says what is opened.
QString sourceIn(const PlatformForm& form, const FormValues& values) {
  for (const PlatformField& field : form.fields) {
    if (field.isSource) return QString::fromStdString(textOf(values, field.name));
  }
  return {};
}

}  // namespace

PlatformDialog::PlatformDialog(PlatformForm form, robotlink::Session& session,
                               robotlink::CommandTable& commands, FormMemory& memory, QWidget* parent)
    : QDialog(parent), form_(std::move(form)), session_(session), commands_(commands), memory_(memory) {
  const QString name = QString::fromStdString(form_.name);
  setObjectName(name + QStringLiteral("Dialog"));
  setWindowTitle(formText(form_.title));
  setWindowIcon(widgets::icon(form_.icon.c_str()));
  auto* layout = new QVBoxLayout(this);
  fields_ = new FormFields(form_, *layout, this);
  hint_ = new QLabel(this);
  hint_->setObjectName(name + QStringLiteral("State"));
  hint_->setWordWrap(true);
  hint_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  hint_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  layout->addWidget(hint_);
  if (form_.connects) createProgress();
  createButtons();
  setMinimumWidth(fontMetrics().averageCharWidth() * 64);
  connect(fields_, &FormFields::changed, this, &PlatformDialog::follow);
  for (const PlatformField& field : form_.fields) {
    if (field.recent) fields_->setItems(field.name, itemsOf(memory_.recent(field)));
  }
  fillIn();
  follow({});
  if (form_.connects) showState(tr("A lost line is reopened automatically."), false, false);
}

void PlatformDialog::fillIn() {
  const FormValues last = memory_.valuesOf(form_);
  state_.values = initialValues(form_);
  for (const PlatformField& field : form_.fields) {
    if (!field.isSource) continue;
    // Values that were never chosen are derived from the source that is opened.
    if (const auto value = last.find(field.name); value != last.end())
      state_.values[field.name] = value->second;
    if (form_.follow) form_.follow(state_, field.name);
  }
  for (const auto& [name, value] : last) state_.values[name] = value;
  fields_->show(state_);
}

void PlatformDialog::createButtons() {
  const QString name = QString::fromStdString(form_.name);
  buttons_ = new QDialogButtonBox(this);
  accept_ = buttons_->addButton(formText(form_.accept),
                                form_.connects ? QDialogButtonBox::ActionRole : QDialogButtonBox::AcceptRole);
  accept_->setObjectName(name + QStringLiteral("Button"));
  accept_->setToolTip(formText(form_.entryHelp));
  accept_->setIcon(widgets::icon(form_.icon.c_str()));
  accept_->setDefault(true);
  if (form_.connects) {
    connectNow_ = buttons_->addButton(tr("Connect &now"), QDialogButtonBox::ActionRole);
    connectNow_->setObjectName(name + QStringLiteral("Now"));
    connectNow_->setToolTip(tr("Tries again at once, instead of after the pause"));
    connectNow_->setVisible(false);
    connect(connectNow_, &QPushButton::clicked, this, &PlatformDialog::connectNow);
  }
  buttons_->addButton(form_.connects ? QDialogButtonBox::Close : QDialogButtonBox::Cancel);
  connect(accept_, &QPushButton::clicked, this, &PlatformDialog::acceptChoices);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout()->addWidget(buttons_);
}

void PlatformDialog::createProgress() {
  progress_ = new QProgressBar(this);
  progress_->setObjectName(QString::fromStdString(form_.name) + QStringLiteral("Progress"));
  progress_->setRange(0, 0);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(8);
  QSizePolicy keepsPlace = progress_->sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(keepsPlace);
  layout()->addWidget(progress_);
}

void PlatformDialog::showEvent(QShowEvent* event) {
  fields_->listAgain();
  QDialog::showEvent(event);
}

void PlatformDialog::follow(const QString& changed) {
  for (auto& [name, value] : fields_->values()) state_.values[name] = value;
  state_.disabled.clear();
  state_.hidden.clear();
  state_.notes.clear();
  state_.hint.clear();
  state_.complete = true;
  if (form_.follow) form_.follow(state_, changed.toStdString());
  fields_->show(state_);
  if (!form_.connects) hint_->setText(formText(state_.hint));
  enable();
}

void PlatformDialog::enable() {
  accept_->setEnabled(state_.complete && wanted_.isEmpty());
}

std::vector<FormValue> PlatformDialog::arguments() const {
  std::vector<FormValue> arguments;
  for (const PlatformField* field : form_.arguments()) {
    const auto value = state_.values.find(field->name);
    arguments.push_back(value != state_.values.end() ? value->second : field->initial);
  }
  return arguments;
}

void PlatformDialog::acceptChoices() {
  if (form_.normalize) form_.normalize(state_.values);
  memory_.remember(form_, state_.values);
  if (form_.connects) return connectRobot();
  accept();
}

void PlatformDialog::connectRobot() {
  wanted_ = sourceIn(form_, state_.values);
  for (const PlatformField& field : form_.fields) {
    if (field.recent) fields_->setItems(field.name, itemsOf(memory_.recent(field)));
  }
  const auto done = commands_.run(form_.command, arguments());
  if (!done) return fail(QString::fromStdString(done.error().text));
  enable();
  showState(tr("Opening %1…").arg(wanted_), false, true);
}

void PlatformDialog::connectNow() {
  if (const auto done = commands_.run("robot.connect-now"); !done)
    showState(QString::fromStdString(done.error().text), true, true);
}

void PlatformDialog::fail(const QString& reason) {
  if (wanted_.isEmpty()) return;
  wanted_.clear();
  showState(reason, true, false);
  enable();
}

void PlatformDialog::tick() {
  if (wanted_.isEmpty()) return;
  for (const std::string& robot : session_.robots())
    subscription_.want(session_, robot, {robotlink::kLinkStatus.name});
  for (const auto* message :
       widgets::latestOfType(session_.store(), {}, "robotcontrol.LinkStatus", session_.timeline().newest())) {
    const auto* status =
        message == nullptr ? nullptr : dynamic_cast<const robotcontrol::LinkStatus*>(message->value.get());
    if (status == nullptr || QString::fromStdString(status->address()) != wanted_) continue;
    const widgets::LinkWords words = widgets::linkWords(*status, 0);
    const QString text = QString::fromStdString(status->text());
    if (status->state() == robotcontrol::LinkStatus::CONNECTED) {
      const QString address = std::exchange(wanted_, QString());
      showState(tr("Connected to %1.").arg(words.robot.isEmpty() ? address : words.robot), false, false);
      enable();
      accept();
      Q_EMIT connected(address);
      return;
    }
    showState(text.isEmpty() ? words.state : text, words.meaning == Meaning::kBad, true);
    return connectNow_->setVisible(status->state() == robotcontrol::LinkStatus::LOST);
  }
}

void PlatformDialog::showState(const QString& text, bool bad, bool busy) {
  hint_->setText(text);
  connectNow_->setVisible(false);
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, widgets::colorOf(bad ? Meaning::kBad : Meaning::kMuted, colors));
  hint_->setPalette(colors);
  progress_->setVisible(busy);
}

}  // namespace app
