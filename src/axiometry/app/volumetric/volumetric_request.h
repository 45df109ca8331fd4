// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "axiometry/app/files/given_file.h"
#include "axiometry/app/files/reader.h"
#include "axiometry/app/volumetric/identify_lengths.h"
#include "axiometry/app/volumetric/plan_volume.h"
#include "axiometry/app/volumetric/predict_line.h"
#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/app/volumetric/singles/assemble_singles.h"
#include "axiometry/app/volumetric/tables/export_tables.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"

/// What the workbench asks of a volumetric calibration, and what it is answered: VolumetricPlanRequest,
/// VolumetricDraft and their like in apps/server/openapi.json. Nothing is kept, and no text of a request is taken for
/// the name of a file. What a request may cost is bounded by its numbers, before anything is computed.
namespace axiometry::app {

/// VolumetricPlanRequest, planned. Fails, with line and column, on members that are unknown, missing or of another
/// kind, on more than 500 points, 8 stations or 6 tools, 12 000 points in all, 20 obstacles, on names that are no
/// given_line(), and as machine_from() and plan_volume() do. The date is today's where it is not given.
Result<volumetric::PlannedCalibration> requested_calibration(const json::Value& body, std::stop_token stop = {});

/// The plan of {"plan": …}. Fails also on a plan that is larger than requested_calibration() makes one, or has names
/// that are none.
Result<volumetric::CalibrationPlan> given_calibration(const json::Value& body);

/// VolumetricDraft, its texts in the reader's language.
json::Value draft_value(const volumetric::PlannedCalibration& planned, const Reader& reader);

inline constexpr std::size_t files_of_lengths_most = 500;  ///< more than any plan has parts

/// identify_lengths() of what a workbench takes, in one thread: it fails also on more than 200 stations with a tool,
/// 1000 segments or 16 tools, and on a plan as given_calibration() does, before anything is computed.
Result<IdentifiedMachine> identify_presentable(const IdentifyFiles& files, const IdentifyChoices& choices);

/// What an assembly takes.
struct AssembleFiles {
  std::vector<GivenFile> errors;  ///< files that its options name
  GivenFile machine;
  std::stop_token stop{};  ///< nobody waits for the answer any more
};

/// Options: {"errors": ["EXX=x.csv", "C0Y=-12.5,1.2"], "at": ["X=0,300:up,-200:down@T1"], "instruments":
/// ["EYX=0.4,0.5"], "reversal": "curves" or "none"}, as `axiometry volumetric assemble` has them, but that a file is
/// one of those that are given. Fails, with line and column, on members that are unknown or of another kind, without
/// errors, on a file that is not given, on one given twice or named by no error, on more than 16 tools, and as
/// parse_single(), put_stand(), put_instrument(), parse_single_reversal() and assemble_singles() do.
Result<AssembleRequest> assemble_request_from(const json::Value& options, const AssembleFiles& files);
Result<Assembled> assemble_presentable(const AssembleFiles& files, const json::Value& options);

/// The member `name`, as the member "model" of a result file. Fails on more than 1500 coefficients or 16 tools too.
Result<volumetric::ErrorModel> given_model(const json::Value& body, std::string_view name = "model");

/// The same with what the member `findings`, as that of a result file, says against it, and with what its remarks
/// beside them do, which results of single measurements have ("remarks", "remarks_before", …). Fails on findings and
/// remarks that are of another kind too; where there are none nothing is said.
Result<KeptModel> given_kept_model(const json::Value& body, std::string_view name = "model",
                                   std::string_view findings = "findings");

/// "nodes" of {"model", "nodes"} or of {"before", "after", "nodes"}: 2 to 21, 11 when it is not there.
Result<std::size_t> given_nodes(const json::Value& body);

/// VolumetricLineRequest but for its model. Fails on members that are unknown or of another kind.
Result<PredictRequest> line_request_from(const json::Value& body);

/// VolumetricTableRequest but for its model; 2 to 401 nodes. Fails likewise.
Result<ExportRequest> table_request_from(const json::Value& body);

/// A result file that somebody gives, {"result": …}, in the reader's language: as it is but for its findings, and that
/// the curves of one of single measurements are made anew out of its model. Fails, with line and column, where a page
/// could not show it: on members that are missing or of another kind, and as given_model() does.
Result<json::Value> given_result(const json::Value& body, const Reader& reader);

}  // namespace axiometry::app
