// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneCompletion.h"

#include <QCoreApplication>
#include <algorithm>

namespace widgets {
namespace {

struct SceneCompletionText {
  Q_DECLARE_TR_FUNCTIONS(widgets::SceneCompletion)
};

QString fromText(const std::string& text) {
  return QString::fromStdString(text);
}

SceneLanguage::Path pathOf(const QStringList& names) {
  SceneLanguage::Path path;
  for (const QString& name : names) path.push_back(name.toStdString());
  return path;
}

/// "double, default 1.0; required".
QString kindText(const std::string& type, const std::string& initial, bool required) {
  QStringList parts;
  if (!type.empty()) parts << fromText(type);
  if (!initial.empty() && initial != "__default__")
    parts << SceneCompletionText::tr("default %1").arg(fromText(initial));
  if (required) parts << SceneCompletionText::tr("required");
  return parts.join(QStringLiteral(", "));
}

QString helpText(const std::string& name, const QString& kind, const std::string& help) {
  QString text = QStringLiteral("<b>%1</b>").arg(fromText(name).toHtmlEscaped());
  if (!kind.isEmpty()) text += QStringLiteral(" (%1)").arg(kind.toHtmlEscaped());
  if (!help.empty()) text += QStringLiteral("<br/>") + fromText(help).toHtmlEscaped();
  return text;
}
QString helpText(const SceneElement& element) {
  return helpText(element.name, kindText(element.type, element.initial, element.required), element.help);
}
QString helpText(const SceneAttribute& attribute) {
  return helpText(attribute.name, kindText(attribute.type, attribute.initial, attribute.required),
                  attribute.help);
}

/// The element with its closing tag; the cursor goes to the first thing that is to be filled in.
SceneProposal proposalOf(const SceneElement& element) {
  SceneProposal proposal{fromText(element.name), fromText(element.name), 0, helpText(element)};
  int back = -1;
  for (const SceneAttribute& attribute : element.attributes) {
    if (!attribute.required) continue;
    proposal.text += QStringLiteral(" %1=\"").arg(fromText(attribute.name));
    if (back < 0) back = proposal.text.size();
    proposal.text += QLatin1Char('"');
  }
  proposal.text += QLatin1Char('>');
  if (back < 0) back = proposal.text.size();
  const bool hasValue = !element.type.empty() && element.type != "string" && element.initial != "__default__";
  if (hasValue) proposal.text += fromText(element.initial);
  // Behind a default value one continues; in an element with children or a text one fills it in.
  if (hasValue && back == proposal.text.size() - static_cast<int>(element.initial.size()))
    back = proposal.text.size();
  proposal.text += QStringLiteral("</%1>").arg(fromText(element.name));
  proposal.back = proposal.text.size() - back;
  return proposal;
}

std::vector<SceneProposal> attributesFor(const SceneLanguage& language, const XmlPlace& place) {
  std::vector<SceneProposal> proposals;
  const auto element = language.element(pathOf(QStringList(place.path) << place.element));
  if (!element) return proposals;
  for (const SceneAttribute& attribute : element->attributes) {
    const QString name = fromText(attribute.name);
    if (place.attributes.contains(name)) continue;
    proposals.push_back({name, name + QStringLiteral("=\"\""), 1, helpText(attribute)});
  }
  return proposals;
}

std::vector<SceneProposal> wordsFor(const std::string& type) {
  std::vector<SceneProposal> proposals;
  if (type != "bool") return proposals;
  for (const char* word : {"true", "false"}) proposals.push_back({QLatin1String(word), QLatin1String(word)});
  return proposals;
}

std::vector<SceneProposal> valuesFor(const SceneLanguage& language, const XmlPlace& place) {
  const auto element = language.element(pathOf(QStringList(place.path) << place.element));
  if (!element) return {};
  const auto attribute =
      std::find_if(element->attributes.begin(), element->attributes.end(),
                   [&](const SceneAttribute& one) { return fromText(one.name) == place.attribute; });
  return attribute == element->attributes.end() ? std::vector<SceneProposal>() : wordsFor(attribute->type);
}

std::vector<SceneProposal> textsFor(const SceneLanguage& language, const XmlPlace& place,
                                    const std::filesystem::path& file) {
  std::vector<SceneProposal> proposals;
  if (place.path.isEmpty()) return proposals;
  const bool isInclude =
      place.path.size() > 1 && place.path[place.path.size() - 2] == QLatin1String("include");
  if (isInclude && place.path.last() == QLatin1String("uri")) {
    for (const SceneModelChoice& model : language.models(file))
      proposals.push_back({fromText(model.uri), fromText(model.uri)});
    return proposals;
  }
  const auto element = language.element(pathOf(place.path));
  return element ? wordsFor(element->type) : proposals;
}

}  // namespace

std::vector<SceneProposal> sceneProposals(const SceneLanguage& language, const XmlPlace& place,
                                          const std::filesystem::path& file) {
  using Kind = XmlPlace::Kind;
  std::vector<SceneProposal> proposals;
  switch (place.kind) {
    case Kind::kTagName:
      for (const SceneElement& one : language.children(pathOf(place.path)))
        proposals.push_back(proposalOf(one));
      break;
    case Kind::kClosingName:
      if (!place.path.isEmpty())
        proposals.push_back({place.path.last(), place.path.last() + QLatin1Char('>')});
      break;
    case Kind::kAttributeName:
      proposals = attributesFor(language, place);
      break;
    case Kind::kAttributeValue:
      proposals = valuesFor(language, place);
      break;
    case Kind::kText:
      proposals = textsFor(language, place, file);
      break;
    case Kind::kElsewhere:
      break;
  }
  const QString prefix = place.kind == Kind::kText ? place.prefix.trimmed() : place.prefix;
  std::erase_if(proposals, [&](const SceneProposal& one) { return !one.shown.startsWith(prefix); });
  return proposals;
}

QString sceneHelpAt(const SceneLanguage& language, const QString& text, int position) {
  using Kind = XmlPlace::Kind;
  // The place behind the character, so that the first one of a word belongs to it.
  const XmlPlace place = xmlPlaceAt(text, position + 1);
  if (place.kind == Kind::kClosingName) {
    const auto element = language.element(pathOf(place.path));
    return element && place.path.last() == place.element ? helpText(*element) : QString();
  }
  if (place.element.isEmpty() || place.kind == Kind::kText || place.kind == Kind::kElsewhere) return {};
  const auto element = language.element(pathOf(QStringList(place.path) << place.element));
  if (!element) return {};
  if (place.kind == Kind::kTagName) return helpText(*element);
  QString name = place.attribute;
  if (place.kind == Kind::kAttributeName) {
    int end = position + 1;
    while (end < text.size() && (text[end].isLetterOrNumber() || text[end] == QLatin1Char('_'))) ++end;
    name = text.mid(place.prefixBegin, end - place.prefixBegin).trimmed();
  }
  for (const SceneAttribute& attribute : element->attributes) {
    if (fromText(attribute.name) == name) return helpText(attribute);
  }
  return {};
}

}  // namespace widgets
