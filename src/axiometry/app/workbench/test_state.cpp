// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/test_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/utf8.h"
#include "axiometry/base/version.h"
#include "axiometry/model/test_day.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::app {
namespace {

using json::Value;

std::string verdict_text(uncertainty::Verdict verdict) {
  return verdict == uncertainty::Verdict::not_applicable ? "" : std::string(uncertainty::verdict_name(verdict));
}

std::string shortened(std::string title) {
  std::size_t at = 0;
  for (std::size_t length = 0; at < title.size() && length < line_length_max; ++length)
    at += character_at(title, at).length;
  title.resize(at);
  return title;
}

std::unexpected<Error> damaged(const Error& error) {
  return fail(ErrorKind::damaged, fmt::format("found options of the archive that cannot be read: {}", error.message));
}

}  // namespace

std::vector<store::FigureRecord> figures_of(const Evaluated& evaluated) {
  std::vector<store::FigureRecord> figures;
  for (const auto& parameter : iso230_2::parameters) {
    const auto& value = evaluated.assessment.evaluation.parameters.*parameter.member;
    if (!value) continue;
    store::FigureRecord figure{std::string(parameter.key), value->in_native(), {}, {}, {}};
    if (const auto known = iso230_2::uncertainty_of_record(evaluated.assessment, parameter)) {
      if (known->U) figure.U = known->U->in_native();
      figure.low = known->interval.lower;
      figure.high = known->interval.upper;
      figure.method = iso230_2::method_key(known->method);
    }
    const auto judged = std::ranges::find_if(evaluated.judgements, [&](const iso230_2::Judgement& judgement) {
      return judgement.tolerance.parameter->key == parameter.key;
    });
    if (judged != evaluated.judgements.end()) {
      figure.limit = judged->tolerance.limit.in_native();
      figure.verdict = verdict_text(judged->decision.verdict);
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

std::string kept_verdict(std::span<const iso230_2::Judgement> judgements) {
  const auto verdict = iso230_2::overall_verdict(judgements);
  return verdict ? verdict_text(*verdict) : std::string();
}

store::EvaluationRecord evaluation_of(const Evaluated& evaluated, const KeptOptions& how) {
  Value kept = to_json(how.options);
  kept.add("from_archive", to_json(how.from_archive));
  if (how.profile) kept.add("import_profile", formats::profile_to_json(*how.profile));
  store::EvaluationRecord evaluation;
  evaluation.program = fmt::format("axiometry {}", version);
  evaluation.standard = edition_of(evaluated.test.metadata.axis);
  evaluation.options = json::dump(kept, 0);
  if (evaluated.assessment.monte_carlo) evaluation.seed = evaluated.assessment.monte_carlo->seed;
  evaluation.result = json_line(evaluated);
  evaluation.unit = deviation_unit_key(evaluated.test.metadata.axis.kind);
  evaluation.conforming = evaluated.assessment.conforming();
  evaluation.verdict = kept_verdict(evaluated.judgements);
  evaluation.label = evaluated.assessment.label;
  evaluation.figures = figures_of(evaluated);
  return evaluation;
}

store::TestState state_of(const Evaluated& evaluated, const Changes& changes, const KeptOptions& how) {
  const Metadata& metadata = evaluated.test.metadata;
  store::TestState state;
  state.machine = machine_of(metadata);
  state.axis = axis_of(metadata);
  state.instruments = instruments_of(metadata);
  // A test of 2062 would be the newest for good, and its machine never due.
  state.measured_on = day_of_test(metadata.conditions.date);
  state.changes = json::dump(to_json(changes), 0);
  state.evaluation = evaluation_of(evaluated, how);
  return state;
}

std::string first_title(const Evaluated& evaluated) {
  const std::string& number = evaluated.test.metadata.conditions.report_number;
  std::string title = number.empty() ? std::filesystem::path(evaluated.test.provenance.file).stem().string() : number;
  if (!evaluated.name.empty()) title += (title.empty() ? "" : " ") + evaluated.name;
  return shortened(report::printable(title));
}

Result<KeptOptions> kept_options(const store::EvaluationRecord& evaluation) {
  auto value = json::parse(evaluation.options);
  if (!value) return damaged(value.error());
  KeptOptions kept;
  Value options = Value::object();
  if (value->is(json::Kind::object)) {
    for (const auto& [name, member] : value->members())
      if (name != "from_archive" && name != "import_profile") options.add(name, member);
    if (const Value* member = value->find("from_archive")) {
      auto taken = from_archive_of(*member);
      if (!taken) return damaged(taken.error());
      kept.from_archive = *std::move(taken);
    }
    if (const Value* member = value->find("import_profile")) {
      auto profile = formats::read_profile(json::dump(*member));
      if (!profile) return damaged(profile.error());
      kept.profile = *std::move(profile);
    }
  }
  auto own = test_options_from(options);
  if (!own) return damaged(own.error());
  kept.options = *std::move(own);
  return kept;
}

Result<Changes> kept_changes(const store::TestState& state) {
  if (state.changes.empty()) return Changes{};
  auto value = json::parse(state.changes);
  if (!value) return damaged(value.error());
  auto changes = changes_from(*value);
  if (!changes) return damaged(changes.error());
  return *std::move(changes);
}

}  // namespace axiometry::app
