// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/captured_motion.h"

#include "axiometry/app/live/sources/own_options.h"
#include "axiometry/app/recordings/motion_table.h"

namespace axiometry::app {

Result<FoundTable> captured_motion(const CaptureSession& session, const CaptureOrder& order, const std::string& date) {
  FoundTable found;
  MotionOrigin origin{.from = order.source, .raw = {}, .date = date};
  if (order.source == simulator_source().id) {
    AXIOMETRY_TRY(const OwnOptions own, own_options(order.options, CaptureSource::Kind::simulator));
    origin.simulated = simulated_motion_note(simulated_motion_of(own, {}), session.motion()->error());
  }
  AXIOMETRY_TRY(found.table, motion_table(session, origin));
  found.found = session.taken();
  found.planned = session.expected();
  for (const capture::CaptureEvent& event : session.motion()->values().events()) found.notes.push_back(event.message);
  for (std::string& remark : session.remarks()) found.notes.push_back(std::move(remark));
  return found;
}

}  // namespace axiometry::app
