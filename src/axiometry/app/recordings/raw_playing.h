// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/app/recordings/raw_log.h"

/// A raw recording on its way through a session again.
namespace axiometry::app {

struct PlayHooks {
  std::function<bool(const RawPiece&)>
      wants;  ///< asked before every piece, also of one that is left out; not after its first no
  std::function<Result<void>(const std::vector<capture::CapturedReading>&)> readings;
  bool goes_on = false;  ///< another connection follows
};

/// Plays what is sound of it: damaged lines and times are left out, an unfinished line at its end too, and from where
/// the reader refuses to go on all up to the next connection. Each of these is a remark of the session. Why nothing in
/// it is a sample, where so it is. Fails when the file cannot be read, and as the hooks do.
Result<std::optional<Error>> play_into(CaptureSession& session, const std::string& raw, const PlayHooks& hooks);

}  // namespace axiometry::app
