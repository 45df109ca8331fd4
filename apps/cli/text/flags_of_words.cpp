// SPDX-License-Identifier: Apache-2.0
#include "cli/text/flags_of_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace axiometry::cli {
namespace {

struct Row {
  std::string_view words;  ///< of an English sentence of the library, without its first letter, which may be a capital
  std::string_view flags;  ///< with a verb in front where it is another one than is called
};

/// tests/flags_of_words.py holds the words against the sentences, and the flags against those that there are.
constexpr std::array rows = {
    // Tests and what is evaluated of them.
    Row{"interval with type A", "--type-a"},
    Row{"the correction for thermal expansion", "--correct nde"},
    Row{"the correction for the air after Ciddor", "--correct air=ciddor"},
    Row{"the correction of the dead path", "--correct dead-path"},
    Row{"the correction of the gain", "--correct gain"},
    Row{"the correction of the sign", "--correct sign"},
    Row{"expected the plan the axis moved after with it", "--plan"},
    Row{"with the plan the axis moved after its readings become one", "evaluate --plan, dynamic"},
    Row{"a log is given beside a test, a recording of positions with its plan", "--temperatures, --plan"},
    Row{"expected one test beside a log of temperatures", "--temperatures"},
    Row{"beside which such a file is given", "evaluate --tolerance-table"},
    Row{"or its format stated as one of", "--to"},
    Row{"expected its address, AXIOMETRY_STORE", "--store"},
    // Plans and their programs.
    Row{"its program is to be written with rollover", "nc --rollover"},
    Row{"plan of a volumetric calibration, which has runs", "--part"},
    // Recordings, and captures of them.
    Row{"expected the number of the one with the", "--stream-axis"},
    Row{"found no sample rate (code 8)", "--rate"},
    Row{"samples a second are assumed", "--rate"},
    Row{"found no length of a count", "--units-per-count, --wavelength, --counts-per-wavelength"},
    Row{"the window around the targets is too narrow", "--target-window"},
    Row{"a smaller shortest standstill and a larger threshold of rest", "--shortest-rest, --rest-threshold"},
    Row{"or the zero or sign of the instrument differ", "--zero, --datum, --reverse"},
    Row{"expected the reflector to rest at every stop", "--rest-window, --rest-threshold"},
    Row{"the instrument counts the other way", "--reversed, --reverse"},
    Row{"expected which one is measured", "--part"},
    Row{"a capture can go on with them", "--resume"},
    Row{"found one file for the test and for what arrives", "--out, --raw"},
    Row{"found the simulator as source of positions or lengths", "--stops"},
    Row{"where it is stated what tells the stops", "capture --stops"},
    Row{"position tells the stops", "--stops"},
    Row{"trigger tells the stops", "--stops"},
    Row{"that nothing else tells the stops", "--stops"},
    Row{"expected its number among those beside the time", "--stop-column"},
    Row{"expected the error that is read", "--error"},
    Row{"found readings without a unit", "--unit"},
    Row{"expected those that were said at its stops", "--keys"},
    // Straightness and angles.
    Row{"the error stated beside the file", "--error"},
    Row{"expected # error: EAX, EBX or ECX, or one stated beside the file", "--error"},
    // Compensation, and what controls do with it.
    Row{"obody names the axis: the table is made for X", "--axis"},
    Row{"count of the control is taken for 1", "--resolution"},
    Row{"found a table in counts of", "--resolution"},
    Row{"is one count another amount?", "--resolution"},
    Row{"obody tells the steps per unit of the control", "--steps-per-unit"},
    Row{"nobody gives a table that was active", "--existing"},
    Row{"or the unit of the existing table stated", "--existing-unit"},
    Row{"expected the last value held beyond the targets", "--hold-ends, --start, --end, --step, --points"},
    Row{"found a periodic part to leave out and no period", "--period"},
    Row{"the part can be left out of it", "--periodic leave"},
    Row{"and make it with the other sign", "--turned-sign"},
    Row{"expected the sign that was asked for, turned or not", "--turned-sign"},
    Row{"a larger magnification", "--magnification, --step"},
    Row{"or 127 as largest number", "--largest 127"},
    Row{"expected one for both: BLCOMP", "--curves both-ways"},
    Row{"which Ix86 can hold, or one curve for both directions", "--curves both-ways"},
    Row{"found the output axis", "--output-axis, --number"},
    // Tracking interferometers and volumes.
    Row{"expected the result of a location of the station", "tracking locate --json"},
    Row{"expected the result of a volumetric calibration", "volumetric identify --out"},
    Row{"found no output, expected points", "--points, --lengths, --recording, --ranges, --truth"},
    Row{"found no output, expected lengths", "--lengths, --recording, --truth"},
    Row{"expected lengths and the truth alone", "--lengths, --truth"},
    Row{"found no plan of lines to walk", "--plan"},
    Row{"expected a plan or points of the location", "--plan, --location-point"},
    Row{"found no points of a station location", "--location-point, --plan"},
    Row{"found neither a true station nor a plan that has one", "--station-true, --plan"},
    Row{"found recordings asked for without a plan", "--plan"},
    Row{"expected stations_mm of the machine", "--station"},
};

}  // namespace

std::string flags_of_words(std::string_view sentence) {
  std::string flags;
  for (const Row& row : rows)
    if (sentence.find(row.words) != sentence.npos && flags.find(row.flags) == flags.npos)
      flags += fmt::format("{}{}", flags.empty() ? "" : ", ", row.flags);
  return flags;
}

std::string with_flags(std::string said, std::string_view sentence) {
  const std::string flags = flags_of_words(sentence);
  if (flags.empty()) return said;
  const bool has_stop = said.ends_with('.');
  if (has_stop) said.pop_back();
  return fmt::format("{} ({}){}", said, flags, has_stop ? "." : "");
}

}  // namespace axiometry::cli
