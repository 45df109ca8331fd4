// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/store/store.h"

/// The use cases behind the page: from a file that is dropped to a report, over an archive.
///
/// What a version of a test found is kept with it and never silently computed again by a newer program: test() shows
/// what was kept. A report is computed again from the measured bytes, the changes, the options and the seed of its
/// version, and is refused (conflict) where that no longer gives the figures that were kept.
///
/// Metadata of an evaluation: what the file says, where it says nothing the inputs of the instruments it names, and
/// over both the changes. Limits: those the file or the changes state; where they state none, those of the axis.
///
/// Who takes a stop token gives up with `unavailable` soon after it was told to stop: within a block of trials, between
/// the steps of a report. Nothing is kept then.
namespace axiometry::app {

/// May be used from many threads at once. Errors are those of the readers (bad_input, with the place) and of the store.
class Workbench {
 public:
  explicit Workbench(store::Store& store);
  ~Workbench();
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  store::Store& archive() const;

  /// What is in a file, and its evaluation; nothing is kept. A file that cannot be read is no failure: it is refused.
  Result<Preview> preview(const Upload& upload, const std::stop_token& stop = {}) const;

  /// Keeps files with all their tests, each at version 1, or, when one of them cannot be read or kept, none. Bytes that
  /// are known make new tests all the same.
  Result<Received> receive(std::span<const Upload> uploads, const store::By& by, const std::stop_token& stop = {});
  /// Within what else is written together. Others that write wait for the evaluation, too.
  Result<Received> receive(store::Transaction& archive, std::span<const Upload> uploads, const store::By& by);

  /// Of a file that is not kept: its only test, or the one of that name.
  Result<Outcome> evaluate(const Upload& upload, const Draft& draft, const std::string& test_name = {},
                           const std::stop_token& stop = {}) const;
  /// Of a test that is not kept yet.
  Result<Outcome> evaluate(const Test& test, const Draft& draft) const;

  /// As if the test were changed so; nothing is kept. Without version: of the latest.
  Result<Outcome> draft(store::Id test, const Draft& draft, const std::stop_token& stop = {}) const;

  /// A new version. Fails with `conflict` when base_version is no longer the latest.
  Result<KeptTest> revise(store::Id test, const Revision& revision, const store::By& by,
                          const std::stop_token& stop = {});
  Result<KeptTest> withdraw(store::Id test, bool withdrawn, const store::By& by);
  Result<KeptTest> test(store::Id id, std::optional<int> version = {}) const;

  /// Its readings and metadata as that version evaluates them; nothing is evaluated.
  Result<PreparedTest> prepared(store::Id id, std::optional<int> version = {}) const;

  /// The bytes as they came.
  Result<Rendered> raw(store::Id test) const;

  /// Fails with not_found on an extension that no writer has, and with conflict where this program no longer finds the
  /// figures that were kept.
  Result<Rendered> report(store::Id test, std::optional<int> version, const ReportRequest& request) const;

  /// Whether a report or a figure of that version has the trials of the Monte Carlo method run again first.
  Result<bool> runs_trials_for(store::Id test, std::optional<int> version) const;

  /// Keeps a report as it is now, for good.
  Result<store::DocumentRecord> issue(store::Id test, std::optional<int> version, const ReportRequest& request,
                                      const store::By& by);
  Result<store::DocumentRecord> attach(store::Id test, const Attachment& attachment, const store::By& by);
  /// With a media type that no browser runs: what is no picture, PDF or plain text is octets.
  Result<Rendered> document(store::Id id) const;
  /// Of a document that is a log of temperatures: those that may be given a role. Fails as formats::sensors_of_log().
  Result<std::vector<std::string>> temperature_sensors(store::Id document) const;

  /// Titles of the figures, in order.
  Result<std::vector<std::string>> figures(store::Id test, std::optional<int> version,
                                           const ReportRequest& request) const;
  /// One of them, from 0, as SVG; for a dark page in colours that are read there. Fails with not_found.
  Result<std::string> figure(store::Id test, std::optional<int> version, std::size_t index, bool dark,
                             const ReportRequest& request) const;

  struct State;  ///< state that the sources behind this header share

 private:
  std::unique_ptr<State> state_;
};

}  // namespace axiometry::app
