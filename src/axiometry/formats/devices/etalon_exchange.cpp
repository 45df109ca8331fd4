// SPDX-License-Identifier: Apache-2.0
//
// The exchange format of Etalon for volumetric errors: its positioning errors.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/devices/error_curves.h"
#include "axiometry/formats/text/fixed_units.h"
#include "axiometry/formats/text/text_lines.h"

namespace axiometry::formats {
namespace etalon_exchange {
namespace {

std::optional<std::string_view> block_name(std::string_view content) {
  if (!content.starts_with('[') || !content.ends_with(']')) return std::nullopt;
  return text::trim(content.substr(1, content.size() - 2));
}

Result<ErrorPoint> point_from(std::string_view content, const TextLine& line) {
  const auto words = text::words(content);
  if (words.size() != 2)
    return fail(fmt::format("found {}, expected two numbers: position and error", text::quoted(content)),
                line.at(content));
  const auto position = parse_number(words[0]);
  const auto error = parse_number(words[1]);
  if (!position || !error)
    return fail(fmt::format("found {}, expected a finite number", text::quoted(position ? words[1] : words[0])),
                line.at(position ? words[1] : words[0]));
  return ErrorPoint{*position, *error, line.at(words[1])};
}

class CurveReader {
 public:
  Result<std::vector<ErrorCurve>> read(std::string_view text) {
    const std::vector<TextLine> lines = content_lines(text);
    AXIOMETRY_TRY_VOID(expect_fixed_units(lines, {"mm"}));
    for (const TextLine& line : lines) AXIOMETRY_TRY_VOID(take(line));
    if (in_points_)
      return fail(fmt::format("found no }} behind the grid points of {}, expected one; is the file cut off?", name_),
                  {line_, 1});
    return std::move(curves_);
  }

 private:
  Result<void> take(const TextLine& line) {
    const std::string_view content = without_comment(line.text);
    if (content.empty()) return {};
    if (in_points_) return take_points(content, line);
    if (const auto name = block_name(content)) {
      name_ = *name;
      line_ = line.number;
      return {};
    }
    const auto item = tagged_value(content, '=');
    if (item && item->tag == "sign" &&
        parse_number(item->value.substr(0, item->value.find_last_not_of(" ;,") + 1)) != 1.0)
      return fail(fmt::format("found SIGN = {}, expected 1 or none: errors are actual minus nominal in this format",
                              text::quoted(item->value)),
                  line.at(item->value));
    if (!item || item->tag != "gridpoints" || !item->value.starts_with('{')) return {};
    in_points_ = true;
    if (line_ == 0) line_ = line.number;
    wanted_ = !axis_of_error(name_).empty();
    if (wanted_) {
      if (const auto again = std::ranges::find(curves_, name_, &ErrorCurve::name); again != curves_.end())
        return fail(fmt::format("found a second block {}, expected only that on line {}", name_, again->line),
                    {line_, 1});
      curves_.push_back({.name = name_, .axis = axis_of_error(name_), .line = line_, .points = {}});
    }
    const std::string_view rest = text::trim(item->value.substr(1));
    return rest.empty() ? Result<void>() : take_points(rest, line);
  }

  Result<void> take_points(std::string_view content, const TextLine& line) {
    const std::size_t end = content.find('}');
    in_points_ = end == std::string_view::npos;
    const std::string_view point = text::trim(content.substr(0, end));
    if (point.empty() || !wanted_) return {};
    AXIOMETRY_TRY(const ErrorPoint found, point_from(point, line));
    curves_.back().points.push_back(found);
    return {};
  }

  std::vector<ErrorCurve> curves_;
  std::string name_;
  std::size_t line_ = 0;
  bool in_points_ = false;
  bool wanted_ = false;
};

Result<std::vector<ErrorCurve>> curves_of(std::string_view text) { return CurveReader().read(text); }

Result<Test> read(std::string_view bytes) { return read_curve(bytes, curves_of); }

Result<void> read_many(ByteReader& bytes, const NamedTestSink& sink) { return read_curves(bytes, sink, curves_of); }

std::size_t count_blocks(std::string_view head, bool positioning_only) {
  std::size_t count = 0;
  for (const TextLine& line : content_lines(head))
    if (const auto name = block_name(without_comment(line.text)))
      count += !positioning_only || !axis_of_error(*name).empty();
  return count;
}

bool holds_many(std::string_view head) { return count_blocks(head, true) > 1; }

int recognise(std::string_view head) {
  if (count_blocks(head, false) == 0) return 0;
  const std::string text = text::to_lower(head);
  if (text.contains("gridpoints")) return 96;
  return count_blocks(head, true) > 0 ? 70 : 0;
}

constexpr std::string_view manual =
    R"(The exchange format of Etalon, in which errors of all axes of a machine go to its control.

```
// Positioning error of the X axis
[EXX]
Gridpoints = {
    0.0    0.0001
    50.0  -0.0003
    100.0  0.0002
}
```

- Read are the positioning errors `[EXX]`, `[EYY]` and `[EZZ]`: rows of position and error in mm below `Gridpoints`.
  Each is a test of its own, named like its block. Other blocks are passed over: straightness, angles, squareness and
  the errors of rotary axes, whose units differ between programs.
- `//` begins a comment.
- The errors stand under ↑ as the only run, with the sign as found. They are computed values, no measured approaches, so
  the tests are no tests after ISO 230-2.
- Refused: a block given twice, grid points without their closing brace, rows of other than two numbers.
)";

}  // namespace
}  // namespace etalon_exchange

extern const Format etalon_exchange_format;
const Format etalon_exchange_format = {
    .id = "etalon-exchange",
    .title = "Etalon exchange format, positioning errors",
    .extensions = ".exc .txt",
    .manual = etalon_exchange::manual,
    .recognise = etalon_exchange::recognise,
    .read = etalon_exchange::read,
    .holds_many = etalon_exchange::holds_many,
    .read_many = etalon_exchange::read_many,
};

}  // namespace axiometry::formats
