// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Frames of the Lasertex HPI-3D (Status Pro µLine) interferometer. Known from a program that reads them, not from its
/// maker: 16 bytes, AA, a command of two bytes, twelve bytes of data, and the check of the fifteen before.
namespace axiometry::formats::hpi {

inline constexpr std::size_t frame_size = 16;
inline constexpr double distances_per_second = 25.0;  ///< as the instrument sends them

/// How a frame of kind weather begins, also one whose check is wrong.
inline constexpr std::string_view begin_of_weather = "\xAA\xB0\x0A";

/// CRC-8, polynomial x⁸ + x⁵ + x⁴ + 1 (31 hex), most significant bit first, begun with FF; nothing is reflected.
std::uint8_t check_of(std::string_view bytes);

enum class FrameKind {
  distance,  ///< B0 15
  velocity,  ///< B0 16
  weather,   ///< B0 0A
  other,     ///< an answer to a command, or one that is not known
};

struct Weather {
  int sensor = 0;  ///< 0: of the air; others touch what they measure
  double celsius = 0.0;
  double percent = 0.0;  ///< relative humidity
  double pascal = 0.0;
};

/// What a frame says.
struct Frame {
  FrameKind kind = FrameKind::other;
  double distance_mm = 0.0;    ///< mm, in steps of 10⁻⁷ mm; where kind is distance
  bool too_fast = false;       ///< the counter overflowed since this was cleared
  bool weak = false;           ///< the light was too weak to count since this was cleared
  bool laser_settled = false;  ///< the state of the laser; what 0 means is not known for sure
  Weather weather = {};        ///< weather of kind weather
};

/// Of the first 16 bytes; nothing when these are no frame: another beginning, or a wrong check. Needs 16 bytes
/// (contract).
std::optional<Frame> frame_at(std::string_view bytes);

/// What makes the instrument send distances and weather. Nothing is set to zero and no flag is cleared.
std::string commands_to_begin();

}  // namespace axiometry::formats::hpi
