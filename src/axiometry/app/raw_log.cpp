// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/raw_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "axiometry/app/fail_system.h"
#include "axiometry/app/source.h"
#include "axiometry/app/synced.h"

namespace axiometry::app {
namespace {

constexpr auto sync_every = std::chrono::seconds(1);

Result<void> put_all(int descriptor, std::string_view bytes, const std::string& name) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return fail_system(name, "write");
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return {};
}

/// A name beside the times for what they were, that no file has yet: link(2) never overwrites.
Result<void> keep_old(const std::string& times) {
  constexpr int most = 1000;
  for (int number = 1; number <= most; ++number) {
    const std::string name = number == 1 ? times + ".old" : fmt::format("{}.old{}", times, number);
    if (::link(times.c_str(), name.c_str()) == 0 || errno == ENOENT) return {};
    if (errno != EEXIST) return fail_system(name, "write");
  }
  return std::unexpected(Error{fmt::format("found {} files of earlier times, expected fewer", most), times, {}});
}

/// A file of the sound stamps takes the place of the one that is not.
Result<void> write_anew(const std::string& raw, const std::vector<RawStamp>& stamps) {
  const std::string name = times_name(raw), beside = name + ".new";
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
        Error{"found a file of this name, expected none: raw data are never overwritten (--resume "
              "goes on with it)",
              name,
              {}});
  if (bytes < 0) return fail_system(name, "write");
  RawLog log(name, bytes, ::open(times_name(name).c_str(), flags, 0666));
  if (log.times_ < 0) {
    auto error = fail_system(times_name(name), "write");
    ::unlink(name.c_str());
    return error;
  }
  AXIOMETRY_TRY_VOID(log.put(log.times_, times_magic()));
  if (!folder_synced(name)) return fail_system(name, "write");
  return log;
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

Result<void> RawLog::append(std::string_view bytes, ArrivalNs arrival) {
  if (bytes.empty()) return {};
  AXIOMETRY_TRY_VOID(put(bytes_, bytes));
  const RawStamp stamp{size_ + bytes.size(), arrival, std::exchange(connection_begins_, false)};
  AXIOMETRY_TRY_VOID(put(times_, times_record(stamp)));
  size_ = stamp.end;
  return std::chrono::steady_clock::now() - synced_ >= sync_every ? sync() : Result<void>{};
}

Result<void> RawLog::sync() {
  synced_ = std::chrono::steady_clock::now();
  if (::fdatasync(bytes_) != 0 || ::fdatasync(times_) != 0) return fail_system(name_, "write");
  return {};
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
  std::vector<char> block(std::size_t{1} << 20);
  for (const RawStamp& stamp : times.stamps) {
    bool begins_connection = stamp.begins_connection;
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
