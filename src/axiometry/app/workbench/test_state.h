// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/workbench/from_archive/from_archive.h"
#include "axiometry/formats/table/import_profile.h"
#include "axiometry/store/store.h"

/// An evaluated test as the archive keeps it.
namespace axiometry::app {

/// Every parameter that exists, with the uncertainty of record (verdict/uncertainty_of_record.h) where there is one,
/// and with its limit and verdict.
std::vector<store::FigureRecord> figures_of(const Evaluated& evaluated);

/// Of all limits together, as lists keep it: overall_verdict(), empty where nothing could be judged. Of several lines
/// it is asked with the judgements of all: one that could not be judged leaves the whole undecided.
std::string kept_verdict(std::span<const iso230_2::Judgement> judgements);

/// What `options` of a kept evaluation holds.
struct KeptOptions {
  TestOptions options{};
  FromArchive from_archive{};
  std::optional<formats::ImportProfile> profile{};  ///< profile by which the file is read, where it came with one
};

/// What a version keeps of an evaluation: options, result, figures. `program` is this one.
store::EvaluationRecord evaluation_of(const Evaluated& evaluated, const KeptOptions& how);

/// The whole state but title and plan.
store::TestState state_of(const Evaluated& evaluated, const Changes& changes, const KeptOptions& how);

/// How a test is called to begin with: its report number, else its file, and its name where the file has many.
std::string first_title(const Evaluated& evaluated);

/// Fails with `damaged` on what evaluation_of() does not write.
Result<KeptOptions> kept_options(const store::EvaluationRecord& evaluation);
/// Likewise of TestState::changes.
Result<Changes> kept_changes(const store::TestState& state);

}  // namespace axiometry::app
