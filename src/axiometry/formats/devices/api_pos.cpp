// SPDX-License-Identifier: Apache-2.0
//
// Position files (.pos) of API (Automated Precision): averages of a test, without its single approaches.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/series/approaches.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/fixed_units.h"
#include "axiometry/formats/text/text_lines.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace api_pos {
namespace {

enum class Block { bidirectional, forward, reverse };
constexpr std::size_t block_count = 3;

/// "Position <tab> Bidirectional Avg Error": words in any case, any blanks between them.
std::optional<Block> block_head(std::string_view line) {
  const std::string name = plain_name(line);
  if (!name.starts_with("position ") || !name.ends_with("avg error")) return std::nullopt;
  if (name.contains("bidirectional")) return Block::bidirectional;
  if (name.contains("forward")) return Block::forward;
  if (name.contains("reverse") || name.contains("backward")) return Block::reverse;
  return std::nullopt;
}

struct Point {
  double position_mm = 0.0;
  double error_mm = 0.0;
  TextPosition at;
  TextPosition error_at;
};

struct Content {
  std::array<std::vector<Point>, block_count> blocks;
  std::array<std::size_t, block_count> head_lines{};

  const std::vector<Point>& points(Block block) const { return blocks[static_cast<std::size_t>(block)]; }
};

bool begins_a_number(std::string_view line) { return std::string_view("+-.,0123456789").contains(line.front()); }

Result<Point> point_from(const TextLine& line, NumberReader& numbers) {
  const auto words = text::words(line.text);
  if (words.size() != 2)
    return fail(fmt::format("found {}, expected two numbers: position and error{}", text::quoted(line.text),
                            line.has_break ? "" : "; the file ends here, is it cut off?"),
                {line.number, line.column});
  Point point{.at = line.at(words[0]), .error_at = line.at(words[1])};
  AXIOMETRY_TRY(point.position_mm, numbers.read(words[0], point.at));
  AXIOMETRY_TRY(point.error_mm, numbers.read(words[1], point.error_at));
  return point;
}

/// Lines between the blocks that do not begin with a number end the block before them: other results may follow.
Result<Content> content_from(std::string_view text) {
  Content content;
  NumberReader numbers(' ');
  std::vector<Point>* block = nullptr;
  const std::vector<TextLine> lines = content_lines(text);
  AXIOMETRY_TRY_VOID(expect_fixed_units(lines, {"mm"}));
  for (const TextLine& line : lines) {
    if (const auto head = block_head(line.text)) {
      std::size_t& first = content.head_lines[static_cast<std::size_t>(*head)];
      if (first != 0)
        return fail(
            fmt::format("found a second block {}, expected only that on line {}", text::quoted(line.text), first),
            {line.number, line.column});
      first = line.number;
      block = &content.blocks[static_cast<std::size_t>(*head)];
    } else if (block != nullptr && begins_a_number(line.text)) {
      AXIOMETRY_TRY(const Point point, point_from(line, numbers));
      block->push_back(point);
    } else {
      block = nullptr;
    }
  }
  return content;
}

Result<void> add(std::vector<ListedReading>& approaches, const std::vector<Point>& points, Direction direction) {
  const ReadingRule rule{Measured::deviation, find_unit("mm")};
  for (const Point& point : points) {
    const Position target = Position::native(point.position_mm);
    AXIOMETRY_TRY(const double deviation, placed(native_deviation(rule, target, point.error_mm), point.error_at));
    approaches.push_back(
        {.target = target, .direction = direction, .deviation = Deviation::native(deviation), .at = point.at});
  }
  return {};
}

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(const Content content, content_from(decoded.text));
  std::vector<ListedReading> approaches;
  AXIOMETRY_TRY_VOID(add(approaches, content.points(Block::forward), Direction::up));
  AXIOMETRY_TRY_VOID(add(approaches, content.points(Block::reverse), Direction::down));
  const bool directed = !approaches.empty();
  if (!directed) AXIOMETRY_TRY_VOID(add(approaches, content.points(Block::bidirectional), Direction::up));
  if (approaches.empty())
    return fail("found no averages, expected rows of position and error below 'Position  Bidirectional Avg Error'");
  AXIOMETRY_TRY(GatheredSeries gathered_series, gathered(approaches));
  Provenance provenance;
  provenance.remarks = encoding_remarks(decoded);
  provenance.remarks.push_back(
      {true, "found averages only, expected single approaches; R and A do not exist, and means stand for readings"});
  if (!directed)
    provenance.remarks.push_back(
        {true,
         "found averages of both directions together; they stand under ↑, the range of them is "
         "M, and B does not exist"});
  provenance.remarks.push_back(
      {false, "found errors in a format that leaves their sign open; they were taken as measured minus target"});
  return Test{Metadata{}, std::move(gathered_series.series), std::move(provenance)};
}

int recognise(std::string_view head) {
  return std::ranges::any_of(content_lines(head),
                             [](const TextLine& line) { return block_head(line.text).has_value(); })
             ? 96
             : 0;
}

constexpr std::string_view manual =
    R"(Averages of a positioning test, as software of API (Automated Precision) exports them (`.pos`).

```
Position       Bidirectional Avg Error
0.000    0.0005
100.000    0.0012
Position       Forward Directional Avg Error
0.000    0.0001
100.000    0.0007
Position       Reverse Directional Avg Error
0.000    0.0009
100.000    0.0017
```

- Positions and errors in mm. Forward averages stand under ↑, reverse ones under ↓, each as the only run.
- A file with bidirectional averages alone gives one curve under ↑: its range is M, and nothing is said about reversal.
- There are no single approaches, so R and A do not exist: this is no test after ISO 230-2, but it serves compensation.
- The sign is taken as found: deviation = measured minus target. It is not documented.
- Files of the same extension by Keysight hold something else and are not read.
- Refused: a block given twice, a position given twice, rows of other than two numbers.
)";

}  // namespace
}  // namespace api_pos

extern const Format api_pos_format;
const Format api_pos_format = {
    .id = "api-pos",
    .title = "API laser, averages",
    .extensions = ".pos",
    .manual = api_pos::manual,
    .recognise = api_pos::recognise,
    .read = api_pos::read,
};

}  // namespace axiometry::formats
