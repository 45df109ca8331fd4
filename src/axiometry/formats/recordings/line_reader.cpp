// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/line_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/text/decoded_text.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t longest_line = 4096;
constexpr std::size_t batch = 4096;
constexpr std::size_t most_damaged_in_a_row = 100;

/// In the same words whether its end has come or not: what a recording gives must not depend on how it was cut.
std::unexpected<Error> fail_long_line(TextPosition at) {
  return fail(fmt::format("found a line of more than {} bytes, expected one sample a line", longest_line), at);
}

}  // namespace

std::vector<std::string> LineReader::remarks() const {
  std::vector<std::string> all = judge_.remarks();
  all.insert(all.end(), remarks_.begin(), remarks_.end());
  if (text_.is_utf16()) all.push_back(encoding_remarks({{}, "UTF-16"}).front().message);
  if (kind_ == StampJudge::Kind::times && options_.rate_hz) all.emplace_back(unused_rate);
  return all;
}

Result<void> LineReader::feed(std::string_view bytes, const SampleSink& sink) {
  auto taken = take_lines(text_.decoded(bytes), sink);
  auto flushed = flush(sink);  // also what stood before a refused line
  return taken ? flushed : taken;
}

Result<void> LineReader::take_lines(std::string_view bytes, const SampleSink& sink) {
  for (std::size_t end = bytes.find('\n'); end != bytes.npos; end = bytes.find('\n')) {
    without_break_ = 0;
    if (skip_to_break_) {
      skip_to_break_ = false;
      ++line_;
    } else if (begun_.empty()) {
      AXIOMETRY_TRY_VOID(take_whole(bytes.substr(0, end)));
    } else {
      begun_ += bytes.substr(0, end);
      AXIOMETRY_TRY_VOID(take_whole(std::exchange(begun_, {})));
    }
    bytes.remove_prefix(end + 1);
    if (samples_.size() >= batch) AXIOMETRY_TRY_VOID(flush(sink));
  }
  without_break_ += bytes.size();
  if (!skip_to_break_) begun_ += bytes;
  if (begun_.size() <= longest_line + 1) return {};  // the last may be half of a line break
  if (!options_.skip_damaged) return fail_long_line({line_ + 1, 1});
  forget_line();
  ++damaged_;
  return {};
}

Result<void> LineReader::finish(const SampleSink& sink) {
  auto taken = begun_.empty() ? Result<void>{} : take_whole(std::exchange(begun_, {}));
  if (taken) taken = settle_all(judge_.flush());
  if (taken) taken = end();
  auto flushed = flush(sink);
  return taken ? flushed : taken;
}

Result<void> LineReader::interrupted(const SampleSink& sink) {
  auto settled = settle_all(judge_.flush());
  text_.interrupted();
  forget_line();
  if (settled) settled = cut_off();
  damaged_in_a_row_ = 0;  // those of a connection that is over
  auto flushed = flush(sink);
  return settled ? flushed : settled;
}

void LineReader::forget_line() {
  begun_.clear();
  skip_to_break_ = true;
  gap();
}

double LineReader::arrival_s() const {
  return options_.arrival_s ? options_.arrival_s() : std::numeric_limits<double>::quiet_NaN();
}

Result<void> LineReader::emit(Sample sample) {
  if (!options_.skip_damaged || !std::isfinite(sample.time_s)) return put(sample);
  return judge({sample.time_s, sample.position, arrival_s(), line_, sample.time_s});
}

Result<void> LineReader::judge(const StampedLine& line) {
  AXIOMETRY_TRY_VOID(settle_all(judge_.push(line)));
  if (judge_.rejected_in_a_row() < most_damaged_in_a_row) return {};
  const StampedLine* const before = judge_.base();
  return std::unexpected(
      Error{fmt::format("found {} lines in a row out of order, the last {} after {}", judge_.rejected_in_a_row(),
                        format_exact(line.told), format_exact(before == nullptr ? 0.0 : before->told)),
            {},
            {line_, 1}});
}

Result<void> LineReader::settle_all(std::span<const StampedLine> lines) {
  for (const StampedLine& line : lines) AXIOMETRY_TRY_VOID(settle(line));
  return {};
}

Result<void> LineReader::put(Sample sample) {
  if (!is_sound(sample)) return fail("found a number beyond 1e15, or none, expected time and position");
  if (sample.time_s < last_time_s_)
    return fail(fmt::format("found time running backwards from {} s to {} s, expected samples in order of time",
                            format_exact(last_time_s_), format_exact(sample.time_s)));
  last_time_s_ = sample.time_s;
  samples_.push_back(sample);
  return {};
}

Result<void> LineReader::take_whole(std::string_view line) {
  ++line_;
  if (line.ends_with('\r')) line.remove_suffix(1);
  auto taken = line.size() > longest_line ? fail_long_line({}) : take(line);
  if (taken) {
    damaged_in_a_row_ = 0;
    return taken;
  }
  if (taken.error().at.line == 0) taken.error().at = {line_, 1};
  if (!options_.skip_damaged || judge_.rejected_in_a_row() >= most_damaged_in_a_row) return taken;
  ++damaged_;
  if (++damaged_in_a_row_ < most_damaged_in_a_row) return {};
  taken.error().message += fmt::format(" (and so in {} lines in a row)", most_damaged_in_a_row);
  return taken;
}

Result<void> LineReader::flush(const SampleSink& sink) {
  if (samples_.empty()) return {};
  auto done = sink(samples_);
  samples_.clear();
  return done;
}

}  // namespace axiometry::formats
