// SPDX-License-Identifier: Apache-2.0
//
// The serial stream of the µMD0, µMD1 and µMD2 interferometer counters: 8 or 16 whole numbers a line.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recordings/line_reader.h"

namespace axiometry::formats {
namespace umd {
namespace {

constexpr std::size_t narrow = 8, wide = 16;                // columns of one axis and of three
constexpr std::array<std::size_t, 3> disp_at = {2, 9, 13};  // DISP of each axis; PHASE stands two behind it
constexpr std::size_t seq_at = 5, code_at = 6, data_at = 7;
constexpr std::int64_t first_error_code = 0x200;  // of PHASE; a fraction lies within ±256
constexpr double fractions_per_count = 256.0;
constexpr std::int64_t largest = std::int64_t{1} << 53;      // whole numbers up to here are doubles without rounding
constexpr std::int64_t longest_gap = std::int64_t{1} << 40;  // samples lost in one piece: months at any rate
constexpr std::size_t patience = 4096;                       // samples within which the stream must tell its rate

/// The columns of one line; `count` is 0 when it is not a line of whole numbers.
struct Columns {
  std::array<std::int64_t, wide> values{};
  std::size_t count = 0;
};

Columns columns_of(std::string_view line) {
  Columns columns;
  const char* p = line.data();
  const char* const end = p + line.size();
  const auto skip_blanks = [&] {
    while (p != end && (*p == ' ' || *p == '\t')) ++p;
  };
  for (skip_blanks(); p != end; skip_blanks()) {
    if (columns.count == wide) return {};
    const auto [rest, fault] = std::from_chars(p, end, columns.values[columns.count]);
    if (fault != std::errc() || (rest != end && *rest != ' ' && *rest != '\t')) return {};
    if (const auto value = columns.values[columns.count]; value < -largest || value > largest) return {};
    ++columns.count;
    p = rest;
  }
  if (columns.count != narrow && columns.count != wide) columns.count = 0;
  return columns;
}

/// First and last value of something that the stream tells now and then.
template <typename Quantity>
void note(std::optional<Quantity>& first, std::optional<Quantity>& last, Quantity value) {
  if (!first) first = value;
  last = value;
}

class UmdReader final : public LineReader {
 public:
  explicit UmdReader(const RecordingOptions& options)
      : LineReader(options, StampJudge::Kind::counts), rate_hz_(options.rate_hz) {}

  Environment environment() const override { return environment_; }

 private:
  struct Waiting {
    std::int64_t seq;
    double position;
    double arrival_s;
  };

  Result<void> take(std::string_view line) override {
    const Columns columns = columns_of(line);
    if (columns.count == 0 && (width_ == 0 || text::trim(line).empty())) return {};  // start-up text
    if (columns.count == 0)
      return fail(
          fmt::format("found {}, expected {} whole numbers as in the lines before", text::quoted(line), width_));
    if (width_ == 0) AXIOMETRY_TRY_VOID(settle_width(columns.count));
    if (columns.count != width_)
      return fail(
          fmt::format("found {}, expected {} as in the lines before", counted(columns.count, "number"), width_));
    const std::int64_t seq = columns.values[seq_at];
    AXIOMETRY_TRY(const std::int64_t count, counted_on(seq));
    AXIOMETRY_TRY_VOID(take_code(columns.values[code_at], static_cast<double>(columns.values[data_at])));
    const auto displacement = columns.values[disp_at[options().axis]];
    const auto phase = columns.values[disp_at[options().axis] + 2];
    const double counts = static_cast<double>(displacement) + static_cast<double>(phase) / fractions_per_count;
    const double position = std::abs(phase) >= first_error_code ? std::numeric_limits<double>::quiet_NaN()
                                                                : counts * *options().units_per_count;
    const StampedLine line_of_count{static_cast<double>(count), position, arrival_s(), line_number(),
                                    static_cast<double>(seq)};
    return options().skip_damaged ? judge(line_of_count) : settle(line_of_count);
  }

  /// Its position is NaN where the counter told an error.
  Result<void> settle(const StampedLine& line) override {
    const auto count = static_cast<std::int64_t>(line.stamp);
    if (last_count_) {
      const auto missing = static_cast<std::size_t>(count - *last_count_ - 1);
      const std::size_t rejected_among = std::min(missing, rejected() - rejected_counted_);  // are told as such
      rejected_counted_ += rejected_among;
      add_lost(missing - rejected_among);
    }
    last_count_ = count;
    last_seq_ = static_cast<std::int64_t>(line.told);
    if (!std::isnan(line.position)) return place({count, line.position, line.arrival_s});
    add_lost(1);
    return {};
  }

  Result<void> settle_width(std::size_t count) {
    if (options().axis > 0 && count == narrow)
      return fail(
          fmt::format("found a stream of one axis, expected one of three to take axis {} from", options().axis + 1));
    width_ = count;
    return {};
  }

  /// SEQ counts samples; a jump of it is lost data. A µMD0 counts with 16 bits, with or without a sign. The number of
  /// the sample since the first one, from the last one that was settled on; where lines are judged it need not grow.
  Result<std::int64_t> counted_on(std::int64_t seq) {
    const StampedLine* const judged = judged_before();
    if (!last_seq_ && judged == nullptr) return 0;
    const std::int64_t before = last_seq_ ? *last_seq_ : static_cast<std::int64_t>(judged->told);
    std::int64_t step = seq - before;
    constexpr std::int64_t turn = 0x10000, most = 0x8000;
    if (step <= 0 && std::abs(seq) < turn && std::abs(before) < turn && step + turn <= most) step += turn;
    if (step <= 0 && !options().skip_damaged) {
      // After a break the instrument may have begun again; how long it was away is not known.
      if (!interrupted_)
        return fail(fmt::format("found the sample counter {} after {}, expected it to grow", seq, before));
      step = 1;
    }
    if (step > longest_gap)
      return fail(fmt::format("found the sample counter {} after {}, expected it to grow by less", seq, before));
    interrupted_ = false;
    return (last_count_ ? *last_count_ : 0) + step;
  }

  Result<void> take_code(std::int64_t code, double data) {
    Environment& e = environment_;
    switch (code) {
      case 3: note(e.air_temperature_start, e.air_temperature_end, Temperature::celsius(data / 100)); break;
      case 5: note(e.air_pressure_start, e.air_pressure_end, Pressure::kPa(data / 1000)); break;
      case 6: note(e.air_humidity_start, e.air_humidity_end, RelativeHumidity::percent(data / 10)); break;
      case 8: return take_rate(data / 100);
      default: break;
    }
    return {};
  }

  Result<void> take_rate(double rate_hz) {
    if (options().rate_hz || by_arrival_) return {};
    if (!(rate_hz > 0.0)) return fail(fmt::format("found a sample rate of {} Hz, expected one above 0", rate_hz));
    if (rate_hz_ && std::abs(rate_hz - *rate_hz_) > 0.01 * *rate_hz_)
      return fail(fmt::format("found a sample rate of {} Hz after {} Hz, expected one for the whole recording", rate_hz,
                              *rate_hz_));
    if (!rate_hz_) rate_hz_ = rate_hz;
    return release();
  }

  Result<void> place(const Waiting& sample) {
    if (by_arrival_ && std::isnan(sample.arrival_s)) add_lost(1);
    if (by_arrival_) return std::isnan(sample.arrival_s) ? Result<void>{} : put({sample.arrival_s, sample.position});
    if (rate_hz_) return put({static_cast<double>(sample.seq) / *rate_hz_, sample.position});
    waiting_.push_back(sample);
    if (waiting_.size() < patience) return {};
    return without_rate();
  }

  Result<void> without_rate() {
    if (!options().arrival_s)
      return fail(fmt::format("found no sample rate (code 8) in {}, expected one, or a rate that is stated",
                              counted(waiting_.size(), "sample")));
    by_arrival_ = true;
    return release();
  }

  Result<void> release() {
    for (const Waiting& sample : std::exchange(waiting_, {})) AXIOMETRY_TRY_VOID(place(sample));
    return {};
  }

  Result<void> end() override {
    if (width_ == 0) return fail("found no line of 8 or 16 whole numbers, expected a µMD stream");
    return waiting_.empty() ? Result<void>{} : without_rate();
  }

  void gap() override { interrupted_ = true; }

  /// What waits is placed as at the end: a rate that is told later must not move what was measured before.
  Result<void> cut_off() override {
    const auto arrived = [](const Waiting& sample) { return !std::isnan(sample.arrival_s); };
    return std::ranges::any_of(waiting_, arrived) ? without_rate() : Result<void>{};
  }

  std::optional<double> rate_hz_;
  std::size_t width_ = 0;
  bool interrupted_ = false;
  bool by_arrival_ = false;
  std::optional<std::int64_t> last_count_;  // samples since the first, lost ones included
  std::optional<std::int64_t> last_seq_;
  std::size_t rejected_counted_ = 0;
  std::vector<Waiting> waiting_;  // what waits until the rate is known
  Environment environment_;
};

Result<std::unique_ptr<RecordingReader>> open(const RecordingOptions& options) {
  if (!options.units_per_count)
    return fail(
        "found no length of a count, expected it, or the wavelength and the counts per wavelength, for a stream of "
        "counts");
  if (!(std::isfinite(*options.units_per_count) && *options.units_per_count != 0.0))
    return fail(fmt::format("found {} per count, expected a number other than 0", *options.units_per_count));
  if (options.rate_hz && !(std::isfinite(*options.rate_hz) && *options.rate_hz > 0.0))
    return fail(fmt::format("found a rate of {} Hz, expected one above 0", *options.rate_hz));
  if (options.axis >= disp_at.size())
    return fail(fmt::format("found axis {} of the stream, expected 1 to {}", options.axis + 1, disp_at.size()));
  return std::make_unique<UmdReader>(options);
}

/// Lines of 8 or 16 numbers whose SEQ grows. The last line of the head may be cut off.
int recognise(std::string_view head) {
  std::size_t fitting = 0, others_behind = 0;
  std::optional<std::int64_t> last_seq;
  while (true) {
    const std::size_t end = head.find('\n');
    if (end == head.npos) break;
    std::string_view line = head.substr(0, end);
    head.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const Columns columns = columns_of(line);
    if (columns.count == 0) {
      others_behind += fitting > 0;
      continue;
    }
    if (last_seq && columns.values[seq_at] <= *last_seq) ++others_behind;
    last_seq = columns.values[seq_at];
    ++fitting;
  }
  if (fitting < 2 || others_behind * 10 > fitting) return fitting == 1 && others_behind == 0 ? 40 : 0;
  return 95;
}

constexpr std::string_view manual =
    R"(The serial stream of the µMD0, µMD1 and µMD2 counters of interferometers: text, one line per sample, whole
numbers separated by blanks.

```
Minimalist Homodyne Test:
0 0 12 0 0 1 10 105
0 0 12 0 -3 2 8 24414
0 0 15 3 17 3 20 1025
```

- Columns: `REF MEAS1 DISP1 VEL1 PHASE1 SEQ CODE DATA`, for three axes followed by `MEAS2 DISP2 VEL2 PHASE2 MEAS3
  DISP3 VEL3 PHASE3`; `--stream-axis` says which one is read.
- The position is `DISP + PHASE/256` counts. `--units-per-count` gives mm (or °) per count; for an interferometer
  `--wavelength` in nm, in the air of the test, and `--counts-per-wavelength` (2, 4 or 8, after the optics). Neither is
  in the stream.
- Time is `SEQ` divided by the sample rate: that of `--rate`, else of the stream itself (code 8, in Hz × 100), else each
  line counts at the moment it arrives. So do all lines of a recording whose connection broke off before the rate came.
  A jump of `SEQ` is counted as lost samples; a counter of 16 bits may turn over.
- A `PHASE` of 0x200 and more is an error code of the counter: such a sample is counted as lost, never used.
- Codes 3, 5 and 6 (temperature in °C × 100, pressure in mbar × 100, humidity in % × 10) become first and last
  values of the air in the test. The scales are those of the firmware's source; check them against your instrument.
- Lines before the first sample are passed over (start-up text). Refused: other lines behind it, numbers beyond
  2^53, a counter that runs backwards or jumps by 2^40, a change of the rate. Of a live stream and with `--skip-damaged`
  such lines are counted and left out, also one whose counter ran ahead; a counter that begins anew is taken on after
  five lines in order.
)";

}  // namespace
}  // namespace umd

extern const Recording umd_recording;
const Recording umd_recording = {
    .id = "umd",
    .title = "µMD0/1/2 serial stream",
    .extensions = ".txt .log .raw",
    .manual = umd::manual,
    .recognise = umd::recognise,
    .open = umd::open,
};

}  // namespace axiometry::formats
