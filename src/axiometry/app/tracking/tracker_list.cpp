// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracker_list.h"

#include <fmt/format.h>

#include "axiometry/app/results/result_json.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/tracking/instruments/tracker_kinds.h"

namespace axiometry::app {
namespace {

using json::Value;
using report::plain;
using tracking::StatedAccuracy;

report::TableCell accuracy_cell(const std::optional<StatedAccuracy>& a, const report::Options& options) {
  if (!a) return {plain("–"), report::Tone::quiet};
  std::string text;
  if (a->constant_um > 0.0) text = fmt::format("{} µm", report::shown_exact(a->constant_um, options));
  if (a->um_per_m > 0.0)
    text += fmt::format("{}{} µm/m", text.empty() ? "" : " + ", report::shown_exact(a->um_per_m, options));
  return {plain(fmt::format("{}{}", a->expanded ? "U = " : "±", text))};
}

Value accuracy_value(const std::optional<StatedAccuracy>& a) {
  if (!a) return {};
  Value object = Value::object();
  object.add("constant_um", a->constant_um);
  object.add("um_per_m", a->um_per_m);
  object.add("stated_as", a->expanded ? "expanded, k = 2" : "bounds");
  const RangingUncertainty u = a->expanded_uncertainty();
  object.add("U_constant_um", u.constant.in_um());
  object.add("U_um_per_m", u.per_length.in_um_per_m());
  return object;
}

}  // namespace

Experiment tracker_list(const report::Options& options) {
  Experiment experiment{
      experiment_document("Kinds of tracking instruments", "Lee et al., Sensors 16 (2016) 482, Table 1"),
      Value::object()};
  report::Document& document = experiment.document;
  document.kind = "List";
  document.running_head = report::translated(document.title, options);
  document.running_status = document.edition;
  report::Table table;
  table.columns = {{plain("Name"), report::Align::start, true},
                   {plain("Range / m")},
                   {plain("Angles")},
                   {plain("Absolute lengths (adm)")},
                   {plain("Interferometer (ifm)")}};
  experiment.json.add("result", "instruments");
  Value& list = experiment.json.add("instruments", Value::array());
  for (const tracking::TrackerKind& kind : tracking::tracker_kinds()) {
    table.rows.push_back({{report::verbatim(kind.id)},
                          {report::verbatim(kind.range_m)},
                          accuracy_cell(kind.across, options),
                          accuracy_cell(kind.absolute, options),
                          accuracy_cell(kind.interferometer, options)});
    Value& item = list.push(Value::object());
    item.add("id", kind.id);
    item.add("title", kind.title);
    item.add("range_m", kind.range_m);
    item.add("across", accuracy_value(kind.across));
    item.add("absolute", accuracy_value(kind.absolute));
    item.add("interferometer", accuracy_value(kind.interferometer));
  }
  table.notes = {
      plain("As the catalogues of 2016 stated them, in the print of that table; a certificate is better. Of angles: at "
            "right angles to the beam, over the distance. U has k = 2; ± is taken as bounds with u = half width/√3 "
            "(GUM 4.3.7), since the table states no k.")};
  document.sections.push_back({"instruments", "Kinds", true, {std::move(table)}});
  experiment.json.add("program", program_to_json());
  return experiment;
}

}  // namespace axiometry::app
