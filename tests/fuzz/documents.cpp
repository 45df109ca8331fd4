// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as what an archive gives back of a kept test: its options and changes, and as JSON of its own; and as what
// is asked of calibrations and tables of compensation, and kept with them. What is read is refused as damaged or
// understood, never trusted.
#include "axiometry/app/compensate/compensate_options.h"
#include "axiometry/app/tracking/evaluate_options.h"
#include "axiometry/app/tracking/tracking_request.h"
#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/app/volumetric/tables/volume_compensation_request.h"
#include "axiometry/app/workbench/calibrations/calibration_json.h"
#include "axiometry/app/workbench/compensations/compensation_json.h"
#include "axiometry/app/workbench/test_state.h"
#include "axiometry/base/json/json.h"
#include "described.h"

using namespace axiometry;

namespace {

template <typename T>
void check_asked(const Result<T>& asked) {
  if (!asked) fuzzing::check_error(asked.error());
}

void check_requests(const json::Value& value) {
  check_asked(app::evaluate_options_from(value));
  check_asked(app::identify_choices_from(value));
  check_asked(app::new_calibration_from(value));
  check_asked(app::calibration_revision_from(value));
  check_asked(app::table_reading_from(value));
  check_asked(app::compensation_revision_from(value));
  check_asked(app::volume_compensation_request_from(value));
  const auto wished = app::compensate_request_from(value);
  check_asked(wished);
  if (!wished) return;
  const json::Value written = app::to_json(*wished);
  const auto again = app::compensate_request_from(written);
  AXIOMETRY_CONTRACT(again && json::dump(app::to_json(*again)) == json::dump(written));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(fuzzing::as_text(data, size));
  if (const auto value = json::parse(bytes); value) {
    const std::string written = json::dump(*value);
    const auto again = json::parse(written);
    AXIOMETRY_CONTRACT(again && json::dump(*again) == written);
    check_requests(*value);
  } else {
    fuzzing::check_error(value.error());
  }
  store::EvaluationRecord evaluation;
  evaluation.options = bytes;
  if (const auto options = app::kept_options(evaluation); !options)
    AXIOMETRY_CONTRACT(options.error().kind == ErrorKind::damaged);
  store::TestState state;
  state.changes = bytes;
  if (const auto changes = app::kept_changes(state); !changes)
    AXIOMETRY_CONTRACT(changes.error().kind == ErrorKind::damaged);
  return 0;
}
