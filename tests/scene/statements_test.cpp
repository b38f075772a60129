// statements_test.cpp - each statement of the language, read into the scene that scene.hpp promises.
#include <gtest/gtest.h>

#include "tests/scene/parse_helpers.hpp"

namespace halfspace::test {
namespace {

template <typename Numbers>
std::string join(const Numbers& numbers) {
  std::string text;
  for (const Number& number : numbers) {
    if (!text.empty()) text += ' ';
    text += number.text;
  }
  return text;
}

// A transform as the language writes it.
struct Spell {
  static std::string option(std::initializer_list<char> key, const Number& number) {
    std::string text = "=";
    text += key;
    text += ' ';
    return text + number.text;
  }
  static char letter(Axis axis) { return static_cast<char>('x' + static_cast<int>(axis)); }

  std::string operator()(const TranslateTransform& t) const { return option({'t', letter(t.axis)}, t.distance); }
  std::string operator()(const ScaleTransform& t) const { return option({'s', letter(t.axis)}, t.factor); }
  std::string operator()(const TranslateAllTransform& t) const { return option({'t', 'a'}, t.distance); }
  std::string operator()(const ScaleAllTransform& t) const { return option({'s', 'a'}, t.factor); }
  std::string operator()(const RotateTransform& t) const { return option({'r', letter(t.axis)}, t.degrees); }
  std::string operator()(const ShearTransform& t) const {
    return option({'v', letter(t.along), letter(t.moved)}, t.amount);
  }
};

std::string spell(const std::vector<Transform>& transforms) {
  std::string text;
  for (const Transform& transform : transforms) {
    if (!text.empty()) text += ' ';
    text += std::visit(Spell{}, transform);
  }
  return text;
}

std::string spell(const BodyStatement& body) {
  std::string text = body.id + ":";
  for (const HalfSpaceReference& reference : body.half_spaces) {
    text += reference.complement ? " !" : " ";
    text += reference.id;
  }
  return text;
}

// A text without errors; its warnings are of no interest here.
Scene scene_of(std::string_view text) {
  ParseResult result = parse(text);
  EXPECT_FALSE(has_errors(result.diagnostics)) << text << "\n" << testing::PrintToString(messages(result));
  return std::move(result.scene);
}

constexpr std::string_view tube = R"(
definition tube;
  quadric outer_tube <1 0 1 0 0 0 0 0 0 -4>;
  quadric inner_tube <1 0 1 0 0 0 0 0 0 -1>;
  plane top_surf <0 1 0 -2>;
  plane bot_surf <0 1 0 2>;
  body tube <outer_tube !inner_tube top_surf !bot_surf>;
enddef;
)";

TEST(Statements, EmptyTextsAreEmptyScenes) {
  for (const std::string_view text : {"", " \t\r\n", ";", ";;", "{}", "{a{b}c}", "\xEF\xBB\xBF;"}) {
    EXPECT_EQ(messages(text), std::vector<std::string>{}) << text;
  }
  EXPECT_TRUE(parse_uniquadrix({}).diagnostics.empty());
}

TEST(Statements, PlaneKeepsTheTextAndTheValueOfItsCoefficients) {
  const Scene scene = scene_of("plane p <1 -2.50 +.5 1e-3>;");
  ASSERT_EQ(scene.top.planes.size(), 1U);
  const PlaneStatement& plane = scene.top.planes[0];
  EXPECT_EQ(plane.id, "p");
  EXPECT_EQ(join(plane.coefficients), "1 -2.50 .5 1e-3");
  EXPECT_EQ(plane.coefficients[1].value, -2.5);
  EXPECT_EQ(plane.coefficients[3].value, 1e-3);
  EXPECT_FALSE(plane.transparent);
}

TEST(Statements, QuadricHasTenCoefficients) {
  const Scene scene = scene_of("quadric q (1 2 3 4 5 6 7 8 9 -10);");
  ASSERT_EQ(scene.top.quadrics.size(), 1U);
  EXPECT_EQ(join(scene.top.quadrics[0].coefficients), "1 2 3 4 5 6 7 8 9 -10");
}

TEST(Statements, OpacityIsTheLastOneWritten) {
  const std::pair<const char*, bool> cases[] = {{"", false},   {"=t", true},    {"=0", false},  {"=o", false},
                                                {"=O", false}, {"=t=0", false}, {"=0 =t", true}};
  for (const auto& [option, transparent] : cases) {
    const std::string rest = std::string(option) + ";";
    EXPECT_EQ(scene_of("plane p <1 0 0 0>" + rest).top.planes.at(0).transparent, transparent) << option;
    EXPECT_EQ(scene_of("quadric q <1 0 0 0 0 0 0 0 0 0>" + rest).top.quadrics.at(0).transparent, transparent);
  }
}

TEST(Statements, BodyListsItsHalfSpacesInOrderInEitherBracket) {
  const Scene scene = scene_of("plane a <1 0 0 0>; quadric b <1 1 1 0 0 0 0 0 0 -1>; body t (a !b); body u <! b a a>;");
  ASSERT_EQ(scene.top.placements.size(), 2U);
  EXPECT_EQ(spell(std::get<BodyStatement>(scene.top.placements[0])), "t: a !b");
  EXPECT_EQ(spell(std::get<BodyStatement>(scene.top.placements[1])), "u: !b a a");
}

TEST(Statements, PositionsAreThoseOfTheText) {
  const Scene scene = scene_of("{ one\n two }  plane a <1 0 0 0>;\n\r\n\tbody t (\n  !a);");
  EXPECT_EQ(scene.top.planes[0].position.line, 2);
  EXPECT_EQ(scene.top.planes[0].position.column, 9);
  const auto& body = std::get<BodyStatement>(scene.top.placements[0]);
  EXPECT_EQ(body.position.line, 4);
  EXPECT_EQ(body.position.column, 2);
  EXPECT_EQ(body.half_spaces[0].position.line, 5);
  EXPECT_EQ(body.half_spaces[0].position.column, 4);
  EXPECT_EQ(body.half_spaces[0].position.file, "t.uq");
}

TEST(Statements, ThePaperStacksBundlesOfTubes) {
  const Scene scene = scene_of(std::string(tube) + R"(
definition bundle_of_tubes;
  array bundle_of_tubes (tube =tx 2) 6 =ry 60;
enddef;
array stack_of_bundles (bundle_of_tubes =ty -7) 3 =ty 5;
)");
  ASSERT_EQ(scene.definitions.size(), 2U);
  EXPECT_EQ(scene.definitions[0].id, "tube");
  EXPECT_EQ(scene.definitions[0].quadrics.size(), 2U);
  EXPECT_EQ(scene.definitions[0].planes.size(), 2U);
  EXPECT_EQ(spell(std::get<BodyStatement>(scene.definitions[0].placements.at(0))),
            "tube: outer_tube !inner_tube top_surf !bot_surf");
  const auto& bundle = std::get<ArrayStatement>(scene.definitions[1].placements.at(0));
  EXPECT_EQ(spell(bundle.initial) + " | " + std::to_string(bundle.count) + " | " + spell(bundle.delta),
            "=tx 2 | 6 | =ry 60");
  const auto& stack = std::get<ArrayStatement>(scene.top.placements.at(0));
  EXPECT_EQ(stack.definition, "bundle_of_tubes");
  EXPECT_EQ(spell(stack.initial) + " | " + std::to_string(stack.count) + " | " + spell(stack.delta),
            "=ty -7 | 3 | =ty 5");
}

TEST(Statements, EveryTransformIsReadInOrder) {
  const std::string all =
      "=tx 1 =ty 2 =tz 3 =ta 4 =sx 5 =sy 6 =sz 7 =sa 8 =rx 9 =ry 10 =rz 11 "
      "=vxy 12 =vxz 13 =vyx 14 =vyz 15 =vzx 16 =vzy 17";
  const Scene scene = scene_of(std::string(tube) + "instance i (tube " + all + ");");
  EXPECT_EQ(spell(std::get<InstanceStatement>(scene.top.placements.at(0)).transforms), all);
}

TEST(Statements, ATransformsNumberMayFollowAtOnce) {
  const Scene scene = scene_of(std::string(tube) + "instance i <tube =tx2=sa-.5 =rz+1e2>;");
  EXPECT_EQ(spell(std::get<InstanceStatement>(scene.top.placements.at(0)).transforms), "=tx 2 =sa -.5 =rz 1e2");
}

TEST(Statements, AnArrayNeedsNoTransforms) {
  const Scene scene = scene_of(std::string(tube) + "array a (tube) 1000000; array b (tube) 1 =tx 1;");
  EXPECT_EQ(std::get<ArrayStatement>(scene.top.placements.at(0)).count, 1'000'000U);
  EXPECT_EQ(std::get<ArrayStatement>(scene.top.placements.at(1)).count, 1U);
}

TEST(Statements, LightsAreAmbientOrParallel) {
  const Scene scene = scene_of("light glow .3; light sun .7 .4 -.4 -1;");
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].id, "glow");
  EXPECT_FALSE(scene.lights[0].direction.has_value());
  ASSERT_TRUE(scene.lights[1].direction.has_value());
  EXPECT_EQ(scene.lights[1].intensity.text + " | " + join(*scene.lights[1].direction), ".7 | .4 -.4 -1");
}

TEST(Statements, ViewKeepsItsParametersAndOptionsInOrder) {
  const Scene scene =
      scene_of("view v vrp 1 2 3 vpn 4 5 6 =p vup 7 8 9 =v dop 1 1 1 cop 2 2 2 =r cop 3 3 3 =a whh 1 whw 2 fbp -1 1;");
  ASSERT_EQ(scene.views.size(), 1U);
  const std::vector<ViewParameter>& parameters = scene.views[0].parameters;
  const std::pair<ViewKey, ViewOption> expected[] = {
      {ViewKey::vrp, ViewOption::standard}, {ViewKey::vpn, ViewOption::point},    {ViewKey::vup, ViewOption::vector},
      {ViewKey::dop, ViewOption::standard}, {ViewKey::cop, ViewOption::relative}, {ViewKey::cop, ViewOption::absolute},
      {ViewKey::whh, ViewOption::standard}, {ViewKey::whw, ViewOption::standard}, {ViewKey::fbp, ViewOption::standard}};
  ASSERT_EQ(parameters.size(), std::size(expected));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    EXPECT_EQ(parameters[i].key, expected[i].first) << i;
    EXPECT_EQ(parameters[i].option, expected[i].second) << i;
  }
  EXPECT_EQ(join(parameters[1].values), "4 5 6");
  EXPECT_EQ(parameters[8].values[0].text + " " + parameters[8].values[1].text, "-1 1");
}

TEST(Statements, AViewNeedsNoIdBeforeItsParameters) {
  const Scene scene = scene_of("view whh 3; view dop .3 .3 -1;");
  EXPECT_EQ(scene.views[0].id, "v#1");
  EXPECT_EQ(scene.views[1].id, "v#2");
}

TEST(Statements, MissingIdsAreMadeUpBesideThoseOfTheTextWithAWarning) {
  const ParseResult result = parse(
      "light .1; light l#1 .1; light .1; plane <1 0 0 0>; quadric <1 0 0 0 0 0 0 0 0 0>; plane a <1 0 0 0>;\n"
      "body (a); definition; enddef; definition d; body b (c); plane c <0 0 1 0>; plane <1 1 0 0>; enddef;\n"
      "instance (d); array (d) 2; view whh 1;");
  EXPECT_EQ(
      messages(result),
      (std::vector<std::string>{
          "t.uq:1:1: warning: id l#2 created for this light", "t.uq:1:25: warning: id l#3 created for this light",
          "t.uq:1:35: warning: id p#1 created for this plane", "t.uq:1:52: warning: id q#1 created for this quadric",
          "t.uq:2:1: warning: id b#1 created for this body", "t.uq:2:11: warning: id d#1 created for this definition",
          "t.uq:2:76: warning: id p#1 created for this plane", "t.uq:3:1: warning: id i#1 created for this instance",
          "t.uq:3:15: warning: id a#1 created for this array", "t.uq:3:28: warning: id v#1 created for this view"}));
  EXPECT_EQ(result.scene.definitions[0].id, "d#1");
  EXPECT_EQ(std::get<ArrayStatement>(result.scene.top.placements.at(2)).id, "a#1");
}

TEST(Statements, NameSpacesAreKeptApart) {
  EXPECT_EQ(messages("plane a <1 0 0 0>; body a (a); light a 1; view a whh 1;"
                     "definition a; plane a <0 1 0 0>; body a (a); enddef; instance b (a);"),
            std::vector<std::string>{});
}

TEST(Statements, IdsMayBeUsedBeforeTheyAreDefinedAndAcrossFiles) {
  const std::vector<SourceText> files = {
      {"one.uq", "body t (a); instance i (ball);"},
      {"two.uq", "plane a <1 0 0 0>; definition ball; instance j (shell); enddef;"},
      {"three.uq", "definition shell; body s (q); quadric q <1 1 1 0 0 0 0 0 0 -1>; enddef;"}};
  const ParseResult result = parse_uniquadrix(files);
  EXPECT_EQ(messages(result), std::vector<std::string>{});
  EXPECT_EQ(result.scene.definitions[1].quadrics[0].position.file, "three.uq");
}

TEST(Statements, CommentsStandWhereverASpaceMay) {
  const Scene scene = scene_of("plane{a}p{b{c}{d}}<1{e}0 0{;}0>{}=t{f};{{{{}}}}");
  EXPECT_TRUE(scene.top.planes.at(0).transparent);
}

TEST(Statements, AnIntensityOutsideZeroToOneIsKeptWithAWarning) {
  const ParseResult result = parse("light a 1.5; light b -.5 0 0 1; light c 1; light d 0;");
  EXPECT_EQ(messages(result),
            (std::vector<std::string>{"t.uq:1:9: warning: intensity 1.5 is outside 0 to 1; it counts as 1",
                                      "t.uq:1:22: warning: intensity -.5 is outside 0 to 1; it counts as 0"}));
  EXPECT_EQ(result.scene.lights[0].intensity.text, "1.5");
}

TEST(Statements, WarningsAreBounded) {
  std::string text;
  for (int i = 0; i < 150; ++i) text += "light .1;";
  const ParseResult result = parse(text);
  EXPECT_FALSE(has_errors(result.diagnostics));
  ASSERT_EQ(result.diagnostics.size(), 101U);
  EXPECT_EQ(format(result.diagnostics.back()), "warning: 50 further warnings are not shown");
}

Diagnostic diagnostic(Severity severity, const std::string& file, int line, int column) {
  Diagnostic made;
  made.severity = severity;
  made.position.file = file;
  made.position.line = line;
  made.position.column = column;
  made.message = "m";
  return made;
}

TEST(Diagnostics, UnknownPartsOfAPositionAreLeftOut) {
  EXPECT_EQ(format(diagnostic(Severity::error, "f", 2, 3)), "f:2:3: error: m");
  EXPECT_EQ(format(diagnostic(Severity::warning, "f", 2, 0)), "f:2: warning: m");
  EXPECT_EQ(format(diagnostic(Severity::limit, "f", 0, 0)), "f: error: m");
  EXPECT_EQ(format(diagnostic(Severity::error, "", 0, 0)), "error: m");
}

TEST(Diagnostics, AWarningIsNoErrorAndALimitIsOne) {
  Diagnostics diagnostics = {diagnostic(Severity::warning, "f", 1, 1)};
  EXPECT_FALSE(has_errors(diagnostics));
  diagnostics.push_back(diagnostic(Severity::limit, "f", 1, 1));
  EXPECT_TRUE(has_errors(diagnostics));
}

}  // namespace
}  // namespace halfspace::test
