// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/raw_recording.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "axiometry/base/contract.h"
#include "axiometry/base/text.h"

namespace axiometry::app {
namespace {

constexpr int decimals = 7;
constexpr double fractions_per_count = 256.0;

void append_fixed(std::string& text, double x) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, x, std::chars_format::fixed, decimals).ptr;
  text.append(digits, end);
}

void append_bytes(std::string& text, double x) {
  auto bits = std::bit_cast<std::uint64_t>(x);
  for (int k = 0; k < 8; ++k, bits >>= 8) text += static_cast<char>(bits & 0xff);
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

Result<RawRecording> RawRecording::create(const std::string& name, const RawSetting& setting) {
  AXIOMETRY_TRY(const RawLayout layout, raw_layout_of(name));
  if (layout == RawLayout::umd && setting.kind == AxisKind::rotary)
    return fail("found counts of a wavelength for a rotary axis, expected a .csv, .txt or .npy recording");
  AXIOMETRY_TRY(OutputFile file, OutputFile::create(name));
  RawRecording recording(std::move(file), layout, setting);
  recording.append_head();
  return recording;
}

void RawRecording::append_head() {
  switch (layout_) {
    case RawLayout::text:
      text_ += setting_.kind == AxisKind::linear ? "time_s,position_mm\n" : "time_s,position_deg\n";
      break;
    case RawLayout::npy: text_ += npy_head(setting_.samples); break;
    case RawLayout::umd: text_ += "Simulated displacements, counts of half a wavelength\r\n"; break;
  }
}

void RawRecording::append(const Sample& sample) {
  switch (layout_) {
    case RawLayout::text:
      append_fixed(text_, sample.time_s);
      text_ += ',';
      append_fixed(text_, sample.position);
      text_ += '\n';
      break;
    case RawLayout::npy:
      append_bytes(text_, sample.time_s);
      append_bytes(text_, sample.position);
      break;
    case RawLayout::umd: append_counts(sample); break;
  }
}

/// REF MEAS DISP VEL PHASE SEQ CODE DATA: whole counts and 256ths of one, the change since the last sample, the number
/// of the sample, and now and then the rate in hundredths of 1 Hz (code 8).
void RawRecording::append_counts(const Sample& sample) {
  constexpr int rate_code = 8;
  constexpr std::size_t rate_every = 1000;
  const double counts = sample.position * 2.0 / setting_.wavelength.in_mm();
  const auto fractions = std::llround(counts * fractions_per_count);
  const auto displacement = static_cast<long long>(std::floor(static_cast<double>(fractions) / fractions_per_count));
  const auto phase = fractions - displacement * static_cast<long long>(fractions_per_count);
  const bool tells = written_ % rate_every == 0;
  fmt::format_to(std::back_inserter(text_), "0 0 {} {} {} {} {} {}\r\n", displacement,
                 written_ == 0 ? 0 : displacement - displacement_, phase,
                 std::llround(sample.time_s * setting_.rate) + 1, tells ? rate_code : 0,
                 tells ? std::llround(setting_.rate * 100.0) : 0);
  displacement_ = displacement;
}

Result<void> RawRecording::write(std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    append(sample);
    ++written_;
  }
  AXIOMETRY_TRY_VOID(file_.write(text_));
  text_.clear();
  return {};
}

Result<void> RawRecording::commit() {
  AXIOMETRY_CONTRACT(written_ == setting_.samples);
  AXIOMETRY_TRY_VOID(write({}));
  return file_.commit();
}

}  // namespace axiometry::app
