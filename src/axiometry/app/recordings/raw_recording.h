// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/app/files/output.h"
#include "axiometry/base/quantity.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/recording.h"

/// Simulated recordings, written as instruments and loggers write them, sample by sample as they come.
namespace axiometry::app {

/// By the extension of the file's name.
enum class RawLayout {
  text,  ///< ".csv", ".txt": a note that it is simulated, then "time_s,position_mm" (or _deg), seven decimals each
  npy,   ///< ".npy": NumPy's float64 of N rows and 2 columns, little-endian
  umd,   ///< ".umd": lines of a µMD interferometer, 8 whole numbers; linear axes only
};

/// Fails on other extensions ("-" is text).
Result<RawLayout> raw_layout_of(std::string_view name);

inline const Length simulated_wavelength = Length::nm(632.991);  ///< in air, where nothing else is asked for

struct RawSetting {
  AxisKind kind = AxisKind::linear;
  std::size_t samples = 0;                   ///< samples that will be written
  double rate = 1.0;                         ///< samples a second
  Length wavelength = simulated_wavelength;  ///< wavelength in air; a count of `umd` is half of it
  bool lengths = false;  ///< whether positions are lengths of a tracking interferometer, no coordinates of an axis
};

inline constexpr std::size_t simulated_head_most = 64;  ///< bytes of a recording that says_simulated() looks at

/// Whether the beginning of a recording says that nobody measured it, as RecordingEncoder and the simulated motions
/// write it; also where it was saved again with a byte order mark or in UTF-16. One of NumPy has no place for that.
bool says_simulated(std::string_view head);

/// The bytes of a recording, sample by sample.
class RecordingEncoder {
 public:
  /// Fails on counts of a rotary axis.
  static Result<RecordingEncoder> make(RawLayout layout, const RawSetting& setting);

  std::string head() const;
  void append(std::string& bytes, const Sample& sample);
  std::size_t written() const { return written_; }  ///< samples

 private:
  RecordingEncoder(RawLayout layout, const RawSetting& setting) : layout_(layout), setting_(setting) {}
  void append_counts(std::string& bytes, const Sample& sample);

  RawLayout layout_;
  RawSetting setting_;
  std::size_t written_ = 0;
  long long displacement_ = 0;  // counts of the sample before
};

class RawRecording {
 public:
  /// Fails as raw_layout_of(), RecordingEncoder::make() and OutputFile::create() do.
  static Result<RawRecording> create(const std::string& name, const RawSetting& setting);

  Result<void> write(std::span<const Sample> samples);

  /// The file appears. Needs all samples to be written.
  Result<void> commit();

 private:
  RawRecording(OutputFile file, RecordingEncoder encoder, std::size_t samples)
      : file_(std::move(file)), encoder_(std::move(encoder)), samples_(samples), text_(encoder_.head()) {}

  OutputFile file_;
  RecordingEncoder encoder_;
  std::size_t samples_;
  std::string text_;
};

}  // namespace axiometry::app
