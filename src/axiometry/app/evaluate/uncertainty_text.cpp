// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/uncertainty_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr std::array<std::string_view, 3> methods = {"annex-a", "gum", "monte-carlo"};
constexpr double trials_max = 1e9;

}  // namespace

Result<void> choose_methods(std::string_view list, UncertaintyOptions& options) {
  while (true) {
    const std::size_t comma = list.find(',');
    const std::string_view method = text::trim(list.substr(0, comma));
    if (std::ranges::find(methods, method) == methods.end()) {
      const auto near = text::nearest(method, std::vector<std::string_view>(methods.begin(), methods.end()));
      return fail(
          fmt::format("found the method {}, expected {}", text::quoted(method),
                      near ? fmt::format("perhaps {}", *near) : fmt::format("some of {}", fmt::join(methods, ","))));
    }
    options.gum = options.gum || method == methods[1];
    options.monte_carlo = options.monte_carlo || method == methods[2];
    if (comma == std::string_view::npos) return {};
    list.remove_prefix(comma + 1);
  }
}

bool is_coverage(double probability) { return probability >= 0.5 && probability <= 0.9999; }

Result<void> choose_seed(std::string_view text, UncertaintyOptions& options) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), options.trials.seed);
  if (error == std::errc() && end == text.data() + text.size()) return {};
  return fail(fmt::format("found {}, expected a whole number from 0 to 18446744073709551615", text::quoted(text)));
}

Result<void> choose_coverage(std::string_view text, UncertaintyOptions& options) {
  const auto number = parse_number(text);
  if (!number || !is_coverage(*number))
    return fail(fmt::format("found {}, expected a probability from 0.5 to 0.9999", text::quoted(text)));
  options.trials.propagation.coverage = *number;
  return {};
}

Result<void> choose_type_a(std::string_view text, UncertaintyOptions& options) {
  const auto found = iso230_2::find_type_a(text);
  if (!found) return fail(fmt::format("found {}, expected pooled, t-scaled or resampled", text::quoted(text)));
  options.trials.type_a = *found;
  return {};
}

Result<void> choose_trials(std::string_view text, UncertaintyOptions& options) {
  if (text == "auto") {
    options.trials.propagation.trials.reset();
    return {};
  }
  const auto number = parse_number(text);
  if (!number || *number < trials_min || *number > trials_max || *number != std::floor(*number))
    return fail(fmt::format("found {} trials, expected auto or a whole number from {:.0f} to {:.0f}",
                            text::quoted(text), trials_min, trials_max));
  options.trials.propagation.trials = static_cast<std::size_t>(*number);
  return {};
}

}  // namespace axiometry::app
