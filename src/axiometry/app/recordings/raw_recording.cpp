// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/raw_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/simulated.h"

namespace axiometry::app {
namespace {

constexpr double fractions_per_count = 256.0;
constexpr std::string_view counts_note = "Simulated displacements";

void append_whole(std::string& text, long long x) {
  char digits[24];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
}

/// Seven decimals, as whole ten millionths; |x| up to 1e9 s, mm or ° gives 1e16 of them, which a double nearly holds.
void append_fixed(std::string& text, double x) {
  constexpr long long one = 10'000'000;
  const long long whole = std::llround(std::abs(x) * static_cast<double>(one));
  if (x < 0.0 && whole > 0) text += '-';
  append_whole(text, whole / one);
  char decimals[8] = {'.'};
  long long rest = whole % one;
  for (int k = 7; k > 0; --k, rest /= 10) decimals[k] = static_cast<char>('0' + rest % 10);
  text.append(decimals, sizeof decimals);
}

void append_bytes(std::string& text, double x) {
  auto bits = std::bit_cast<std::array<char, 8>>(x);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bits);
  text.append(bits.data(), bits.size());
}

/// Version 1.0: magic, length of the header, a Python literal padded to a multiple of 64.
std::string npy_head(std::size_t rows) {
  constexpr std::size_t before = 10;
  std::string dictionary = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, 2), }}", rows);
  while ((before + dictionary.size() + 1) % 64 != 0) dictionary += ' ';
  dictionary += '\n';
  std::string head("\x93NUMPY\x01\x00", 8);
  head += static_cast<char>(dictionary.size() & 0xff);
  head += static_cast<char>(dictionary.size() >> 8);
  return head + dictionary;
}

}  // namespace

Result<RawLayout> raw_layout_of(std::string_view name) {
  const std::string extension = text::to_lower(std::filesystem::path(name).extension().string());
  if (name == "-" || extension == ".csv" || extension == ".txt") return RawLayout::text;
  if (extension == ".npy") return RawLayout::npy;
  if (extension == ".umd") return RawLayout::umd;
  return fail(
      fmt::format("found the recording {}, expected a file ending in .csv, .txt, .npy or .umd", text::quoted(name)));
}

bool says_simulated(std::string_view head) {
  std::string plain;  // without a byte order mark, and without the zeros of UTF-16
  for (const char c : head.substr(0, simulated_head_most))
    if (c != '\0' && static_cast<unsigned char>(c) < 0x80) plain += c;
  return plain.starts_with(fmt::format("# {}", simulated_note)) || plain.starts_with(counts_note);
}

Result<RecordingEncoder> RecordingEncoder::make(RawLayout layout, const RawSetting& setting) {
  if (layout == RawLayout::umd && setting.kind == AxisKind::rotary)
    return fail("found counts of a wavelength for a rotary axis, expected a .csv, .txt or .npy recording");
  return RecordingEncoder(layout, setting);
}

std::string RecordingEncoder::head() const {
  switch (layout_) {
    case RawLayout::text:
      return fmt::format("# {}\ntime_s,{}\n", simulated_note,
                         setting_.lengths                    ? "length_mm"
                         : setting_.kind == AxisKind::linear ? "position_mm"
                                                             : "position_deg");
    case RawLayout::npy: return npy_head(setting_.samples);
    case RawLayout::umd: return fmt::format("{}, counts of half a wavelength\r\n", counts_note);
  }
  return {};
}

void RecordingEncoder::append(std::string& bytes, const Sample& sample) {
  switch (layout_) {
    case RawLayout::text:
      append_fixed(bytes, sample.time_s);
      bytes += ',';
      append_fixed(bytes, sample.position);
      bytes += '\n';
      break;
    case RawLayout::npy:
      append_bytes(bytes, sample.time_s);
      append_bytes(bytes, sample.position);
      break;
    case RawLayout::umd: append_counts(bytes, sample); break;
  }
  ++written_;
}

/// REF MEAS DISP VEL PHASE SEQ CODE DATA: whole counts and 256ths of one, the change since the last sample, the number
/// of the sample, and now and then the rate in hundredths of 1 Hz (code 8).
void RecordingEncoder::append_counts(std::string& bytes, const Sample& sample) {
  constexpr int rate_code = 8;
  constexpr std::size_t rate_every = 1000;
  const double counts = sample.position * 2.0 / setting_.wavelength.in_mm();
  const auto fractions = std::llround(counts * fractions_per_count);
  const auto displacement = static_cast<long long>(std::floor(static_cast<double>(fractions) / fractions_per_count));
  const auto phase = fractions - displacement * static_cast<long long>(fractions_per_count);
  const bool tells = written_ % rate_every == 0;
  const long long columns[] = {displacement,
                               written_ == 0 ? 0 : displacement - displacement_,
                               phase,
                               std::llround(sample.time_s * setting_.rate) + 1,
                               tells ? rate_code : 0,
                               tells ? std::llround(setting_.rate * 100.0) : 0};
  bytes += "0 0";
  for (const long long column : columns) {
    bytes += ' ';
    append_whole(bytes, column);
  }
  bytes += "\r\n";
  displacement_ = displacement;
}

Result<RawRecording> RawRecording::create(const std::string& name, const RawSetting& setting) {
  AXIOMETRY_TRY(const RawLayout layout, raw_layout_of(name));
  AXIOMETRY_TRY(RecordingEncoder encoder, RecordingEncoder::make(layout, setting));
  AXIOMETRY_TRY(OutputFile file, OutputFile::create(name));
  return RawRecording(std::move(file), std::move(encoder), setting.samples);
}

Result<void> RawRecording::write(std::span<const Sample> samples) {
  for (const Sample& sample : samples) encoder_.append(text_, sample);
  AXIOMETRY_TRY_VOID(file_.write(text_));
  text_.clear();
  return {};
}

Result<void> RawRecording::commit() {
  AXIOMETRY_CONTRACT(encoder_.written() == samples_);
  AXIOMETRY_TRY_VOID(write({}));
  return file_.commit();
}

}  // namespace axiometry::app
