// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a plan of a test, as what is asked of the planner, and as a sequence of approaches. What is read is
// written and read again as the same.
#include "axiometry/app/plan/plan_request.h"
#include "axiometry/app/plan/plan_text.h"
#include "axiometry/formats/plan/plan_json.h"
#include "described.h"

using namespace axiometry;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzzing::as_text(data, size);
  if (const auto plan = formats::read_plan(bytes); plan) {
    const std::string written = formats::write_plan(*plan);
    const auto again = formats::read_plan(written);
    AXIOMETRY_CONTRACT(again && formats::write_plan(*again) == written);
  } else {
    fuzzing::check_error(plan.error());
  }
  if (const auto body = json::parse(bytes); body && body->is(json::Kind::object)) {
    const auto asked = app::requested_plan_of(*body);
    if (!asked)
      fuzzing::check_error(asked.error());
    else
      AXIOMETRY_CONTRACT(app::read_requested(app::write_requested(*asked)).has_value());
  }
  if (const auto sequence = app::parse_sequence(std::string(bytes)); !sequence) fuzzing::check_error(sequence.error());
  return 0;
}
