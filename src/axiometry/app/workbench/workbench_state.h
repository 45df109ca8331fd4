// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "axiometry/app/files/recent.h"
#include "axiometry/app/workbench/measured_file.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/go_on_unless.h"

/// What the sources of the workbench share.
namespace axiometry::app {

/// A test with what was found of it.
struct Found {
  Evaluated evaluated;
  ArchiveQuestion asked;     ///< nothing where the answer is of another day
  FromArchive from_archive;  ///< the answer
  double milliseconds = 0.0;
};

/// Who answers what an evaluation asks the archive.
using Answers = std::function<Result<FromArchive>(const ArchiveQuestion&)>;

struct Workbench::State {
  explicit State(store::Store& archive) : store(archive) {}

  store::Store& store;
  Recent<std::string, MeasuredFile> files{std::size_t{64} << 20};  ///< by SHA-256 and profile; weighed by their memory
  Recent<std::string, Evaluated> evaluations{64};                  ///< evaluations of kept versions: "12/3"
  Recent<std::string, std::string> logs{std::size_t{32} << 20};    ///< bytes of temperature logs, by SHA-256
  std::mutex monte_carlo;                                          ///< a run takes all processors: one at a time

  /// As somebody sends it; what was read a short while ago is not read again, and its tests then go by the name of that
  /// day. Fails as read_measured() and given_file_name() do.
  Result<std::shared_ptr<const MeasuredFile>> read(const HashedBytes& sent, const std::string& name,
                                                   const std::optional<formats::ImportProfile>& profile);
  /// By the profile that the version keeps, where it was received with one.
  Result<std::shared_ptr<const MeasuredFile>> file_of(const store::TestRecord& record);
  /// Of a temperature log that the archive keeps. Fails with `not_found` where it has none of that hash.
  Result<std::shared_ptr<const std::string>> log_bytes(const std::string& hash);
  /// The measured test of a record, by whose file name it goes.
  Result<Test> measured(const store::TestRecord& record);

  /// What the archive knows when it is asked, each time as of one moment.
  Answers answers() const;

  Result<Found> evaluate(Test test, const Draft& draft, const std::optional<ArchiveLinks>& links,
                         const Answers& answers, const std::stop_token& stop = {});
  /// With what was taken from the archive on another day.
  Result<Found> evaluate_with(Test test, const Draft& draft, FromArchive taken, const std::stop_token& stop = {});

  /// A version evaluated again, with the figures that were kept or not at all.
  Result<std::shared_ptr<const Evaluated>> evaluated(const store::TestRecord& record, const std::stop_token& stop);
  /// A note where the axis has other limits by now than those that the version was judged with.
  Result<std::optional<iso230_2::Finding>> changed_limits_of(const store::TestRecord& record);
  /// One that was evaluated again a short while ago; nullptr where there is none.
  std::shared_ptr<const Evaluated> remembered(const store::TestRecord& record);
};

ArchiveLinks links_of(const store::TestRecord& record);
Outcome outcome_of(Found found);

/// The result that a version keeps. Fails with `damaged` when it cannot be read.
Result<json::Value> kept_result(const store::TestRecord& record);

}  // namespace axiometry::app
