// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/IdlReader.h"

#include <gmock/gmock.h>

#include "robotlink/ros/Resolution.h"
#include "tests/robotlink/ros/RosMessages.h"

namespace robotlink::ros {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::SizeIs;

/// A struct p::msg::M with these members, and declarations before it.
std::string idl(const std::string& members, const std::string& before = {}) {
  return before + "module p { module msg { struct M { " + members + " }; }; };";
}

Definitions definitionsOf(const std::string& text) {
  const auto definitions = readIdl("p/msg/M", text);
  EXPECT_TRUE(definitions) << definitions.error().describe();
  return definitions.value_or(Definitions{});
}

Field memberOf(const std::string& member, const std::string& before = {}) {
  const auto fields = definitionsOf(idl(member, before)).structs["p/M"].fields;
  EXPECT_THAT(fields, SizeIs(1));
  return fields.empty() ? Field{} : fields.front();
}

std::string idlErrorOf(const std::string& text) {
  const auto definitions = readIdl("p/msg/M", text);
  return definitions ? "none" : definitions.error().describe();
}

TEST(IdlReader, membersHaveTypesAndShapes) {
  EXPECT_EQ(memberOf("double x;"), (Field{"x", Kind::kFloat64, "", Shape::kSingle, 0, {}}));
  EXPECT_EQ(memberOf("unsigned long long x;").kind, Kind::kUint64);
  EXPECT_EQ(memberOf("unsigned short x;").kind, Kind::kUint16);
  EXPECT_EQ(memberOf("unsigned long x;").kind, Kind::kUint32);
  EXPECT_EQ(memberOf("long long x;").kind, Kind::kInt64);
  EXPECT_EQ(memberOf("long x;").kind, Kind::kInt32);
  EXPECT_EQ(memberOf("octet x;").kind, Kind::kUint8);
  EXPECT_EQ(memberOf("wstring<8> x;").kind, Kind::kWstring);
  EXPECT_EQ(memberOf("sequence<uint8> data;"), (Field{"data", Kind::kUint8, "", Shape::kSequence, 0, {}}));
  EXPECT_EQ(memberOf("sequence<string<5>, 3> few;"),
            (Field{"few", Kind::kString, "", Shape::kSequence, 3, {}}));
  EXPECT_EQ(memberOf("float k[3][3];"), (Field{"k", Kind::kFloat32, "", Shape::kArray, 9, {}}));
  EXPECT_EQ(memberOf("builtin_interfaces::msg::Time stamp;").kind, Kind::kTime);
  EXPECT_THAT(definitionsOf(idl("double x, y;")).structs["p/M"].fields, SizeIs(2));
}

TEST(IdlReader, whatIsNoDeclarationIsSkipped) {
  EXPECT_EQ(memberOf("@verbatim (language=\"comment\", text=\n \"a ) // b\" \"c\") @unit (value=\"m\")\n"
                     "/* more; */ @default (value=-1.5) double x; // last\n",
                     "#include \"q/msg/N.idl\"\n@key\n")
                .name,
            "x");
}

TEST(IdlReader, typedefsAndConstantsAreReplaced) {
  EXPECT_EQ(memberOf("double__9 k;", "module p { module msg { typedef double double__9[9]; }; };"),
            (Field{"k", Kind::kFloat64, "", Shape::kArray, 9, {}}));
  EXPECT_EQ(
      memberOf("sequence<number, N> k;", "const uint32 N = 4; typedef real number; typedef float real;"),
      (Field{"k", Kind::kFloat32, "", Shape::kSequence, 4, {}}));
  EXPECT_EQ(memberOf("string s;", "const string NAME = \"a;\" \"b\"; const double HALF = 0.5;").name, "s");
}

TEST(IdlReader, enumerationsNameTheirValues) {
  const Field field = memberOf("Level level;", "module p { enum Level { OK, @value(5) WARN, ERROR }; };");
  EXPECT_EQ(field.kind, Kind::kUint32);
  EXPECT_THAT(field.enumerators, ElementsAre(Pair("OK", 0), Pair("WARN", 5), Pair("ERROR", 6)));
}

TEST(IdlReader, namesAreFoundFromTheInnermostModuleOutwards) {
  const std::string files =
      "================\nIDL: p/msg/M\n" + idl("P a; q::msg::P b; ::q::msg::P c;") +
      "\n================\nIDL: p/msg/P\nmodule p { module msg { struct P { double x; }; }; };" +
      "\n================\nIDL: q/msg/P\nmodule q { module msg { struct P { float x; }; }; };";
  const auto definitions = definitionsOf(files);
  const auto& fields = definitions.structs.at("p/M").fields;
  EXPECT_EQ(fields.at(0).structName, "p/P");
  EXPECT_EQ(fields.at(1).structName, "q/P");
  EXPECT_EQ(fields.at(2).structName, "q/P");
}

TEST(IdlReader, errorsNameTheLine) {
  EXPECT_EQ(idlErrorOf("module p {\n struct M {\n double 7;"), "p/msg/M:3: a name is expected, not \"7\"");
  EXPECT_THAT(idlErrorOf(idl("double x")), HasSubstr("\";\" is expected, not \"}\""));
  EXPECT_THAT(idlErrorOf(idl("Nowhere x;")), HasSubstr("p/M.x is a Nowhere, which is not defined here"));
  EXPECT_THAT(idlErrorOf("module p {"), HasSubstr("\"}\" is expected"));
  EXPECT_THAT(idlErrorOf("union U switch (long) {};"), HasSubstr("not \"union\""));
  EXPECT_THAT(idlErrorOf(idl("long double x;")), HasSubstr("at most 64 bits"));
  EXPECT_THAT(idlErrorOf(idl("@optional long x;")), HasSubstr("optional members are not read"));
  EXPECT_THAT(idlErrorOf(idl("sequence<sequence<long> > x;")), HasSubstr("a sequence of lists is not read"));
  EXPECT_THAT(idlErrorOf(idl("sequence<list> x;", "typedef sequence<long> list;")),
              HasSubstr("a list of lists"));
  EXPECT_THAT(idlErrorOf(idl("long x[N];")), HasSubstr("a number is expected, not \"N\""));
  EXPECT_THAT(idlErrorOf(idl("a x;", "typedef b a; typedef a b;")), HasSubstr("has no type"));
  EXPECT_THAT(idlErrorOf("@verbatim (text=\"never closed"), HasSubstr("\")\" is expected"));
}

TEST(IdlReader, messagesAreDecoded) {
  EXPECT_EQ(
      test::decoded(idl("octet a; P b; Level c;",
                        "module p { enum Level { LOW, HIGH }; module msg { struct P { int16 x[2]; }; }; };"),
                    "00010000 01 00 0200 0300 0000 01000000", {"ros2idl", "cdr"}),
      "a: 1 b { x: 2 x: 3 } c: HIGH");
}

TEST(IdlReader, depthAndSizeAreLimited) {
  std::string modules;
  for (int i = 0; i <= kMaxDepth; ++i) modules += "module m {";
  EXPECT_THAT(idlErrorOf(modules), HasSubstr("nested too deeply"));
  std::string many;
  for (std::size_t i = 0; i <= kMaxFields; ++i) many += "long x;";
  EXPECT_THAT(idlErrorOf(idl(many)), HasSubstr("too many fields"));
}

}  // namespace
}  // namespace robotlink::ros
