// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/raw_times.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/base/counted.h"

namespace axiometry::app {
namespace {

constexpr std::string_view magic_1 = "AXIOMETRYTIMES1\n", magic_2 = "AXIOMETRYTIMES2\n";
constexpr std::size_t record_size = 16;
constexpr std::uint64_t one = 1;
constexpr std::uint64_t end_mask = (one << 46) - 1, unknown_bit = one << 46, connection_bit = one << 47;
constexpr int check_at = 48;
constexpr std::uint64_t connection_bit_1 = one << 63;
constexpr std::size_t largest_times = std::size_t{4} << 30;
constexpr std::uint64_t longest_piece = std::uint64_t{64} << 10;  // no piece longer than this was ever read at once

std::uint64_t little_endian(std::uint64_t x) {
  if constexpr (std::endian::native == std::endian::big) x = std::byteswap(x);
  return x;
}

/// CRC-16/CCITT of the two words of a record, least byte first; not 0 of zeros, which is what a power cut leaves.
std::uint64_t check_of(std::uint64_t first, std::uint64_t second) {
  unsigned crc = 0xffff;
  for (const std::uint64_t word : {first, second})
    for (int shift = 0; shift < 64; shift += 8) {
      crc ^= static_cast<unsigned>((word >> shift) & 0xff) << 8;
      for (int bit = 0; bit < 8; ++bit) crc = ((crc & 0x8000) != 0 ? crc << 1 ^ 0x1021 : crc << 1) & 0xffff;
    }
  return crc;
}

/// One record as it stands in the file; `at` is the end of its piece, in the first version the begin.
struct ReadStamp {
  std::uint64_t at = 0;
  std::optional<ArrivalNs> arrival{};
  bool begins_connection = false;
  std::size_t number = 0;  // its number in the file, from 0
};

std::optional<ReadStamp> stamp_of(std::string_view record, int version, std::size_t number) {
  std::uint64_t words[2];
  std::memcpy(words, record.data(), record_size);
  const std::uint64_t first = little_endian(words[0]);
  const auto arrival = static_cast<ArrivalNs>(little_endian(words[1]));
  if (arrival < 0) return std::nullopt;  // a time before 1970 is no arrival
  if (version == 1) return ReadStamp{first & ~connection_bit_1, arrival, (first & connection_bit_1) != 0, number};
  const std::uint64_t told = first & ((one << check_at) - 1);
  if (check_of(told, little_endian(words[1])) != first >> check_at) return std::nullopt;
  return ReadStamp{told & end_mask, (told & unknown_bit) != 0 ? std::nullopt : std::optional(arrival),
                   (told & connection_bit) != 0, number};
}

/// The most stamps of which none has a smaller key than one in front of it; of equal choices the later ones.
template <typename Key>
std::vector<ReadStamp> in_order(std::vector<ReadStamp> stamps, Key key) {
  const auto before = [&](const ReadStamp& a, const ReadStamp& b) { return key(a) < key(b); };
  if (std::ranges::is_sorted(stamps, before)) return stamps;
  constexpr std::size_t none = SIZE_MAX;
  std::vector<std::size_t> ends, behind(stamps.size(), none);  // of the best chain of each length; the one in front
  for (std::size_t k = 0; k < stamps.size(); ++k) {
    const auto place = std::upper_bound(ends.begin(), ends.end(), k,
                                        [&](std::size_t a, std::size_t b) { return before(stamps[a], stamps[b]); });
    if (place != ends.begin()) behind[k] = *(place - 1);
    if (place == ends.end())
      ends.push_back(k);
    else
      *place = k;
  }
  std::vector<ReadStamp> chain;
  for (std::size_t k = ends.back(); k != none; k = behind[k]) chain.push_back(stamps[k]);
  std::ranges::reverse(chain);
  return chain;
}

/// The records of a file of times, one by one, of the version that its beginning says or most of them speak for.
struct ReadTimes {
  int version = 2;
  bool headed = true;
  std::size_t records = 0;
  std::size_t torn = 0;            // bytes behind the last one
  std::vector<ReadStamp> sound{};  // stamps that pass their check
};

ReadTimes read_as(std::string_view bytes, int version) {
  ReadTimes read{.version = version};
  for (; bytes.size() >= record_size; bytes.remove_prefix(record_size))
    if (const auto stamp = stamp_of(bytes.substr(0, record_size), version, read.records++))
      read.sound.push_back(*stamp);
  read.torn = bytes.size();
  return read;
}

ReadTimes read_times(std::string_view bytes, std::uint64_t size) {
  if (bytes.starts_with(magic_2)) return read_as(bytes.substr(magic_2.size()), 2);
  if (bytes.starts_with(magic_1)) return read_as(bytes.substr(magic_1.size()), 1);
  ReadTimes checked = read_as(bytes, 2);
  checked.headed = false;
  if (!checked.sound.empty()) return checked;
  // Without a check, only what cannot be by chance: nearly all in order and within the bytes.
  ReadTimes old = read_as(bytes, 1);
  old.headed = false;
  std::erase_if(old.sound, [&](const ReadStamp& s) { return s.at > size; });
  if (old.sound.size() >= 2 &&
      10 * in_order(old.sound, [](const ReadStamp& s) { return s.at; }).size() >= 9 * old.records)
    return old;
  return checked;
}

/// Those of the first version tell begins: each piece ends where the next one begins.
std::vector<ReadStamp> by_ends(const std::vector<ReadStamp>& begins, std::uint64_t size) {
  std::vector<ReadStamp> ends;
  if (!begins.empty() && begins.front().at > 0) ends.push_back({.at = begins.front().at, .number = SIZE_MAX});
  for (std::size_t k = 0; k < begins.size(); ++k) {
    ends.push_back(begins[k]);
    const bool last = k + 1 == begins.size();
    ends.back().at = last ? size : begins[k + 1].at;
    const bool whole = last ? size - begins[k].at <= longest_piece : begins[k + 1].number == begins[k].number + 1;
    if (!whole) ends.back().arrival.reset();
  }
  return ends;
}

/// Where records are missing in front of one, their pieces lie in what it ends; in front of the connection that it
/// tells of, where it has no piece of its own.
std::vector<ReadStamp> without_the_arrivals_behind_gaps(const std::vector<ReadStamp>& stamps) {
  std::vector<ReadStamp> result;
  std::size_t expected = 0;
  for (ReadStamp stamp : stamps) {
    if (stamp.number != expected) {
      if (!stamp.arrival && stamp.begins_connection) result.push_back({.at = stamp.at, .number = expected});
      stamp.arrival.reset();
    }
    expected = stamp.number + 1;
    result.push_back(stamp);
  }
  return result;
}

void remark_on(const ReadTimes& read, const std::vector<ReadStamp>& kept, std::size_t beyond, std::uint64_t size,
               const std::string& name, std::vector<std::string>& remarks) {
  if (!read.headed)
    remarks.push_back(fmt::format(
        "found {} without its beginning AXIOMETRYTIMES2, read {} records of it that are sound", name, kept.size()));
  if (beyond > 0)
    remarks.push_back(fmt::format("found {} of {} times in {} beyond the {} bytes of the recording, left them out",
                                  beyond, read.records, name, size));
  std::size_t damaged = read.records - beyond - kept.size();
  if (!read.headed && damaged > 0) --damaged;  // one of them is the beginning, which was told
  if (damaged > 0) {
    std::size_t first = 0;
    while (first < kept.size() && kept[first].number == first) ++first;
    remarks.push_back(fmt::format("found {} of {} times in {} damaged, the first is number {}, left them out", damaged,
                                  read.records, name, first + 1));
  }
  if (read.torn > 0)
    remarks.push_back(fmt::format("found {} of an unfinished time at the end of {}, left {} out",
                                  counted(read.torn, "byte"), name, read.torn == 1 ? "it" : "them"));
}

}  // namespace

std::string times_name(const std::string& raw) { return raw + ".times"; }

bool has_times(const std::string& raw) { return ::access(times_name(raw).c_str(), R_OK) == 0; }

bool is_raw_name(std::string_view name) { return name.ends_with(".raw"); }

bool is_raw(const std::string& name) { return name != "-" && (has_times(name) || is_raw_name(name)); }

std::string times_magic() { return std::string(magic_2); }

std::string times_record(const RawStamp& stamp) {
  const std::uint64_t second = little_endian(static_cast<std::uint64_t>(stamp.arrival.value_or(0)));
  const std::uint64_t told =
      (stamp.end & end_mask) | (stamp.arrival ? 0 : unknown_bit) | (stamp.begins_connection ? connection_bit : 0);
  const std::uint64_t first = little_endian(told | check_of(told, little_endian(second)) << check_at);
  std::string record(record_size, '\0');
  std::memcpy(record.data(), &first, sizeof first);
  std::memcpy(record.data() + sizeof first, &second, sizeof second);
  return record;
}

Result<RawTimes> raw_times(const std::string& raw, std::uint64_t size) {
  const std::string name = base_name(times_name(raw));
  if (::access(times_name(raw).c_str(), F_OK) != 0)
    return RawTimes{.stamps = {},
                    .remarks = {fmt::format("found no {} beside the recording: when its {} bytes arrived is not known",
                                            name, size)},
                    .untimed = size};
  AXIOMETRY_TRY(Source source, Source::open(times_name(raw)));
  AXIOMETRY_TRY(const std::string bytes, source.read_all(largest_times));
  ReadTimes read = read_times(bytes, size);
  const auto beyond =
      static_cast<std::size_t>(std::erase_if(read.sound, [&](const ReadStamp& s) { return s.at > size; }));
  auto kept = in_order(std::move(read.sound), [](const ReadStamp& s) { return s.at; });
  std::vector<ReadStamp> timed;
  std::ranges::copy_if(kept, std::back_inserter(timed), [](const ReadStamp& s) { return s.arrival.has_value(); });
  const auto ordered = in_order(std::move(timed), [](const ReadStamp& s) { return *s.arrival; });
  std::erase_if(kept, [&](const ReadStamp& s) {
    return s.arrival && !std::ranges::binary_search(ordered, s.number, {}, &ReadStamp::number);
  });
  RawTimes times;
  remark_on(read, kept, beyond, size, name, times.remarks);
  const bool leading = read.headed && read.version == 2 && kept.size() + beyond == read.records &&
                       (kept.empty() || kept.back().number + 1 == kept.size());
  if (leading) times.prefix = magic_2.size() + kept.size() * record_size;
  if (read.version == 1)
    kept = by_ends(kept, size);
  else
    kept = without_the_arrivals_behind_gaps(kept);
  for (const ReadStamp& s : kept) times.stamps.push_back({s.at, s.arrival, s.begins_connection});
  times.untimed = size - (times.stamps.empty() ? 0 : times.stamps.back().end);
  std::uint64_t unknown = times.untimed, begin = 0;
  for (const RawStamp& stamp : times.stamps) {
    if (!stamp.arrival) unknown += stamp.end - begin;
    begin = stamp.end;
  }
  if (unknown > 0)
    times.remarks.push_back(
        fmt::format("when {} of the {} bytes of the recording arrived is not known", unknown, size));
  return times;
}

}  // namespace axiometry::app
