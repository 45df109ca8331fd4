// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/recording.h"

/// Continuous recordings: what instruments send line by line. One .cpp in recordings/ per layout, each with one `const
/// Recording <stem>_recording = {…}`; the build collects them (docs/howto/add-a-format.md).
namespace axiometry::formats {

struct Unit;

/// What the samples of a channel are taken for.
enum class ChannelMeaning {
  position,  ///< position of the axis, mm or °
  value,     ///< readings in the unit that the stream names, as they stand there
  number     ///< number without a unit: a trigger
};

/// What the user must say because the stream does not.
struct RecordingOptions {
  AxisKind kind = AxisKind::linear;
  ChannelMeaning meaning = ChannelMeaning::position;
  std::optional<double> units_per_count;  ///< mm or ° per count, for streams of counts
  std::optional<double> rate_hz;          ///< samples per second, for streams without time stamps
  std::size_t axis = 0;                   ///< number of the axis in a stream of several: 0 is the first
  bool axis_stated = false;               ///< whether somebody said so; else columns are taken only by what they say
  /// Of an axis that rests: what deviates is what is sought, and of several columns none of which says that it is the
  /// position, or too many, the first counts that is neither setpoint nor temperature or the like.
  bool at_standstill = false;
  /// When the bytes that are being fed arrived, s; NaN where that is lost. For streams that tell neither time nor rate,
  /// and for how long a source was away whose clock began anew. Empty when it is never known.
  std::function<double()> arrival_s{};
  /// Whether a line that is no sample, or whose time is out of order (recordings/stamp_judge.h), is counted as lost
  /// instead of being refused: a disturbed cable must not end a test of two hours. A hundred such lines in a row are
  /// refused all the same.
  bool skip_damaged = false;
};

/// Takes the bytes of one recording as they arrive, cut anywhere, and hands samples on. Never keeps more than a line.
class RecordingReader {
 public:
  virtual ~RecordingReader() = default;

  /// Fails, with the line, on what is no sample where one must be, on time running backwards and on numbers that are
  /// not finite; what stood in front has gone to the sink. Gaps (lost samples that the stream itself shows, such as a
  /// jump of its counter) are told by lost().
  virtual Result<void> feed(std::string_view bytes, const SampleSink& sink) = 0;

  /// Nothing more comes: the last line, when it has no line break, and what waited to be told more. Fails where the
  /// recording is none as a whole; what is missing of one that was interrupted is no reason.
  virtual Result<void> finish(const SampleSink& sink) = 0;

  /// The connection broke, or nothing more is read: bytes are missing here. Hands on what waited for the next line,
  /// forgets the unfinished line and passes over all bytes up to the next line break, which may be the end of a line
  /// whose beginning is missing.
  virtual Result<void> interrupted(const SampleSink& sink) = 0;

  /// Bytes of a sample whose end has not come.
  virtual std::size_t unfinished() const = 0;

  /// Bytes since the last line break, passed over or not; 0 of layouts without lines.
  virtual std::uint64_t without_break() const { return 0; }

  /// How many samples the stream itself shows to be lost so far, damaged lines included.
  virtual std::size_t lost() const = 0;

  /// Sentences of what was out of order so far and how it was taken.
  virtual std::vector<std::string> remarks() const { return {}; }

  /// Of readings, the unit that the stream names; nullptr where it names none, or no sample has come.
  virtual const Unit* unit() const { return nullptr; }
  /// Of readings, what the stream calls them: "EYX", "yaw"; nothing where it does not, or no sample has come.
  virtual std::string_view name() const { return {}; }

  /// What the stream has told about the air so far, first and last values; nothing for most.
  virtual Environment environment() const { return {}; }
};

struct Recording {
  std::string_view id;          ///< "umd", for --stream
  std::string_view title;       ///< "µMD0/1/2 serial stream"
  std::string_view extensions;  ///< ".txt", a hint for people
  std::string_view manual;      ///< Markdown: grammar, units, what is refused, an example

  /// Whether its numbers may be readings of anything, ChannelMeaning; else they are positions.
  bool of_any_quantity = false;
  /// Whether samples of two of its channels that stand in one line have one time.
  bool channels_share_time = false;

  /// How well the beginning (at most 64 KiB, cut anywhere) fits: 0 not at all, 100 surely.
  int (*recognise)(std::string_view head);

  /// A reader for one recording. Fails when an option is missing that the stream needs.
  Result<std::unique_ptr<RecordingReader>> (*open)(const RecordingOptions& options);
};

/// Every layout, in alphabetical order of the source files (generated).
std::span<const Recording* const> recording_table();

/// nullptr when there is none of that id.
const Recording* find_recording(std::string_view id);

/// The layout that fits best. Fails on an empty beginning and on what no layout recognises; the message lists what is
/// read.
Result<const Recording*> recognise_recording(std::string_view head);

/// Of a layout whose samples are times and positions: fails on a length per count, which would not be used.
Result<void> check_times_and_positions(const RecordingOptions& options);
/// What its reader remarks where a rate was given.
inline constexpr std::string_view unused_rate =
    "the rate that was given is not used, since the recording tells its times";

/// mm per count of an interferometer: λ divided by the counts that a wavelength of path has (2, 4 or 8 after optics and
/// electronics). The wavelength is that in the air of the test. Fails unless both are positive.
Result<double> mm_per_count(Length wavelength, double counts_per_wavelength);

}  // namespace axiometry::formats
