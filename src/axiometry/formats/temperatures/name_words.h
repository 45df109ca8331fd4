// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

/// Words in the names of columns: "Bed temperature", "bed_left", "T1Bed", "Maschinenbett". Private to temperatures/.
namespace axiometry::formats {

enum class WordPlace {
  whole,          ///< "dew" in "dew point", not in "sidewall"
  front,          ///< of a word: "air" in "airflow", not in "fairing"
  front_or_back,  ///< as in German compounds: "luft" in "Luftfilter" and "Hallenluft"
  back,
  anywhere,
};

struct NameWord {
  std::string_view word;  ///< in lower case
  WordPlace place = WordPlace::whole;
};

/// Whether a name has it. Words are parted by what is no letter, by a capital after a small letter, and before "temp".
bool has_word(std::string_view name, const NameWord& sought);

/// "machine", "equipment" or "air" by a word of the sensor's name. Of "air above the bed" the air counts. Nothing for
/// "column 2", the name of a column without a head.
std::optional<std::string_view> sensor_role(std::string_view name);

}  // namespace axiometry::formats
