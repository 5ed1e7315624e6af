// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/yaml_file.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

YamlMap Parse(const std::string& text) { return ParseYaml("v.yaml", text); }

std::string ParseError(const std::string& text) {
  return ErrorFrom([&] { Parse(text); });
}

TEST(YamlFile, ReadsEveryTypeOfValue) {
  const YamlMap file = Parse(
      "name: LBV 150\n"
      "mass: -1.5e1\n"
      "count: 7\n"
      "is_wet: true\n"
      "size: [0.53, .25, 2]\n"
      "dofs: [surge, yaw]\n"
      "dof: heave\n"
      "pairs: [[1, 2], [3, 4]]\n"
      "pair: [5, 6]\n"
      "body: {inner: {depth: 3}}\n"
      "thrusters:\n"
      "  - name: left\n"
      "  - name: right\n");
  EXPECT_EQ(file.String("name"), "LBV 150");
  EXPECT_EQ(file.Number("mass"), -15.0);
  EXPECT_EQ(file.Integer("count"), 7);
  EXPECT_TRUE(file.Boolean("is_wet"));
  EXPECT_THAT(file.Numbers("size", 3), ElementsAre(0.53, 0.25, 2.0));
  EXPECT_THAT(file.Strings("dofs"), ElementsAre("surge", "yaw"));
  EXPECT_THAT(file.Strings("dof"), ElementsAre("heave"));
  EXPECT_THAT(file.NumberLists("pairs", 2), ElementsAre(ElementsAre(1, 2), ElementsAre(3, 4)));
  EXPECT_THAT(file.NumberLists("pair", 2), ElementsAre(ElementsAre(5, 6)));
  EXPECT_EQ(file.Map("body").Map("inner").Number("depth"), 3.0);
  ASSERT_EQ(file.Maps("thrusters").size(), 2u);
  EXPECT_EQ(file.Maps("thrusters")[0].String("name"), "left");
  EXPECT_EQ(file.Maps("thrusters")[1].String("name"), "right");
  EXPECT_NO_THROW(file.Finish());
}

TEST(YamlFile, GivesTheDefaultOfAMissingKeyAndKnowsIt) {
  const YamlMap file = Parse("a: 1");
  EXPECT_EQ(file.Number("b", 2.5), 2.5);
  EXPECT_EQ(file.String("c", "none"), "none");
  EXPECT_EQ(file.Integer("d", 4), 4);
  EXPECT_FALSE(file.Boolean("e", false));
  EXPECT_FALSE(file.OptionalMap("f").has_value());
  EXPECT_THAT(file.OptionalMaps("g"), IsEmpty());
  EXPECT_EQ(ErrorFrom([&] { file.Finish(); }),
            "v.yaml:1: key 'a' is not known here, expected one of: b, c, d, e, f, g. Correct or "
            "remove it.");
}

TEST(YamlFile, RefusesAKeyThatNobodyReadsInAMapBelow) {
  const YamlMap file = Parse("list:\n  - {x: 1}\n  - x: 1\n    y: 2\n");
  for (const YamlMap& map : file.Maps("list")) map.Number("x");
  EXPECT_EQ(
      ErrorFrom([&] { file.Finish(); }),
      "v.yaml:4: key 'list[1].y' is not known here, expected one of: x. Correct or remove it.");
}

TEST(YamlFile, AllowsWhatIsIgnoredWithAllBelowIt) {
  const YamlMap file = Parse("a: 1\nextra: {b: {c: 2}}\n");
  file.Number("a");
  file.Ignore("extra");
  EXPECT_NO_THROW(file.Finish());
}

TEST(YamlFile, NamesTheMissingKeyAndTheMapItBelongsTo) {
  const YamlMap file = Parse("a: 1\nbody:\n  b: 2\n");
  EXPECT_EQ(ErrorFrom([&] { file.Number("mass"); }),
            "v.yaml:1: key 'mass' is missing, expected a finite number.");
  EXPECT_EQ(ErrorFrom([&] { file.Map("body").String("name"); }),
            "v.yaml:2: key 'body.name' is missing, expected a text.");
  EXPECT_EQ(ErrorFrom([&] { Parse("froce: 60\n").Number("force"); }),
            "v.yaml:1: key 'force' is missing, expected a finite number: found 'froce'.");
}

TEST(YamlFile, SaysWhatWasFoundInPlaceOfANumber) {
  const YamlMap file =
      Parse("a: heavy\nb: '3'\nc: .nan\nd: .inf\ne: 1e999\nf:\ng: [1]\nh: {}\ni: inf\nj: nan");
  const auto error = [&](const char* key) { return ErrorFrom([&] { file.Number(key); }); };
  EXPECT_EQ(error("a"), "v.yaml:1: key 'a' is 'heavy', expected a finite number.");
  EXPECT_EQ(error("b"), "v.yaml:2: key 'b' is the quoted text '3', expected a finite number.");
  EXPECT_EQ(error("c"), "v.yaml:3: key 'c' is '.nan', expected a finite number.");
  EXPECT_EQ(error("d"), "v.yaml:4: key 'd' is '.inf', expected a finite number.");
  EXPECT_EQ(error("e"), "v.yaml:5: key 'e' is '1e999', expected a finite number.");
  EXPECT_EQ(error("f"), "v.yaml:6: key 'f' is empty, expected a finite number.");
  EXPECT_EQ(error("g"), "v.yaml:7: key 'g' is a list of 1, expected a finite number.");
  EXPECT_EQ(error("h"), "v.yaml:8: key 'h' is a map, expected a finite number.");
  EXPECT_EQ(error("i"), "v.yaml:9: key 'i' is 'inf', expected a finite number.");
  EXPECT_EQ(error("j"), "v.yaml:10: key 'j' is 'nan', expected a finite number.");
}

TEST(YamlFile, SaysWhatWasExpectedOfTheOtherTypes) {
  const YamlMap file =
      Parse("n: 1.5\ntext: [a]\nempty:\nflag: yes\nsize: [1, 2]\nbad: [1, x]\nmaps: [1]");
  EXPECT_EQ(ErrorFrom([&] { file.Integer("n"); }),
            "v.yaml:1: key 'n' is '1.5', expected a whole number.");
  EXPECT_EQ(ErrorFrom([&] { file.String("text"); }),
            "v.yaml:2: key 'text' is a list of 1, expected a text.");
  EXPECT_EQ(ErrorFrom([&] { file.String("empty"); }),
            "v.yaml:3: key 'empty' is empty, expected a text.");
  EXPECT_EQ(ErrorFrom([&] { file.Boolean("flag"); }),
            "v.yaml:4: key 'flag' is 'yes', expected true or false.");
  EXPECT_EQ(ErrorFrom([&] { file.Numbers("size", 3); }),
            "v.yaml:5: key 'size' is a list of 2, expected a list of 3 numbers.");
  EXPECT_EQ(ErrorFrom([&] { file.Numbers("bad"); }),
            "v.yaml:6: key 'bad[1]' is 'x', expected a finite number.");
  EXPECT_EQ(ErrorFrom([&] { file.Maps("maps"); }),
            "v.yaml:7: key 'maps[0]' is '1', expected a map.");
  EXPECT_EQ(ErrorFrom([&] { file.Map("n"); }), "v.yaml:1: key 'n' is '1.5', expected a map.");
  EXPECT_EQ(ErrorFrom([&] { file.NumberLists("n", 2); }),
            "v.yaml:1: key 'n' is '1.5', expected a list of 2 numbers, or a list of such lists.");
}

TEST(YamlFile, LetsTheCallerRefuseAValueAtItsPlace) {
  const YamlMap file = Parse("a: 1\nbody:\n  mass: -3\n");
  EXPECT_EQ(ErrorFrom([&] { file.Map("body").Fail("mass", "is -3, expected a mass above 0."); }),
            "v.yaml:3: key 'body.mass' is -3, expected a mass above 0.");
}

TEST(YamlFile, RefusesWhatIsNotYaml) {
  EXPECT_THAT(ParseError("a: 1\nb: [1, 2\n"),
              AllOf(StartsWith("v.yaml:"), HasSubstr("not valid YAML")));
  EXPECT_THAT(ParseError("a: 1\n\tb: 2\n"),
              AllOf(StartsWith("v.yaml:"), HasSubstr("not valid YAML")));
  for (const char* open : {"\"open\n", "\"open", "'open\n", "'open"}) {
    EXPECT_EQ(ParseError(std::string("a: 1\nb: ") + open),
              "v.yaml:3: not valid YAML: illegal EOF in scalar.");
  }
}

TEST(YamlFile, RefusesAnEmptyFileAndOneThatIsNoMap) {
  EXPECT_EQ(ParseError(""), "v.yaml: is empty, expected keys and values ('key: value').");
  EXPECT_EQ(ParseError("# only a comment\n"),
            "v.yaml: is empty, expected keys and values ('key: value').");
  EXPECT_EQ(ParseError("- 1\n- 2\n"),
            "v.yaml:1: is a list of 2, expected keys and values ('key: value').");
  EXPECT_EQ(ParseError("t,tau,v"), "v.yaml:1: is a text, expected keys and values ('key: value').");
}

TEST(YamlFile, ANameHoldsSomethingAndNothingThatATerminalObeys) {
  const auto name = [](const char* text) { return ParseYaml("v.yaml", text).Name("name"); };
  const auto error_of = [&](const char* text) { return ErrorFrom([&] { name(text); }); };
  EXPECT_EQ(name("name: Fl\xc3\xa4"
                 "che 7"),
            "Fl\xc3\xa4"
            "che 7");
  EXPECT_EQ(error_of("a: 1\nname: \"\""), "v.yaml:2: key 'name' is empty, expected a name.");
  EXPECT_EQ(error_of("name: \"  \""), "v.yaml:1: key 'name' is empty, expected a name.");
  EXPECT_EQ(error_of("name: \"a\\x1b[2J\""),
            "v.yaml:1: key 'name' is 'a\\x1b[2J', expected a name without control characters.");
}

TEST(YamlFile, RefusesRepeatedKeysAliasesTagsAndSecondDocuments) {
  EXPECT_EQ(ParseError("a: 1\nb: 2\na: 3\n"),
            "v.yaml:3: key 'a' was given on line 1 already. Remove one of the two.");
  EXPECT_EQ(ParseError("a: &x [1]\n"),
            "v.yaml:1: an anchor ('&') stands here, expected plain values.");
  EXPECT_THAT(ParseError("a: &x [*x]\n"), HasSubstr("anchor"));
  EXPECT_THAT(ParseError("a: !!binary x\n"), HasSubstr("a tag ("));
  EXPECT_EQ(ParseError("a: 1\n---\nb: 2\n"),
            "v.yaml:2: a second document starts here, expected one per file.");
  EXPECT_EQ(ParseError("[1, 2]: 3\n"), "v.yaml:1: a key is not a text, expected 'key: value'.");
}

TEST(YamlFile, RefusesBytesThatAreNotText) {
  EXPECT_EQ(ParseError("a: 1\nb: caf\xe9\n"),
            "v.yaml:2: byte 0xe9 is not UTF-8. Save the file as UTF-8.");
  EXPECT_EQ(ParseError(std::string("a: 1\n\0\0", 7)),
            "v.yaml:2: control character 0x00, expected text. The file is damaged; restore it.");
  EXPECT_EQ(Parse("a: caf\xc3\xa9").String("a"), "caf\xc3\xa9");
  // Found by fuzzing: an encoding longer than needed; half a pair; beyond the last code point.
  for (const char* const text : {"a: \xe0\x84\x9e",
                                 "a: \xc0\x80",
                                 "a: \xed\xa0\x80",
                                 "a: \xf0\x8f\xbf\xbf",
                                 "a: \xf4\x90\x80\x80"}) {
    EXPECT_THAT(ParseError(text), HasSubstr("is not UTF-8")) << text;
  }
  for (const char* const text : {"\xc2\xa0",
                                 "\xe0\xa0\x80",
                                 "\xed\x9f\xbf",
                                 "\xee\x80\x80",
                                 "\xf0\x90\x80\x80",
                                 "\xf4\x8f\xbf\xbd"}) {
    EXPECT_EQ(Parse(std::string("a: x") + text).String("a"), std::string("x") + text);
  }
  // Found by fuzzing: yaml-cpp makes a single byte of these.
  for (const char* const text :
       {"a: 1\nb: \"o\\N\"\n", "a: 1\nb: \"o\\_\"\n", "a: 1\n\"o\\N\": b\n"}) {
    EXPECT_EQ(
        ParseError(text),
        "v.yaml:2: the escape '\\N' or '\\_' stands in a text, expected the character itself.");
  }
}

// 100000 levels would overflow the stack of any reader that recurses without a limit.
TEST(YamlFile, RefusesHugeNestingWithoutOverflowingTheStack) {
  EXPECT_EQ(ParseError("a: " + std::string(40, '[') + std::string(40, ']')),
            "v.yaml:1: values nest deeper than 32 levels.");
  EXPECT_EQ(ParseError("a: " + std::string(100000, '[') + std::string(100000, ']')),
            "v.yaml:1: values nest deeper than 32 levels.");
  EXPECT_THAT(ParseError("a: " + std::string(100000, '[')), StartsWith("v.yaml:1: "));
  std::string maps;
  for (int i = 0; i < 20000; ++i) maps += "{a: ";
  EXPECT_THAT(ParseError(maps + std::string(20000, '}')), HasSubstr("nest deeper than 32 levels"));
}

}  // namespace
}  // namespace fathom
