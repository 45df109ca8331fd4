// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/sensor_role.h"

#include "axiometry/formats/text/name_words.h"

namespace axiometry::formats {
namespace {

struct RoleWord {
  NameWord sought;
  std::string_view role;
};
/// In this order: "air above the bed" is of the air.
constexpr RoleWord words_of_roles[] = {
    {{"air", WordPlace::front}, "air"},
    {{"luft", WordPlace::front_or_back}, "air"},
    {{"ambient", WordPlace::front}, "air"},
    {{"room", WordPlace::front_or_back}, "air"},
    {{"raum", WordPlace::front_or_back}, "air"},
    {{"hall", WordPlace::front}, "air"},
    {{"umgebung", WordPlace::front}, "air"},
    {{"laser", WordPlace::front_or_back}, "equipment"},
    {{"optic", WordPlace::front}, "equipment"},
    {{"interferom", WordPlace::front}, "equipment"},
    {{"material", WordPlace::front}, "machine"},
    {{"machine", WordPlace::front}, "machine"},
    {{"maschine", WordPlace::front_or_back}, "machine"},
    {{"bed", WordPlace::front}, "machine"},
    {{"bett", WordPlace::front_or_back}, "machine"},
    {{"table", WordPlace::front}, "machine"},
    {{"tisch", WordPlace::front_or_back}, "machine"},
    {{"column", WordPlace::front}, "machine"},
    {{"ständer", WordPlace::front_or_back}, "machine"},
    {{"spindle", WordPlace::front_or_back}, "machine"},
    {{"spindel", WordPlace::front_or_back}, "machine"},
    {{"scale", WordPlace::front}, "machine"},
    {{"maßstab", WordPlace::front_or_back}, "machine"},
    {{"screw", WordPlace::front_or_back}, "machine"},
};

/// Of what is no reading of a sensor, and of what flows: no word of a place beside them changes that.
constexpr NameWord words_without_role[] = {
    {"dew", WordPlace::whole},
    {"dewpoint", WordPlace::anywhere},
    {"tau", WordPlace::whole},
    {"taupunkt", WordPlace::anywhere},
    {"set", WordPlace::whole},
    {"setpoint", WordPlace::anywhere},
    {"soll", WordPlace::whole},
    {"sollwert", WordPlace::anywhere},
    {"consigne", WordPlace::whole},
    {"alarm", WordPlace::anywhere},
    {"limit", WordPlace::front},
    {"grenzwert", WordPlace::anywhere},
    {"coolant", WordPlace::anywhere},
    {"kühlmittel", WordPlace::anywhere},
    {"kühlwasser", WordPlace::anywhere},
    {"kühlschmierstoff", WordPlace::anywhere},
    {"kss", WordPlace::whole},
    {"oil", WordPlace::whole},
    {"öl", WordPlace::whole},
    {"Öl", WordPlace::whole},
    {"hydrauliköl", WordPlace::anywhere},
};

}  // namespace

bool names_no_role(std::string_view name) { return has_any_word(name, words_without_role); }

std::optional<std::string_view> sensor_role(std::string_view name) {
  if (name.starts_with("column ")) return std::nullopt;
  for (const RoleWord& row : words_of_roles)
    if (has_word(name, row.sought)) return row.role;
  return std::nullopt;
}

}  // namespace axiometry::formats
