// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/InsideProgram.h"

#include "app/core/program/HostedRobot.h"
#include "robotlink/debugging/program/RequestPreview.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {
namespace {

class InsidePreview final : public ProgramPreview {
 public:
  explicit InsidePreview(robotlink::RobotProgram& program) : preview_(program) {}
  std::string add(const robotcontrol::Request& request) override { return preview_.add(request); }
  bool answer(const robotcontrol::Request& request) override { return preview_.answer(request); }
  std::shared_ptr<const robotlink::SharedDebugQueue> takeQueue(robotlink::Instant now) override {
    return preview_.takeQueue(now);
  }

 private:
  robotlink::RequestPreview preview_;
};

}  // namespace

InsideProgram::InsideProgram(std::unique_ptr<robotlink::RobotProgram> program)
    : program_(std::move(program)) {}

InsideProgram::~InsideProgram() = default;

HostedProgram::Made InsideProgram::create(Parts parts, const robotlink::RobotProgram::Part& part) {
  const HostedRobot& robot = parts.robot;
  const robotlink::RobotSetup setup{robot.name, robot.team, *robot.description, robot.field, robot.map};
  auto program =
      robotlink::RobotProgram::create(setup, std::move(parts.layout), parts.platform, parts.parameters, part);
  if (!program) return tl::unexpected(program.error());
  return std::unique_ptr<HostedProgram>(new InsideProgram(std::move(*program)));
}

void InsideProgram::setListeners(Listeners listeners) {
  program_->debugProcess().setListener(std::move(listeners.queue));
}

std::vector<robotcontrol::ParameterValues> InsideProgram::parameters() const {
  return program_->parameters();
}

void InsideProgram::recordPackages(const std::set<std::string>& packages) {
  program_->recordPackages(packages);
}

void InsideProgram::setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes) {
  program_->setKeys(modes);
}

const robotlink::Layout& InsideProgram::layout() const {
  return program_->layout();
}

std::vector<std::string> InsideProgram::yieldedPackages() const {
  return program_->yieldedPackages();
}

const std::vector<robotlink::Process*>& InsideProgram::processes() const {
  return program_->processes();
}

const robotlink::Process& InsideProgram::debugProcess() const {
  return program_->debugProcess();
}

void InsideProgram::offer(const robotlink::PackagePtr& package) {
  program_->debugProcess().offer(package);
}

void InsideProgram::tap(const std::set<std::string>& packages, PackageTap tap) {
  for (const robotlink::Process* process : program_->processes()) {
    for (robotlink::AnySender* sender : process->senders()) {
      if (!packages.contains(sender->package())) continue;
      sender->addTap(
          [tap, name = sender->package()](const robotlink::PackagePtr& value) { tap(name, value); });
    }
  }
}

bool InsideProgram::request(const robotcontrol::Request& request) {
  return program_->debugProcess().request(request);
}

std::unique_ptr<ProgramPreview> InsideProgram::preview() {
  return std::make_unique<InsidePreview>(*program_);
}

std::string InsideProgram::missingProcess() const {
  return program_->missingProcess();
}

void InsideProgram::stop() {
  program_->stop();
}

}  // namespace app
