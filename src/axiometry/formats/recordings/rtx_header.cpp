// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/rtx_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/name_words.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t longest_rtx_header = std::size_t{64} << 10;
constexpr double slowest_hz = 1e-6, fastest_hz = 1e9;
constexpr double interval_tolerance = 0.01;
constexpr std::size_t longest_value = 200;

struct RtxLine {
  std::string_view key, value;
};

RtxLine key_and_value(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == line.npos) return {text::trim(line), {}};
  return {text::trim(line.substr(0, colon)), text::trim(line.substr(colon + 1))};
}

/// Readable text of one line, whatever its bytes are.
std::string shown_value(std::string_view value) {
  std::string shown;
  for (const char c : value.substr(0, longest_value))
    shown += static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~' ? '?' : c;
  return shown;
}

void take_text(RtxHeader& header, std::string_view key, std::string_view value) {
  const std::pair<std::string_view, std::string*> members[] = {{"owner", &header.owner},
                                                               {"version no", &header.version},
                                                               {"file type", &header.file_type},
                                                               {"machine", &header.machine},
                                                               {"serial no", &header.serial_number},
                                                               {"date", &header.date},
                                                               {"by", &header.by},
                                                               {"axis", &header.axis},
                                                               {"location", &header.location}};
  for (const auto& [name, member] : members)
    if (text::equal_ignoring_case(key, name)) *member = shown_value(value);
}

struct RtxNumbers {
  std::string_view samples, rate, actual_rate, interval;
};

void take_number(RtxNumbers& numbers, std::string_view key, std::string_view value) {
  const std::pair<std::string_view, std::string_view*> members[] = {{"sample no", &numbers.samples},
                                                                    {"sample rate", &numbers.rate},
                                                                    {"actual sample rate", &numbers.actual_rate},
                                                                    {"trigger interval", &numbers.interval}};
  for (const auto& [name, member] : members)
    if (text::equal_ignoring_case(key, name)) *member = value;
}

Result<void> settle(RtxHeader& header, const RtxNumbers& numbers) {
  const auto samples = parse_count(numbers.samples);
  if (!samples || *samples == 0)
    return fail(fmt::format("found {} as Sample no of an .rtx recording, expected how many samples it holds",
                            text::quoted(numbers.samples)));
  header.samples = static_cast<std::uint64_t>(*samples);
  header.rate_is_actual = !numbers.actual_rate.empty();
  const std::string_view stated = header.rate_is_actual ? numbers.actual_rate : numbers.rate;
  const auto rate = parse_number(stated);
  if (!rate || !(*rate >= slowest_hz && *rate <= fastest_hz))
    return fail(
        fmt::format("found {} as sample rate of an .rtx recording, expected 1e-6 to 1e9 Hz", text::quoted(stated)));
  header.rate_hz = *rate;
  header.trigger_interval = parse_number(numbers.interval);
  return {};
}

/// "10/02/2025" or " 3/ 4/2025", whose first two numbers may each be the month, and not "31/12/2025" or "05/05/2025".
bool reads_two_ways(std::string_view date) {
  std::array<unsigned, 2> numbers{};
  for (unsigned& number : numbers) {
    date = text::trim(date);
    const auto [end, error] = std::from_chars(date.data(), date.data() + date.size(), number);
    date = text::trim(date.substr(static_cast<std::size_t>(end - date.data())));
    if (error != std::errc{} || date.empty() || (date.front() != '/' && date.front() != '-')) return false;
    date.remove_prefix(1);
  }
  return numbers[0] != numbers[1] && std::ranges::all_of(numbers, [](unsigned n) { return n >= 1 && n <= 12; });
}

}  // namespace

Result<std::optional<RtxHeader>> rtx_header(std::string_view bytes) {
  constexpr std::string_view title = "HEADER::";
  if (!text::equal_ignoring_case(bytes.substr(0, title.size()), title.substr(0, bytes.size())))
    return fail("found no .rtx recording, expected HEADER:: at its beginning");
  RtxHeader header;
  RtxNumbers numbers;
  std::size_t at = 0;
  while (true) {
    const std::size_t end = bytes.find('\n', at);
    if ((end == bytes.npos ? bytes.size() : end) > longest_rtx_header)
      return fail(
          fmt::format("found no Data: in the first {} bytes of an .rtx recording, expected it behind the header",
                      longest_rtx_header));
    if (end == bytes.npos) return std::optional<RtxHeader>();
    const auto [key, value] = key_and_value(bytes.substr(at, end - at));
    at = end + 1;
    if (text::equal_ignoring_case(key, "data") && value.empty()) break;
    take_text(header, key, value);
    take_number(numbers, key, value);
  }
  header.data_at = at;
  AXIOMETRY_TRY_VOID(settle(header, numbers));
  return std::optional(std::move(header));
}

std::optional<AxisKind> rtx_kind(const RtxHeader& h) {
  static constexpr NameWord rtx_angular[] = {{"ang", WordPlace::front}, {"rot", WordPlace::front}, {"rta"}};
  static constexpr NameWord rtx_linear[] = {{"lin", WordPlace::front}, {"rtl"}};
  if (has_any_word(h.file_type, rtx_angular)) return AxisKind::rotary;
  if (has_any_word(h.file_type, rtx_linear)) return AxisKind::linear;
  return std::nullopt;
}

std::vector<std::string> rtx_remarks(const RtxHeader& h) {
  std::vector<std::string> remarks;
  if (!h.rate_is_actual)
    remarks.push_back(
        "the file states no actual sample rate: the times are those of the sample rate that was asked for");
  if (h.trigger_interval && std::abs(*h.trigger_interval * h.rate_hz - 1.0) > interval_tolerance)
    remarks.push_back(
        fmt::format("the file states a trigger interval of {} and a rate of {} Hz, which are no interval of time and "
                    "its rate: were the samples triggered by position, their times are wrong",
                    format_exact(*h.trigger_interval), format_exact(h.rate_hz)));
  const std::pair<std::string_view, const std::string*> named[] = {
      {"the file names the machine {}", &h.machine},
      {"the file names the axis {}", &h.axis},
      {"the file names the location {}", &h.location},
      {"the file names the serial number {}", &h.serial_number}};
  for (const auto& [words, value] : named)
    if (!value->empty()) remarks.push_back(fmt::format(fmt::runtime(words), text::quoted(*value)));
  if (!h.date.empty())
    remarks.push_back(
        fmt::format(fmt::runtime(reads_two_ways(h.date)
                                     ? "the file is of {}; whether the day or the month stands first it does not say"
                                     : "the file is of {}"),
                    text::quoted(h.date)));
  return remarks;
}

}  // namespace axiometry::formats
