// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/app/live/disk/capture_folder.h"
#include "axiometry/app/live/service/capture_state.h"
#include "axiometry/app/live/sources/capture_source.h"
#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/store/records.h"

/// Captures that run while nobody waits for them: each in a thread of its own, raw bytes on the disk first, then
/// readings, then the evaluation so far; in the end a test in the store.
namespace axiometry::app {

/// What a capture has come to when it ends.
struct CapturedEnd {
  HeldCapture& held;
  std::optional<Test> test;  ///< absent when none can be made of what came
};

/// Captures of an archive that became tables, wherever they were made.
struct ArchivedCaptures {
  std::vector<EndedCapture> listed;
  std::vector<EndedCapture> discarded;
};

/// Where tests go, and how they are evaluated.
struct CaptureKeeping {
  /// Keeps the test with its raw recording, or the raw recording alone; the id of the test. When it fails, the files
  /// stay and the capture can be resumed. Called twice for the same capture, it gives the same test.
  std::function<Result<std::optional<store::Id>>(const CapturedEnd&)> keep;
  /// The test that it has become already, with its raw recording, where a program ended before it could remove the
  /// files; nothing where it has become none.
  std::function<Result<std::optional<store::Id>>(const HeldCapture&)> kept;
  std::function<Result<Outcome>(const CaptureOrder&, const Test&)> evaluate;

  /// Of lengths: keeps the file of a plan, and gives its SHA-256. Of tables: gives bytes by that.
  std::function<Result<std::string>(const CaptureOrder&, const std::string& plan)> keep_plan{};
  std::function<Result<std::string>(const std::string& sha256)> bytes{};
  /// Of tables: keeps the raw recording, and the table where there is one. When it fails, the files stay and the
  /// capture can be resumed. Called twice for the same capture, it gives the same.
  std::function<Result<TableEnd>(const HeldCapture&, const std::optional<FoundTable>&)> keep_table{};
  /// That it came to its end, and that it is to be listed no more.
  std::function<Result<void>(const EndedCapture&)> keep_capture{};
  std::function<Result<void>(const EndedCapture&, const std::string& actor)> discard_capture{};
  /// All that were kept and not discarded, the oldest first; and those that were discarded.
  std::function<Result<ArchivedCaptures>()> captures{};
};

struct CaptureSettings {
  std::string folder;                                  ///< folder for what arrives, until it is in the store
  std::vector<CaptureSource> sources;                  ///< sources beside the simulator
  std::size_t most_at_once = 8;                        ///< captures that run
  std::size_t most_concluding = 2;                     ///< interrupted ones that are read to their end to be kept
  std::uint64_t raw_limit = std::uint64_t{256} << 20;  ///< bytes of one recording
  Duration for_undo = Duration::s(10);  ///< time to undo a reading that a key took, before its capture ends
};

/// What is asked of a new capture of lengths.
struct LengthWish {
  LengthTask task;
  std::string source;                                        ///< id of the source
  std::string layout;                                        ///< empty: recognised
  std::vector<std::pair<std::string, std::string>> options;  ///< options by name, as those of a CaptureWish
  std::string actor;
};

/// What is asked of a new capture: of a test, or with the option "stops" of a straightness or a rotation.
struct CaptureWish {
  store::Id plan = 0;
  Plan whole;                                                ///< the plan, with its further ones
  std::string source;                                        ///< id of the source
  std::string layout;                                        ///< empty: recognised
  std::vector<std::pair<std::string, std::string>> options;  ///< flags by name; speed, preset, seed, give-up
  std::string actor;
};

/// May be used from many threads at once. Its end interrupts all captures; their recordings can be resumed.
class CaptureService {
 public:
  /// Fails on two sources of one name. Captures that became tables and that the archive lists are here from now on,
  /// also where the archive came from elsewhere.
  static Result<std::unique_ptr<CaptureService>> open(CaptureSettings settings, CaptureKeeping keeping);
  ~CaptureService();
  CaptureService(const CaptureService&) = delete;
  CaptureService& operator=(const CaptureService&) = delete;

  const std::vector<CaptureSource>& sources() const { return settings_.sources; }  ///< the simulator first

  /// CaptureFolder::without_order()
  std::vector<std::string> without_order() const;

  /// Fails on a source, layout or option that there is not, as CaptureSession::open() does; with unavailable when the
  /// source cannot be reached and when too many captures run; with conflict when another one listens to it.
  Result<CaptureState> start(const CaptureWish& wish);
  Result<CaptureState> start(const LengthWish& wish);

  /// Goes on with an interrupted one: its recording is played first, then the source is listened to again. Fails as
  /// start() does, and as CaptureFolder::take(); with conflict where it has become a test already.
  Result<CaptureState> resume(store::Id id);

  /// Ends a running one, or an interrupted one without listening any more; what came is kept. Nothing happens to one
  /// that has ended. Comes back when it has ended, or after five seconds. Fails with not_found, and with unavailable
  /// where as many interrupted ones as may be are being ended.
  Result<CaptureState> stop(store::Id id);

  /// What a person says at a stop of a motion. Fails with not_found, and with conflict on one that is none, that has
  /// ended, and whose stops the position tells.
  Result<CaptureState> press(store::Id id, capture::StopKey key);

  /// With the readings after that revision. Fails with not_found.
  Result<CaptureState> state(store::Id id, CaptureRevision after = 0);

  /// All that run, were interrupted, or ended since the program began (the last fifty), and all of tables until they
  /// are discarded, the newest first; without readings, events and evaluation.
  std::vector<CaptureState> states();

  /// The part of the plan that a capture of lengths is about. Fails with not_found on one of a test, and as the archive
  /// does.
  Result<LengthTask> task_of(const CaptureState& state) const;
  /// A file of a capture that became a table: "raw", "times", "keys", or table_role(). Fails with not_found.
  Result<std::string> file_of(store::Id id, std::string_view role);
  Result<std::string> file_of(const CaptureState& state, std::string_view role) const;
  /// Forgets a capture that became a table; its files stay in the archive. Fails with not_found, and with conflict on
  /// one that goes on or was interrupted.
  Result<void> discard(store::Id id, const std::string& actor);

 private:
  class Running;
  struct Begun;
  enum class Way { listen, go_on, conclude };

  CaptureService(CaptureSettings settings, CaptureKeeping keeping, CaptureFolder folder);
  Result<const CaptureSource*> source_named(const std::string& id) const;
  Result<LengthTask> task_of(const LengthOrder& order, std::size_t part) const;
  /// `recorded`: file of what was heard before; empty: none. `task`: of lengths, where it is at hand; else it is read
  /// from the archive.
  Result<Begun> begin(const CaptureOrder& order, Way way, const std::string& recorded,
                      std::optional<LengthTask> task = {}) const;
  Result<void> reserve(const CaptureSource& source);
  void release(const std::string& source);
  Result<CaptureState> start(CaptureOrder order, const CaptureSource& source, std::optional<LengthTask> task = {});
  CaptureState launch(HeldCapture held, Begun begun, Way way);
  bool may_conclude() const;
  Result<CaptureState> restart(store::Id id, Way way);
  Result<CaptureState> go_on(HeldCapture held);
  Result<CaptureState> play(HeldCapture held, Way way);
  std::shared_ptr<Running> find(store::Id id) const;
  CaptureState state_of(const CaptureOrder& order, store::Id id, CaptureState::Stage stage) const;
  CaptureState state_of(const CaptureFolder::Ended& ended) const;
  void agree_with_archive();
  void forget_old();

  CaptureSettings settings_;
  CaptureKeeping keeping_;
  mutable std::mutex mutex_;  // guards all below
  CaptureFolder folder_;
  std::vector<std::string> beginning_;            // sources of captures that are about to run
  std::map<store::Id, CaptureState> restarting_;  // captures whose source is being reached again
  std::set<store::Id> about_to_conclude_;         // captures that are restarting
  std::map<store::Id, std::shared_ptr<Running>> captures_;
};

}  // namespace axiometry::app
