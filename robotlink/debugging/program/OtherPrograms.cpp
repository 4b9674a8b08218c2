// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/OtherPrograms.h"

#include <algorithm>
#include <utility>

#include "robotlink/debugging/ProcessChannel.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/program/ProcessTable.h"

namespace robotlink {

using robotcontrol::ProcessTable;
using robotcontrol::Request;

namespace {

/// Ids of requests that are repeated here; ProgramRequests has others.
constexpr std::uint64_t kIdsHere = kRepeatedIds | (std::uint64_t{1} << 62U);

}  // namespace

void OtherPrograms::add(const std::string& program, std::vector<ProcessChannel*> channels,
                        Questions questions, const std::set<std::string>& commanding) {
  Program& added = programs_.emplace_back();
  added.name = program;
  added.table =
      std::make_unique<Receiver<ProcessTable>>(debugProcess_, "debug/processes/" + program, Blocking::kNo);
  for (ProcessChannel* channel : channels) {
    const std::string& process = channel->process();
    Seat& seat = added.seats.emplace_back();
    seat.channel = channel;
    seat.questions = std::move(questions[process]);
    seat.isCommanding = commanding.contains(process);
  }
}

bool OtherPrograms::isConnected(const Program& program) {
  return program.table->connected() &&
         std::ranges::all_of(program.seats, [](const Seat& seat) { return seat.channel->connected(); });
}

bool OtherPrograms::isCommanding(const Program& program) {
  return std::ranges::any_of(program.seats, &Seat::isCommanding);
}

std::string OtherPrograms::missingProcess() const {
  for (const Program& program : programs_) {
    for (const Seat& seat : program.seats) {
      if (seat.isCommanding && (seat.isStuck || !seat.channel->connected())) return seat.channel->process();
    }
  }
  return {};
}

std::vector<std::string> OtherPrograms::update() {
  std::vector<std::string> news;
  for (Program& program : programs_) {
    for (Seat& seat : program.seats) {
      if (seat.channel->connected() && seat.generation != seat.channel->generation()) askAgain(seat);
    }
    // A process that was stopped closes its links, but its program still runs.
    const bool running = program.running ? program.table->connected() : isConnected(program);
    const bool isAnother = program.generation != program.table->generation();
    if (running && (!program.running || isAnother)) {
      news.push_back("Program " + program.name + (program.ranBefore ? " runs again." : " runs."));
      program.ranBefore = true;
      program.generation = program.table->generation();
    } else if (!running && program.running) {
      news.push_back("Program " + program.name +
                     " is no longer running, or its machine cannot be reached. The others continue" +
                     (isCommanding(program) ? ", but the robot stays stopped until it is back" : "") +
                     "; restart it.");
    }
    program.running = running;
    for (Seat& seat : program.seats) {
      if (std::string text = followStuck(program, seat); !text.empty()) news.push_back(std::move(text));
    }
  }
  return news;
}

std::string OtherPrograms::followStuck(const Program& program, Seat& seat) {
  const auto* row = program.running ? rowOf(program, seat.channel->process()) : nullptr;
  const bool isStuck = row != nullptr && row->state().starts_with(kDoesNotReturn);
  if (seat.isStuck.exchange(isStuck) == isStuck || row == nullptr) return {};
  const std::string who = "Process " + row->name() + " of program " + program.name;
  if (!isStuck) return who + " has returned and continues.";
  return who + " " + row->state() + "." +
         (seat.isCommanding ? " The robot stays stopped until it returns or its program is restarted." : "");
}

/// A program that was started again, or that was out of reach, gets all requests that still matter.
void OtherPrograms::askAgain(Seat& seat) {
  seat.generation = seat.channel->generation();
  seat.channel->restart();
  Request tables;
  tables.mutable_send_tables();
  for (auto* requests : {&seat.questions, &seat.remembered}) {
    for (Request& request : *requests) {
      request.set_id(kIdsHere | ++repeated_);
      seat.channel->add(request);
    }
  }
  tables.set_id(kIdsHere | ++repeated_);
  seat.channel->add(tables);
}

const OtherPrograms::Seat* OtherPrograms::seatOf(const Program& program, const std::string& process) {
  const auto found = std::ranges::find_if(
      program.seats, [&](const Seat& seat) { return seat.channel->process() == process; });
  return found == program.seats.end() ? nullptr : &*found;
}

std::string OtherPrograms::stateOf(const Program& program, const std::string& process) {
  const auto* row = rowOf(program, process);
  if (row != nullptr && row->state() != "running") return row->state();
  return seatOf(program, process)->channel->connected() ? "running" : "stopped";
}

bool OtherPrograms::runs(const std::string& process) const {
  return std::ranges::any_of(programs_,
                             [&](const Program& program) { return seatOf(program, process) != nullptr; });
}

std::string OtherPrograms::whyNot(const std::string& process) const {
  for (const Program& program : programs_) {
    if (seatOf(program, process) == nullptr) continue;
    if (!program.running)
      return "program " + program.name + ", which runs process " + process + ", does not run";
    const std::string state = stateOf(program, process);
    if (state == "running") return "";
    const bool isStuck = state.starts_with(kDoesNotReturn);
    return "process " + process + " of program " + program.name + (isStuck ? " " : " has ") + state;
  }
  return "";
}

bool OtherPrograms::remember(const std::string& process, const Request& request) {
  Seat* seat = nullptr;
  for (Program& program : programs_) {
    for (Seat& one : program.seats) {
      if (one.channel->process() == process) seat = &one;
    }
  }
  if (seat == nullptr) return false;
  if (!request.has_set_key() && !request.has_select_solution() && !request.has_set_parameters() &&
      !request.has_record_packages())
    return true;
  std::erase_if(seat->remembered, [&](const Request& other) {
    return setTheSame(other, request) || (other.has_record_packages() && request.has_record_packages());
  });
  seat->remembered.push_back(request);
  return true;
}

void OtherPrograms::rememberForAll(const Request& request) {
  for (const Program& program : programs_) {
    for (const Seat& seat : program.seats) remember(seat.channel->process(), request);
  }
}

const ProcessTable::Process* OtherPrograms::rowOf(const Program& program, const std::string& process) {
  const ProcessTable* table = program.table->get();
  if (table == nullptr) return nullptr;
  const auto found =
      std::ranges::find_if(table->processes(), [&](const auto& row) { return row.name() == process; });
  return found == table->processes().end() ? nullptr : &*found;
}

void OtherPrograms::fillProcesses(ProcessTable& to) const {
  for (const Program& program : programs_) {
    for (const Seat& seat : program.seats) {
      auto& row = *to.add_processes();
      if (const auto* known = rowOf(program, seat.channel->process())) row = *known;
      row.set_name(seat.channel->process());
      row.set_state(!program.running ? "stopped: program " + program.name + " does not run"
                                     : stateOf(program, seat.channel->process()));
      if (row.state() == "running") row.set_state("running in program " + program.name);
    }
  }
}

}  // namespace robotlink
