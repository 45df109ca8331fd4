// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/app/recordings/raw_log.h"

namespace axiometry::app {

/// What a pipe brings is nowhere else: a raw file of it, begun with the first bytes, so that where nothing comes no
/// file bars the next. Without arrivals, so that it reads the same played again: as a file.
class PipedLog {
 public:
  /// Of no file where the name is empty.
  explicit PipedLog(std::string raw) : raw_(std::move(raw)) {}

  /// To the file before anything is done with them. The log, or nullptr where none is kept.
  Result<RawLog*> append(std::string_view bytes) {
    if (raw_.empty()) return nullptr;
    if (!log_) {
      AXIOMETRY_TRY(RawLog log, RawLog::create(raw_));
      log_.emplace(std::move(log));
      AXIOMETRY_TRY(RawHold hold, RawHold::take(raw_));
      hold_.emplace(std::move(hold));
    }
    AXIOMETRY_TRY_VOID(log_->append(bytes, std::nullopt));
    return &*log_;
  }

 private:
  std::string raw_;
  std::optional<RawHold> hold_;
  std::optional<RawLog> log_;
};

}  // namespace axiometry::app
