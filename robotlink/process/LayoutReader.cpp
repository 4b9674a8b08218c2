// SPDX-License-Identifier: GPL-3.0-or-later
// readLayout() and parseLayout() of Layout.h: the form of layout files.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "robotlink/config/YamlReader.h"
#include "robotlink/process/Layout.h"

namespace robotlink {
namespace {

constexpr int kVersion = 1;
constexpr double kMaxPeriodMs = 60'000;

bool isPlainName(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

/// Whether it can be the address or the name of a machine; whether there is one is seen when it is used.
bool isHost(const std::string& host) {
  return !host.empty() && std::all_of(host.begin(), host.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == ':';
  });
}

void checkName(const YamlNode& node, const std::string& name) {
  if (node.empty() || isPlainName(name)) return;
  node.fail("layout.name", "'" + name + "' is not a name: use lowercase letters, digits and '-'", {name});
}

Layout::Task readTask(const YamlNode& node) {
  Layout::Task task;
  task.where = node.where();
  const auto entries = node.entries();
  if (entries.size() == 1) {
    task.task = entries.front().first;
    task.solution = entries.front().second.as<std::string>();
  } else if (node.isMap()) {
    node.fail("layout.task-form", "each task is one line: '- task: solution'");
  }
  return task;
}

void readSchedule(const YamlNode& node, Layout::Process& process) {
  process.priority = node.optional("priority", 0);
  if (process.priority < -20 || process.priority > 19) {
    node.optionalChild("priority")
        .fail("layout.priority", "a priority is a nice value, -20 (most urgent) to 19");
  }
  const double periodMs = node.optional("period_ms", 0.0);
  if (periodMs < 0 || periodMs > kMaxPeriodMs) {
    node.optionalChild("period_ms").fail("layout.period", "a period is between 0 (none) and 60000 ms");
    return;
  }
  process.period = std::chrono::microseconds(std::llround(periodMs * 1000));
}

Layout::Process readProcess(const YamlNode& node) {
  Layout::Process process;
  process.where = node.where();
  process.name = node.required<std::string>("name");
  checkName(node.optionalChild("name"), process.name);
  readSchedule(node, process);
  process.debug = node.optional("debug", false);
  const YamlNode blocking = node.optionalChild("blocking");
  for (const YamlNode& item : blocking.items()) {
    process.blocking.push_back({item.as<std::string>(), item.where()});
  }
  const YamlNode outputs = node.optionalChild("blocking_outputs");
  for (const YamlNode& item : outputs.items())
    process.blockingOutputs.push_back({item.as<std::string>(), item.where()});
  const YamlNode tasks = process.debug ? node.optionalChild("tasks") : node.child("tasks");
  for (const YamlNode& item : tasks.items()) process.tasks.push_back(readTask(item));
  return process;
}

Layout::Program readProgram(const YamlNode& node) {
  Layout::Program program;
  program.where = node.where();
  program.name = node.required<std::string>("name");
  checkName(node.optionalChild("name"), program.name);
  const YamlNode host = node.optionalChild("host");
  program.host = host.empty() ? std::string() : host.as<std::string>();
  if (!host.empty() && !isHost(program.host)) {
    host.fail("layout.host", "'" + program.host + "' is neither the IP address of a machine nor its name",
              {program.host});
  }
  for (const YamlNode& item : node.child("processes").items())
    program.processes.push_back({item.as<std::string>(), item.where()});
  return program;
}

Layout::Task readShadow(const YamlNode& node) {
  Layout::Task shadow;
  shadow.where = node.where();
  const auto text = node.as<std::string>();
  const auto slash = text.find('/');
  shadow.task = text.substr(0, slash);
  if (slash != std::string::npos) shadow.solution = text.substr(slash + 1);
  if (slash == std::string::npos && !text.empty())
    node.fail("layout.shadow-form", "each shadow is one line: '- task/solution'");
  return shadow;
}

tl::expected<Layout, Errors> read(Result<YamlReader> reader, const std::string& file) {
  if (!reader) return tl::unexpected(Errors{reader.error()});
  const YamlNode root = reader->root();
  Layout layout;
  layout.file = file;
  const YamlNode version = root.child("version");
  if (const int number = version.as<int>(); number != kVersion) {
    version.fail("layout.version", "this program reads layouts of version 1, not " + std::to_string(number));
  }
  layout.name = root.required<std::string>("name");
  checkName(root.optionalChild("name"), layout.name);
  layout.help = root.optional<std::string>("help", "");
  for (const YamlNode& node : root.child("processes").items()) layout.processes.push_back(readProcess(node));
  const YamlNode programs = root.optionalChild("programs");
  for (const YamlNode& node : programs.items()) layout.programs.push_back(readProgram(node));
  const YamlNode shadows = root.optionalChild("shadows");
  for (const YamlNode& node : shadows.items()) layout.shadows.push_back(readShadow(node));
  if (auto finished = reader->finish(); !finished) return tl::unexpected(finished.error());
  return layout;
}

}  // namespace

tl::expected<Layout, Errors> readLayout(const std::filesystem::path& file) {
  return read(YamlReader::load(file), file.string());
}

tl::expected<Layout, Errors> parseLayout(const std::string& text, const std::string& file) {
  return read(YamlReader::parse(text, file), file);
}

}  // namespace robotlink
