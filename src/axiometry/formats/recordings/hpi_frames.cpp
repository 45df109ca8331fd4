// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/hpi_frames.h"

#include "axiometry/base/contract.h"

namespace axiometry::formats::hpi {
namespace {

constexpr char first_byte = '\xAA', first_of_command = '\xB0';
constexpr std::size_t data_at = 3, check_at = frame_size - 1;
constexpr double steps_per_mm = 1e7;  // a step is 10⁻¹⁰ m
constexpr double steps_per_degree = 100.0, pascal_per_step = 10.0;

/// Two's complement, the most significant byte first.
double signed_number(std::string_view bytes) {
  std::uint64_t bits = (static_cast<unsigned char>(bytes.front()) & 0x80) != 0 ? ~std::uint64_t{0} : 0;
  for (char c : bytes) bits = bits << 8 | static_cast<unsigned char>(c);
  return static_cast<double>(static_cast<std::int64_t>(bits));
}

bool bit(char byte, int number) { return (static_cast<unsigned char>(byte) >> number & 1) != 0; }

std::string command(char second) {
  std::string frame{first_byte, first_of_command, second, '\0', '\0', '\0', '\0'};
  frame += static_cast<char>(check_of(frame));
  return frame;
}

}  // namespace

std::uint8_t check_of(std::string_view bytes) {
  unsigned check = 0xFF;
  for (char c : bytes) {
    check ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) check = (check << 1 ^ ((check & 0x80) != 0 ? 0x31U : 0U)) & 0xFF;
  }
  return static_cast<std::uint8_t>(check);
}

std::optional<Frame> frame_at(std::string_view bytes) {
  AXIOMETRY_CONTRACT(bytes.size() >= frame_size);
  if (bytes[0] != first_byte || bytes[1] != first_of_command) return std::nullopt;
  if (check_of(bytes.substr(0, check_at)) != static_cast<unsigned char>(bytes[check_at])) return std::nullopt;
  const std::string_view data = bytes.substr(data_at, check_at - data_at);
  Frame frame;
  switch (bytes[2]) {
    case '\x15': frame.kind = FrameKind::distance; break;
    case '\x16': frame.kind = FrameKind::velocity; break;
    case '\x0A': frame.kind = FrameKind::weather; break;
    default: return frame;
  }
  if (frame.kind == FrameKind::weather) {
    frame.weather = {
        .sensor = static_cast<unsigned char>(data[0]),
        .celsius = signed_number(data.substr(1, 2)) / steps_per_degree,
        .percent = static_cast<double>(static_cast<unsigned char>(data[3])),
        .pascal = static_cast<double>(static_cast<unsigned char>(data[6]) << 8 | static_cast<unsigned char>(data[7])) *
                  pascal_per_step};
    return frame;
  }
  if (frame.kind == FrameKind::distance) frame.distance_mm = signed_number(data.substr(0, 7)) / steps_per_mm;
  frame.too_fast = bit(data[9], 3);
  frame.laser_settled = bit(data[10], 0);
  frame.weak = !bit(data[10], 3);
  return frame;
}

std::string commands_to_begin() { return command('\x32') + command('\x79'); }

}  // namespace axiometry::formats::hpi
