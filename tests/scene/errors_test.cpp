// errors_test.cpp - each error: its exact place, and a message that names what is wrong and the remedy.
#include <gtest/gtest.h>

#include "tests/scene/parse_helpers.hpp"

namespace halfspace::test {
namespace {

struct ErrorCase {
  std::string text;
  std::string place;  // line:column
  std::string wrong;  // both are parts of the message
  std::string remedy;
};

void PrintTo(const ErrorCase& c, std::ostream* out) { *out << c.text; }

class OneError : public testing::TestWithParam<ErrorCase> {};

TEST_P(OneError, IsTheOnlyOneAndSaysWhereWhatAndWhatWouldBeRight) {
  const std::vector<std::string> found = errors(GetParam().text);
  ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
  EXPECT_EQ(found[0].substr(0, found[0].find(' ')), "t.uq:" + GetParam().place + ":");
  EXPECT_NE(found[0].find(GetParam().wrong), std::string::npos) << found[0];
  EXPECT_NE(found[0].find(GetParam().remedy), std::string::npos) << found[0];
}

const ErrorCase words[] = {
    {"plain a <1 0 0 0>;", "1:1", "found 'plain'", "did you mean 'plane'?"},
    {";\n 7;", "2:2", "found '7'", "a statement (plane, quadric, body, definition, enddef, instance, array"},
    {"read foo;", "1:1", "found 'read'", "expected a statement"},
    {"Plane a <1 0 0 0>;", "1:1", "found 'Plane'", "did you mean 'plane'?"},
    {"}", "1:1", "no comment is open", "expected a statement"},
    {"[a];", "1:1", "found '['", "expected a statement"},
    {"plane light <1 0 0 0>;", "1:7", "'light' is a word of the language", "choose another id"},
    {"plane 2a <1 0 0 0>;", "1:7", "found '2a'", "starts with a letter"},
    {"plane a\n<1 0 0 0>\nbody b (a);", "2:10", "no ';'", "write one after '>'"},
    {"plane a <1 0 0 0> body b (a);", "1:18", "no ';'", "write one after '>'"},
    {"plane a <1 0 0 0>", "1:18", "no ';'", "write one after '>'"},
    {"plane a <1 0 0 0> 5;", "1:19", "found '5'", "expected ';'"},
    {"plane a <1 0 0 0>;\n\n  { never { closed }", "3:3", "not closed", "needs a '}'"},
    {"body b (a); definition d; {", "1:27", "not closed", "needs a '}'"},
    {"plane a", "1:8", "the end of the file", "expected '<' or '('"},
    {std::string("plane a <1 0 \0 0>;", 18), "1:14", "\\x00", "a plane takes 4 numbers"},
    {"plane \xC3\xA4 <1 0 0 0>;", "1:7", "\\xc3\\xa4", "expected '<' or '('"},
    {"plane " + std::string(100, '$'), "1:7", std::string(40, '$') + "...'", "expected"},
};
INSTANTIATE_TEST_SUITE_P(Words, OneError, testing::ValuesIn(words));

const ErrorCase numbers[] = {
    {"plane a <nan 0 0 0>;", "1:10", "'nan' is not a number", "write a finite decimal"},
    {"plane a <1 -nan 0 0>;", "1:12", "'-nan' is not a number", "write a finite decimal"},
    {"plane a <1 0 inf 0>;", "1:14", "'inf' is not a number", "write a finite decimal"},
    {"plane a <1 0 0 -Infinity>;", "1:16", "'-Infinity' is not a number", "write a finite decimal"},
    {"plane a <0x10 0 0 0>;", "1:10", "hexadecimal", "write a decimal"},
    {"plane a <-0X1p3 0 0 0>;", "1:10", "hexadecimal", "write a decimal"},
    {"plane a <1e309 0 0 0>;", "1:10", "out of range", "from 1e-308 to 1e308"},
    {"plane a <1.1e308 0 0 0>;", "1:10", "out of range", "from 1e-308 to 1e308"},
    {"plane a <1 0 0 -1e99999999999>;", "1:16", "out of range", "from 1e-308 to 1e308"},
    {"plane a <1 0 0 9e-309>;", "1:16", "out of range", "write 0"},
    {"plane a <1 0 0 1e-400>;", "1:16", "out of range", "write 0"},
    {"plane a <1 0 0 1.2.3>;", "1:16", "'1.2.3' is not a number", "write a finite decimal"},
    {"plane a <1 0 0 1-2>;", "1:16", "'1-2' is not a number", "write a finite decimal"},
    {"plane a <1 0 0 3mm>;", "1:16", "'3mm' is not a number", "write a finite decimal"},
    {"plane a <1 0 0 +-3>;", "1:16", "'+-3' is not a number", "write a finite decimal"},
    {"plane a <1 0 0 .>;", "1:16", "'.' is not a number", "write a finite decimal"},
    {"plane a <1 0 0 1e>;", "1:16", "'1e' is not a number", "write a finite decimal"},
    {"plane a <1 0 0 " + std::string(401, '1') + ">;", "1:16", "too long", "at most 400"},
};
INSTANTIATE_TEST_SUITE_P(Numbers, OneError, testing::ValuesIn(numbers));

const ErrorCase half_spaces[] = {
    {"plane a <1, 0, 0, 0>;", "1:11", "found ','", "white space separates"},
    {"plane a <1 0 0>;", "1:15", "found '>' after 3", "takes 4 numbers (A B C D)"},
    {"plane a <1 0 0 0 0>;", "1:18", "found '0' as one more", "takes 4 numbers (A B C D)"},
    {"quadric a <1 0 0 0>;", "1:19", "found '>' after 4", "takes 10 numbers (A B C D E F G H J K)"},
    {"plane a <1 0 0 0);", "1:17", "found ')'", "expected '>'"},
    {"plane a 1 0 0 0;", "1:9", "found '1'", "expected '<' or '('"},
    {"plane a <1 0 0 0> =x;", "1:19", "found '=x'", "'=t' (transparent) or '=0' (opaque)"},
    {"plane a <1 0 0 0> = t;", "1:19", "nothing between", "expected ';'"},
    {" plane a <0 0 0 4>;", "1:2", "no direction", "one of A B C must not be 0"},
    {"plane a <-0 0.0 0e9 4>;", "1:1", "no direction", "one of A B C must not be 0"},
    {"quadric a <0 0 0 0 0 0 0 0 0 4>;", "1:1", "no surface", "must not be 0"},
    {"plane a <1 0 0 0>;\nquadric a <1 0 0 0 0 0 0 0 0 0>;", "2:9", "already defined at t.uq:1:7", "choose another id"},
};
INSTANTIATE_TEST_SUITE_P(HalfSpaces, OneError, testing::ValuesIn(half_spaces));

const ErrorCase bodies[] = {
    {"body b ();", "1:1", "no half-space", "name at least one"},
    {"plane a <1 0 0 0>; body b (a\nbody c (a);", "2:1", "found 'body'", "the id of a plane or quadric, '!' or ')'"},
    {"plane a <1 0 0 0>; body\nbody c (a);", "2:1", "found 'body'", "the rest of the statement"},
    {"plane a <1 0 0 0>; body b (a view);", "1:30", "'view' is a word of the language", "choose another id"},
    {"body b <>;", "1:1", "no half-space", "name at least one"},
    {"plane outer <1 0 0 0>; body b (outr);", "1:32", "no plane or quadric 'outr'", "did you mean 'outer'?"},
    {"body b (!zz);", "1:10", "no plane or quadric 'zz' outside the definitions", "define it there"},
    {"plane a <1 0 0 0>; definition d; body b (a); enddef;", "1:42", "'a' in definition 'd'", "define it there"},
    {"definition d; plane a <1 0 0 0>; enddef; body b (a);", "1:50", "'a' outside the definitions", "define it there"},
    {"plane a <1 0 0 0>; body b (a, a);", "1:29", "found ','", "white space separates"},
    {"plane a <1 0 0 0>; body b (a>;", "1:29", "found '>'", "the id of a plane or quadric, '!' or ')'"},
    {"plane a <1 0 0 0>; body b (a !);", "1:31", "found ')'", "the id of a plane or quadric after '!'"},
    {"plane a <1 0 0 0>; body b (!!a);", "1:29", "found '!'", "the id of a plane or quadric after '!'"},
    {"plane a <1 0 0 0>; body b a;", "1:27", "found 'a'", "expected '<' or '('"},
    {"plane a <1 0 0 0>; body b (a); body b (a);", "1:37", "'b' is already defined at t.uq:1:25", "another id"},
    {"plane a <1 0 0 0>; body b (a) =t;", "1:31", "found '=t'", "expected ';'"},
};
INSTANTIATE_TEST_SUITE_P(Bodies, OneError, testing::ValuesIn(bodies));

const std::string ball = "definition ball; quadric q <1 1 1 0 0 0 0 0 0 -1>; body b (q); enddef;\n";
const ErrorCase hierarchy[] = {
    {"instance i (ball);", "1:13", "no definition 'ball'", "write one, from 'definition' to 'enddef;'"},
    {ball + "array a (bal) 2;", "2:10", "no definition 'bal'", "did you mean 'ball'?"},
    {ball + "definition ball; enddef;", "2:12", "already defined at t.uq:1:12", "choose another id"},
    {ball + "instance i (ball); array i (ball) 2;", "2:26", "already defined at t.uq:2:10", "choose another id"},
    {ball + "instance i (ball =qx 1);", "2:18", "found '=qx'", "=tx =ty =tz =ta =sx =sy =sz =sa =rx"},
    {ball + "instance i (ball =vxx 1);", "2:18", "found '=vxx'", "=vxy =vxz =vyx =vyz =vzx =vzy"},
    {ball + "instance i (ball =ra 1);", "2:18", "found '=ra'", "a transform ("},
    {ball + "instance i (ball =t 1);", "2:18", "found '=t'", "a transform ("},
    {ball + "instance i (ball =tx);", "2:21", "found ')'", "a number after '=tx'"},
    {ball + "instance i (ball =tx 1, =ty 1);", "2:23", "found ','", "a transform or ')'"},
    {ball + "instance i (ball) =tx 1;", "2:19", "found '=tx'", "expected ';'"},
    {ball + "instance i ball;", "2:12", "found 'ball'", "expected '<' or '('"},
    {ball + "instance i ();", "2:13", "found ')'", "the id of a definition"},
    {ball + "instance i (ball =sx 0);", "2:22", "scaling by 0", "a factor other than 0 after '=sx'"},
    {ball + "array i (ball) 3 =sa -0.0;", "2:22", "scaling by 0", "a factor other than 0 after '=sa'"},
    {ball + "array i (ball);", "2:15", "found ';'", "the number of copies"},
    {ball + "array i (ball) 0;", "2:16", "'0' is not a number of copies", "a whole number from 1 to 1000000"},
    {ball + "array i (ball) -3;", "2:16", "'-3' is not a number of copies", "a whole number from 1"},
    {ball + "array i (ball) 2.5;", "2:16", "'2.5' is not a number of copies", "a whole number from 1"},
    {ball + "array i (ball) 1e3;", "2:16", "'1e3' is not a number of copies", "a whole number from 1"},
    {ball + "array i (ball) nan;", "2:16", "'nan' is not a number of copies", "a whole number from 1"},
    {ball + "array i (ball) 1000001;", "2:16", "too many", "at most 1000000"},
    {ball + "array i (ball) 99999999999999999999999;", "2:16", "too many", "at most 1000000"},
    {"definition a;\ninstance i (a);\nenddef;", "2:13", "'a' contains itself: 'a' draws 'a'", "remove one"},
    {"definition a; instance i (b); enddef;\ndefinition b; array i (c) 2; enddef;\n"
     "definition c; instance i (b); enddef; instance i (a);",
     "3:27", "'b' contains itself: 'b' draws 'c' draws 'b'", "remove one"},
    {"definition open;\nplane p <1 0 0 0>;", "1:1", "still open", "write 'enddef;'"},
    {"enddef;", "1:1", "no definition to end", "remove this 'enddef;'"},
    {"definition a;\n definition b; enddef; enddef;", "2:2", "cannot stand in another", "end 'a' (line 1)"},
    {"definition a;\nlight .5; enddef;", "2:1", "a light cannot stand in a definition", "move it behind"},
    {"definition a;\nview whh 1; enddef;", "2:1", "a view cannot stand in a definition", "'enddef;' of 'a'"},
};
INSTANTIATE_TEST_SUITE_P(Hierarchy, OneError, testing::ValuesIn(hierarchy));

const ErrorCase lights_and_views[] = {
    {"light s;", "1:8", "found ';'", "the intensity of the light"},
    {"light s .5 1 2;", "1:15", "found ';' after 2", "takes 3 numbers (x y z)"},
    {"light s .5 1 2 3 4;", "1:18", "'4' as one more", "takes 3 numbers (x y z)"},
    {"light s .5 0 0 0;", "1:12", "zero vector", "one of x y z must not be 0"},
    {"light s 1; light s 1;", "1:18", "already defined at t.uq:1:7", "choose another id"},
    {"view v;", "1:7", "found ';'", "a view parameter (vrp, vpn, vup, dop, cop, whh, whw, fbp)"},
    {"view v vrx 0 0 0;", "1:8", "found 'vrx'", "did you mean 'vrp'?"},
    {"view v vrp 0 0;", "1:15", "found ';' after 2", "'vrp' takes 3 numbers (x y z)"},
    {"view v whh 1 2;", "1:14", "found '2' as one more", "'whh' takes 1 number (size)"},
    {"view v vrp 0 0 0 =p;", "1:18", "found '=p'", "no option after 'vrp'"},
    {"view v dop 0 0 1 =a;", "1:18", "found '=a'", "'=v' or '=p' after 'dop'"},
    {"view v cop 0 0 1 =v;", "1:18", "found '=v'", "'=a' or '=r' after 'cop'"},
    {"view v vpn 0 0 0;", "1:8", "'vpn' is the zero vector", "needs a direction"},
    {"view v vup 0 0 0 =v;", "1:8", "'vup' is the zero vector", "needs a direction"},
    {"view v dop 0 0 0;", "1:8", "'dop' is the zero vector", "needs a direction"},
    {"view v vrp 1 2 3 vup 1 2 3 =p;", "1:18", "'vup' is the view reference point", "away from vrp"},
    {"view v vpn 0 0 0 =p vrp 1 2 3;", "1:8", "'vpn' is the view reference point", "away from vrp"},
    {"view v whh 0;", "1:8", "'whh' is 0", "must be above 0"},
    {"view v whw -2;", "1:8", "'whw' is -2", "must be above 0"},
    {"view v fbp 2 2;", "1:8", "front plane at 2 and its back plane at 2", "the front must be the smaller"},
    {"view v fbp 3 -2;", "1:8", "front plane at 3", "the front must be the smaller"},
    {"view v whh 1; view v whh 1;", "1:20", "already defined at t.uq:1:6", "choose another id"},
    {"view plane whh 1;", "1:6", "'plane' is a word of the language", "choose another id"},
};
INSTANTIATE_TEST_SUITE_P(LightsAndViews, OneError, testing::ValuesIn(lights_and_views));

TEST(Errors, NumbersAtTheEndsOfTheRangeAreGood) {
  EXPECT_EQ(errors("plane a <1e308 -1e308 1e-308 -1e-308>; plane b <1. .5 00012 1E+2>;"), std::vector<std::string>{});
  EXPECT_EQ(errors("plane a <1 0e999999999 -0 0.000e-99999>;"), std::vector<std::string>{});
  EXPECT_EQ(parse("plane a <1 0e999999999 0 0>;").scene.top.planes.at(0).coefficients[1].text, "0");
}

TEST(Errors, ALimitIsToldFromAnError) {
  EXPECT_EQ(parse(ball + "array i (ball) 1000001;").diagnostics.at(0).severity, Severity::limit);
  EXPECT_EQ(parse(ball + "array i (ball) 0;").diagnostics.at(0).severity, Severity::error);
}

TEST(Errors, AllOfATextComeInOneRunInItsOrder) {
  const std::vector<std::string> found = errors(
      "body b (c a);\n"
      "plane c <0 0 nan 0x1 5>;\n"
      "plane d <0 0 0 1>\n"
      "light .5 0 0 0; instance i (e); quadric c <1>; oops;\n"
      "enddef; array (f =sx 0 =sy 0) 0 =sz 0;\n");
  std::vector<std::string> places;
  places.reserve(found.size());
  for (const std::string& line : found) places.push_back(line.substr(5, line.find(": ") - 5));
  EXPECT_EQ(places, (std::vector<std::string>{"1:11", "2:14", "2:18", "2:22", "3:1", "3:18", "4:10", "4:29", "4:41",
                                              "4:45", "4:48", "5:1", "5:16", "5:22", "5:28", "5:31", "5:37"}))
      << testing::PrintToString(found);
}

TEST(Errors, AStatementWithAnErrorStillDefinesItsId) {
  EXPECT_EQ(errors("plane a <1 0 0 x>; body b (a); definition d oops; enddef; instance i (d);").size(), 2U);
}

TEST(Errors, ReadingGoesOnAtAStatementWordThatStartsALine) {
  const std::vector<std::string> found = errors("plane a <1 0\nplane b <0 0 0 1>;\nbody c (a b);");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].substr(0, 9), "t.uq:2:1:");
  EXPECT_EQ(found[1], "t.uq:2:1: error: this plane has no direction; one of A B C must not be 0");
}

TEST(Errors, EndWithANoteAfterAHundred) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "oops;\n";
  const std::vector<std::string> found = errors(text);
  ASSERT_EQ(found.size(), 101U);
  EXPECT_EQ(found[99].substr(0, 11), "t.uq:100:1:");
  EXPECT_EQ(found[100], "error: nothing more is checked after 100 errors; mend these first");
}

TEST(Errors, OfReferencesEndAfterAHundredToo) {
  std::string body = "body b (";
  std::string instances;
  for (int i = 0; i < 1000; ++i) {
    body += "unknown ";
    instances += "instance (unknown);";
  }
  EXPECT_EQ(errors(body + ");").size(), 101U);
  EXPECT_EQ(errors(instances).size(), 101U);
}

TEST(Errors, NameTheFileTheyAreIn) {
  const std::vector<SourceText> files = {{"b.uq", "plane p <1 0 0 0>; definition d;"},
                                         {"a.uq", "\nplane p <1 0 0 0>; body b (p q); definition e; enddef;"}};
  EXPECT_EQ(messages(parse_uniquadrix(files)),
            (std::vector<std::string>{
                "b.uq:1:20: error: this definition is still open at the end of the file; write 'enddef;' after its "
                "last statement",
                "a.uq:2:7: error: a plane or quadric 'p' is already defined at b.uq:1:7; choose another id",
                "a.uq:2:30: error: there is no plane or quadric 'q' outside the definitions; define it there"}));
}

TEST(Errors, ALongCycleIsNamedInPart) {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    text += "definition d" + std::to_string(i) + "; instance i (d" + std::to_string((i + 1) % 20) + "); enddef;\n";
  }
  const std::vector<std::string> found = errors(text);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("t.uq:20:29: error: definition 'd0' contains itself: 'd0' draws 'd1' draws"),
            std::string::npos)
      << found[0];
  EXPECT_NE(found[0].find("'d7' draws ... draws 'd0';"), std::string::npos) << found[0];
}

// A chain of `length` definitions, each drawing the next.
std::string chain(int length) {
  std::string text = "instance top (d0);";
  for (int i = 0; i + 1 < length; ++i) {
    text += "definition d" + std::to_string(i) + "; instance i (d" + std::to_string(i + 1) + "); enddef;\n";
  }
  return text + "definition d" + std::to_string(length - 1) + "; enddef;";
}

TEST(Errors, NestingHasALimit) {
  EXPECT_EQ(errors(chain(1000)), std::vector<std::string>{});
  for (const int length : {1001, 100'000}) {
    const ParseResult result = parse(chain(length));
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].severity, Severity::limit);
    EXPECT_NE(result.diagnostics[0].message.find("more than 1000 deep"), std::string::npos);
  }
}

}  // namespace
}  // namespace halfspace::test
