// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/raw_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "axiometry/app/fail_system.h"
#include "axiometry/app/source.h"
#include "axiometry/app/synced.h"

namespace axiometry::app {
namespace {

constexpr std::string_view magic = "AXIOMETRYTIMES1\n";
constexpr std::size_t record_size = 16;
constexpr std::uint64_t connection_bit = std::uint64_t{1} << 63;
constexpr auto sync_every = std::chrono::seconds(1);
constexpr std::size_t largest_times = std::size_t{4} << 30;

using Record = std::array<char, record_size>;

std::uint64_t little_endian(std::uint64_t x) {
  if constexpr (std::endian::native == std::endian::big) x = std::byteswap(x);
  return x;
}

Record record_of(std::uint64_t offset, ArrivalNs arrival) {
  Record record;
  const std::uint64_t words[2] = {little_endian(offset), little_endian(static_cast<std::uint64_t>(arrival))};
  std::memcpy(record.data(), words, record_size);
  return record;
}

struct Stamp {
  std::uint64_t offset = 0;
  ArrivalNs arrival = 0;
  bool begins_connection = false;
};

Stamp stamp_of(const char* record) {
  std::uint64_t words[2];
  std::memcpy(words, record, record_size);
  const std::uint64_t offset = little_endian(words[0]);
  return {offset & ~connection_bit, static_cast<ArrivalNs>(little_endian(words[1])), (offset & connection_bit) != 0};
}

/// A record that a crash of the machine left unfinished at the end is passed over.
Result<std::vector<Stamp>> stamps_of(const std::string& raw) {
  const std::string name = times_name(raw);
  AXIOMETRY_TRY(Source source, Source::open(name));
  AXIOMETRY_TRY(const std::string bytes, source.read_all(largest_times));
  if (!bytes.starts_with(magic))
    return std::unexpected(Error{"found no times of a raw recording, expected \"AXIOMETRYTIMES1\"", name, {}});
  std::vector<Stamp> stamps;
  for (std::size_t at = magic.size(); at + record_size <= bytes.size(); at += record_size) {
    stamps.push_back(stamp_of(bytes.data() + at));
    const bool ordered = stamps.size() < 2 || (stamps.back().offset >= stamps[stamps.size() - 2].offset &&
                                               stamps.back().arrival >= stamps[stamps.size() - 2].arrival);
    if (!ordered)
      return std::unexpected(Error{fmt::format("found record {} before the one in front of it, expected offsets and "
                                               "times in order",
                                               stamps.size()),
                                   name,
                                   {}});
  }
  return stamps;
}

}  // namespace

std::string times_name(const std::string& raw) { return raw + ".times"; }

bool has_times(const std::string& raw) { return ::access(times_name(raw).c_str(), R_OK) == 0; }

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
  AXIOMETRY_TRY_VOID(log.put(log.times_, magic));
  if (!folder_synced(name)) return fail_system(name, "write");
  return log;
}

Result<RawLog> RawLog::resume(const std::string& name) {
  AXIOMETRY_TRY(const std::vector<Stamp> stamps, stamps_of(name));
  const int bytes = ::open(name.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (bytes < 0) return fail_system(name, "write");
  RawLog log(name, bytes, ::open(times_name(name).c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  struct stat status {};
  if (log.times_ < 0 || ::fstat(bytes, &status) != 0 ||
      ::ftruncate(log.times_, static_cast<off_t>(magic.size() + stamps.size() * record_size)) != 0)
    return fail_system(name, "write");
  log.size_ = static_cast<std::uint64_t>(status.st_size);
  if (!stamps.empty()) log.last_ = stamps.back().arrival;
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

Result<void> RawLog::put(int descriptor, std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return fail_system(name_, "write");
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return {};
}

Result<void> RawLog::append(std::string_view bytes, ArrivalNs arrival) {
  const std::uint64_t flag = std::exchange(connection_begins_, false) ? connection_bit : 0;
  const Record record = record_of(size_ | flag, arrival);
  AXIOMETRY_TRY_VOID(put(times_, {record.data(), record.size()}));
  AXIOMETRY_TRY_VOID(put(bytes_, bytes));
  size_ += bytes.size();
  return std::chrono::steady_clock::now() - synced_ >= sync_every ? sync() : Result<void>{};
}

Result<void> RawLog::sync() {
  synced_ = std::chrono::steady_clock::now();
  if (::fdatasync(bytes_) != 0 || ::fdatasync(times_) != 0) return fail_system(name_, "write");
  return {};
}

Result<void> play(const std::string& raw, const std::function<Result<void>(const RawPiece&)>& sink) {
  AXIOMETRY_TRY(const std::vector<Stamp> stamps, stamps_of(raw));
  AXIOMETRY_TRY(Source source, Source::open(raw));
  std::uint64_t at = 0;
  std::vector<char> block(std::size_t{1} << 20);
  bool begins_connection = false;  // also of a time whose bytes never came
  for (std::size_t k = 0; k < stamps.size(); ++k) {
    begins_connection = begins_connection || stamps[k].begins_connection;
    const bool last = k + 1 == stamps.size();
    std::size_t left = last ? SIZE_MAX : stamps[k + 1].offset - stamps[k].offset;
    if (stamps[k].offset != at)
      return std::unexpected(Error{fmt::format("found times from byte {} on, expected them from byte {}: the raw file "
                                               "is shorter than its times",
                                               stamps[k].offset, at),
                                   raw,
                                   {}});
    while (left > 0) {
      AXIOMETRY_TRY(const std::size_t got, source.read(std::span(block).first(std::min(left, block.size()))));
      if (got == 0) break;
      left -= got;
      at += got;
      AXIOMETRY_TRY_VOID(sink({{block.data(), got}, stamps[k].arrival, std::exchange(begins_connection, false)}));
    }
  }
  return {};
}

}  // namespace axiometry::app
