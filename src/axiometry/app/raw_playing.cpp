// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/raw_playing.h"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <utility>

namespace axiometry::app {
namespace {

class Playing {
 public:
  Playing(CaptureSession& session, const PlayHooks& hooks) : session_(session), hooks_(hooks) {}

  Result<void> take(const RawPiece& piece) {
    if (!going_on_) return {};
    going_on_ = hooks_.wants(piece);
    if (!going_on_) return {};
    if (!first_) first_ = piece.arrival;
    if (piece.begins_connection) {
      AXIOMETRY_TRY(const auto readings, session_.interrupted());
      AXIOMETRY_TRY_VOID(hooks_.readings(readings));
    }
    const auto readings = session_.feed(piece.bytes, arrival_s(piece));
    if (readings) {
      at_ += piece.bytes.size();
      return hooks_.readings(*readings);
    }
    if (session_.samples() == 0) return std::unexpected(readings.error());
    session_.remark(fmt::format("left out the recording behind byte {}: {}", at_, readings.error().to_string()));
    going_on_ = false;
    return {};
  }

  /// `remarks`: on the times.
  void end(std::vector<std::string> remarks) {
    for (std::string& remark : remarks) session_.remark(std::move(remark));
    if (going_on_ && session_.unfinished() > 0)
      session_.remark(
          fmt::format("left out the last {} bytes of the recording, which are no whole sample", session_.unfinished()));
  }

 private:
  std::optional<double> arrival_s(const RawPiece& piece) const {
    if (!piece.timed) return std::nullopt;
    if (!piece.arrival) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(*piece.arrival - *first_) * 1e-9;
  }

  CaptureSession& session_;
  const PlayHooks& hooks_;
  std::optional<ArrivalNs> first_;
  std::uint64_t at_ = 0;
  bool going_on_ = true;
};

}  // namespace

Result<void> play_into(CaptureSession& session, const std::string& raw, const PlayHooks& hooks) {
  Playing playing(session, hooks);
  AXIOMETRY_TRY(auto remarks, play(raw, [&](const RawPiece& piece) { return playing.take(piece); }));
  playing.end(std::move(remarks));
  return {};
}

}  // namespace axiometry::app
