// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"

/// When the bytes of a raw recording arrived: the file beside it, what a record of it is, and what is sound of one that
/// a power cut or a bad disk has harmed.
namespace axiometry::app {

/// Nanoseconds since 1970-01-01 00:00 UTC.
using ArrivalNs = std::int64_t;

/// RAW.times: 16 bytes "AXIOMETRYTIMES2\n", then for every piece 16 bytes, two little-endian words of 64 bits. The
/// first holds where the piece ends in RAW (bits 0 to 45), whether its arrival is not known (46), whether a connection
/// begins with it (47), and the check of all else (48 to 63: CRC-16/CCITT from 0xffff), so that no single byte can be
/// wrong unnoticed. The second is the arrival. A piece begins where the one before ends; a record
/// without a piece tells that a connection begins behind it, before its first piece has come.
///
/// "AXIOMETRYTIMES1\n", of programs before, has where the piece begins in place of its end, bit 63 for a connection,
/// and no check.
std::string times_name(const std::string& raw);

/// Whether the times of a raw file lie beside it.
bool has_times(const std::string& raw);

/// Whether a file is one that a live capture writes, with times beside it or lost: by them, or by the name.
bool is_raw(const std::string& name);

/// Likewise by the name alone: of bytes that lie in no file.
bool is_raw_name(std::string_view name);

struct RawStamp {
  std::uint64_t end = 0;               ///< end of the piece: bytes of the raw file in front of it and in it
  std::optional<ArrivalNs> arrival{};  ///< nothing where it is not known
  bool begins_connection = false;
};

std::string times_magic();
std::string times_record(const RawStamp& stamp);

/// What is sound of the times of a raw file.
struct RawTimes {
  std::vector<RawStamp> stamps;         ///< stamps in order, none beyond the bytes
  std::vector<std::string> remarks;     ///< what was missing or left out, and where; none of a sound file
  std::uint64_t untimed = 0;            ///< bytes behind the last stamp
  std::optional<std::size_t> prefix{};  ///< bytes of the file that hold just these stamps, where nothing else follows
                                        ///< but what is unfinished or points beyond the bytes
};

/// A record that fails its check, points beyond the bytes, is of before 1970 or is out of order with more of the others
/// than agree with it is left out; the arrival of the bytes between its neighbours is then not known. A file without
/// its beginning is read by its records. Fails only when the times are there and cannot be read.
Result<RawTimes> raw_times(const std::string& raw, std::uint64_t size);

}  // namespace axiometry::app
