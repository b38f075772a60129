// real.hpp - a number of 256 bits (MPFR), for scenes as their text means them.
#pragma once

#include <mpfr.h>

#include <string>
#include <utility>

namespace halfspace::oracle {

class Real {
 public:
  static constexpr mpfr_prec_t bits = 256;

  Real() : Real(0.0) {}
  Real(double v) {  // NOLINT(google-explicit-constructor): constants in formulae
    mpfr_init2(m_, bits);
    mpfr_set_d(m_, v, MPFR_RNDN);
  }
  Real(const Real& other) {
    mpfr_init2(m_, bits);
    mpfr_set(m_, other.m_, MPFR_RNDN);
  }
  Real(Real&& other) noexcept {
    mpfr_init2(m_, bits);
    mpfr_swap(m_, other.m_);
  }
  Real& operator=(const Real& other) {
    mpfr_set(m_, other.m_, MPFR_RNDN);
    return *this;
  }
  Real& operator=(Real&& other) noexcept {
    mpfr_swap(m_, other.m_);
    return *this;
  }
  ~Real() { mpfr_clear(m_); }

  // A decimal literal.
  static Real parse(const std::string& text) {
    Real r;
    mpfr_set_str(r.m_, text.c_str(), 10, MPFR_RNDN);
    return r;
  }

  static Real cos_degrees(const Real& degrees) {
    Real r;
    mpfr_cosu(r.m_, degrees.m_, 360, MPFR_RNDN);
    return r;
  }

  static Real sin_degrees(const Real& degrees) {
    Real r;
    mpfr_sinu(r.m_, degrees.m_, 360, MPFR_RNDN);
    return r;
  }

  [[nodiscard]] double to_double() const { return mpfr_get_d(m_, MPFR_RNDN); }

  Real& operator+=(const Real& b) { return mpfr_add(m_, m_, b.m_, MPFR_RNDN), *this; }
  Real& operator-=(const Real& b) { return mpfr_sub(m_, m_, b.m_, MPFR_RNDN), *this; }
  Real& operator*=(const Real& b) { return mpfr_mul(m_, m_, b.m_, MPFR_RNDN), *this; }
  Real& operator/=(const Real& b) { return mpfr_div(m_, m_, b.m_, MPFR_RNDN), *this; }
  friend Real operator+(Real a, const Real& b) { return a += b; }
  friend Real operator-(Real a, const Real& b) { return a -= b; }
  friend Real operator*(Real a, const Real& b) { return a *= b; }
  friend Real operator/(Real a, const Real& b) { return a /= b; }
  friend Real operator-(Real a) { return mpfr_neg(a.m_, a.m_, MPFR_RNDN), a; }
  friend Real sqrt(Real a) { return mpfr_sqrt(a.m_, a.m_, MPFR_RNDN), a; }
  friend Real abs(Real a) { return mpfr_abs(a.m_, a.m_, MPFR_RNDN), a; }

  friend bool operator<(const Real& a, const Real& b) { return mpfr_less_p(a.m_, b.m_) != 0; }
  friend bool operator>(const Real& a, const Real& b) { return b < a; }
  friend bool operator<=(const Real& a, const Real& b) { return mpfr_lessequal_p(a.m_, b.m_) != 0; }
  friend bool operator>=(const Real& a, const Real& b) { return b <= a; }
  friend bool operator==(const Real& a, const Real& b) { return mpfr_equal_p(a.m_, b.m_) != 0; }

 private:
  mpfr_t m_;
};

}  // namespace halfspace::oracle
