// SPDX-License-Identifier: Apache-2.0
//
// Arrays of NumPy (.npy, versions 1 to 3): the form for recordings of hundreds of millions of samples.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recording.h"

namespace axiometry::formats {
namespace npy {
namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr std::size_t longest_header = std::size_t{64} << 10;
constexpr std::size_t batch = 4096;

/// What the header says about the samples.
struct Shape {
  std::size_t rows = 0;
  bool position_first = false;
};

/// The text behind 'key': in the header, without blanks in front; empty when the key is missing.
std::string_view value_of(std::string_view header, std::string_view key) {
  for (char quote : {'\'', '"'}) {
    const std::string name = fmt::format("{}{}{}", quote, key, quote);
    const std::size_t at = header.find(name);
    if (at == header.npos) continue;
    const std::size_t colon = header.find(':', at + name.size());
    if (colon == header.npos) continue;
    return text::trim(header.substr(colon + 1));
  }
  return {};
}

Result<std::vector<std::size_t>> shape_of(std::string_view header) {
  const std::string_view value = value_of(header, "shape");
  const std::size_t end = value.find(')');
  if (!value.starts_with('(') || end == value.npos) return fail("found a NumPy header without a shape, expected one");
  std::vector<std::size_t> shape;
  for (std::string_view part : text::split(value.substr(1, end - 1), ',')) {
    part = text::trim(part);
    if (part.empty()) continue;  // "(5,)"
    const auto size = parse_count(part);
    if (!size) return fail(fmt::format("found {} in the shape, expected a number", text::quoted(part)));
    shape.push_back(static_cast<std::size_t>(*size));
  }
  return shape;
}

Result<Shape> structured(std::string_view descr, const std::vector<std::size_t>& shape) {
  std::string packed;
  for (char c : descr.substr(0, descr.find(']')))
    if (c != ' ') packed += c == '"' ? '\'' : c;
  std::vector<std::string_view> names;
  std::string_view rest = packed;
  for (std::size_t at = rest.find("('"); at != rest.npos; at = rest.find("('")) {
    rest.remove_prefix(at + 2);
    const std::size_t name_end = rest.find('\'');
    if (name_end == rest.npos) break;
    names.push_back(rest.substr(0, name_end));
    if (!rest.substr(name_end).starts_with("','<f8')"))
      return fail(fmt::format("found the record {}, expected fields of '<f8' only", text::quoted(packed)));
  }
  const bool position_first = names.size() == 2 && names[0] == "position" && names[1] == "time";
  if (!position_first && !(names.size() == 2 && names[0] == "time" && names[1] == "position"))
    return fail(fmt::format("found the record {}, expected the fields 'time' and 'position'", text::quoted(packed)));
  if (shape.size() != 1) return fail("found records in more than one dimension, expected a list of them");
  return Shape{shape[0], position_first};
}

Result<Shape> shape_from(std::string_view header) {
  AXIOMETRY_TRY(const std::vector<std::size_t> shape, shape_of(header));
  const std::string_view descr = value_of(header, "descr");
  if (descr.starts_with('[')) return structured(descr, shape);
  if (!descr.starts_with("'<f8'") && !descr.starts_with("\"<f8\""))
    return fail(fmt::format("found numbers of the type {}, expected '<f8' (float64, little-endian)",
                            text::quoted(descr.substr(0, descr.find(',')))));
  if (shape.size() != 2 || shape[1] != 2)
    return fail(
        fmt::format("found an array of the shape ({}), expected (N, 2): time in s, position", fmt::join(shape, ", ")));
  if (value_of(header, "fortran_order").starts_with("True"))
    return fail("found an array in Fortran order, expected C order: numpy.ascontiguousarray() makes it");
  return Shape{shape[0], false};
}

/// Header text and where the data begin; nothing while it is not complete.
struct Header {
  std::string_view text;
  std::size_t data_at = 0;
};

Result<std::optional<Header>> header_of(std::string_view bytes) {
  constexpr std::size_t version_at = 6, length_at = 8;
  if (!bytes.starts_with(magic.substr(0, bytes.size()))) return fail("found no NumPy array, expected one (.npy)");
  if (bytes.size() < length_at) return std::optional<Header>();
  const auto version = static_cast<unsigned char>(bytes[version_at]);
  if (version < 1 || version > 3) return fail(fmt::format("found version {} of .npy, expected 1 to 3", version));
  const std::size_t digits = version == 1 ? 2 : 4;
  if (bytes.size() < length_at + digits) return std::optional<Header>();
  std::size_t length = 0;
  for (std::size_t k = digits; k > 0; --k) length = length << 8 | static_cast<unsigned char>(bytes[length_at + k - 1]);
  if (length > longest_header) return fail(fmt::format("found a NumPy header of {} bytes, expected less", length));
  const std::size_t data_at = length_at + digits + length;
  if (bytes.size() < data_at) return std::optional<Header>();
  return std::optional(Header{bytes.substr(length_at + digits, length), data_at});
}

class NpyReader final : public RecordingReader {
 public:
  explicit NpyReader(bool rate_given) : rate_given_(rate_given) {}

  std::vector<std::string> remarks() const override {
    return rate_given_ ? std::vector{std::string(unused_rate)} : std::vector<std::string>{};
  }

  Result<void> feed(std::string_view bytes, const SampleSink& sink) override {
    if (!shape_) {
      begun_ += bytes;
      AXIOMETRY_TRY(const auto header, header_of(begun_));
      if (!header) return {};
      AXIOMETRY_TRY(shape_, shape_from(header->text));
      const std::string data = begun_.substr(header->data_at);
      begun_.clear();
      return feed_data(data, sink);
    }
    return feed_data(bytes, sink);
  }

  Result<void> finish(const SampleSink&) override {
    if (!shape_) return fail("found a NumPy array that ends in its header, expected samples");
    if (!interrupted_ && (rows_ != shape_->rows || !begun_.empty()))
      return fail(fmt::format("found {}, expected {} as the header says: the file is cut off", counted(rows_, "sample"),
                              shape_->rows));
    return {};
  }

  Result<void> interrupted(const SampleSink&) override {
    begun_.clear();
    interrupted_ = true;
    return {};
  }
  std::size_t unfinished() const override { return begun_.size(); }
  std::size_t lost() const override { return 0; }

 private:
  bool rate_given_ = false;
  Result<void> feed_data(std::string_view bytes, const SampleSink& sink) {
    if (!begun_.empty()) {
      const std::size_t missing = std::min(sizeof(Sample) - begun_.size(), bytes.size());
      begun_ += bytes.substr(0, missing);
      bytes.remove_prefix(missing);
      if (begun_.size() < sizeof(Sample)) return {};
      AXIOMETRY_TRY_VOID(hand_over(begun_, sink));
      begun_.clear();
    }
    while (bytes.size() >= sizeof(Sample)) {
      const std::size_t count = std::min(bytes.size() / sizeof(Sample), batch);
      AXIOMETRY_TRY_VOID(hand_over(bytes.substr(0, count * sizeof(Sample)), sink));
      bytes.remove_prefix(count * sizeof(Sample));
    }
    begun_ = bytes;
    return {};
  }

  Result<void> hand_over(std::string_view bytes, const SampleSink& sink) {
    samples_.resize(bytes.size() / sizeof(Sample));
    std::memcpy(samples_.data(), bytes.data(), bytes.size());
    if constexpr (std::endian::native == std::endian::big)
      for (Sample& s : samples_)
        for (double* x : {&s.time_s, &s.position})
          *x = std::bit_cast<double>(std::byteswap(std::bit_cast<std::uint64_t>(*x)));
    if (shape_->position_first)
      for (Sample& s : samples_) std::swap(s.time_s, s.position);
    const std::size_t room = shape_->rows - rows_;
    const std::size_t good = std::min(good_ones(), room);
    const Sample* const bad = samples_.data() + good;
    const double before = good > 0 ? samples_[good - 1].time_s : last_time_s_;
    rows_ += good;
    last_time_s_ = before;
    if (good > 0) AXIOMETRY_TRY_VOID(sink(std::span(samples_).first(good)));
    if (good == samples_.size()) return {};
    if (good == room)
      return fail(fmt::format("found more than the {} samples that the header says, expected no more", shape_->rows));
    if (!is_sound(*bad))
      return fail(
          fmt::format("found a number beyond 1e15, or none, in sample {}, expected time and position", rows_ + 1));
    return fail(
        fmt::format("found time running backwards from {} s to {} s in sample {}, expected samples in order of "
                    "time",
                    format_exact(before), format_exact(bad->time_s), rows_ + 1));
  }

  /// How many from the first one on are finite and in order of time: all at once, then, if not all, one by one.
  std::size_t good_ones() const {
    const auto is_good = [](double before, const Sample& s) {
      return (s.time_s >= before) & (std::abs(s.time_s) <= farthest_sample) & (std::abs(s.position) <= farthest_sample);
    };
    bool all = true;
    double before = last_time_s_;
    for (const Sample& s : samples_) {
      all &= is_good(before, s);
      before = s.time_s;
    }
    if (all) return samples_.size();
    std::size_t good = 0;
    for (before = last_time_s_; is_good(before, samples_[good]); ++good) before = samples_[good].time_s;
    return good;
  }

  std::optional<Shape> shape_;
  std::string begun_;  // the header, later a sample whose end has not come yet
  bool interrupted_ = false;
  std::size_t rows_ = 0;
  double last_time_s_ = -1e300;
  std::vector<Sample> samples_;
};

Result<std::unique_ptr<RecordingReader>> open(const RecordingOptions& options) {
  AXIOMETRY_TRY_VOID(check_times_and_positions(options));
  if (options.axis > 0) return fail(fmt::format("found axis {} of an array, expected 1: it has one", options.axis + 1));
  return std::make_unique<NpyReader>(options.rate_hz.has_value());
}

int recognise(std::string_view head) { return head.starts_with(magic) ? 100 : 0; }

constexpr std::string_view manual =
    R"(An array of NumPy in a file (`.npy`, versions 1 to 3): the fastest form, for recordings of hundreds of
millions of samples.

```python
numpy.save("run.npy", numpy.column_stack([time_s, position_mm]))
```

- `float64`, little-endian, of the shape (N, 2) in C order: time in s and position in mm (° on a rotary axis); or
  records with the fields `time` and `position`, both `float64`, in either order.
- Refused: other types and shapes, Fortran order, numbers that are none or beyond 1e15, time that runs backwards, a
  file whose length is not what its header says.
)";

}  // namespace
}  // namespace npy

extern const Recording npy_recording;
const Recording npy_recording = {
    .id = "npy",
    .title = "NumPy array of time and position",
    .extensions = ".npy",
    .manual = npy::manual,
    .recognise = npy::recognise,
    .open = npy::open,
};

}  // namespace axiometry::formats
