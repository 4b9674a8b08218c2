// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/SimulationSetupDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/Workbench.h"
#include "simcore/SceneFileKind.h"
#include "widgets/Icon.h"

namespace app {
namespace {

constexpr int kMaxRobots = 100;

/// The element of `last` at an index, if it has this type, otherwise the default.
template <typename T>
T last(const SimulationSetupDialog::Arguments& arguments, std::size_t index, T fallback) {
  if (index >= arguments.size()) return fallback;
  const T* value = std::get_if<T>(&arguments[index]);
  return value != nullptr ? *value : fallback;
}

/// The model of the robots in a scene, found in its text; empty: none.
QString kindIn(const QString& scene) {
  QFile file(QString::fromStdString(Workbench::sceneNamed(scene.trimmed().toStdString()).string()));
  constexpr qint64 kEnough = 1 << 20;
  if (!QFileInfo(file).isFile() || !file.open(QIODevice::ReadOnly)) return {};
  const QByteArray text = file.read(kEnough);
  for (const auto& robot : Workbench::simulatedRobots()) {
    if (text.contains("model://" + QByteArray::fromStdString(robot.name) + "<"))
      return QString::fromStdString(robot.name);
  }
  return {};
}

}  // namespace

SimulationSetupDialog::SimulationSetupDialog(const Arguments& last, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("simulationSetup"));
  setWindowTitle(tr("Simulate"));
  new QVBoxLayout(this);
  createWorld();
  createRobots();
  createPorts();
  hint_ = new QLabel(this);
  hint_->setObjectName(QStringLiteral("setupHint"));
  hint_->setWordWrap(true);
  layout()->addWidget(hint_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  layout()->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  restore(last);
  update();
}

void SimulationSetupDialog::createWorld() {
  auto* group = new QGroupBox(tr("World"), this);
  auto* row = new QHBoxLayout(group);
  scene_ = new QComboBox(group);
  scene_->setObjectName(QStringLiteral("setupScene"));
  scene_->setAccessibleName(tr("Scene or map"));
  scene_->setEditable(true);
  scene_->setInsertPolicy(QComboBox::NoInsert);
  scene_->setMinimumContentsLength(44);
  scene_->setToolTip(
      tr("A shipped scene by its name, or a file: an SDFormat world, or the map of a building (.map)"));
  for (const auto& file : Workbench::scenes()) scene_->addItem(QString::fromStdString(file.stem().string()));
  auto* browse = new QToolButton(group);
  browse->setObjectName(QStringLiteral("setupBrowse"));
  browse->setIcon(widgets::icon("open"));
  browse->setToolTip(tr("Choose a file"));
  row->addWidget(scene_, 1);
  row->addWidget(browse);
  layout()->addWidget(group);
  connect(browse, &QToolButton::clicked, this, &SimulationSetupDialog::chooseFile);
  connect(scene_, &QComboBox::currentTextChanged, this, &SimulationSetupDialog::followScene);
}

void SimulationSetupDialog::createRobots() {
  auto* group = new QGroupBox(tr("Robots"), this);
  auto* form = new QFormLayout(group);
  kind_ = new QComboBox(group);
  kind_->setObjectName(QStringLiteral("setupKind"));
  for (const auto& robot : Workbench::simulatedRobots())
    kind_->addItem(QString::fromStdString(robot.title), QString::fromStdString(robot.name));
  kind_->setCurrentIndex(std::max(0, kind_->findData(QString::fromStdString(simcore::RobotsToAdd{}.model))));
  kind_->setToolTip(tr("Kind of the robots to add to the world"));
  robots_ = new QSpinBox(group);
  robots_->setObjectName(QStringLiteral("setupRobots"));
  robots_->setRange(0, kMaxRobots);
  robots_->setSpecialValueText(tr("none"));
  robots_->setToolTip(
      tr("Placed at the map's home or the kick-off positions first, then where there is room"));
  teams_ = new QComboBox(group);
  teams_->setObjectName(QStringLiteral("setupTeams"));
  teams_->addItem(tr("Both, as many in each"), QStringLiteral("both"));
  teams_->addItem(tr("Red"), QStringLiteral("red"));
  teams_->addItem(tr("Blue"), QStringLiteral("blue"));
  teams_->setToolTip(tr("Team of the added robots; red plays toward the sky-blue goal"));
  kinematic_ = new QCheckBox(tr("Moved by their odometry, without forces"), group);
  kinematic_->setObjectName(QStringLiteral("setupKinematic"));
  kinematic_->setToolTip(tr("Faster with many robots: nothing slips, and obstacles stop them"));
  form->addRow(tr("Kind:"), kind_);
  form->addRow(tr("Add:"), robots_);
  form->addRow(tr("Teams:"), teams_);
  form->addRow(QString(), kinematic_);
  layout()->addWidget(group);
  connect(robots_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this] { update(); });
  connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { update(); });
}

void SimulationSetupDialog::createPorts() {
  auto* group = new QGroupBox(tr("External programs"), this);
  auto* form = new QFormLayout(group);
  ports_ = new QCheckBox(tr("Can drive the robots over ARCOS"), group);
  ports_->setObjectName(QStringLiteral("setupPorts"));
  ports_->setToolTip(
      tr("Each robot with an ARCOS microcontroller gets a TCP port; a program connected there drives it "
         "instead of the one here"));
  port_ = new QSpinBox(group);
  port_->setObjectName(QStringLiteral("setupPort"));
  port_->setRange(1024, 65535 - kMaxRobots);
  port_->setValue(8101);
  port_->setToolTip(tr("Port of the first robot; the next robot has the next one"));
  network_ = new QCheckBox(tr("From other computers, too"), group);
  network_->setObjectName(QStringLiteral("setupNetwork"));
  network_->setToolTip(
      tr("Anyone who can reach this computer can then drive the robots: ARCOS has no password"));
  form->addRow(ports_);
  form->addRow(tr("First port:"), port_);
  form->addRow(QString(), network_);
  layout()->addWidget(group);
  connect(ports_, &QCheckBox::toggled, this, [this] { update(); });
  connect(network_, &QCheckBox::toggled, this, [this] { update(); });
}

void SimulationSetupDialog::restore(const Arguments& arguments) {
  const auto scene = last<std::string>(arguments, 0, {});
  if (!scene.empty()) scene_->setEditText(QString::fromStdString(scene));
  followScene();
  const int kind = kind_->findData(QString::fromStdString(last<std::string>(arguments, 1, {})));
  if (kind >= 0) kind_->setCurrentIndex(kind);
  robots_->setValue(static_cast<int>(last<double>(arguments, 2, 0)));
  teams_->setCurrentIndex(
      std::max(0, teams_->findData(QString::fromStdString(last<std::string>(arguments, 6, {})))));
  kinematic_->setChecked(last<bool>(arguments, 3, false));
  const int port = static_cast<int>(last<double>(arguments, 4, 0));
  ports_->setChecked(port > 0);
  if (port > 0) port_->setValue(port);
  network_->setChecked(last<bool>(arguments, 5, false));
}

void SimulationSetupDialog::chooseFile() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open scene or map"), QFileInfo(scene_->currentText()).path(),
                                   tr("Worlds and maps (*.sdf *.world *.map);;All files (*)"));
  if (file.isEmpty()) return;
  scene_->setEditText(file);
  if (simcore::isMapFile(file.toStdString()) && robots_->value() == 0) robots_->setValue(1);
}

/// The default is to add robots of the kind that the scene contains.
void SimulationSetupDialog::followScene() {
  const int kind = kind_ != nullptr
                       ? kind_->findData(simcore::isMapFile(scene_->currentText().toStdString())
                                             ? QString::fromStdString(simcore::RobotsToAdd{}.model)
                                             : kindIn(scene_->currentText()))
                       : -1;
  if (kind >= 0) kind_->setCurrentIndex(kind);
  update();
}

void SimulationSetupDialog::update() {
  const bool adds = robots_->value() > 0;
  const std::string kind = kind_->currentData().toString().toStdString();
  const auto robots = Workbench::simulatedRobots();
  const bool plays = std::any_of(robots.begin(), robots.end(),
                                 [&](const auto& robot) { return robot.name == kind && robot.plays; });
  kind_->setEnabled(adds);
  teams_->setEnabled(adds && plays);
  port_->setEnabled(ports_->isChecked());
  network_->setEnabled(ports_->isChecked());
  buttons_->button(QDialogButtonBox::Open)->setEnabled(!scene_->currentText().trimmed().isEmpty());
  QString text;
  if (simcore::isMapFile(scene_->currentText().toStdString()) && !adds)
    text = tr("A map has no robots of its own: there will be none.");
  if (ports_->isChecked() && network_->isChecked()) {
    text = tr("Anyone who can reach this computer over the network will be able to drive these robots.");
  }
  hint_->setText(text);
}

QJsonArray SimulationSetupDialog::toJson(const Arguments& arguments) {
  QJsonArray array;
  for (const auto& value : arguments) {
    if (const auto* flag = std::get_if<bool>(&value)) array.append(*flag);
    if (const auto* number = std::get_if<double>(&value)) array.append(*number);
    if (const auto* text = std::get_if<std::string>(&value)) array.append(QString::fromStdString(*text));
  }
  return array;
}

SimulationSetupDialog::Arguments SimulationSetupDialog::fromJson(const QJsonArray& array) {
  Arguments arguments;
  for (const QJsonValue& value : array) {
    if (value.isBool()) arguments.emplace_back(value.toBool());
    if (value.isDouble()) arguments.emplace_back(value.toDouble());
    if (value.isString()) arguments.emplace_back(value.toString().toStdString());
  }
  return arguments;
}

SimulationSetupDialog::Arguments SimulationSetupDialog::arguments() const {
  return {scene_->currentText().trimmed().toStdString(),
          kind_->currentData().toString().toStdString(),
          static_cast<double>(robots_->value()),
          kinematic_->isChecked(),
          ports_->isChecked() ? static_cast<double>(port_->value()) : 0.0,
          ports_->isChecked() && network_->isChecked(),
          teams_->currentData().toString().toStdString()};
}

}  // namespace app
