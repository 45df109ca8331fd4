// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/read_recording.h"

#include <utility>
#include <vector>

#include "axiometry/app/recordings/raw_playing.h"
#include "axiometry/digest/sha256.h"

namespace axiometry::app {
namespace {

constexpr std::size_t recording_block = std::size_t{256} << 10;

}  // namespace

Result<Test> read_recording(Source& source, const CaptureOptions& options) {
  AXIOMETRY_TRY(Plan plan, load_plan(options.plan, options.part));
  const bool live = is_raw(source.name());
  CaptureOptions taken = options;
  taken.recording.skip_damaged = taken.recording.skip_damaged || live;
  AXIOMETRY_TRY(CaptureSession session, CaptureSession::open(std::move(plan), taken));
  auto end = CaptureSession::End::of_file;
  Sha256 hash;
  if (live) {
    end = CaptureSession::End::of_reading;
    const PlayHooks hooks{.wants =
                              [&](const RawPiece& piece) {
                                hash.update(piece.bytes);
                                return true;
                              },
                          .readings = [](const auto&) { return Result<void>{}; }};
    AXIOMETRY_TRY(auto none, play_into(session, source.name(), hooks));
    if (none) return std::unexpected(*std::move(none));
  } else {
    std::vector<char> block(recording_block);
    while (true) {
      AXIOMETRY_TRY(const std::size_t got, source.read(block));
      if (got == 0) break;
      hash.update({block.data(), got});
      AXIOMETRY_TRY_VOID(session.feed({block.data(), got}));
    }
  }
  AXIOMETRY_TRY_VOID(session.finish(end));
  AXIOMETRY_TRY(Test test, session.test());
  test.provenance.file = source.name();
  test.provenance.sha256 = hash.finish();
  return test;
}

}  // namespace axiometry::app
