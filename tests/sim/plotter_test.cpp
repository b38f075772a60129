// The simulated plotters refuse what misprints on paper: each violation, its wording and its byte offset.
#include "sim/plotter.hpp"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using F = PlotterFunction;
using M = PlotterMode;

void dots(SimulatedPlotter& plotter, std::size_t count, std::uint8_t value = 0) {
  const std::vector<std::uint8_t> bytes(count, value);
  (void)plotter.write(bytes);
}

void text(SimulatedPlotter& plotter, std::string_view letters) {
  const std::vector<std::uint8_t> bytes(letters.begin(), letters.end());
  (void)plotter.write(bytes);
}

void ready(SimulatedVersatec& plotter, M mode) {
  (void)plotter.function(F::reset);
  (void)plotter.function(F::clear);
  (void)plotter.set_mode(mode);
}

void ready(SimulatedVarian& plotter, M mode) {
  (void)plotter.set_mode(mode);
  if (mode == M::plot) (void)plotter.function(F::auto_step);
}

template <typename Plotter>
struct Case {
  std::size_t offset;
  const char* what;
  void (*script)(Plotter&);
};

template <typename Plotter, std::size_t N>
void expect_violations(const Case<Plotter> (&cases)[N]) {
  for (const Case<Plotter>& c : cases) {
    Plotter plotter;
    c.script(plotter);
    ASSERT_EQ(plotter.violations().size(), 1U) << c.what;
    EXPECT_EQ(plotter.violations()[0].what, c.what);
    EXPECT_EQ(plotter.violations()[0].offset, c.offset) << c.what;
  }
}

TEST(SimulatedVersatec, NamesEachViolationAndItsByte) {
  using P = SimulatedVersatec;
  const Case<P> cases[] = {
      {0, "mode set before reset and clear", [](P& p) { (void)p.set_mode(M::plot); }},
      {0, "mode set before reset and clear",
       [](P& p) {
         (void)p.function(F::reset);
         (void)p.set_mode(M::plot);
       }},
      {0, "clear that does not follow a reset", [](P& p) { (void)p.function(F::clear); }},
      {0, "feed before reset and clear", [](P& p) { (void)p.function(F::form_feed); }},
      {0, "write before a mode is set", [](P& p) { dots(p, 880); }},
      {0, "write before a mode is set",
       [](P& p) {
         (void)p.function(F::reset);
         (void)p.function(F::clear);
         dots(p, 1);
       }},
      {0, "transfer of no bytes",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 0);
       }},
      {0, "transfer of more than 16384 bytes",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 16385);
       }},
      {881, "mode set within a line",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 881);
         (void)p.set_mode(M::print);
       }},
      {879, "form feed within a line",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 879);
         (void)p.function(F::form_feed);
       }},
      {2000, "end of transmission within a line",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 2000);
         (void)p.function(F::end_of_transmission);
       }},
      {880, "terminate without a line begun",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 880);
         (void)p.function(F::terminate);
       }},
      {0, "a Versatec has no auto step",
       [](P& p) {
         ready(p, M::plot);
         (void)p.function(F::auto_step);
       }},
      {0, "feed in print-plot mode",
       [](P& p) {
         ready(p, M::print_plot);
         (void)p.function(F::form_feed);
       }},
      {3, "byte that print mode does not take",
       [](P& p) {
         ready(p, M::print);
         text(p, "\n\r\fA");
       }},
      {880, "job closed without a form feed or end of transmission",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 880);
         p.close();
       }},
      {100, "job closed within a line",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 100);
         p.close();
       }},
  };
  expect_violations(cases);
}

TEST(SimulatedVarian, NamesEachViolationAndItsByte) {
  using P = SimulatedVarian;
  const Case<P> cases[] = {
      {0, "write before a mode is set", [](P& p) { dots(p, 264); }},
      {0, "auto step before plot mode", [](P& p) { (void)p.function(F::auto_step); }},
      {0, "auto step before plot mode",
       [](P& p) {
         (void)p.set_mode(M::print);
         (void)p.function(F::auto_step);
       }},
      {0, "dots without auto step",
       [](P& p) {
         (void)p.set_mode(M::plot);
         dots(p, 264);
       }},
      {264, "dots without auto step",  // setting the mode again forgets it
       [](P& p) {
         ready(p, M::plot);
         dots(p, 264);
         (void)p.set_mode(M::plot);
         dots(p, 264);
       }},
      {2, "auto step within a line",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 2);
         (void)p.function(F::auto_step);
       }},
      {0, "transfer of an odd number of bytes",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 263);
       }},
      {0, "a Varian has no such function", [](P& p) { (void)p.function(F::reset); }},
      {0, "byte that print mode does not take",
       [](P& p) {
         ready(p, M::print);
         text(p, "\r\n");
       }},
      {266, "mode set within a line",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 266);
         (void)p.set_mode(M::print);
       }},
      {264, "job closed without a form feed",
       [](P& p) {
         ready(p, M::plot);
         dots(p, 264);
         p.close();
       }},
  };
  expect_violations(cases);
}

TEST(SimulatedVersatec, KeepsPagesApartFromFeeds) {
  SimulatedVersatec plotter;
  ready(plotter, M::plot);
  dots(plotter, 880, 0xAA);
  dots(plotter, 440, 0x55);
  dots(plotter, 440, 0x55);
  EXPECT_EQ(plotter.function(F::form_feed), DeviceStatus::ok);
  EXPECT_EQ(plotter.function(F::form_feed), DeviceStatus::ok);
  dots(plotter, 10, 0xFF);
  EXPECT_EQ(plotter.function(F::terminate), DeviceStatus::ok);
  EXPECT_EQ(plotter.function(F::end_of_transmission), DeviceStatus::ok);
  plotter.close();
  EXPECT_TRUE(plotter.violations().empty());
  ASSERT_EQ(plotter.pages().size(), 2U);
  EXPECT_EQ(plotter.pages()[0].width, 7040);
  EXPECT_EQ(plotter.pages()[0].height, 2);
  EXPECT_EQ(plotter.pages()[0].dots[879], 0xAA);
  EXPECT_EQ(plotter.pages()[0].dots[880], 0x55);
  EXPECT_EQ(plotter.pages()[1].height, 1);
  EXPECT_EQ(plotter.pages()[1].dots[9], 0xFF);
  EXPECT_EQ(plotter.pages()[1].dots[10], 0);
}

TEST(SimulatedVersatec, DropsAPageThatIsReset) {
  SimulatedVersatec plotter;
  ready(plotter, M::plot);
  dots(plotter, 1000);
  ready(plotter, M::plot);
  EXPECT_TRUE(plotter.pages().empty());
  plotter.close();
  EXPECT_TRUE(plotter.violations().empty());
}

TEST(SimulatedVersatec, EntersPlotModeAfterPrintPlot) {
  SimulatedVersatec plotter;
  ready(plotter, M::print_plot);
  text(plotter, "\n");
  dots(plotter, 880, 0xFF);
  EXPECT_TRUE(plotter.violations().empty());
  EXPECT_EQ(plotter.pages().size(), 1U);
}

TEST(SimulatedPlotter, TakesNothingOnceThePaperHasEnded) {
  SimulatedVarian plotter;
  plotter.limit_paper(2);
  ready(plotter, M::plot);
  const std::vector<std::uint8_t> bytes(1000);
  const Accepted first = plotter.write(bytes);
  EXPECT_EQ(first.status, DeviceStatus::ok);
  EXPECT_EQ(first.count, 528U);
  const Accepted second = plotter.write(bytes);
  EXPECT_EQ(second.status, DeviceStatus::no_paper);
  EXPECT_EQ(second.count, 0U);
}

TEST(SimulatedPlotter, StrikesTheCallsOfAFaultAndNoOthers) {
  SimulatedVarian plotter;
  plotter.set_fault({DeviceStatus::offline, 1, 2});
  EXPECT_EQ(plotter.set_mode(M::plot), DeviceStatus::ok);
  EXPECT_EQ(plotter.function(F::auto_step), DeviceStatus::offline);
  EXPECT_EQ(plotter.function(F::auto_step), DeviceStatus::offline);
  EXPECT_EQ(plotter.function(F::auto_step), DeviceStatus::ok);
  EXPECT_TRUE(plotter.violations().empty());
}

}  // namespace
}  // namespace halfspace
