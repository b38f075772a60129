// root_gaps.hpp - the open intervals between the real roots of several polynomials.
// Limit    Positions are integers in 2^-112: roots that are closer together than that count as one. Roots of any multiplicity and
//          pairs of complex ones near the line are such clusters too; nothing need be squarefree.
// Source   Descartes' rule of signs in Bernstein's basis, with halving.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "host/algebra/polynomial.hpp"

namespace halfspace {

inline constexpr int position_bits = 112;  // a position n is the number n / 2^112

// number / 2^shift.
struct Dyadic {
  mpz_class number;
  unsigned shift = 0;
};

class RootGaps {
 public:
  // Of the polynomials that are not zero, between two positions. They must outlive this.
  RootGaps(const std::vector<Polynomial>& all, const mpz_class& low, const mpz_class& high);

  // Gap i lies between clusters i - 1 and i; the first begins, and the last ends, at the end of the range.
  [[nodiscard]] std::size_t count() const { return clusters_.size() + 1; }
  [[nodiscard]] bool is_empty(std::size_t gap) const;
  [[nodiscard]] bool holds(std::size_t gap, const mpz_class& position) const;
  // A short number in a gap that is not empty.
  [[nodiscard]] Dyadic inside(std::size_t gap) const;

  // The gap's ends, as well as positions can say.
  [[nodiscard]] mpz_class low_end(std::size_t gap);
  [[nodiscard]] mpz_class high_end(std::size_t gap);

 private:
  // The roots of f in the open interval (at, at + 1) / 2^shift, or at / 2^shift itself.
  struct Root {
    const Polynomial* f = nullptr;
    mpz_class at;
    int shift = 0;
    bool is_point = false;

    [[nodiscard]] mpz_class low() const { return at << static_cast<unsigned>(position_bits - shift); }
    [[nodiscard]] mpz_class high() const {
      return (is_point ? at : mpz_class(at + 1)) << static_cast<unsigned>(position_bits - shift);
    }
    [[nodiscard]] bool is_fine() const { return is_point || shift >= position_bits; }
    [[nodiscard]] int sign_at(const mpz_class& number, int shift_of_number) const;
    void halve();  // of one that is not fine
  };
  struct Cluster {
    std::vector<Root> roots;
    mpz_class low, high;
  };

  [[nodiscard]] const mpz_class& low_of(std::size_t gap) const;
  [[nodiscard]] const mpz_class& high_of(std::size_t gap) const;
  void find(const std::vector<Polynomial>& all);
  void isolate(const Polynomial& f, const mpz_class& at, int shift);
  void separate();
  void gather();
  static void refine(Cluster& cluster);

  mpz_class low_, high_;
  std::vector<Root> roots_;
  std::vector<Cluster> clusters_;
};

}  // namespace halfspace
