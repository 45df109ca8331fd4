// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/sources/capture_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr std::size_t longest_name = 40;
constexpr std::string_view name_of_simulator = "simulator";

bool is_name(std::string_view name) {
  return !name.empty() && name.size() <= longest_name && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
}

}  // namespace

std::string_view kind_name(CaptureSource::Kind kind) {
  switch (kind) {
    case CaptureSource::Kind::simulator: return "simulator";
    case CaptureSource::Kind::tcp: return "tcp";
    case CaptureSource::Kind::serial: return "serial";
  }
  return "";
}

CaptureSource simulator_source() {
  return {.id = std::string(name_of_simulator),
          .kind = CaptureSource::Kind::simulator,
          .title = "Simulator",
          .address = {}};
}

Result<CaptureSource> parse_capture_source(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    return fail(fmt::format("found the source {}, expected NAME=tcp://host:port or NAME=serial:///dev/ttyACM0",
                            text::quoted(text)));
  const std::string_view name = text.substr(0, equals);
  if (!is_name(name))
    return fail(fmt::format("found the name {} of a source, expected 1 to {} letters, digits, '-', '_' or '.'",
                            text::quoted(name), longest_name));
  if (text::equal_ignoring_case(name, name_of_simulator))
    return fail("found the name simulator of a source, expected another one: that is there already");
  AXIOMETRY_TRY(const auto address, parse_live(std::string(text.substr(equals + 1))));
  if (!address || address->kind == LiveAddress::Kind::simulator)
    return fail(fmt::format("found {} as source {}, expected tcp://host:port or serial:///dev/ttyACM0",
                            text::quoted(text.substr(equals + 1)), name));
  return CaptureSource{
      .id = std::string(name),
      .kind = address->kind == LiveAddress::Kind::tcp ? CaptureSource::Kind::tcp : CaptureSource::Kind::serial,
      .title = std::string(name),
      .address = *address};
}

}  // namespace axiometry::app
