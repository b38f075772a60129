// quartic_table.hpp - what is known of the quartics of one body, each worked out once however many faces ask.
// Two quadrics have one n up to a constant, on whichever of them the sheets are.
#pragma once

#include <array>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "host/resolve/line_root.hpp"
#include "host/resolve/quartic.hpp"
#include "host/resolve/root_marks.hpp"

namespace halfspace {

// P^2 = R^2 d, d apart.
struct Radical {
  Curve p, r;
};

// An irreducible curve of degree three or four, canonical. Two of one table are different curves.
class KnownQuartic {
 public:
  // The lines y0 .. y1 are those of its marks.
  KnownQuartic(QuarticForm form, std::int64_t y0, std::int64_t y1) : form_(std::move(form)), y0_(y0), y1_(y1) {}

  [[nodiscard]] const QuarticForm& form() const { return form_; }
  // Where it turns. Of P^2 = R^2 d the points P = R = 0 are nodes: double roots of the discriminant.
  [[nodiscard]] const std::vector<Mark>& turns(const std::optional<Radical>& radical);
  // Where it meets a curve of second order that is no part of it, or another quartic.
  [[nodiscard]] std::vector<Mark> meetings(const Curve& p) const;
  [[nodiscard]] const std::vector<Mark>& meetings(const KnownQuartic& p);
  // On a local line. Valid as long as the table.
  [[nodiscard]] const std::vector<LineRoot>& roots(std::int64_t y);

 private:
  QuarticForm form_;
  std::int64_t y0_, y1_;
  std::optional<std::vector<Mark>> turns_;
  std::map<const KnownQuartic*, std::vector<Mark>> meetings_;
  std::unordered_map<std::int64_t, std::vector<LineRoot>> roots_;
};

// The factors of an n, each once.
struct KnownFactors {
  std::vector<Curve> curves;  // of degree one and two
  std::vector<KnownQuartic*> quartics;
};

// References stay valid as long as the table.
class QuarticTable {
 public:
  // Marks are those of the local lines y0 .. y1.
  QuarticTable(std::int64_t y0, std::int64_t y1) : y0_(y0), y1_(y1) {}

  // p is not zero.
  [[nodiscard]] const KnownFactors& factors_of(QuarticForm p);

 private:
  [[nodiscard]] KnownQuartic* known(QuarticForm p);

  std::int64_t y0_, y1_;
  std::map<std::array<mpz_class, 15>, KnownFactors> factors_;
  std::list<KnownQuartic> quartics_;
};

}  // namespace halfspace
