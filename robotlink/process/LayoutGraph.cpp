// SPDX-License-Identifier: GPL-3.0-or-later
// layoutGraph() of Layout.h: a layout as text for Graphviz.
#include <map>
#include <sstream>
#include <tuple>

#include "robotlink/process/Layout.h"

namespace robotlink {
namespace {

// Quotes a string for the DOT language; in records, "{}|<>" have a meaning of their own.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string inRecord(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string("{}|<>\"\\ ").find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string milliseconds(Duration period) {
  std::ostringstream text;
  text << std::chrono::duration<double, std::milli>(period).count();
  return text.str();
}

void writeProcess(std::ostream& out, const Layout::Process& process) {
  std::string schedule = process.debug ? "debug" : "";
  const auto add = [&](const std::string& text) { schedule += (schedule.empty() ? "" : ", ") + text; };
  if (process.period > Duration::zero()) add("every " + milliseconds(process.period) + " ms");
  if (process.priority != 0) add("priority " + std::to_string(process.priority));
  out << "  " << quoted(process.name) << " [shape=record, label=\"{" << inRecord(process.name);
  if (!schedule.empty()) out << "|" << inRecord(schedule);
  for (std::size_t i = 0; i < process.tasks.size(); ++i) {
    const Layout::Task& task = process.tasks[i];
    out << (i == 0 ? "|" : "") << inRecord(task.task + ": " + task.solution) << "\\l";
  }
  out << "}\"" << (process.debug ? ", style=dotted" : "") << "];\n";
}

void writeLinks(std::ostream& out, const std::vector<LayoutLink>& links) {
  std::map<std::tuple<std::string, std::string, bool>, std::string>
      edges;  // packages by (from, to, blocking)
  for (const LayoutLink& link : links) {
    std::string& packages = edges[{link.from, link.to, link.blocking}];
    packages += (packages.empty() ? "" : "\\n") + link.package;
  }
  const auto node = [](const std::string& process) { return quoted(process.empty() ? "platform" : process); };
  for (const auto& [edge, packages] : edges) {
    const auto& [from, to, blocking] = edge;
    out << "  " << node(from) << " -> " << node(to) << " [label=\"" << packages << "\""
        << (blocking ? "" : ", style=dashed") << "];\n";
  }
}

}  // namespace

std::string layoutGraph(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform) {
  std::ostringstream out;
  out << "// Solid: the receiving process waits for the package. Dashed: it does not. Dotted: debug queues "
         "and requests.\n";
  out << "digraph " << quoted(layout.name) << " {\n";
  out << "  rankdir=LR;\n  node [fontname=\"sans-serif\"];\n  edge [fontname=\"sans-serif\", fontsize=10];\n";
  out << "  \"platform\" [shape=component];\n";
  std::string debug;
  for (const Layout::Process& process : layout.processes) {
    writeProcess(out, process);
    if (process.debug) debug = process.name;
  }
  writeLinks(out, layoutLinks(layout, catalog, platform));
  for (const Layout::Process& process : layout.processes) {
    if (debug.empty() || process.debug) continue;
    out << "  " << quoted(process.name) << " -> " << quoted(debug)
        << " [dir=both, style=dotted, constraint=false];\n";
  }
  out << "}\n";
  return out.str();
}

}  // namespace robotlink
