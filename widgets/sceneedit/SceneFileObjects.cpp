// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneFileObjects.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <array>
#include <utility>

#include "widgets/sceneedit/XmlText.h"

namespace widgets {
namespace {

constexpr std::array kObjectElements = {"model",  "link",      "joint",   "sensor", "light",
                                        "visual", "collision", "include", "frame",  "actor"};

bool isObject(const QString& element) {
  return std::any_of(kObjectElements.begin(), kObjectElements.end(),
                     [&](const char* one) { return element == QLatin1String(one); });
}

/// The text in the first child of this name; empty if there is none.
QString childText(const QString& text, const std::vector<XmlElement>& all, int parent, const char* name) {
  for (const XmlElement& one : all) {
    if (one.parent == parent && one.name == QLatin1String(name))
      return text.mid(one.openEnd, one.closeBegin - one.openEnd).trimmed();
  }
  return {};
}

QString objectName(const QString& text, const std::vector<XmlElement>& all, int index, const QString& uri) {
  const XmlElement& element = all[static_cast<std::size_t>(index)];
  if (element.name != QLatin1String("include")) {
    const XmlTag tag{XmlTag::Kind::kOpening, element.name, element.begin, element.openEnd, true};
    return xmlAttributes(text, tag).value(QStringLiteral("name"));
  }
  const QString name = childText(text, all, index, "name");
  return name.isEmpty() ? uri.section(QLatin1Char('/'), -1) : name;
}

/// Returns an object's name in the views of the scene. `around`: that of its container; `model`: its model.
QString selectionOf(const SceneObject& object, const QString& around, const QString& model,
                    const QString& type) {
  const QString& element = object.element;
  const QString begin = around.isEmpty() ? QString() : around + QLatin1Char('/');
  if (element == QLatin1String("sensor")) {
    const QString port = model + QLatin1Char('/') + object.name;
    return type == QLatin1String("camera") ? port + QStringLiteral("/image") : port;
  }
  if (element == QLatin1String("link") || element == QLatin1String("joint"))
    return QStringLiteral("%1/%2:%3").arg(model, element, object.name);
  if (element == QLatin1String("collision")) return begin + QStringLiteral("solid:") + object.name;
  if (element == QLatin1String("visual") || element == QLatin1String("light"))
    return begin + element + QLatin1Char(':') + object.name;
  return begin + object.name;
}

/// A part of a path: a name, and which elements it means; empty: any.
struct PathPart {
  QString element, name;
};
PathPart partOf(const QString& written) {
  const int colon = written.indexOf(QLatin1Char(':'));
  QString kind = written.left(std::max(0, colon));
  if (kind == QLatin1String("solid")) kind = QStringLiteral("collision");
  return isObject(kind) ? PathPart{kind, written.mid(colon + 1)} : PathPart{{}, written};
}

/// The first object of a part among those in `around`, at any depth; null: the outermost ones.
const SceneObject* objectOf(const std::vector<SceneObject>& objects, const PathPart& part,
                            const SceneObject* around) {
  for (const SceneObject& object : objects) {
    const bool isThere = around == nullptr ? object.path == object.name
                                           : object.path.startsWith(around->path + QLatin1Char('/'));
    const bool isMeant = part.element.isEmpty() || object.element == part.element;
    if (isThere && isMeant && object.name == part.name) return &object;
  }
  return nullptr;
}

/// The path with the file's own model called `to` instead of `from`.
QString renamed(const QString& path, const QString& from, const QString& to) {
  const bool isIt = path == from || path.startsWith(from + QLatin1Char('/'));
  return isIt ? to + path.mid(from.size()) : path;
}

}  // namespace

std::vector<SceneObject> sceneObjects(const QString& text) {
  const auto elements = xmlElements(text);
  std::vector<SceneObject> objects;
  // The path of the object that each element is in, or is.
  std::vector<QString> paths(elements.size()), selections(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const XmlElement& element = elements[i];
    if (element.parent >= 0) {
      paths[i] = paths[static_cast<std::size_t>(element.parent)];
      selections[i] = selections[static_cast<std::size_t>(element.parent)];
    }
    if (!isObject(element.name)) continue;
    const int index = static_cast<int>(i);
    const bool isInclude = element.name == QLatin1String("include");
    const QString uri = isInclude ? childText(text, elements, index, "uri") : QString();
    const QString name = objectName(text, elements, index, uri);
    if (name.isEmpty()) continue;
    SceneObject object;
    object.uri = uri;
    object.element = element.name;
    object.name = name;
    object.begin = element.begin;
    object.end = element.end;
    const bool isOuter = paths[i].isEmpty();
    const QString model = isOuter ? name : paths[i].section(QLatin1Char('/'), 0, 0);
    const XmlTag tag{XmlTag::Kind::kOpening, element.name, element.begin, element.openEnd, true};
    const QString type = xmlAttributes(text, tag).value(QStringLiteral("type"));
    const QString around = isOuter ? QString() : selections[static_cast<std::size_t>(element.parent)];
    paths[i] = isOuter ? name : paths[i] + QLatin1Char('/') + name;
    selections[i] = selectionOf(object, around, model, type);
    object.path = paths[i];
    object.selection = selections[i];
    objects.push_back(std::move(object));
  }
  return objects;
}

FoundSceneObject findSceneObject(const QString& text, const QString& path, const QString& instance) {
  const auto objects = sceneObjects(text);
  QString wanted = path;
  wanted.replace(QLatin1String("::"), QLatin1String("/"));
  if (!instance.isEmpty() && !objects.empty()) wanted = renamed(wanted, instance, objects.front().path);
  const QStringList parts = wanted.split(QLatin1Char('/'));
  const SceneObject* object = objectOf(objects, partOf(parts.first()), nullptr);
  if (object == nullptr) return {};
  for (int i = 1; i < parts.size(); ++i) {
    const SceneObject* next = objectOf(objects, partOf(parts[i]), object);
    if (next == nullptr) {
      if (!object->uri.isEmpty()) return {*object, parts.mid(i).join(QLatin1Char('/'))};
      // After an object of a model, a path may name one of its values: red1/neck/position.
      return i > 1 ? FoundSceneObject{*object, {}} : FoundSceneObject{};
    }
    object = next;
  }
  return {*object, {}};
}

std::optional<SceneObject> sceneObjectAt(const QString& text, int position, const QString& instance) {
  const auto objects = sceneObjects(text);
  std::optional<SceneObject> found;
  for (const SceneObject& object : objects) {
    if (object.begin <= position && position < object.end) found = object;
  }
  if (!found || instance.isEmpty()) return found;
  const QString& own = objects.front().path;
  found->path = renamed(found->path, own, instance);
  found->selection = renamed(found->selection, own, instance);
  return found;
}

QString withElements(const QString& text, const QString& xml, int* position) {
  const auto elements = xmlElements(text);
  const XmlElement* around = nullptr;
  for (const char* wanted : {"world", "model"}) {
    const auto found = std::find_if(elements.begin(), elements.end(), [&](const XmlElement& one) {
      return one.name == QLatin1String(wanted) && one.isClosed && one.end > one.openEnd;
    });
    if (around == nullptr && found != elements.end()) around = &*found;
  }
  if (around == nullptr) return text;
  // The text is inserted before the blanks that precede the closing tag.
  int at = around->closeBegin;
  while (at > around->openEnd && (text[at - 1] == QLatin1Char(' ') || text[at - 1] == QLatin1Char('\t')))
    --at;
  const bool hasLine = at > 0 && text[at - 1] == QLatin1Char('\n');
  const QString before = hasLine ? QString() : QStringLiteral("\n");
  int blanks = 0;
  while (blanks < xml.size() && xml[blanks] == QLatin1Char(' ')) ++blanks;
  if (position != nullptr) *position = at + before.size() + blanks;
  return text.left(at) + before + xml + text.mid(at);
}

QString withInclude(const QString& text, const QString& uri, const QString& name, int* position) {
  return withElements(text,
                      QStringLiteral("    <include>\n      <uri>%1</uri>\n      <name>%2</name>\n"
                                     "      <pose>0 0 0 0 0 0</pose>\n    </include>\n")
                          .arg(uri.toHtmlEscaped(), name.toHtmlEscaped()),
                      position);
}

QString withoutObject(const QString& text, const SceneObject& object) {
  int begin = object.begin, end = object.end;
  const auto isBlank = [&](int at) { return text[at] == QLatin1Char(' ') || text[at] == QLatin1Char('\t'); };
  while (begin > 0 && isBlank(begin - 1)) --begin;
  while (end < text.size() && isBlank(end)) ++end;
  const bool beginsLine = begin == 0 || text[begin - 1] == QLatin1Char('\n');
  const bool endsLine = end == text.size() || text[end] == QLatin1Char('\n');
  if (!beginsLine || !endsLine) return text.left(object.begin) + text.mid(object.end);
  return text.left(begin) + text.mid(std::min(end + 1, text.size()));
}

QString renamedObject(const QString& element, const QString& name) {
  const auto elements = xmlElements(element);
  if (elements.empty()) return element;
  const XmlElement& outer = elements.front();
  if (outer.name == QLatin1String("include")) {
    for (const XmlElement& one : elements) {
      if (one.parent == 0 && one.name == QLatin1String("name"))
        return element.left(one.openEnd) + name.toHtmlEscaped() + element.mid(one.closeBegin);
    }
    return element.left(outer.openEnd) + QStringLiteral("<name>%1</name>").arg(name.toHtmlEscaped()) +
           element.mid(outer.openEnd);
  }
  static const QRegularExpression kName(QStringLiteral("(\\sname\\s*=\\s*)(\"[^\"]*\"|'[^']*')"));
  const auto match = kName.match(element.left(outer.openEnd));
  if (!match.hasMatch()) return element;
  return element.left(match.capturedStart(2)) + QStringLiteral("\"%1\"").arg(name.toHtmlEscaped()) +
         element.mid(match.capturedEnd(2));
}

namespace {

/// The first name that is not taken, of one with numbers behind it.
QString numberedObjectName(const QString& text, const QString& name, int number) {
  QStringList taken;
  for (const SceneObject& object : sceneObjects(text)) taken << object.path;
  while (taken.contains(name + QString::number(number))) ++number;
  return name + QString::number(number);
}

}  // namespace

QString freeObjectName(const QString& text, const QString& name) {
  const auto objects = sceneObjects(text);
  const bool isTaken = std::ranges::any_of(objects, [&](const SceneObject& one) { return one.path == name; });
  return isTaken ? numberedObjectName(text, name, 2) : name;
}

QString copiedObjectName(const QString& text, const QString& name) {
  constexpr int kMaxDigits = 8;
  int end = name.size();
  while (end > 0 && name.size() - end < kMaxDigits && name[end - 1].isDigit()) --end;
  return numberedObjectName(text, name.left(end), end < name.size() ? name.midRef(end).toInt() + 1 : 2);
}

}  // namespace widgets
