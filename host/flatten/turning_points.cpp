#include "host/flatten/turning_points.hpp"

#include <flint/fmpz_mpoly.h>

#include <array>

namespace halfspace {
namespace {

constexpr slong v_axis = 1;
constexpr slong w_axis = 2;

// Polynomials in u, v, w.
const fmpz_mpoly_ctx_struct* space() {
  static const struct Context {
    fmpz_mpoly_ctx_t ring;
    Context() { fmpz_mpoly_ctx_init(ring, 3, ORD_LEX); }
    ~Context() { fmpz_mpoly_ctx_clear(ring); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
  } context;
  return context.ring;
}

}  // namespace

// In FLINT's keeping.
class TurningPoints::SpacePolynomial {
 public:
  SpacePolynomial() { fmpz_mpoly_init(p_, space()); }
  explicit SpacePolynomial(const SliceForm& form) : SpacePolynomial() {
    static constexpr std::array<std::array<ulong, 3>, 10> powers{
        {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
    fmpz_t c;
    fmpz_init(c);
    for (std::size_t i = 0; i < powers.size(); ++i) {
      fmpz_set_mpz(c, form.q[i].get_mpz_t());
      fmpz_mpoly_set_coeff_fmpz_ui(p_, c, powers[i].data(), space());
    }
    fmpz_clear(c);
  }
  SpacePolynomial(const SpacePolynomial&) = delete;
  SpacePolynomial& operator=(const SpacePolynomial&) = delete;
  SpacePolynomial(SpacePolynomial&& other) noexcept : SpacePolynomial() { fmpz_mpoly_swap(p_, other.p_, space()); }
  SpacePolynomial& operator=(SpacePolynomial&& other) noexcept {
    fmpz_mpoly_swap(p_, other.p_, space());
    return *this;
  }
  ~SpacePolynomial() { fmpz_mpoly_clear(p_, space()); }

  [[nodiscard]] bool is_zero() const { return fmpz_mpoly_is_zero(p_, space()) != 0; }
  [[nodiscard]] slong degree_in(slong axis) const { return fmpz_mpoly_degree_si(p_, axis, space()); }

  [[nodiscard]] SpacePolynomial leading(slong axis) const {
    SpacePolynomial result;
    const auto order = static_cast<ulong>(degree_in(axis));
    fmpz_mpoly_get_coeff_vars_ui(result.p_, p_, &axis, &order, 1, space());
    return result;
  }
  [[nodiscard]] SpacePolynomial discriminant(slong axis) const {
    SpacePolynomial result;
    fmpz_mpoly_discriminant(result.p_, p_, axis, space());
    return result;
  }
  [[nodiscard]] SpacePolynomial resultant(const SpacePolynomial& other, slong axis) const {
    SpacePolynomial result;
    fmpz_mpoly_resultant(result.p_, p_, other.p_, axis, space());
    return result;
  }
  // Without the factors that `other` has too.
  [[nodiscard]] SpacePolynomial without(const SpacePolynomial& other) const {
    SpacePolynomial common, result;
    fmpz_mpoly_gcd(common.p_, p_, other.p_, space());
    fmpz_mpoly_divides(result.p_, p_, common.p_, space());
    return result;
  }
  // Without multiple factors of positive degree along the axis.
  [[nodiscard]] SpacePolynomial squarefree(slong axis) const {
    SpacePolynomial slope;
    fmpz_mpoly_derivative(slope.p_, p_, axis, space());
    return without(slope);
  }

  // Of one in u alone, each root once: crossings of a projection are double zeros of its discriminant.
  [[nodiscard]] Polynomial in_u() const {
    Polynomial result;
    if (is_zero()) return result;
    result.resize(static_cast<std::size_t>(degree_in(0)) + 1);
    fmpz_t c;
    fmpz_init(c);
    for (slong i = 0; i < fmpz_mpoly_length(p_, space()); ++i) {
      fmpz_mpoly_get_term_coeff_fmpz(c, p_, i, space());
      fmpz_get_mpz(result[fmpz_mpoly_get_term_var_exp_ui(p_, i, 0, space())].get_mpz_t(), c);
    }
    fmpz_clear(c);
    return degree(result) > 1 ? squarefree_part(result) : result;
  }

  // Where its roots in v meet or run to infinity. False: it has multiple factors.
  bool append_turns(std::vector<Polynomial>& found) const {
    if (is_zero()) return true;
    found.push_back(leading(v_axis).in_u());
    if (degree_in(v_axis) < 2) return true;
    SpacePolynomial turns = discriminant(v_axis);
    if (!turns.is_zero()) {
      found.push_back(turns.in_u());
      return true;
    }
    const SpacePolynomial once = squarefree(v_axis);
    if (once.degree_in(v_axis) >= 2) found.push_back(once.discriminant(v_axis).in_u());
    return false;
  }

  // Where roots in v of both coincide, but for common factors. False: there are some.
  bool append_meetings(const SpacePolynomial& other, std::vector<Polynomial>& found) const {
    if (is_zero() || other.is_zero()) return true;
    const SpacePolynomial all = resultant(other, v_axis);
    found.push_back(all.is_zero() ? without(other).resultant(other.without(*this), v_axis).in_u() : all.in_u());
    return !all.is_zero();
  }

 private:
  fmpz_mpoly_t p_;
};

TurningPoints::TurningPoints(std::span<const SliceForm> forms) : forms_(forms) {}
TurningPoints::~TurningPoints() = default;

const TurningPoints::SpacePolynomial& TurningPoints::form(std::uint32_t i) {
  const auto known = read_.find(i);
  return known != read_.end() ? known->second : read_.emplace(i, SpacePolynomial(forms_[i])).first->second;
}

// The projection along w of the curve in which two surfaces meet; of one surface (i = j) that of its limb, or of its pole.
const TurningPoints::SpacePolynomial& TurningPoints::shadow(std::uint32_t i, std::uint32_t j) {
  const std::vector<std::uint32_t> name{i, j};
  if (const auto known = shadows_.find(name); known != shadows_.end()) return known->second;
  const SpacePolynomial& f = form(i);
  SpacePolynomial result;
  if (i != j) {
    result = f.resultant(form(j), w_axis);
  } else {
    result = f.degree_in(w_axis) == 2 ? f.discriminant(w_axis) : f.leading(w_axis);
  }
  return shadows_.emplace(name, std::move(result)).first->second;
}

const std::vector<Polynomial>& TurningPoints::of(const std::vector<std::uint32_t>& meeting) {
  const auto [entry, is_new] = known_.try_emplace(meeting);
  std::vector<Polynomial>& found = entry->second;
  if (!is_new) return found;
  const std::uint32_t i = meeting.front();
  const std::uint32_t j = meeting[meeting.size() / 2];
  const SpacePolynomial& curve = shadow(i, j);
  if (meeting.size() == 3) {
    const std::uint32_t k = meeting.back();
    // Common factors are curves that lie before each other: then another pair tells the points, or a limb, on which they come together.
    if (!curve.append_meetings(shadow(i, k), found) && !curve.append_meetings(shadow(j, k), found)) {
      curve.append_meetings(shadow(i, i), found);
    }
    return found;
  }
  const bool is_cast_once = curve.append_turns(found);
  if (i == j) return found;
  // A curve that lies before itself along w turns on a limb, too; that of a surface along w is the other's.
  for (const std::uint32_t k : meeting) {
    if (!is_cast_once) curve.append_meetings(shadow(k, k), found);
  }
  if (form(i).degree_in(w_axis) <= 0 && form(j).degree_in(w_axis) <= 0) form(i).append_meetings(form(j), found);
  return found;
}

}  // namespace halfspace
