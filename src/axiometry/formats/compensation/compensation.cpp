// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/compensation/compensation.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/volumetric/field/unseen_reasons.h"

namespace axiometry::formats {

Result<const Compensation*> compensation_named(std::string_view id) {
  std::string known;
  for (const Compensation* compensation : compensation_table()) {
    if (compensation->id == id) return compensation;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", compensation->id);
  }
  return fail(fmt::format("found the table {}, expected one of {}", text::quoted(id), known));
}

Result<void> check_all_told(const volumetric::ErrorModel& model) {
  const auto unseen = model.unseen_errors();
  if (unseen.empty()) return {};
  return fail(
      fmt::format("found that the lengths do not tell {}, expected all 21 errors: a control would take a number "
                  "that nobody measured",
                  volumetric::error_list(unseen)));
}

std::string position_text(double position_mm) { return format_exact(std::round(1e6 * position_mm) / 1e6); }

std::string compensation_head(const volumetric::ErrorModel& model, std::string_view mark) {
  std::string text;
  const auto line = [&](std::string_view words) { text += fmt::format("{} {}\n", mark, words); };
  std::string name;  // one line, whatever it holds
  for (const char c : model.machine().name) name += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  if (!name.empty()) line("Machine: " + name);
  line(fmt::format("Kinematic chain, workpiece to tool, F the foundation: {}", model.machine().chain.text()));
  for (std::size_t a = 0; a < volumetric::axis_count; ++a)
    line(fmt::format("{} was observed from {} to {} mm", "XYZ"[a], position_text(model.observed().lowest_mm[a]),
                     position_text(model.observed().highest_mm[a])));
  if (model.coefficients().reversal() != volumetric::Reversal::none)
    line("The errors differ by direction; these are the means of both.");
  return text;
}

}  // namespace axiometry::formats
