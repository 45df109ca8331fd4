// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/uncertainty_members.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "axiometry/app/evaluate/uncertainty_text.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

using json::Value;

Result<void> take_methods(const Value& value, UncertaintyOptions& options) {
  AXIOMETRY_TRY(const auto* items, formats::items_in(value, "methods"));
  UncertaintyOptions chosen;
  for (const Value& item : *items) {
    AXIOMETRY_TRY(const std::string name, formats::text_in(item, "a method"));
    if (auto known = choose_methods(name, chosen); !known) return fail(known.error().message, item.at());
  }
  options.gum = chosen.gum;
  options.monte_carlo = chosen.monte_carlo;
  return {};
}

Result<void> take_trials(const Value& value, UncertaintyOptions& options) {
  AXIOMETRY_TRY(const double trials, formats::number_in(value, "trials"));
  if (trials < trials_min || trials > trials_max_workbench || trials != std::floor(trials))
    return fail(fmt::format("found {} trials, expected null or a whole number from {:.0f} to {:.0f}",
                            format_exact(trials), trials_min, trials_max_workbench),
                value.at());
  options.trials.propagation.trials = static_cast<std::size_t>(trials);
  return {};
}

/// A number below seed_limit, or text: of the numbers from there on JSON's readers make others.
Result<void> take_seed(const Value& value, UncertaintyOptions& options) {
  if (value.is(json::Kind::number) && value.number() >= 0 && value.number() < static_cast<double>(seed_limit) &&
      value.number() == std::floor(value.number())) {
    options.trials.seed = static_cast<std::uint64_t>(value.number());
    return {};
  }
  const auto whole = value.is(json::Kind::text) ? parse_count(value.text()) : std::nullopt;
  if (!whole)
    return fail("found a seed that is no whole number from 0 to 9007199254740991, or text up to 18446744073709551615",
                value.at());
  options.trials.seed = *whole;
  return {};
}

Result<void> take_coverage(const Value& value, UncertaintyOptions& options) {
  double& coverage = options.trials.propagation.coverage;
  AXIOMETRY_TRY(coverage, formats::number_in(value, "coverage"));
  if (is_coverage(coverage)) return {};
  return fail(fmt::format("found the coverage {}, expected a probability from 0.5 to 0.9999", format_exact(coverage)),
              value.at());
}

}  // namespace

Result<void> take_uncertainty(formats::JsonMembers& members, UncertaintyOptions& options) {
  if (const Value* methods = members.optional("methods")) AXIOMETRY_TRY_VOID(take_methods(*methods, options));
  if (const Value* trials = members.optional("trials")) AXIOMETRY_TRY_VOID(take_trials(*trials, options));
  if (const Value* seed = members.optional("seed")) AXIOMETRY_TRY_VOID(take_seed(*seed, options));
  if (const Value* coverage = members.optional("coverage")) AXIOMETRY_TRY_VOID(take_coverage(*coverage, options));
  return {};
}

}  // namespace axiometry::app
