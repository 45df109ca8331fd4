// SPDX-License-Identifier: Apache-2.0
// What makes a distribution from numbers and from words, and what is wrong with them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/uncertainty/distribution.h"

namespace axiometry::uncertainty {
namespace {

constexpr double degrees_of_freedom_min = 0.1;

Result<void> check_finite(double x) {
  if (!std::isfinite(x)) return fail(fmt::format("found the number {}, expected a finite one", x));
  return {};
}

Result<void> check_not_negative(double x, std::string_view what) {
  AXIOMETRY_TRY_VOID(check_finite(x));
  if (x < 0.0) return fail(fmt::format("found the {} {}, expected one not below 0", what, format_exact(x)));
  return {};
}

Result<void> check_limits(double lower, double upper) {
  AXIOMETRY_TRY_VOID(check_finite(lower));
  AXIOMETRY_TRY_VOID(check_finite(upper));
  if (lower > upper)
    return fail(
        fmt::format("found limits {} and {}, expected the lower one first", format_exact(lower), format_exact(upper)));
  if (!std::isfinite(upper - lower))
    return fail(
        fmt::format("found limits {} and {}, expected a width below 1e308", format_exact(lower), format_exact(upper)));
  return {};
}

Result<void> check(const Constant& f) { return check_finite(f.value); }

Result<void> check(const Normal& f) {
  AXIOMETRY_TRY_VOID(check_finite(f.mean));
  return check_not_negative(f.sd, "standard deviation");
}

Result<void> check(const StudentT& f) {
  AXIOMETRY_TRY_VOID(check_finite(f.degrees_of_freedom));
  if (f.degrees_of_freedom <= 0.0)
    return fail(fmt::format("found {} degrees of freedom, expected more than 0", format_exact(f.degrees_of_freedom)));
  if (f.degrees_of_freedom < degrees_of_freedom_min)
    return fail(fmt::format("found {} degrees of freedom, expected at least {}", format_exact(f.degrees_of_freedom),
                            degrees_of_freedom_min));
  AXIOMETRY_TRY_VOID(check_finite(f.location));
  return check_not_negative(f.scale, "scale");
}

Result<void> check(const Trapezoidal& f) {
  AXIOMETRY_TRY_VOID(check_limits(f.lower, f.upper));
  if (!(f.beta >= 0.0 && f.beta <= 1.0))
    return fail(fmt::format("found the ratio {} of top to base, expected 0 to 1", f.beta));
  return {};
}

Result<void> check(const CurvilinearTrapezoid& f) {
  AXIOMETRY_TRY_VOID(check_limits(f.lower, f.upper));
  AXIOMETRY_TRY_VOID(check_not_negative(f.d, "half width of the limits"));
  const double half = (f.upper - f.lower) / 2;
  if (f.d > half * (1.0 + 1e-12))  // half the width may be rounded, as in −0.05 to 0.05 with d = 0.05
    return fail(fmt::format("found limits {} and {} known within ±{}, expected at most ±{}, half their distance",
                            format_exact(f.lower), format_exact(f.upper), format_exact(f.d), format_exact(half)));
  return {};
}

Result<void> check(const Empirical& f) {
  if (f.values.empty()) return fail("found no value of an empirical distribution, expected at least one");
  for (const double x : f.values) AXIOMETRY_TRY_VOID(check_finite(x));
  return {};
}

template <typename Form>
Result<void> check(const Form& f) {
  return check_limits(f.lower, f.upper);
}

template <typename Form>
Distribution::Form from_numbers(std::span<const double> x) {
  if constexpr (std::is_same_v<Form, Empirical>)
    return Empirical{{x.begin(), x.end()}};
  else if constexpr (std::is_same_v<Form, Constant>)
    return Constant{x[0]};
  else if constexpr (requires { Form{0.0, 0.0, 0.0}; })
    return Form{x[0], x[1], x[2]};
  else
    return Form{x[0], x[1]};
}

/// One row per form, in the order of Distribution::Form.
struct Kind {
  std::string_view name;
  std::string_view parameters;
  std::size_t count;  ///< of parameters; 0: one or more
  Distribution::Form (*make)(std::span<const double>);
};

constexpr Kind kinds[] = {
    {"constant", "VALUE", 1, from_numbers<Constant>},
    {"normal", "MEAN SD", 2, from_numbers<Normal>},
    {"t", "DEGREES-OF-FREEDOM LOCATION SCALE", 3, from_numbers<StudentT>},
    {"uniform", "LOWER UPPER", 2, from_numbers<Uniform>},
    {"triangular", "LOWER UPPER", 2, from_numbers<Triangular>},
    {"trapezoidal", "LOWER UPPER BETA", 3, from_numbers<Trapezoidal>},
    {"arcsine", "LOWER UPPER", 2, from_numbers<Arcsine>},
    {"ctrap", "LOWER UPPER D", 3, from_numbers<CurvilinearTrapezoid>},
    {"empirical", "VALUE…", 0, from_numbers<Empirical>},
};
static_assert(std::size(kinds) == std::variant_size_v<Distribution::Form>);

std::vector<double> numbers_of(const Distribution::Form& form) {
  return std::visit(
      []<typename F>(const F& f) -> std::vector<double> {
        if constexpr (std::is_same_v<F, Empirical>) {
          return f.values;
        } else if constexpr (std::is_same_v<F, Constant>) {
          return {f.value};
        } else if constexpr (requires { F{0.0, 0.0, 0.0}; }) {
          const auto& [a, b, c] = f;
          return {a, b, c};
        } else {
          const auto& [a, b] = f;
          return {a, b};
        }
      },
      form);
}

Result<const Kind*> find_kind(std::string_view name) {
  if (const auto* kind = std::ranges::find(kinds, name, &Kind::name); kind != std::end(kinds)) return kind;
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds) names.push_back(kind.name);
  const auto near = text::nearest(name, names);
  return fail(near ? fmt::format("found the distribution {}, expected perhaps '{}'", text::quoted(name), *near)
                   : fmt::format("found the distribution {}, expected {}", text::quoted(name), fmt::join(names, ", ")));
}

}  // namespace

Result<Distribution> Distribution::make(Form form) {
  AXIOMETRY_TRY_VOID(std::visit([](const auto& f) { return check(f); }, form));
  if (auto* empirical = std::get_if<Empirical>(&form)) std::ranges::sort(empirical->values);
  return Distribution(std::move(form));
}

Result<Distribution> Distribution::parse(std::string_view text) {
  const auto words = text::words(text::trim(text));
  if (words.empty()) return fail("found nothing, expected a distribution such as 'uniform -0.5 0.5'");
  AXIOMETRY_TRY(const Kind* kind, find_kind(words[0]));
  std::vector<double> numbers;
  for (const std::string_view word : std::span(words).subspan(1)) {
    const auto x = parse_number(word);
    if (!x) return fail(fmt::format("found {} after '{}', expected a number", text::quoted(word), kind->name));
    numbers.push_back(*x);
  }
  if (kind->count == 0 ? numbers.empty() : numbers.size() != kind->count)
    return fail(fmt::format("found {} after '{}', expected {}", counted(numbers.size(), "number"), kind->name,
                            kind->parameters));
  return make(kind->make(numbers));
}

std::string Distribution::text() const {
  std::string text(kinds[form_.index()].name);
  for (const double x : numbers_of(form_)) text += " " + format_exact(x);
  return text;
}

}  // namespace axiometry::uncertainty
