// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/recognised.h"

#include "axiometry/base/read_budget.h"
#include "axiometry/formats/table/generic_delimited.h"

namespace axiometry::app {

Recognised recognised(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, read_budget::head_bytes);
  Recognised found{formats::recognise(head)};
  if (found.format && (*found.format)->id != formats::any_table_format) return found;
  if (const auto recording = formats::recognise_recording(head)) found.recording = *recording;
  return found;
}

}  // namespace axiometry::app
