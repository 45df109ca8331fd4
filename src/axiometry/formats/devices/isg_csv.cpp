// SPDX-License-Identifier: Apache-2.0
//
// Tables of volumetric errors of ISG kernels (also Beckhoff's): their positioning errors.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/devices/error_curves.h"
#include "axiometry/formats/text/text_lines.h"

namespace axiometry::formats {
namespace isg_csv {
namespace {

std::string blank_separated(std::string_view content) {
  std::string spaced(content);
  std::ranges::replace_if(
      spaced, [](char c) { return c == ';' || c == ','; }, ' ');
  return spaced;
}

bool is_argument(std::string_view name) {
  return name.size() == 1 && std::string_view("XYZABCUVW").contains(name.front());
}

/// "EXX", "A0B": an error of a machine after ISO 230-1. Words of three such letters are none.
bool is_error(std::string_view name) {
  const auto is_axis = [](char c) { return std::string_view("XYZABCUVW").contains(c); };
  if (name.size() != 3 || !is_axis(name[2])) return false;
  return (name[0] == 'E' && is_axis(name[1])) || (is_axis(name[0]) && name[1] == '0');
}

/// A line of names alone.
bool is_header(const std::vector<std::string_view>& words) {
  return !words.empty() &&
         std::ranges::all_of(words, [](std::string_view w) { return is_argument(w) || is_error(w); }) &&
         std::ranges::any_of(words, is_error);
}

/// One positioning error of a header: its column, that of its own axis, and those of other arguments.
struct CurveColumns {
  std::string name;
  std::size_t error = 0;
  std::size_t position = 0;
  std::vector<std::size_t> others{};
};

Result<std::vector<CurveColumns>> curves_in(const std::vector<std::string_view>& header, std::size_t line) {
  std::vector<CurveColumns> curves;
  for (std::size_t c = 0; c < header.size(); ++c) {
    const std::string axis = axis_of_error(header[c]);
    if (axis.empty()) continue;
    CurveColumns curve{.name = std::string(header[c]), .error = c};
    bool has_position = false;
    for (std::size_t k = 0; k < header.size(); ++k) {
      if (!is_argument(header[k])) continue;
      if (header[k] == axis) {
        curve.position = k;
        has_position = true;
      } else {
        curve.others.push_back(k);
      }
    }
    if (!has_position)
      return fail(fmt::format("found {} without a column {}, expected its positions", header[c], axis), {line, 1});
    curves.push_back(std::move(curve));
  }
  return curves;
}

class CurveReader {
 public:
  Result<std::vector<ErrorCurve>> read(std::string_view text) {
    for (const TextLine& line : content_lines(text)) {
      const std::string_view content = without_comment(line.text);
      if (content.empty()) continue;
      if (content.starts_with('#')) {
        header_.clear();
        continue;
      }
      const std::string spaced = blank_separated(content);
      AXIOMETRY_TRY_VOID(header_.empty() ? take_header(spaced, line) : take_row(spaced, line));
    }
    return std::move(curves_);
  }

 private:
  Result<void> take_header(const std::string& content, const TextLine& line) {
    const auto words = text::words(content);
    if (!is_header(words))
      return fail(
          fmt::format("found {}, expected a header of arguments and errors such as X EXX EYX", text::quoted(content)),
          {line.number, line.column});
    std::set<std::string_view> columns;
    for (const std::string_view word : words)
      if (!columns.insert(word).second)
        return fail(fmt::format("found {} twice in the header, expected each column once", text::quoted(word)),
                    {line.number, line.column});
    header_.assign(words.begin(), words.end());
    header_line_ = line.number;
    AXIOMETRY_TRY(columns_, curves_in(words, line.number));
    return {};
  }

  Result<void> take_row(const std::string& content, const TextLine& line) {
    const auto words = text::words(content);
    if (words.size() != header_.size())
      return fail(fmt::format("found {}, expected {} as in the header on line {}", counted(words.size(), "number"),
                              header_.size(), header_line_),
                  {line.number, line.column});
    std::vector<double> row;
    for (std::string_view word : words) {
      const auto value = parse_number(word);
      if (!value)
        return fail(fmt::format("found {}, expected a finite number", text::quoted(word)),
                    {line.number, line.column + static_cast<std::size_t>(word.data() - content.data())});
      row.push_back(*value);
    }
    for (const CurveColumns& columns : columns_) {
      std::string name = columns.name;
      for (std::size_t c : columns.others) name += fmt::format(" {}={}", header_[c], format_exact(row[c]));
      const auto [number, inserted] = numbers_.try_emplace(name, curves_.size());
      if (inserted) curves_.push_back({name, axis_of_error(columns.name), line.number, {}});
      curves_[number->second].points.push_back({row[columns.position], row[columns.error], {line.number, line.column}});
    }
    return {};
  }

  std::vector<ErrorCurve> curves_;
  std::map<std::string, std::size_t> numbers_;  ///< numbers of the curves, by name
  std::vector<std::string> header_;
  std::size_t header_line_ = 0;
  std::vector<CurveColumns> columns_;
};

Result<std::vector<ErrorCurve>> curves_of(std::string_view text) { return CurveReader().read(text); }

Result<Test> read(std::string_view bytes) { return read_curve(bytes, curves_of); }

Result<void> read_many(ByteReader& bytes, const NamedTestSink& sink) { return read_curves(bytes, sink, curves_of); }

struct Found {
  std::size_t headers = 0;
  std::size_t positioning_errors = 0;
  bool other_arguments = false;  ///< beside that of a positioning error: one curve for each of their values
};

Found found_in(std::string_view head) {
  Found found;
  for (const TextLine& line : content_lines(head)) {
    const std::string content = blank_separated(without_comment(line.text));
    const auto words = text::words(content);
    if (!is_header(words)) continue;
    ++found.headers;
    const auto errors =
        std::ranges::count_if(words, [](std::string_view w) { return is_error(w) && !axis_of_error(w).empty(); });
    found.positioning_errors += static_cast<std::size_t>(errors);
    if (errors > 0) found.other_arguments |= std::ranges::count_if(words, is_argument) > 1;
  }
  return found;
}

bool holds_many(std::string_view head) {
  const Found found = found_in(head);
  return found.positioning_errors > 1 || found.other_arguments;
}

int recognise(std::string_view head) {
  for (const TextLine& line : content_lines(head)) {
    const std::string_view content = without_comment(line.text);
    if (content.empty() || content.starts_with('#')) continue;
    const Found found = found_in(content);
    return found.headers > 0 ? (found_in(head).positioning_errors > 0 ? 96 : 60) : 0;
  }
  return 0;
}

constexpr std::string_view manual =
    R"(The table of volumetric errors of ISG kernels ("ISG CSV"), which Beckhoff's control reads too.

```
// Errors of the X axis
X      EXX     EYX     EZX
0.0    0.0001  0.0000  0.0002
50.0  -0.0003  0.0001  0.0001
100.0  0.0002  0.0003  0.0000
```

- A header names arguments (X, Y, Z) and errors; rows of numbers follow, separated by blanks, commas or semicolons. `//`
  begins a comment, `#` ends a table; another header may follow.
- Read are the positioning errors EXX, EYY and EZZ over their own axis, in mm. Each is a test of its own. With further
  arguments there is one test for each of their values, named like `EXX Z=100`.
- The errors stand under ↑ as the only run, with the sign as found. They are computed values, no measured approaches, so
  the tests are no tests after ISO 230-2.
- Refused: rows with other than the header's number of columns, a position given twice, an error without its axis.
)";

}  // namespace
}  // namespace isg_csv

extern const Format isg_csv_format;
const Format isg_csv_format = {
    .id = "isg-csv",
    .title = "ISG table of volumetric errors, positioning errors",
    .extensions = ".csv .txt",
    .manual = isg_csv::manual,
    .recognise = isg_csv::recognise,
    .read = isg_csv::read,
    .holds_many = isg_csv::holds_many,
    .read_many = isg_csv::read_many,
};

}  // namespace axiometry::formats
