// SPDX-License-Identifier: Apache-2.0
//
// CSV with one reading per row, of one test or, with a column `test`, of any number of them.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_long_rows.h"
#include "axiometry/formats/csv/csv_preamble.h"
#include "axiometry/formats/csv/csv_values.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace csv_long {
namespace {

constexpr std::size_t block_size = std::size_t{256} << 10;  // stays in the second-level cache

Result<LongRows> rows_below(Preamble preamble, NamedTestSink sink) {
  if (preamble.columns.empty()) return fail("found no header, expected a line that names the columns");
  AXIOMETRY_TRY(const LongLayout layout, long_layout(preamble));
  return LongRows(std::move(preamble), layout, std::move(sink));
}

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  const std::string_view text = decoded.text;
  AXIOMETRY_TRY(Preamble preamble, read_preamble(text));
  const std::size_t header_end = preamble.size;
  std::optional<NamedTest> only;
  AXIOMETRY_TRY(LongRows rows, rows_below(std::move(preamble), [&](NamedTest&& test) -> Result<void> {
                  if (only)
                    return fail(fmt::format("found a second test {}, expected one test", text::quoted(test.name)),
                                {test.line, 1});
                  only = std::move(test);
                  return {};
                }));
  AXIOMETRY_TRY_VOID(rows.take(text.substr(header_end), text.data() + text.size()));
  AXIOMETRY_TRY_VOID(rows.finish());
  Test test{std::move(only->metadata), std::move(only->series), {}};
  test.provenance.remarks = encoding_remarks(decoded);
  std::ranges::move(only->remarks, std::back_inserter(test.provenance.remarks));
  test.provenance.remarks.insert(test.provenance.remarks.end(), rows.remarks().begin(), rows.remarks().end());
  return test;
}

/// A block of the file at a time; whole lines go on, the rest moves to the front.
class Blocks {
 public:
  explicit Blocks(ByteReader& reader) : reader_(reader), buffer_(std::make_unique<char[]>(block_size + slack)) {}

  /// Reads until the buffer is full or the file ends.
  Result<std::string_view> fill() {
    while (size_ < block_size && !ended_) {
      AXIOMETRY_TRY(const std::size_t count, reader_.read({buffer_.get() + size_, block_size - size_}));
      ended_ = count == 0;
      size_ += count;
    }
    return std::string_view(buffer_.get(), size_);
  }

  void drop(std::size_t count) {
    std::copy(buffer_.get() + count, buffer_.get() + size_, buffer_.get());
    size_ -= count;
  }

  bool ended() const { return ended_; }
  const char* readable_end() const { return buffer_.get() + block_size + slack; }

 private:
  static constexpr std::size_t slack = 256;  // bytes behind the text that may be looked at

  ByteReader& reader_;
  std::unique_ptr<char[]> buffer_;
  std::size_t size_ = 0;
  bool ended_ = false;
};

Result<LongRows> rows_after_header(Blocks& blocks, const NamedTestSink& sink) {
  AXIOMETRY_TRY(const std::string_view head, blocks.fill());
  AXIOMETRY_TRY(const std::string_view text, readable_text(head));
  AXIOMETRY_TRY(Preamble preamble, read_preamble(text));
  if (preamble.size == text.size() && !blocks.ended())
    return fail(
        fmt::format("found no header in the first {} KiB, expected a line that names the columns", block_size >> 10));
  blocks.drop(static_cast<std::size_t>(text.data() - head.data()) + preamble.size);
  return rows_below(std::move(preamble), sink);
}

Result<void> read_many(ByteReader& bytes, const NamedTestSink& sink) {
  Blocks blocks(bytes);
  AXIOMETRY_TRY(LongRows rows, rows_after_header(blocks, sink));
  while (true) {
    AXIOMETRY_TRY(const std::string_view text, blocks.fill());
    if (text.empty()) return rows.finish();
    const std::size_t last_break = text.rfind('\n');
    const bool whole = last_break != std::string_view::npos;
    if (!whole && !blocks.ended())
      return fail(fmt::format("found a line of more than {} KiB, expected shorter ones", block_size >> 10));
    const std::size_t size = whole ? last_break + 1 : text.size();
    AXIOMETRY_TRY_VOID(rows.take(text.substr(0, size), blocks.readable_end()));
    blocks.drop(size);
  }
}

/// Run by run, up along the targets and down back again: the order of the standard test cycle.
std::string write(const Test& test) {
  const Series& series = test.series;
  std::string text = metadata_lines(test);
  text += fmt::format("{}\n", long_table_head(test.metadata.axis.kind));
  for (std::size_t j = 0; j < series.run_count(); ++j)
    for (const Direction direction : {Direction::up, Direction::down}) {
      if (!series.has(direction)) continue;
      for (std::size_t k = 0; k < series.target_count(); ++k) {
        const std::size_t i = direction == Direction::up ? k : series.target_count() - 1 - k;
        const auto reading = series.reading(i, direction, j);
        text += fmt::format("{},{},{},{}\n", format_exact(series.targets()[i].in_native()),
                            direction == Direction::up ? "up" : "down", j + 1,
                            reading ? format_exact(reading->in_native()) : "");
      }
    }
  return text;
}

struct Found {
  bool test = false;
  bool target = false;
  bool direction = false;
  bool run = false;
  bool reading = false;
};

Found roles_in(std::string_view head) {
  Found found;
  for (const Column& c : header_columns(head)) {
    found.test |= c.role == ColumnRole::test;
    found.target |= c.role == ColumnRole::target;
    found.direction |= c.role == ColumnRole::direction;
    found.run |= c.role == ColumnRole::run;
    found.reading |= c.role == ColumnRole::reading && !c.run && !c.direction;
  }
  return found;
}

int recognise(std::string_view head) {
  const Found found = roles_in(head);
  if (found.target && found.direction && found.reading) return found.run ? 90 : 80;
  // Enough of it for a message about the rest, unless the generic importer can do without that.
  const int roles = found.target + found.direction + found.run + found.reading;
  if (roles >= 2) return 4 + roles;
  return has_faulty_header(head) ? 5 : 0;
}

bool holds_many(std::string_view head) {
  const auto text = readable_text(head);
  return text && roles_in(*text).test;
}

constexpr std::string_view manual = R"(Delimited text, one reading per row; columns in any order.

```
# machine: Mill 5
# axis: X
target_mm,direction,run,deviation_um
0,up,1,0.1
250,up,1,0.4
250,down,1,1.1
0,down,1,0.9
```

| column | meaning |
|---|---|
| `target_mm` | target position; also `target`, `nominal`, `position` |
| `direction` | direction of approach: up, down, ↑, ↓, +, -, forward, backward, reverse, positive, negative |
| `run` | number of the run from 1; also `cycle`; without it approaches count themselves, in the order of the rows |
| `deviation_um` | deviation, actual minus target; also `error` |
| `measured_mm` | instead of it the measured position; also `actual`, `position` |
| `test` | optional: name of the test, for files that hold many; the rows of one test stand together |

- Units stand in the names, as `target_mm`, `deviation (µm)`, `error [arcsec]`, or in a line such as `# unit: um`,
  `# target unit: mm`: um, mm, nm, m, in, uin; arcsec, deg, mdeg, rad, mrad, urad. Angles make a rotary axis.
- Delimiter: comma, semicolon or tab. Decimal point, or decimal comma with semicolons or tabs; one of them in a file.
- Text is UTF-8. Files of one test may be UTF-16, Windows-1252, Latin-1 or GBK too, which a remark then tells.
- Fields may be quoted (RFC 4180). A byte order mark, CRLF, blank rows and comments (`# …`) do no harm.
- Instruments may print lines of their own above the header: `Machine;Mill 5` is understood, the unknown passed over
  and told. So is a comment of few words, `# air temperature: 68 F`, of which nothing is kept.
  A header may stand behind a `#`. German names are understood too: Sollposition, Richtung, Lauf, Abweichung.
- A missing reading is an empty field, `-`, `--`, `NA`, `n/a`, `#N/A` or `null`.
- Between semicolons and tabs, `1.000` beside `500` is refused: its mark may part thousands. As many decimals in all
  numbers, or none of these marks, make it plain.
- A unit stated for all is that of columns without one; two different ones are refused.
- Lines `# key: value` above the header are metadata. Keys are those of the metadata table, such as `machine.name`;
  `machine`, `axis`, `date`, `inspector`, `serial number`, `feed` and the like are understood. A text that a line
  cannot hold as it is stands in quotation marks as in JSON: `# machine.name: "two\nlines"`.
- `# source_remark:` holds what was told when the readings were first read out of another file, such as guesses.
- Columns named time, timestamp, date, comment, note, remark, temperature, pressure, humidity, operator, sequence, no,
  index, point, row or line are passed over and named, and so is what is computed from readings (mean, std, min, max,
  range, sum). Any other column is refused, also one of these that may hold readings too: `time corrected error`,
  `index [um]`.
- A measured position beside a deviation is compared with it: deviations of the other sign are refused, others that
  differ are a finding. So are labels ↑ and ↓ that run the other way than the targets of a single test.
- Targets within 0.5 nm (or 5e-7°) of one another are one target: computed positions carry float noise.
- Refused: NaN and infinite numbers, ragged rows, a reading given twice, mixed units, fewer than two targets, runs
  beyond 10 000, files of many tests that are not UTF-8, a measured position more than half a turn from its target,
  deviations as large as the target positions (they are measured positions under a wrong name).
)";

}  // namespace
}  // namespace csv_long

extern const Format csv_long_format;
const Format csv_long_format = {
    .id = "csv-long",
    .title = "CSV, one reading per row",
    .extensions = ".csv .txt .tsv",
    .manual = csv_long::manual,
    .recognise = csv_long::recognise,
    .read = csv_long::read,
    .holds_many = csv_long::holds_many,
    .read_many = csv_long::read_many,
    .write = csv_long::write,
};

}  // namespace axiometry::formats
