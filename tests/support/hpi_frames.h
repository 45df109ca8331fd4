// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

/// Frames as an HPI-3D sends them, made bit by bit and not by the code under test.
namespace axiometry::testing_support {

struct HpiState {
  bool too_fast = false, weak = false, ready = true;
};

inline std::string hpi_frame(char command, std::string_view data) {
  std::string frame{'\xAA', '\xB0', command};
  frame += data;
  unsigned check = 0xFF;
  for (char c : frame)
    for (int k = 7; k >= 0; --k) {
      const bool turn = ((check >> 7) & 1U) != ((static_cast<unsigned char>(c) >> k) & 1U);
      check = (check << 1) & 0xFFU;
      if (turn) check ^= 0x31U;
    }
  return frame + static_cast<char>(check);
}

inline std::string big_endian(std::int64_t value, int bytes) {
  std::string text;
  for (int k = bytes - 1; k >= 0; --k) text += static_cast<char>(value >> (8 * k) & 0xFF);
  return text;
}

inline std::string hpi_distance(double mm, HpiState state = {}) {
  std::string data = big_endian(std::llround(mm * 1e7), 7) + std::string(2, '\0');
  data += state.too_fast ? '\x08' : '\0';
  data += static_cast<char>((state.weak ? 0 : 8) | (state.ready ? 1 : 0));
  data += '\x5A';
  return hpi_frame('\x15', data);
}

inline std::string hpi_weather(int sensor, double celsius, int percent, double hpa) {
  return hpi_frame('\x0A', std::string(1, static_cast<char>(sensor)) + big_endian(std::llround(celsius * 100.0), 2) +
                               static_cast<char>(percent) + "PP" + big_endian(std::llround(hpa * 10.0), 2) +
                               std::string(4, '\0'));
}

inline std::string hpi_velocity() { return hpi_frame('\x16', std::string(10, '\0') + "\x09\x5A"); }

}  // namespace axiometry::testing_support
