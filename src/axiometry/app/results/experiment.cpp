// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/experiment.h"

#include "axiometry/base/text/number_text.h"

namespace axiometry::app {

Result<void> write_outputs(const Experiment& experiment, const OutputNames& names, const report::Options& options) {
  AXIOMETRY_TRY_VOID(check_inputs_spared(names));
  AXIOMETRY_TRY_VOID(write_document(experiment.document, names.reports, options));
  if (!names.json.empty()) AXIOMETRY_TRY_VOID(write_file(names.json, json::dump(experiment.json) + "\n"));
  return {};
}

report::Document experiment_document(std::string_view title, std::string_view source) {
  report::Document document;
  document.kind = "Simulation";
  document.title = std::string(title);
  document.edition = std::string(source);
  document.running_head = document.title;
  document.running_status = "Simulation, no measurement";
  return document;
}

report::TableCell number_cell(double x, int decimals, const report::Options& options, report::Tone tone) {
  return {report::plain(format_fixed(x, decimals, options.numbers)), tone};
}

report::TableCell word_cell(std::string_view text) { return {report::plain(text)}; }

}  // namespace axiometry::app
