// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>

namespace axiometry::testing_support {

/// The bytes of an .rtx recording as programs write it. `header` stands in front of Data: in place of the usual lines.
inline std::string rtx_file(std::span<const double> positions, double rate_hz, const std::string& header = {}) {
  std::string bytes = "HEADER::\r\n";
  if (header.empty())
    bytes +=
        "File name: run.rtx\r\nOwner: CARTO-Dynamic\r\nVersion no: 4.13\r\nFile Type: rtx\r\nVelocity: \r\n"
        "Sample rate: " +
        std::to_string(rate_hz) + "\r\nSample no: " + std::to_string(positions.size()) +
        "\r\nTrigger point: 0\r\nTrigger interval: " + std::to_string(1.0 / rate_hz) +
        "\r\nActual sample rate: " + std::to_string(rate_hz) +
        "\r\nFlags: 0 1 2 0 2\r\nUSER-TEXT::\r\nMachine: Mill 5\r\nDate: 10/02/2025 12:58:22\r\nAxis: X\r\n";
  else
    bytes += header;
  bytes += "Data:\r\n";
  for (const double x : positions) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int k = 0; k < 8; ++k) bytes += static_cast<char>(bits >> (8 * k) & 0xFF);
  }
  return bytes + "\r\nEOF::\r\n";
}

}  // namespace axiometry::testing_support
