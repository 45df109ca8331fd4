// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/annex_a_json.h"

#include <optional>
#include <string_view>

#include "axiometry/app/results/told_results.h"

namespace axiometry::app {
namespace {

using json::Place;
using json::Value;

void put_contributor(Place place, const iso230_2::Contributor& contributor) {
  json::Object object(place);
  object.add("key", contributor.key);
  object.add("symbol", contributor.symbol);
  object.add("title", contributor.title);
  object.add("formula", contributor.formula);
  {
    json::List inputs = object.list("inputs");
    for (const auto& input : contributor.inputs) {
      json::Object row = inputs.object();
      row.add("symbol", input.symbol);
      row.add("value", input.value);
      row.add("unit", input.unit);
      if (!input.note.empty()) row.add("note", input.note);
    }
  }
  object.add("U", native_number(contributor.U));
}

void put_corrected(Place place, const iso230_2::CorrectedRepeatability& corrected) {
  json::Object object(place);
  object.add("R", native_number(corrected.parameters.R));
  object.add("R_up", native_number(corrected.parameters.R_up));
  object.add("R_down", native_number(corrected.parameters.R_down));
  json::List floored = object.list("floored_targets");
  for (std::size_t i : corrected.floored) floored.push(corrected.positions[i].target.in_native());
}

void put_annex_a_mean(Place place, const std::optional<iso230_2::AnnexAMean>& mean) {
  if (!mean) return place.put(std::nullopt);
  json::Object object(place);
  object.add("environment", native_number(mean->environment));
  object.add("U", mean->U.in_native());
}

/// x̄_i of every target, as gum_budget.positions of the law of propagation.
void put_annex_a_positions(Place place, const iso230_2::AnnexA& annex) {
  json::List list(place);
  for (const iso230_2::AnnexAPosition& position : annex.positions) {
    json::Object row = list.object();
    row.add("target", position.target.in_native());
    row.add("length_m", position.length_m);
    {
      json::Object own(row.at("contributions"));
      for (std::size_t k = 0; k < annex.budget.size(); ++k)
        if (annex.budget[k].key != "eve") own.add(annex.budget[k].key, native_number(position.contributions[k]));
    }
    put_annex_a_mean(row.at("up"), position.up);
    put_annex_a_mean(row.at("down"), position.down);
    put_annex_a_mean(row.at("mean"), position.mean);
  }
}

}  // namespace

void put_annex_a_budget(Place place, const iso230_2::AnnexA& annex) {
  json::Object object(place);
  {
    json::List contributors = object.list("contributors");
    for (const auto& contributor : annex.budget) put_contributor(contributors.next(), contributor);
  }
  object.add("notes", Value::array({annex.notes.begin(), annex.notes.end()}));
  object.add("runs", annex.runs);
  object.add("slow_environment", annex.slow_environment);
  object.add("coverage_factor", 2);
  object.add("missing", Value::array({annex.missing.begin(), annex.missing.end()}));
  object.add("datum", annex.datum.in_native());
  put_annex_a_positions(object.at("positions"), annex);
  if (annex.corrected) put_corrected(object.at("corrected_repeatability"), *annex.corrected);
}

}  // namespace axiometry::app
