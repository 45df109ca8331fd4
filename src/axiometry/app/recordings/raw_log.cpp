// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/raw_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "axiometry/app/files/fail_system.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/synced.h"

namespace axiometry::app {
namespace {

constexpr auto sync_every = std::chrono::seconds(1);
constexpr std::size_t most_old_times = 1000;
constexpr std::string_view old_suffix = ".old", new_suffix = ".new";

Result<void> put_all(int descriptor, std::string_view bytes, const std::string& name) {
  if (!written_all(descriptor, bytes)) return fail_system(name, "write");
  return {};
}

/// Where a disk knows no second name of a file, such as a USB stick.
Result<void> copy(const std::string& times, const std::string& name) {
  AXIOMETRY_TRY(Source source, Source::open(times));
  const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return fail_system(name, "write");
  std::vector<char> block(std::size_t{1} << 20);
  Result<void> copied;
  while (copied) {
    const auto got = source.read(block);
    if (!got) copied = std::unexpected(got.error());
    if (!got || *got == 0) break;
    copied = put_all(descriptor, {block.data(), *got}, name);
  }
  if (copied && ::fsync(descriptor) != 0) copied = fail_system(name, "write");
  ::close(descriptor);
  if (!copied) ::unlink(name.c_str());
  return copied;
}

/// The file stays under a name that none has yet: neither link(2) nor O_EXCL ever overwrites.
Result<void> keep_old(const std::string& times) {
  for (std::size_t number = 1; number <= most_old_times; ++number) {
    const std::string name = fmt::format("{}{}{}", times, old_suffix, number == 1 ? "" : std::to_string(number));
    if (::link(times.c_str(), name.c_str()) == 0 || errno == ENOENT) return {};
    if (errno != EEXIST) return copy(times, name);
  }
  return std::unexpected(
      Error{fmt::format("found {} files of earlier times, expected fewer", most_old_times), times, {}});
}

/// A file of the sound stamps takes the place of the one that is not.
Result<void> write_anew(const std::string& raw, const std::vector<RawStamp>& stamps) {
  const std::string name = times_name(raw), beside = name + std::string(new_suffix);
  AXIOMETRY_TRY_VOID(keep_old(name));
  const int descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return fail_system(beside, "write");
  std::string bytes = times_magic();
  for (const RawStamp& stamp : stamps) bytes += times_record(stamp);
  auto written = put_all(descriptor, bytes, beside);
  if (written && ::fsync(descriptor) != 0) written = fail_system(beside, "write");
  ::close(descriptor);
  if (written && ::rename(beside.c_str(), name.c_str()) != 0) written = fail_system(name, "write");
  if (!written) ::unlink(beside.c_str());
  if (written && !folder_synced(raw)) written = fail_system(name, "write");
  return written;
}

}  // namespace

Result<RawLog> RawLog::create(const std::string& name) {
  constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC;
  const int bytes = ::open(name.c_str(), flags, 0666);
  if (bytes < 0 && errno == EEXIST)
    return std::unexpected(
        Error{"found a file of this name, expected none: raw data are never overwritten, though a capture can go on "
              "with them",
              name,
              {}});
  if (bytes < 0) return fail_system(name, "write");
  RawLog log(name, bytes, ::open(times_name(name).c_str(), flags, 0666));
  if (log.times_ < 0) {
    auto error = fail_system(times_name(name), "write");
    ::unlink(name.c_str());
    return error;
  }
  auto begun = log.put(log.times_, times_magic());
  if (begun && !folder_synced(name)) begun = fail_system(name, "write");
  if (begun) return log;
  for (const std::string& file : {times_name(name), name}) ::unlink(file.c_str());
  return std::unexpected(std::move(begun).error());
}

Result<RawLog> RawLog::resume(const std::string& name) {
  const int bytes = ::open(name.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (bytes < 0) return fail_system(name, "write");
  RawLog log(name, bytes, -1);
  struct stat status {};
  if (::fstat(bytes, &status) != 0) return fail_system(name, "write");
  log.size_ = static_cast<std::uint64_t>(status.st_size);
  AXIOMETRY_TRY(const RawTimes times, raw_times(name, log.size_));
  if (!times.prefix) AXIOMETRY_TRY_VOID(write_anew(name, times.stamps));
  log.times_ = ::open(times_name(name).c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (log.times_ < 0 || (times.prefix && ::ftruncate(log.times_, static_cast<off_t>(*times.prefix)) != 0))
    return fail_system(times_name(name), "write");
  if (times.untimed > 0) AXIOMETRY_TRY_VOID(log.put(log.times_, times_record({.end = log.size_})));
  for (const RawStamp& stamp : times.stamps) log.last_ = std::max(log.last_, stamp.arrival.value_or(0));
  return log;
}

RawLog::RawLog(RawLog&& other) noexcept
    : name_(std::move(other.name_)),
      bytes_(std::exchange(other.bytes_, -1)),
      times_(std::exchange(other.times_, -1)),
      size_(other.size_),
      last_(other.last_),
      connection_begins_(other.connection_begins_),
      is_synced_(other.is_synced_),
      synced_(other.synced_) {}

RawLog::~RawLog() {
  for (const int descriptor : {bytes_, times_})
    if (descriptor >= 0) ::close(descriptor);
}

ArrivalNs RawLog::stamp() {
  using namespace std::chrono;
  const ArrivalNs now = duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
  last_ = std::max(last_, now);
  return last_;
}

Result<void> RawLog::put(int descriptor, std::string_view bytes) const { return put_all(descriptor, bytes, name_); }

Result<void> RawLog::append(std::string_view bytes, std::optional<ArrivalNs> arrival) {
  if (bytes.empty()) return {};
  AXIOMETRY_TRY_VOID(put(bytes_, bytes));
  const RawStamp stamp{size_ + bytes.size(), arrival, std::exchange(connection_begins_, false)};
  AXIOMETRY_TRY_VOID(put(times_, times_record(stamp)));
  size_ = stamp.end;
  is_synced_ = false;
  return sync_when_due();
}

Result<void> RawLog::begin_connection() {
  connection_begins_ = true;
  is_synced_ = false;
  return put(times_, times_record({.end = size_, .begins_connection = true}));
}

Result<void> RawLog::sync() {
  synced_ = std::chrono::steady_clock::now();
  if (::fdatasync(bytes_) != 0 || ::fdatasync(times_) != 0) return fail_system(name_, "write");
  is_synced_ = true;
  return {};
}

Result<void> RawLog::sync_when_due() {
  const bool due = !is_synced_ && std::chrono::steady_clock::now() - synced_ >= sync_every;
  return due ? sync() : Result<void>{};
}

Result<RawHold> RawHold::take(const std::string& raw) {
  RawHold hold(::open(raw.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (hold.descriptor_ < 0 || ::fstat(hold.descriptor_, &status) != 0) return fail_system(raw, "read");
  if (!S_ISREG(status.st_mode))
    return std::unexpected(Error{"found a device, a pipe or a folder, expected a file", raw, {}});
  if (::flock(hold.descriptor_, LOCK_EX | LOCK_NB) == 0) return hold;
  if (errno != EWOULDBLOCK) return fail_system(raw, "lock");
  return std::unexpected(Error{"found another program at this recording, expected none: it has one listener", raw, {}});
}

RawHold::RawHold(RawHold&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

RawHold::~RawHold() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> sync_raw(const std::string& raw) {
  for (const std::string& name : {raw, times_name(raw)}) {
    const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0 && errno == ENOENT && name != raw) continue;
    if (descriptor < 0) return fail_system(name, "read");
    const bool done = synced(descriptor);
    ::close(descriptor);
    if (!done) return fail_system(name, "write");
  }
  return folder_synced(raw) ? Result<void>{} : fail_system(raw, "write");
}

void remove_raw(const std::string& raw) {
  const std::filesystem::path times = times_name(raw);
  const std::string name = times.filename().string();
  std::vector<std::string> all{raw, times.string(), times.string() + std::string(new_suffix)};
  std::error_code ignored;
  const auto folder = times.has_parent_path() ? times.parent_path() : std::filesystem::path(".");
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with(name + std::string(old_suffix)))
      all.push_back(entry.path().string());
  for (const std::string& file : all) ::unlink(file.c_str());
}

Result<std::vector<std::string>> play(const std::string& raw,
                                      const std::function<Result<void>(const RawPiece&)>& sink) {
  AXIOMETRY_TRY(Source source, Source::open(raw));
  std::error_code unknown;
  const auto size = std::filesystem::file_size(raw, unknown);
  AXIOMETRY_TRY(RawTimes times, raw_times(raw, unknown ? 0 : size));
  const bool timed = std::ranges::any_of(times.stamps, [](const RawStamp& s) { return s.arrival.has_value(); });
  times.stamps.push_back({.end = UINT64_MAX});  // what is behind them, and what comes while it is read
  std::uint64_t at = 0;
  bool begins_connection = false;
  std::vector<char> block(std::size_t{1} << 20);
  for (const RawStamp& stamp : times.stamps) {
    begins_connection = begins_connection || stamp.begins_connection;
    while (at < stamp.end) {
      const std::size_t most = std::min<std::uint64_t>(stamp.end - at, block.size());
      AXIOMETRY_TRY(const std::size_t got, source.read(std::span(block).first(most)));
      if (got == 0) return std::move(times.remarks);
      at += got;
      AXIOMETRY_TRY_VOID(sink({{block.data(), got}, stamp.arrival, std::exchange(begins_connection, false), timed}));
    }
  }
  return std::move(times.remarks);
}

}  // namespace axiometry::app
