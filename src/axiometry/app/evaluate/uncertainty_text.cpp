// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/uncertainty_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"

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
