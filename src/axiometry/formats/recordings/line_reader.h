// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/recording.h"
#include "axiometry/formats/recordings/stamp_judge.h"
#include "axiometry/formats/text/streamed_text.h"

namespace axiometry::formats {

/// What readers of lines share: bytes cut anywhere become lines of UTF-8, samples go on in batches, damaged lines are
/// refused or counted. A reader of one layout says what a line is.
class LineReader : public RecordingReader {
 public:
  Result<void> feed(std::string_view bytes, const SampleSink& sink) final;
  Result<void> finish(const SampleSink& sink) final;
  Result<void> interrupted(const SampleSink& sink) final;
  std::size_t unfinished() const final { return begun_.size() + text_.unfinished(); }
  std::uint64_t without_break() const final { return without_break_; }
  std::size_t lost() const final { return damaged_ + lost_ + judge_.rejected(); }
  std::vector<std::string> remarks() const final;

 protected:
  /// `kind`: of the stamps that are judged.
  LineReader(const RecordingOptions& options, StampJudge::Kind kind) : options_(options), kind_(kind), judge_(kind) {}

  const RecordingOptions& options() const { return options_; }

  /// One line without its line break and without a carriage return. Calls emit() for the samples it holds.
  virtual Result<void> take(std::string_view line) = 0;
  /// After the last line.
  virtual Result<void> end() { return {}; }
  /// Bytes are missing before the next line.
  virtual void gap() {}
  /// Besides, what was sent before them has come to its end.
  virtual Result<void> cut_off() { return {}; }
  /// A line whose stamp is settled.
  virtual Result<void> settle(const StampedLine& line) { return put({line.stamp, line.position}); }

  /// Of a line with a time of its own: to be judged where damaged lines are passed over.
  Result<void> emit(Sample sample);
  Result<void> judge(const StampedLine& line);
  const StampedLine* judged_before() const { return judge_.base(); }
  std::size_t rejected() const { return judge_.rejected(); }
  double arrival_s() const;  ///< NaN where it is not known
  /// Fails on a number that is not finite and on a time before that of the last sample.
  Result<void> put(Sample sample);
  void add_lost(std::size_t samples) { lost_ += samples; }
  std::size_t line_number() const { return line_; }
  void remark(std::string text) { remarks_.push_back(std::move(text)); }

 private:
  Result<void> take_lines(std::string_view bytes, const SampleSink& sink);
  Result<void> take_whole(std::string_view line);
  Result<void> flush(const SampleSink& sink);
  Result<void> settle_all(std::span<const StampedLine> lines);
  void forget_line();

  RecordingOptions options_;
  StampJudge::Kind kind_;
  StampJudge judge_;
  StreamedText text_;
  bool skip_to_break_ = false;
  std::vector<std::string> remarks_;
  std::string begun_;  // a line whose break has not come yet
  std::uint64_t without_break_ = 0;
  std::size_t line_ = 0;
  std::size_t damaged_ = 0;
  std::size_t damaged_in_a_row_ = 0;
  std::size_t lost_ = 0;
  double last_time_s_ = -1e300;
  std::vector<Sample> samples_;
};

}  // namespace axiometry::formats
