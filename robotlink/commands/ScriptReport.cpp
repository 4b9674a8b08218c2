// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/ScriptReport.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

#include "robotlink/base/Printable.h"

namespace robotlink {
namespace {

std::string escaped(const std::string& text) {
  return escapedMarkup(printableLines(text));
}

}  // namespace

std::string junitXml(const std::vector<ScriptOutcome>& outcomes) {
  const auto failures =
      std::ranges::count_if(outcomes, [](const auto& each) { return !each.failure.empty(); });
  std::ostringstream xml;
  xml.imbue(std::locale::classic());
  xml << std::fixed << std::setprecision(3) << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      << "<testsuites>\n  <testsuite name=\"robotcontrol\" tests=\"" << outcomes.size() << "\" failures=\""
      << failures << "\" errors=\"0\" skipped=\"0\">\n";
  for (const ScriptOutcome& outcome : outcomes) {
    xml << "    <testcase classname=\"script\" name=\"" << escaped(outcome.name) << "\" time=\""
        << outcome.seconds << "\"";
    if (outcome.failure.empty()) {
      xml << "/>\n";
    } else {
      xml << ">\n      <failure message=\"" << escaped(outcome.failure) << "\"/>\n    </testcase>\n";
    }
  }
  xml << "  </testsuite>\n</testsuites>\n";
  return xml.str();
}

}  // namespace robotlink
