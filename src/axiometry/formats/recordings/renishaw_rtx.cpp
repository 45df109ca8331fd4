// SPDX-License-Identifier: Apache-2.0
//
// Renishaw .rtx: a dynamic recording, a header of text and numbers of eight bytes.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recording.h"
#include "axiometry/formats/recordings/rtx_header.h"

namespace axiometry::formats {
namespace renishaw_rtx {
namespace {

constexpr std::size_t rtx_number = sizeof(double);
constexpr std::size_t rtx_batch = 4096;
constexpr std::size_t longest_rtx_end = 64;  // bytes: "\r\nEOF::\r\n" and blanks
constexpr double deg_per_mrad = 180.0 / std::numbers::pi / 1000.0;

class RtxReader final : public RecordingReader {
 public:
  explicit RtxReader(const RecordingOptions& options)
      : scale_(options.kind == AxisKind::rotary ? deg_per_mrad : 1.0), kind_(options.kind) {}

  Result<void> feed(std::string_view bytes, const SampleSink& sink) override {
    begun_ += bytes;
    if (header_) return take_numbers(sink);
    if (begun_.size() < next_look_) return {};
    next_look_ = 2 * begun_.size();  // pieces of a byte must not cost the header anew for each
    return begin(sink);
  }

  Result<void> finish(const SampleSink& sink) override {
    if (!header_ && !begun_.empty()) AXIOMETRY_TRY_VOID(begin(sink));
    if (!header_) return fail("found an .rtx recording that ends in its header, expected samples");
    if (interrupted_) return {};
    if (end_mark_taken_for_number()) return cut_off(taken_ - 1);
    if (taken_ < header_->samples) return cut_off(taken_);
    const std::string_view rest = text::trim(begun_);
    if (rest.empty() || text::equal_ignoring_case(rest, "EOF::")) return {};
    return fail(fmt::format("found more behind the {} that the header says, expected EOF::",
                            counted(header_->samples, "sample")));
  }

  Result<void> interrupted(const SampleSink&) override {
    begun_.clear();
    interrupted_ = true;
    return {};
  }

  std::size_t unfinished() const override { return begun_.size(); }
  std::size_t lost() const override { return 0; }
  std::vector<std::string> remarks() const override {
    std::vector<std::string> remarks = header_ ? rtx_remarks(*header_) : std::vector<std::string>{};
    if (header_ && kind_ == AxisKind::rotary) remarks.push_back("the numbers of the file were taken as angles in mrad");
    return remarks;
  }

 private:
  Result<void> begin(const SampleSink& sink) {
    AXIOMETRY_TRY(header_, rtx_header(begun_));
    if (!header_) return {};
    AXIOMETRY_TRY_VOID(of_this_kind());
    begun_.erase(0, header_->data_at);
    return take_numbers(sink);
  }

  /// A file that calls itself angular would give lengths that are none.
  Result<void> of_this_kind() const {
    if (rtx_kind(*header_).value_or(kind_) == kind_) return {};
    const std::string type = text::quoted(header_->file_type);
    if (kind_ == AxisKind::linear)
      return fail(
          fmt::format("found an .rtx recording of the file type {}, whose numbers are angles in mrad, expected "
                      "one of a linear axis",
                      type));
    return fail(
        fmt::format("found an .rtx recording of the file type {}, whose numbers are in mm, expected one of a "
                    "rotary axis",
                    type));
  }

  Result<void> cut_off(std::uint64_t samples) const {
    return fail(fmt::format("found {}, expected {} as the header says: the file is cut off", counted(samples, "sample"),
                            header_->samples));
  }

  /// The end mark with its line ends is as long as a number: where a number is missing it was taken for the last.
  bool end_mark_taken_for_number() const {
    return taken_ > 0 && text::equal_ignoring_case(text::trim(last_number_ + begun_), "EOF::");
  }

  Result<void> take_numbers(const SampleSink& sink) {
    std::size_t at = 0;
    while (taken_ < header_->samples && begun_.size() - at >= rtx_number) {
      const std::uint64_t room = std::min<std::uint64_t>(header_->samples - taken_, rtx_batch);
      const auto count = std::min<std::size_t>(room, (begun_.size() - at) / rtx_number);
      AXIOMETRY_TRY_VOID(hand_over(std::string_view(begun_).substr(at, count * rtx_number), sink));
      at += count * rtx_number;
    }
    begun_.erase(0, at);
    if (taken_ < header_->samples || begun_.size() <= longest_rtx_end) return {};
    return fail(fmt::format("found more behind the {} that the header says, expected EOF::",
                            counted(header_->samples, "sample")));
  }

  Result<void> hand_over(std::string_view bytes, const SampleSink& sink) {
    std::vector<Sample> samples;
    Result<void> done;
    for (std::size_t k = 0; done && k < bytes.size(); k += rtx_number) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, bytes.data() + k, rtx_number);
      if constexpr (std::endian::native == std::endian::big) bits = std::byteswap(bits);
      const Sample sample{static_cast<double>(taken_) / header_->rate_hz, std::bit_cast<double>(bits) * scale_};
      if (is_sound(sample)) {
        samples.push_back(sample);
        ++taken_;
      } else {
        done = fail(
            fmt::format("found a number beyond 1e15, or none, in sample {}, expected time and position", taken_ + 1));
      }
    }
    last_number_ = bytes.substr(bytes.size() - rtx_number);
    if (!samples.empty()) AXIOMETRY_TRY_VOID(sink(samples));
    return done;
  }

  double scale_;
  AxisKind kind_;
  std::optional<RtxHeader> header_;
  std::string begun_;        // the header, later less than a number, or what follows the last one
  std::string last_number_;  // bytes of the number read last
  std::size_t next_look_ = 1;
  bool interrupted_ = false;
  std::uint64_t taken_ = 0;
};

Result<std::unique_ptr<RecordingReader>> open(const RecordingOptions& options) {
  if (options.units_per_count)
    return fail("found a length per count for an .rtx recording, expected none: it holds positions");
  if (options.rate_hz) return fail("found a rate for an .rtx recording, expected none: it states its own");
  if (options.axis > 0) return fail(fmt::format("found axis {} of an .rtx recording, expected 1", options.axis + 1));
  return std::make_unique<RtxReader>(options);
}

int recognise(std::string_view head) {
  constexpr std::string_view title = "HEADER::";
  if (!text::equal_ignoring_case(head.substr(0, title.size()), title)) return 0;
  const auto header = rtx_header(head);
  if (header) return *header ? 100 : head.find("Sample no") != head.npos ? 60 : 0;
  return head.find("Sample no") != head.npos ? 90 : 0;  // the reader says what is wrong with it
}

constexpr std::string_view manual =
    R"(A dynamic recording of a Renishaw laser (`.rtx`, as CARTO and older programs export it). Known from programs that
read it, not from its maker.

```
HEADER::
Owner: CARTO-Dynamic
Sample rate: 50000
Sample no: 1000001
Trigger interval: 2e-05
Actual sample rate: 50000
Data:
(1000001 numbers of eight bytes)
EOF::
```

- Lines of `Key: value` in any order up to `Data:`; then as many numbers as `Sample no` says, each a float64,
  little-endian, in mm; for a rotary axis in mrad. Sample i was taken at i / `Actual sample rate`, or `Sample rate`
  where that is not stated.
- A `File Type` that says angular or linear is held against the axis, which `dynamic --rotary` or the plan tells: the
  other one is refused.
- Machine, axis, location and date are told as remarks; of a date such as 10/02/2025 it is not known whether the day
  or the month stands first.
- A trigger interval that is not one over the rate is told: the samples may have been triggered by position.
- Refused: fewer or more numbers than the header says, numbers that are none or beyond 1e15, a header without a
  number of samples or a rate, or of more than 64 KiB.
- `axiometry dynamic` tells velocity, acceleration, vibrations and how evenly the axis moved; with stops in it
  `axiometry evaluate --plan` takes the readings out of it.
)";

}  // namespace
}  // namespace renishaw_rtx

extern const Recording renishaw_rtx_recording;
const Recording renishaw_rtx_recording = {
    .id = "renishaw-rtx",
    .title = "Renishaw laser, dynamic",
    .extensions = ".rtx",
    .manual = renishaw_rtx::manual,
    .recognise = renishaw_rtx::recognise,
    .open = renishaw_rtx::open,
};

}  // namespace axiometry::formats
