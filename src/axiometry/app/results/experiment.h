// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json/json.h"
#include "axiometry/report/document.h"

/// A computation that no measured file stands behind: its result for people and for programs.
namespace axiometry::app {

struct Experiment {
  report::Document document;  ///< the terminal shows its tables as well
  json::Value json;
};

/// Writes JSON and reports as they are asked for. Fails when one cannot be written.
Result<void> write_outputs(const Experiment& experiment, const OutputNames& names, const report::Options& options);

/// What the documents of experiments have in common.
report::Document experiment_document(std::string_view title, std::string_view source);

/// Cells of their tables: a number with so many decimals, "−0.00" shown as "0.00"; and the same in a tone.
report::TableCell number_cell(double x, int decimals, const report::Options& options,
                              report::Tone tone = report::Tone::normal);
report::TableCell word_cell(std::string_view text);

}  // namespace axiometry::app
