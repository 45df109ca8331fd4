// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/method_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

using iso230_2::Contribution;
using iso230_2::ParameterDistribution;

double half_width(const ParameterDistribution& d) {
  return (std::max(d.high, d.value) - std::min(d.low, d.value)) / 2.0;
}

/// U of Annex A and of the GUM are for 95 %: an interval for another probability says nothing about them.
bool comparable(double coverage) { return std::abs(coverage - 0.95) < 1e-9; }

/// How the numbers of one row are written.
struct RowStyle {
  const Options& options;
  ParameterScale scale;
  AxisKind kind;

  int value_decimals(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment) const {
    return parameter_decimals(parameter, assessment, kind, options);
  }
  std::string number(double native, int places) const {
    return format_fixed(native * scale.per_native, places, options.numbers);
  }
};

ShownDistribution shown(const ParameterDistribution& d, const RowStyle& style) {
  const auto& s = d.summary;
  const double low = std::min(d.low, d.value), high = std::max(d.high, d.value);
  const int places = uncertainty_decimals(Deviation::native((high - low) / 4.0), style.scale, style.options);
  const int places_of_u = uncertainty_decimals(Deviation::native(s.sd), style.scale, style.options);
  const auto number = [&](double native) { return style.number(native, places); };
  const bool outside = d.value < d.low || d.value > d.high;
  return {number(s.mean),   s.sd == 0.0 ? "0" : style.number(s.sd, places_of_u),
          number(d.bias()), number(low),
          number(high),     shown_short(s.tolerance * style.scale.per_native, style.options, 1),
          s.stable,         outside};
}

MethodRow row(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, const RowStyle& style) {
  MethodRow row;
  row.parameter = &parameter;
  std::optional<double> half;
  if (assessment.monte_carlo) {
    if (const auto& d = assessment.monte_carlo->distributions[iso230_2::index_of(parameter)]; d && d->refusal.empty()) {
      row.monte_carlo = shown(*d, style);
      if (comparable(assessment.monte_carlo->coverage)) half = half_width(*d);
    }
  }
  if (const auto* gum = assessment.gum ? assessment.gum->find(parameter.key) : nullptr) {
    const Deviation U = gum->uncertainty.U;
    row.gum_U = shown_uncertainty(U, style.scale, style.options);
    if (half) row.gum_width = width_words(U.in_native(), *half, style.options);
    if (!half && !row.monte_carlo) half = U.in_native();
  }
  if (const auto U = assessment.annex_a ? assessment.annex_a->U.*parameter.member : std::nullopt) {
    row.annex_a_U = shown_uncertainty(*U, style.scale, style.options);
    if (half) row.annex_a_width = width_words(U->in_native(), *half, style.options);
  }
  const double value = (assessment.evaluation.parameters.*parameter.member)->in_native();
  row.value = style.number(value, style.value_decimals(parameter, assessment));
  return row;
}

}  // namespace

std::vector<MethodRow> method_rows(const iso230_2::Assessment& assessment, AxisKind kind, const Options& asked) {
  const Options options = fitted(asked, assessment.evaluation.parameters);
  const RowStyle style{options, parameter_scale(kind, options.unit), kind};
  std::vector<MethodRow> rows;
  for (const auto& parameter : iso230_2::parameters)
    if (assessment.evaluation.parameters.*parameter.member) rows.push_back(row(parameter, assessment, style));
  return rows;
}

std::string width_words(double U, double half_width, const Options& options) {
  constexpr double alike = 1.05;
  constexpr double most = 100.0;
  if (U <= 0.0 || half_width <= 0.0) return "";
  const double ratio = std::max(U / half_width, half_width / U);
  if (ratio <= alike) return "alike";
  const std::string_view which = U > half_width ? "wider" : "narrower";
  if (ratio > most) return fmt::format("over {:.0f}× {}", most, which);
  return fmt::format("{}× {}", format_fixed(ratio, std::max(0, decimals_for(ratio, 2)), options.numbers), which);
}

std::string measurand_statement(iso230_2::Measurand measurand, std::size_t runs, bool uncorrected) {
  std::string text;
  if (measurand == iso230_2::Measurand::this_test)
    text =
        "The uncertainty is that of this test: by how much the parameters may differ from those that the same "
        "approaches would have given with perfect instruments at 20 °C. The scatter of the machine itself is part "
        "of the result and not of its uncertainty.";
  else
    text = fmt::format(
        "The uncertainty is that of this machine: by how much the parameters of this test may differ from those that "
        "the axis has in the long run. Besides instruments and temperature it counts that {} {} per direction {} only "
        "a "
        "sample.",
        runs, runs == 1 ? "approach" : "approaches", runs == 1 ? "is" : "are");
  if (uncorrected)
    text += " What the findings tell as not corrected is not in it: without a correction it does not hold.";
  return text;
}

std::string method_statement(const iso230_2::Assessment& assessment) {
  const auto method = iso230_2::method_of_record(assessment);
  if (!method) return "";
  return fmt::format("Method of record: {}. It alone stands with the results and decides; others are for comparison.",
                     iso230_2::method_title(*method));
}

std::string hypothesis_statement(const iso230_2::Assessment& assessment) {
  const auto* run = iso230_2::run_with_intervals(assessment);
  if (run == nullptr || std::ranges::count(run->hypotheses, false, &iso230_2::NoiseHypothesis::refuted) < 2) return "";
  return "u, mean, bias and the histogram are those of one hypothesis about the noise, of each parameter the one with "
         "the "
         "largest u; the interval holds for all of them, and for noise of any size up to what they say";
}

namespace {

bool states_an_interval(const iso230_2::MonteCarlo& monte_carlo) {
  return std::ranges::any_of(monte_carlo.distributions, [](const auto& d) { return d && d->refusal.empty(); });
}

}  // namespace

std::string trials_statement(const iso230_2::MonteCarlo& monte_carlo) {
  if (!states_an_interval(monte_carlo))
    return fmt::format("{} trials, of which none states an interval", shown_count(monte_carlo.trials));
  std::string text = shown_count(monte_carlo.trials) + " trials, ";
  if (!monte_carlo.adaptive) text += "as asked for";
  if (monte_carlo.adaptive)
    text += monte_carlo.stable ? "as many as the numerical tolerance asked for (JCGM 101, 7.9)"
                               : "the most that were allowed";
  if (monte_carlo.stable) return text + "; every u is stable within its numerical tolerance";
  std::string symbols;
  for (std::size_t p = 0; p < std::size(iso230_2::parameters); ++p)
    if (const auto& d = monte_carlo.distributions[p]; d && !d->summary.stable)
      symbols.append(symbols.empty() ? "" : ", ").append(iso230_2::parameters[p].symbol);
  return text + "; not stable within the numerical tolerance: " + symbols;
}

std::string refusal_statement(const iso230_2::MonteCarlo& monte_carlo) {
  for (const auto& d : monte_carlo.distributions)
    if (d && !d->refusal.empty()) return std::string(iso230_2::refusal_sentence) + d->refusal;
  if (states_an_interval(monte_carlo)) return "";
  return "No interval is stated, since no input of the uncertainty acts on any parameter";
}

std::string type_a_statement(const iso230_2::MonteCarlo& monte_carlo) {
  if (monte_carlo.measurand == iso230_2::Measurand::this_test) return "";
  switch (monte_carlo.type_a) {
    case iso230_2::TypeA::pooled: return "pooled: the scatter at all targets tells about that at each";
    case iso230_2::TypeA::t_scaled: return "each target for itself: Student’s t for its mean, χ² for its variance";
    case iso230_2::TypeA::resampled: return "whole runs drawn with replacement (bootstrap)";
  }
  return "";
}

std::string outside_statement(std::span<const MethodRow> rows) {
  std::string symbols;
  for (const MethodRow& row : rows)
    if (row.monte_carlo && row.monte_carlo->value_outside)
      symbols.append(symbols.empty() ? "" : ", ").append(row.parameter->symbol);
  if (symbols.empty()) return "";
  return "Intervals widened to hold the measured value, of which known noise or systematic inputs explain a part: " +
         symbols;
}

std::string shown_distribution(const uncertainty::Distribution& distribution, const Options& options) {
  const auto number = [&](double x) { return shown_short(x, options, 5); };
  const auto limits = [&](std::string_view name, const auto& form) {
    return fmt::format("{} from {} to {}", name, number(form.lower), number(form.upper));
  };
  return std::visit(
      [&]<typename Form>(const Form& form) -> std::string {
        using namespace uncertainty;
        if constexpr (std::is_same_v<Form, Constant>)
          return fmt::format("constant {}", number(form.value));
        else if constexpr (std::is_same_v<Form, Normal>)
          return fmt::format("normal, mean {}, standard deviation {}", number(form.mean), number(form.sd));
        else if constexpr (std::is_same_v<Form, StudentT>)
          return fmt::format("t with {} degrees of freedom, location {}, scale {}", number(form.degrees_of_freedom),
                             number(form.location), number(form.scale));
        else if constexpr (std::is_same_v<Form, Uniform>)
          return limits("uniform", form);
        else if constexpr (std::is_same_v<Form, Triangular>)
          return limits("triangular", form);
        else if constexpr (std::is_same_v<Form, Trapezoidal>)
          return fmt::format("{}, top to base {}", limits("trapezoidal", form), number(form.beta));
        else if constexpr (std::is_same_v<Form, Arcsine>)
          return limits("arcsine", form);
        else if constexpr (std::is_same_v<Form, CurvilinearTrapezoid>)
          return fmt::format("{}, limits ± {}", limits("uniform", form), number(form.d));
        else
          return fmt::format("empirical, {} values", form.values.size());
      },
      distribution.form());
}

std::string shown_distribution(const std::string& text, const Options& options) {
  const auto parsed = uncertainty::Distribution::parse(text);
  return parsed ? shown_distribution(*parsed, options) : text;
}

std::string shown_percent(double share, const Options& options) {
  const double percent = 100.0 * share;
  if (percent > 0.0 && percent < 1.0) return "<\u00a01\u00a0%";
  const bool whole = std::abs(percent - std::round(percent)) < 1e-9 || percent < 99.0;
  return format_fixed(percent, whole ? 0 : 1, options.numbers) + "\u00a0%";
}

std::string shown_count(std::size_t count) {
  std::string digits = fmt::format("{}", count);
  for (std::size_t end = digits.size(); end > 3; end -= 3) digits.insert(end - 3, "\u2009");
  return digits;
}

std::vector<Contribution> gum_contributions(const iso230_2::GumUncertainty& gum) {
  std::vector<Contribution> all;
  for (std::size_t k = 0; k < gum.sources.size(); ++k) {
    Contribution own{gum.sources[k].key, gum.sources[k].title, {}};
    for (const auto& p : gum.parameters) own.u[iso230_2::index_of(*p.parameter)] = p.contributions[k].in_native();
    all.push_back(std::move(own));
  }
  return all;
}

namespace {

/// What rounding leaves of an input that has no effect is shown as none.
void drop_rounding(std::vector<Contribution>& all) {
  constexpr double negligible = 1e-9;
  for (std::size_t p = 0; p < std::size(iso230_2::parameters); ++p) {
    double largest = 0.0;
    for (const Contribution& c : all) largest = std::max(largest, c.u[p]);
    for (Contribution& c : all)
      if (c.u[p] < negligible * largest) c.u[p] = 0.0;
  }
}

}  // namespace

iso230_2::UncertaintyMethod contributing_method(const iso230_2::Assessment& assessment) {
  const auto* run = iso230_2::run_with_intervals(assessment);
  return run != nullptr && !run->contributions.empty() ? iso230_2::UncertaintyMethod::monte_carlo
                                                       : iso230_2::UncertaintyMethod::gum;
}

std::vector<Contribution> contributions(const iso230_2::Assessment& assessment) {
  std::vector<Contribution> all;
  if (const auto* run = iso230_2::run_with_intervals(assessment)) all = run->contributions;
  if (all.empty() && assessment.gum) all = gum_contributions(*assessment.gum);
  drop_rounding(all);
  const auto order = main_parameters(assessment.evaluation.parameters);
  std::ranges::stable_sort(all, [&](const Contribution& a, const Contribution& b) {
    for (std::size_t p : order)
      if (a.u[p] != b.u[p]) return a.u[p] > b.u[p];
    return false;
  });
  return all;
}

std::vector<std::size_t> main_parameters(const iso230_2::AxisParameters& measured) {
  const auto existing = [&](std::initializer_list<std::string_view> keys) {
    std::vector<std::size_t> found;
    for (std::string_view key : keys) {
      const auto& parameter = *iso230_2::find_parameter(key);
      if (measured.*parameter.member) found.push_back(iso230_2::index_of(parameter));
    }
    return found;
  };
  const auto bidirectional = existing({"A", "E", "M", "R", "B"});
  return bidirectional.empty() ? existing({"A_up", "A_down", "E_up", "E_down", "R_up", "R_down"}) : bidirectional;
}

double share(std::span<const Contribution> all, std::size_t of, std::size_t parameter) {
  double sum = 0.0;
  for (const Contribution& c : all) sum += c.u[parameter] * c.u[parameter];
  return sum > 0.0 ? all[of].u[parameter] * all[of].u[parameter] / sum : 0.0;
}

double standard_uncertainty(const iso230_2::Assessment& assessment, std::size_t parameter) {
  const auto& monte_carlo = assessment.monte_carlo;
  if (monte_carlo && !monte_carlo->contributions.empty()) {
    const auto& found = monte_carlo->distributions[parameter];
    return found ? found->summary.sd : 0.0;
  }
  const auto* found = assessment.gum ? assessment.gum->find(iso230_2::parameters[parameter].key) : nullptr;
  return found ? found->uncertainty.u.in_native() : 0.0;
}

std::optional<Leading> leading(std::span<const Contribution> all, std::size_t parameter,
                               const iso230_2::Assessment& assessment) {
  const auto largest = std::ranges::max_element(all, {}, [parameter](const Contribution& c) { return c.u[parameter]; });
  if (largest == all.end() || largest->u[parameter] <= 0.0) return std::nullopt;
  const double part = share(all, static_cast<std::size_t>(largest - all.begin()), parameter);
  const double u = standard_uncertainty(assessment, parameter);
  if (u <= 0.0) return std::nullopt;
  return Leading{&*largest, part, u, u * std::sqrt(std::max(0.0, 1.0 - part))};
}

std::string leading_statement(const Leading& leading, AxisKind kind, const Options& options) {
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto shown = [&](double native) { return shown_uncertainty(Deviation::native(native), scale, options); };
  const std::string start =
      fmt::format("{}, {} of the variance", leading.contribution->title, shown_percent(leading.share, options));
  constexpr double hardly_anything = 0.01;  // of u, below which a number would say more than is known
  if (leading.u_without < hardly_anything * leading.u)
    return fmt::format("{}; u\u00a0=\u00a0{}\u00a0{}", start, shown(leading.u), scale.unit);
  return fmt::format("{}; without it u would fall from {} to about {}\u00a0{}", start, shown(leading.u),
                     shown(leading.u_without), scale.unit);
}

}  // namespace axiometry::report
