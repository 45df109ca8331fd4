// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/raw_playing.h"

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
    if (!wanted_ || !(wanted_ = hooks_.wants(piece))) return {};
    const std::uint64_t begin = std::exchange(at_, at_ + piece.bytes.size());
    if (!first_) first_ = piece.arrival;
    if (piece.begins_connection) {
      take_up_again(begin);
      AXIOMETRY_TRY(const auto readings, session_.interrupted());
      AXIOMETRY_TRY_VOID(hooks_.readings(readings));
    }
    if (refused_) return {};
    auto readings = session_.feed(piece.bytes, arrival_s(piece));
    if (!readings) refused_ = std::move(readings).error();
    return hooks_.readings(readings ? *readings : session_.found_before());
  }

  /// `remarks`: on the times. Why nothing was a sample, where so it is.
  std::optional<Error> end(std::vector<std::string> remarks) {
    if (refused_ && session_.samples() == 0) return refused_;
    for (std::string& remark : remarks) session_.remark(std::move(remark));
    if (hooks_.goes_on) take_up_again(at_);
    if (refused_)
      session_.leave_out_rest(*refused_);
    else if (wanted_ && session_.unfinished() > 0)
      session_.remark(
          session_.unfinished() == 1
              ? "left out the last byte of the recording, which is no whole sample"
              : fmt::format("left out the last {} bytes of the recording, which are no whole sample",
                            session_.unfinished()));
    return std::nullopt;
  }

 private:
  std::optional<double> arrival_s(const RawPiece& piece) const {
    if (!piece.timed) return std::nullopt;
    if (!piece.arrival) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(*piece.arrival - *first_) * 1e-9;
  }

  /// What the reader refused ends where a connection begins, as it does in a live capture that is gone on with.
  void take_up_again(std::uint64_t at) {
    if (!refused_) return;
    session_.remark(fmt::format("left out the recording up to the connection that begins behind byte {}: {}", at,
                                refused_->to_string()));
    refused_.reset();
  }

  CaptureSession& session_;
  const PlayHooks& hooks_;
  std::optional<ArrivalNs> first_;
  std::optional<Error> refused_;  // why and from where on it cannot be read
  std::uint64_t at_ = 0;
  bool wanted_ = true;
};

}  // namespace

Result<std::optional<Error>> play_into(CaptureSession& session, const std::string& raw, const PlayHooks& hooks) {
  Playing playing(session, hooks);
  AXIOMETRY_TRY(auto remarks, play(raw, [&](const RawPiece& piece) { return playing.take(piece); }));
  return playing.end(std::move(remarks));
}

}  // namespace axiometry::app
