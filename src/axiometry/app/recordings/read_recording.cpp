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

Result<std::string> hear(Source& source, CaptureSession& session) {
  Sha256 hash;
  if (is_raw(source.name())) {
    const PlayHooks hooks{.wants =
                              [&](const RawPiece& piece) {
                                hash.update(piece.bytes);
                                return true;
                              },
                          .readings = [](const auto&) { return Result<void>{}; }};
    AXIOMETRY_TRY(auto none, play_into(session, source.name(), hooks));
    if (none) return std::unexpected(*std::move(none));
    AXIOMETRY_TRY_VOID(session.finish(CaptureSession::End::of_reading));
    return hash.finish();
  }
  std::vector<char> block(recording_block);
  while (true) {
    AXIOMETRY_TRY(const std::size_t got, source.read(block));
    if (got == 0) break;
    hash.update({block.data(), got});
    AXIOMETRY_TRY_VOID(session.feed({block.data(), got}));
  }
  AXIOMETRY_TRY_VOID(session.finish(CaptureSession::End::of_file));
  return hash.finish();
}

CaptureOptions options_of_source(const Source& source, CaptureOptions options) {
  options.recording.skip_damaged = options.recording.skip_damaged || is_raw(source.name());
  return options;
}

Result<Test> read_recording(Source& source, const CaptureOptions& options) {
  AXIOMETRY_TRY(Plan plan, load_plan(options.plan, options.part.value_or(1)));
  AXIOMETRY_TRY(CaptureSession session, CaptureSession::open(std::move(plan), options_of_source(source, options)));
  AXIOMETRY_TRY(std::string sha256, hear(source, session));
  AXIOMETRY_TRY(Test test, session.test());
  test.provenance.file = source.name();
  test.provenance.sha256 = std::move(sha256);
  return test;
}

}  // namespace axiometry::app
