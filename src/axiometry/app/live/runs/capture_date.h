// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/app/recordings/raw_times.h"
#include "axiometry/base/result.h"

/// When what a live capture heard was measured.
namespace axiometry::app {

/// "2026-11-21", the day of the place, as the date of a plan is; empty where nothing arrived.
std::string arrival_date(std::optional<ArrivalNs> first_arrival);

/// The session's test, with its source and the day on which its first bytes arrived.
Result<Test> dated_test(const CaptureSession& session, const std::string& from, std::optional<ArrivalNs> first_arrival);

}  // namespace axiometry::app
