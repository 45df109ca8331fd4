// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

/// Words in the names of columns: "Bed temperature", "bed_left", "T1Bed", "Maschinenbett", "Schleppfehler".
namespace axiometry::formats {

enum class WordPlace {
  whole,          ///< "dew" in "dew point", not in "sidewall"
  front,          ///< at the front of a word: "air" in "airflow", not in "fairing"
  front_or_back,  ///< as in German compounds: "luft" in "Luftfilter" and "Hallenluft"
  back,
  anywhere,
};

struct NameWord {
  std::string_view word;  ///< word in lower case
  WordPlace place = WordPlace::whole;
};

/// Whether a name has it. Words end at what is no letter, at a capital after a small letter, and before "temp".
bool has_word(std::string_view name, const NameWord& sought);
bool has_any_word(std::string_view name, std::span<const NameWord> sought);

}  // namespace axiometry::formats
