// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/captured_motion.h"

#include "axiometry/app/recordings/motion_table.h"

namespace axiometry::app {

Result<FoundTable> captured_motion(const CaptureSession& session, const CaptureOrder& order, const std::string& date) {
  FoundTable found;
  AXIOMETRY_TRY(found.table, motion_table(session, {.from = order.source, .raw = {}, .date = date}));
  found.found = session.taken();
  found.planned = session.expected();
  for (const capture::CaptureEvent& event : session.motion()->values().events()) found.notes.push_back(event.message);
  for (std::string& remark : session.remarks()) found.notes.push_back(std::move(remark));
  return found;
}

}  // namespace axiometry::app
