// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/recording.h"

namespace axiometry::formats {

/// What readers of lines share: bytes cut anywhere become lines, samples go on in batches, damaged lines are refused
/// or counted. A reader of one layout says what a line is.
class LineReader : public RecordingReader {
 public:
  Result<void> feed(std::string_view bytes, const SampleSink& sink) final;
  Result<void> finish(const SampleSink& sink) final;
  void interrupted() final;
  std::size_t lost() const final { return damaged_ + lost_; }

 protected:
  explicit LineReader(bool skip_damaged) : skip_damaged_(skip_damaged) {}

  /// One line without its line break and without a carriage return. Calls emit() for the samples it holds.
  virtual Result<void> take(std::string_view line) = 0;
  /// After the last line.
  virtual Result<void> end() { return {}; }
  /// Bytes are missing before the next line.
  virtual void gap() {}

  /// Fails on a number that is not finite and on a time before that of the last sample.
  Result<void> emit(Sample sample);
  void add_lost(std::size_t samples) { lost_ += samples; }
  std::size_t line_number() const { return line_; }

 private:
  Result<void> take_lines(std::string_view bytes, const SampleSink& sink);
  Result<void> take_whole(std::string_view line);
  Result<void> flush(const SampleSink& sink);

  bool skip_damaged_;
  bool skip_to_break_ = false;
  std::string begun_;  // a line whose break has not come yet
  std::size_t line_ = 0;
  std::size_t damaged_ = 0;
  std::size_t damaged_in_a_row_ = 0;
  std::size_t lost_ = 0;
  double last_time_s_ = -1e300;
  std::vector<Sample> samples_;
};

}  // namespace axiometry::formats
