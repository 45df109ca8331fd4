// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/live/service/capture_service.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/store/store.h"

/// Captures and the archive.
namespace axiometry::app {

/// Keeps tests in the workbench's archive, in JSON after their plan, with the raw recording and its times attached; a
/// recording without a test as bytes alone. What the simulator made belongs to a machine of its own, so that no trend
/// of a real one shows it. The workbench must outlive it.
CaptureKeeping keeping_in(Workbench& workbench);

/// Where captures of a store lie until they are in it: STORE.captures beside a file, else a folder of the user's state
/// (XDG_STATE_HOME). Fails when there is no home folder.
Result<std::string> captures_folder(const store::Info& store);

/// The plan as the archive knows its axis: with the names of the machine and the axis that the record belongs to.
Result<Plan> captured_plan(const store::Store& store, const store::PlanRecord& record, Plan plan);

}  // namespace axiometry::app
