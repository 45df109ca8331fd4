// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/disk/stop_marks.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

#include "axiometry/app/files/synced.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

using capture::StopKey;

constexpr std::string_view before_all = "begin";  // the time of a mark before the recording begins
constexpr auto earliest_s = -std::numeric_limits<double>::infinity();

std::string_view key_word(StopKey key) {
  return key == StopKey::take ? "take" : key == StopKey::skip ? "skip" : "undo";
}

std::optional<StopMark> mark_of(std::string_view line) {
  const std::size_t comma = line.find(',');
  if (comma == line.npos) return std::nullopt;
  const std::string_view time = text::trim(line.substr(0, comma));
  const auto key = stop_key(text::trim(line.substr(comma + 1)));
  const auto time_s = time == before_all ? std::optional(earliest_s) : parse_number(time);
  if (!key || !time_s) return std::nullopt;
  return StopMark{*key, *time_s};
}

std::string line_of(const StopMark& mark) {
  return fmt::format("{},{}\n", std::isfinite(mark.time_s) ? format_exact(mark.time_s) : std::string(before_all),
                     key_word(mark.key));
}

std::unexpected<Error> fail_by_system(const std::string& file) {
  return std::unexpected(Error{std::system_category().message(errno), file, {}});
}

/// Of a file of whole lines, or one whose last a power failure cut off.
std::size_t whole_lines_of(std::string_view bytes) { return bytes.rfind('\n') + 1; }  // npos + 1 is 0

Result<std::vector<StopMark>> stop_marks_in(std::string_view bytes, const std::string& file) {
  std::vector<StopMark> marks;
  std::size_t number = 0;
  for (std::string_view line : text::split(bytes, '\n')) {
    ++number;
    line = text::trim(line);
    if (line.empty() || line.starts_with('#')) continue;
    const auto mark = mark_of(line);
    const bool begins_late = mark && mark->time_s == earliest_s && !marks.empty() && marks.back().time_s > earliest_s;
    if (!mark || begins_late)
      return std::unexpected(Error{fmt::format("found {}, expected a time in s and take, skip or undo, such as "
                                               "12.5,take",
                                               text::quoted(line)),
                                   file,
                                   {number, 1}});
    if (!marks.empty() && mark->time_s < marks.back().time_s)
      return std::unexpected(Error{fmt::format("found {} s after {} s, expected the order in which it was said",
                                               format_exact(mark->time_s), format_exact(marks.back().time_s)),
                                   file,
                                   {number, 1}});
    marks.push_back(*mark);
  }
  return marks;
}

}  // namespace

std::optional<StopKey> stop_key(std::string_view word) {
  for (const StopKey key : {StopKey::take, StopKey::skip, StopKey::undo})
    if (word == key_word(key)) return key;
  return std::nullopt;
}

std::string marks_name(const std::string& raw) { return raw + ".keys"; }

bool has_marks(const std::string& raw) {
  std::error_code unknown;
  return std::filesystem::exists(marks_name(raw), unknown);
}

Result<void> append_mark(const std::string& raw, const StopMark& mark) {
  const std::string file = marks_name(raw), line = line_of(mark);
  if (const auto before = has_marks(raw) ? whole_file(file) : Result<std::string>(); before && !before->empty()) {
    std::error_code failed;
    if (const std::size_t whole = whole_lines_of(*before); whole < before->size())
      std::filesystem::resize_file(file, whole, failed);
    if (failed) return std::unexpected(Error{failed.message(), file, {}});
  }
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor < 0) return fail_by_system(file);
  const bool written = written_all(descriptor, line) && synced(descriptor) && folder_synced(file);
  const auto failed = written ? Result<void>{} : Result<void>(fail_by_system(file));
  ::close(descriptor);
  return failed;
}

Result<std::vector<StopMark>> read_marks(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  return stop_marks_in(bytes, file);
}

Result<std::vector<StopMark>> marks_beside(const std::string& raw) {
  if (!has_marks(raw)) return std::vector<StopMark>();
  const std::string file = marks_name(raw);
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  return stop_marks_in(std::string_view(bytes).substr(0, whole_lines_of(bytes)), file);
}

}  // namespace axiometry::app
