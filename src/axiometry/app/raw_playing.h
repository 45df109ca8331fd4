// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "axiometry/app/capture_session.h"
#include "axiometry/app/raw_log.h"

/// A raw recording on its way through a session again.
namespace axiometry::app {

struct PlayHooks {
  std::function<bool(const RawPiece&)> wants;  ///< asked before every piece; after the first no it is asked no more
  std::function<Result<void>(const std::vector<capture::CapturedReading>&)> readings;
};

/// Plays what is sound of it: damaged lines and times are left out, an unfinished line at its end too, and from where
/// the reader refuses to go on all that is behind. Each of these is a remark of the session. Fails when the file cannot
/// be read, when nothing in it is a sample, and as the hooks do.
Result<void> play_into(CaptureSession& session, const std::string& raw, const PlayHooks& hooks);

}  // namespace axiometry::app
