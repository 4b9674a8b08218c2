// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/LayoutPrograms.h"

#include <algorithm>
#include <map>

#include "robotlink/base/Spelling.h"
#include "robotlink/process/Layout.h"

namespace robotlink {
namespace {

using Program = Layout::Program;

std::string lineOf(const FilePosition& where) {
  return "line " + std::to_string(where.line);
}

class ProgramChecker {
 public:
  explicit ProgramChecker(const Layout& layout) : layout_(layout) {}

  Errors check() {
    for (const Program& program : layout_.programs) checkProgram(program);
    if (!layout_.programs.empty()) {
      checkHosts();
      checkAllRun();
    }
    return std::move(errors_);
  }

 private:
  void add(const FilePosition& where, const char* id, std::string text, std::vector<std::string> arguments) {
    errors_.push_back({std::string("layout.") + id, std::move(text), std::move(arguments), where});
  }
  void checkProgram(const Program& program);
  void checkPart(const Program& program, const Program::Part& part);
  void checkHosts();
  void checkAllRun();

  const Layout& layout_;
  /// The first program of each process.
  std::map<std::string, const Program*> runBy_;
  Errors errors_;
};

void ProgramChecker::checkProgram(const Program& program) {
  for (const Program& other : layout_.programs) {
    if (&other == &program) break;
    if (other.name != program.name) continue;
    add(program.where, "program-twice",
        "there is a program " + program.name + " already, in " + lineOf(other.where) + "; rename one of them",
        {program.name});
    break;
  }
  if (program.processes.empty()) {
    add(program.where, "program-empty",
        "program " + program.name + " runs no process; give it one or remove it", {program.name});
  }
  for (const Program::Part& part : program.processes) checkPart(program, part);
}

void ProgramChecker::checkPart(const Program& program, const Program::Part& part) {
  const auto& all = layout_.processes;
  const bool isKnown = std::any_of(
      all.begin(), all.end(), [&](const Layout::Process& process) { return process.name == part.process; });
  if (!isKnown) {
    std::vector<std::string> names;
    for (const Layout::Process& process : all) names.push_back(process.name);
    return add(part.where, "program-unknown-process",
               "there is no process '" + part.process + "' that program " + program.name + " could run" +
                   suggestion(part.process, names),
               {part.process, program.name});
  }
  const auto [first, isFirst] = runBy_.emplace(part.process, &program);
  if (isFirst) return;
  add(part.where, "program-process-twice",
      "process " + part.process + " is run by program " + first->second->name + " already (" +
          lineOf(first->second->where) + "); remove it from one of them",
      {part.process, first->second->name});
}

void ProgramChecker::checkHosts() {
  const auto& all = layout_.programs;
  const auto isNamed = [](const Program& program) { return !program.host.empty(); };
  if (std::none_of(all.begin(), all.end(), isNamed)) return;
  for (const Program& program : all) {
    if (isNamed(program)) continue;
    add(program.where, "program-host",
        "program " + program.name +
            " has no host, but others have; name all hosts, or none if all run on one machine",
        {program.name});
  }
}

void ProgramChecker::checkAllRun() {
  for (const Layout::Process& process : layout_.processes) {
    if (runBy_.contains(process.name)) continue;
    add(process.where, "program-missing",
        "process " + process.name + " is run by no program; add it to one of those under 'programs'",
        {process.name});
  }
}

}  // namespace

Errors checkPrograms(const Layout& layout) {
  return ProgramChecker(layout).check();
}

std::set<std::string> commandingProcesses(const std::vector<LayoutLink>& links) {
  std::set<std::string> commanding;
  const auto addSenders = [&] {
    const std::size_t before = commanding.size();
    for (const LayoutLink& link : links) {
      const bool isTaken = link.to.empty() || commanding.contains(link.to);
      if (isTaken && !link.from.empty()) commanding.insert(link.from);
    }
    return commanding.size() > before;
  };
  while (addSenders()) {
  }
  return commanding;
}

const Layout::Program* Layout::programOf(const std::string& process) const {
  for (const Program& program : programs) {
    for (const Program::Part& part : program.processes) {
      if (part.process == process) return &program;
    }
  }
  return nullptr;
}

const Layout::Program* Layout::findProgram(const std::string& program) const {
  const auto found =
      std::find_if(programs.begin(), programs.end(), [&](const Program& one) { return one.name == program; });
  return found == programs.end() ? nullptr : &*found;
}

const Layout::Program* Layout::mainProgram() const {
  for (const Process& process : processes) {
    if (process.debug) return programOf(process.name);
  }
  return nullptr;
}

}  // namespace robotlink
