// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/head_words.h"

#include <algorithm>
#include <span>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/csv_cells.h"

namespace axiometry::formats::generic {
namespace {

using Words = std::span<const std::string_view>;

// Whole words of languages that write with blanks; of Chinese and Japanese, which do not, any part of a name.
constexpr std::string_view target_words[] = {
    "target",    "targets",      "nominal",    "nominale",  "setpoint",  "commanded", "command",      "cmd",
    "demand",    "set",          "desired",    "soll",      "sollwert",  "sollpos",   "sollposition", "sollwerte",
    "ziel",      "zielposition", "nennwert",   "cible",     "consigne",  "théorique", "theorique",    "visée",
    "obiettivo", "teorica",      "teorico",    "impostata", "comandata", "bersaglio", "objetivo",     "teórica",
    "teórico",   "consigna",     "programmed", "目标",      "目標",      "指令",      "名义",         "理论",
    "理論",      "设定",         "設定",       "给定"};
constexpr std::string_view measured_words[] = {
    "measured", "actual",   "measurement", "reading",   "observed",  "ist",     "istwert", "istpos", "istposition",
    "messwert", "gemessen", "mesuré",      "mesurée",   "mesure",    "mesuree", "réel",    "réelle", "reelle",
    "misurata", "misurato", "misura",      "effettiva", "effettivo", "reale",   "medida",  "medido", "real",
    "实际",     "实测",     "测量值",      "实测值",    "実測",      "実際",    "測定値",  "测得"};
constexpr std::string_view deviation_words[] = {"deviation",
                                                "deviations",
                                                "dev",
                                                "error",
                                                "errors",
                                                "err",
                                                "delta",
                                                "diff",
                                                "difference",
                                                "abweichung",
                                                "abweichungen",
                                                "abw",
                                                "fehler",
                                                "messabweichung",
                                                "positionsabweichung",
                                                "positionierabweichung",
                                                "differenz",
                                                "écart",
                                                "ecart",
                                                "écarts",
                                                "erreur",
                                                "déviation",
                                                "scostamento",
                                                "scostamenti",
                                                "errore",
                                                "deviazione",
                                                "scarto",
                                                "desviación",
                                                "desviacion",
                                                "desvío",
                                                "desvio",
                                                "偏差",
                                                "误差",
                                                "誤差",
                                                "δ",
                                                "Δ"};
constexpr std::string_view position_words[] = {"position",   "positions",    "pos",   "posizione",  "posición",
                                               "posicion",   "quote",        "quota", "koordinate", "coordinate",
                                               "coordonnée", "messposition", "位置",  "坐标",       "座標"};
constexpr std::string_view direction_heads[] = {"direction",      "dir",           "approach", "sense",     "richtung",
                                                "anfahrrichtung", "fahrtrichtung", "sens",     "direzione", "verso",
                                                "dirección",      "direccion",     "sentido",  "方向"};
constexpr std::string_view run_words[] = {
    "run",      "runs",   "cycle",     "cycles",    "pass",    "repeat",    "repetition", "trial",      "lauf",
    "messlauf", "zyklus", "durchgang", "durchlauf", "messung", "messreihe", "passage",    "essai",      "série",
    "serie",    "ciclo",  "corsa",     "prova",     "passata", "pasada",    "ensayo",     "repetición", "repeticion",
    "循环",     "次数",   "测次",      "次",        "回数",    "回目",      "サイクル",   "轮"};
constexpr std::string_view time_words[] = {"time",  "timestamp", "zeit",   "zeitstempel", "uhrzeit", "temps", "heure",
                                           "tempo", "ora",       "tiempo", "hora",        "时间",    "時間",  "時刻"};
constexpr std::string_view index_words[] = {
    "no",   "nr",    "num",  "number", "index",    "idx",    "id",    "point", "points", "row",
    "line", "i",     "n",    "seq",    "sequence", "sample", "punkt", "zeile", "nummer", "lfd",
    "pt",   "punto", "riga", "ligne",  "序号",     "编号",   "番号",  "点号",  "测点"};
constexpr std::string_view ignored_words[] = {
    "date", "datum", "comment", "comments", "note", "notes", "remark", "remarks", "temperature", "temp", "temperatur",
    "pressure", "humidity", "operator", "kommentar", "bemerkung", "luftdruck", "luftfeuchte", "prüfer", "bediener",
    "température", "temperatura", "pression", "humidité", "pressione", "umidità", "presión", "humedad", "温度", "气压",
    "湿度", "気圧", "备注", "日期", "操作", "status", "quality", "signal", "beam", "feed", "vorschub", "velocity",
    "speed",
    // Computed from the readings: computed again here.
    "mean", "average", "avg", "std", "stdev", "stddev", "sigma", "min", "max", "minimum", "maximum", "median", "range",
    "sum", "total", "mittel", "mittelwert", "standardabweichung", "streuung", "summe", "moyenne", "écart-type", "media",
    "promedio", "spannweite", "reversal", "umkehrspanne", "limit", "limits", "limite", "limites", "tolerance",
    "tolérance", "toleranz", "tolleranza", "tolerancia", "grenze", "grenzwert", "obergrenze", "untergrenze", "公差",
    "平均", "平均值", "标准差", "標準偏差", "stdabw", "rms", "rmse", "variance", "varianz", "varianza", "moy", "mittl",
    "repeatability", "wiederholbarkeit", "wiederholpräzision", "wiederholgenauigkeit", "répétabilité", "répétabilite",
    "repetabilite", "ripetibilità", "ripetibilita", "repetibilidad", "重复定位精度", "uncertainty", "unsicherheit",
    "messunsicherheit", "incertitude", "incertezza", "incertidumbre", "不确定度", "backlash", "hysteresis", "hysterese",
    "hystérésis", "isteresi", "histéresis", "umkehrspiel", "gioco", "反向间隙"};
// A deviation with one of these is no deviation from a target along the axis, or has lost its sign: "standard
// deviation", "écart-type", "yaw error", "vertical deviation", "abs error".
constexpr std::string_view other_deviation_words[] = {
    "standard",     "estándar",   "estandar",    "típica",       "tipica",      "type",        "tipo",
    "quadratico",   "quadratica", "quadratique", "squared",      "square",      "quadratisch", "quadrat",
    "cuadrático",   "abs",        "absolute",    "absolut",      "absolu",      "assoluto",    "absoluto",
    "betrag",       "magnitude",  "yaw",         "roll",         "gieren",      "nicken",      "rollen",
    "straightness", "geradheit",  "rectitude",   "rettilineità", "incremental", "inkremental", "incrémental"};
// Deviations, or what takes them away ("Added ↑" of our own reports of tables): names alone do not say.
constexpr std::string_view correction_words[] = {
    "added",        "addiert",           "ajouté",       "correction",    "corrections",
    "corr",         "korrektur",         "korrekturen",  "korrekturwert", "korrekturwerte",
    "kompensation", "kompensationswert", "komp",         "compensation",  "compensations",
    "comp",         "correzione",        "correzioni",   "compensazione", "corrección",
    "correccion",   "compensación",      "compensacion", "补偿",          "補正"};
// Across the way, unless it is the axis that is called so: "vertical deviation", not "error of the vertical axis".
constexpr std::string_view across_words[] = {"vertical", "vertikal", "verticale", "horizontal", "horizontale"};
constexpr std::string_view axis_words[] = {"axis", "achse", "axe", "asse", "eje"};
constexpr std::string_view minus_words[] = {"minus", "moins", "meno", "menos"};
constexpr std::string_view up_words[] = {
    "up",       "forward",   "fwd",      "positive", "hin",    "vor",     "vorwärts", "vorwaerts", "positiv",
    "aufwärts", "aufwaerts", "hinweg",   "aller",    "avant",  "montant", "montée",   "positif",   "avanti",
    "andata",   "positivo",  "positiva", "adelante", "ida",    "subida",  "avance",   "ascending", "hinfahrt",
    "正向",     "正方向",    "去程",     "往路",     "正行程", "上行"};
constexpr std::string_view down_words[] = {
    "down",     "backward", "bwd",       "back",       "reverse",   "rev",         "negative",   "neg",
    "zurück",   "zurueck",  "rück",      "rueck",      "rückwärts", "rueckwaerts", "negativ",    "abwärts",
    "abwaerts", "rückweg",  "rueckweg",  "retour",     "arrière",   "arriere",     "descendant", "descente",
    "négatif",  "negatif",  "indietro",  "ritorno",    "negativo",  "negativa",    "atrás",      "atras",
    "vuelta",   "bajada",   "retroceso", "descending", "rückfahrt", "backwards",   "反向",       "负向",
    "負方向",   "负方向",   "回程",      "復路",       "逆行程",    "下行"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// "4s up", "6 sigma", "2σ": so many standard deviations, and no number of a run.
bool names_a_multiple_of_s(const std::vector<std::string>& words) {
  for (std::size_t k = 1; k < words.size(); ++k)
    if (is_digit(words[k - 1].front()) && (words[k] == "s" || words[k] == "σ" || words[k] == "sigma")) return true;
  return false;
}

/// "Lauf 1 auf", "ab 2": a direction at the end of a name, or before its number; "auf 20 °C bezogen" tells none.
std::optional<Direction> direction_by_end(const std::vector<std::string>& words) {
  if (words.empty()) return std::nullopt;
  const bool numbered = words.size() == 2 && is_digit(words.back().front());
  for (const std::string& word : {words.back(), numbered ? words.front() : words.back()}) {
    if (word == "auf" || word == "hoch") return Direction::up;
    if (word == "ab" || word == "runter") return Direction::down;
  }
  return std::nullopt;
}

/// Lower case of ASCII and of the letters of Latin-1.
std::string lower(std::string_view s) {
  std::string result = text::to_lower(s);
  for (std::size_t k = 0; k + 1 < result.size(); ++k) {
    auto& trail = result[k + 1];
    const auto code = static_cast<unsigned char>(trail);
    if (static_cast<unsigned char>(result[k]) == 0xC3 && code >= 0x80 && code <= 0x9E && code != 0x97)
      trail = static_cast<char>(code + 0x20);
  }
  return result;
}

void replace_all(std::string& s, std::string_view from, std::string_view to) {
  for (std::size_t k = 0; (k = s.find(from, k)) != std::string::npos; k += to.size()) s.replace(k, from.size(), to);
}
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

/// Lower-case words and numbers, in order.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < name.size();) {
    std::size_t end = k;
    if (is_digit(name[k])) {
      while (end < name.size() && is_digit(name[end])) ++end;
    } else {
      while (end < name.size() && is_letter(name[end])) ++end;
    }
    if (end > k) words.emplace_back(name.substr(k, end - k));
    k = std::max(end, k + 1);
  }
  return words;
}

bool is_east_asian(std::string_view word) { return static_cast<unsigned char>(word.front()) >= 0xE3; }

/// Place of the first word of the list in the name; nothing when there is none.
std::optional<std::size_t> find_any(const std::vector<std::string>& words, Words list) {
  for (std::size_t k = 0; k < words.size(); ++k)
    for (std::string_view word : list)
      if (words[k] == word || (is_east_asian(word) && words[k].contains(word))) return k;
  return std::nullopt;
}

struct NameAndUnit {
  std::string name;
  const Unit* unit = nullptr;
};

/// "Abweichung 1/10", "error in 0.1", "deviation in 10": the unit behind it is counted in parts or in tens, and which
/// it is only a person knows. "Lauf 1" is a number of its own.
bool is_multiple_of_unit(std::string_view before_unit) {
  const std::size_t begin = before_unit.find_last_not_of("0123456789./,");
  const std::string_view number = text::trim(before_unit.substr(begin == std::string_view::npos ? 0 : begin + 1));
  if (number.empty() || !is_digit(number.front()) || !is_digit(number.back())) return false;
  const std::string_view words = text::trim(before_unit.substr(0, before_unit.size() - number.size()));
  return number.find_first_of("./,") != std::string_view::npos || words.ends_with(" in") || words.ends_with(" en");
}

/// "soll [mm]", "error_um", "Abweichung in µm", "位置(mm)".
NameAndUnit part_unit(std::string name) {
  for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}, std::pair{'<', '>'}}) {
    const std::size_t begin = name.find(open);
    const std::size_t end = begin == std::string::npos ? begin : name.find(close, begin);
    if (end == std::string::npos) continue;
    const Unit* unit = unit_in(std::string_view(name).substr(begin, end - begin + 1));
    if (unit == nullptr) continue;
    name.replace(begin, end - begin + 1, " ");
    return {std::string(text::trim(name)), unit};
  }
  const std::size_t mark = name.find_last_of("_ /,");
  if (mark == std::string::npos || mark + 1 == name.size()) return {std::move(name), nullptr};
  const std::string_view last = std::string_view(name).substr(mark + 1);
  const Unit* unit = find_unit(last);
  if (unit == nullptr) return {std::move(name), nullptr};
  std::string before(text::trim(std::string_view(name).substr(0, mark)));
  if (before.ends_with(" in") || before.ends_with(" en")) before.resize(before.size() - 3);
  return {std::move(before), is_multiple_of_unit(before) ? nullptr : unit};
}

/// A sign is a direction at the very beginning or end, in brackets, and between a blank and a digit; not the hyphen in
/// "run-1" and "soll-ist".
std::optional<Direction> direction_by_sign(std::string_view name) {
  const auto of = [](char sign) { return sign == '+' ? Direction::up : Direction::down; };
  const auto is_sign = [](char c) { return c == '+' || c == '-'; };
  if (name.contains("+/-")) return std::nullopt;  // both signs
  if (name.size() < 2) return name == "+" || name == "-" ? std::optional(of(name.front())) : std::nullopt;
  if (is_sign(name.back())) return of(name.back());
  if (is_sign(name.front())) return of(name.front());
  for (std::size_t k = 1; k + 1 < name.size(); ++k) {
    if (!is_sign(name[k])) continue;
    const bool bracketed = (name[k - 1] == '(' && name[k + 1] == ')') || (name[k - 1] == '[' && name[k + 1] == ']');
    if (bracketed || (name[k - 1] == ' ' && is_digit(name[k + 1]))) return of(name[k]);
  }
  return std::nullopt;
}

HeadRole role_of(const std::vector<std::string>& words) {
  if (find_any(words, ignored_words) || names_a_multiple_of_s(words)) return HeadRole::ignored;
  if (find_any(words, deviation_words))
    return find_any(words, other_deviation_words) || (find_any(words, across_words) && !find_any(words, axis_words))
               ? HeadRole::ignored
               : HeadRole::deviation;
  if (find_any(words, measured_words)) return HeadRole::measured;
  if (find_any(words, target_words)) return find_any(words, index_words) ? HeadRole::index : HeadRole::target;
  if (find_any(words, direction_heads)) return HeadRole::direction;
  if (find_any(words, run_words)) return HeadRole::run;
  if (find_any(words, time_words)) return HeadRole::time;
  if (find_any(words, position_words)) return find_any(words, index_words) ? HeadRole::index : HeadRole::position;
  if (find_any(words, index_words)) return HeadRole::index;
  return HeadRole::unknown;
}

}  // namespace

const Unit* unit_in(std::string_view cell) {
  cell = text::trim(cell);
  for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}, std::pair{'<', '>'}})
    if (cell.size() > 2 && cell.front() == open && cell.back() == close)
      cell = text::trim(cell.substr(1, cell.size() - 2));
  if (cell.starts_with("in ")) cell = text::trim(cell.substr(3));
  return cell.empty() ? nullptr : find_unit(cell);
}

std::optional<Direction> direction_word(std::string_view cell) {
  if (const auto direction = direction_from(cell)) return direction;
  const std::vector<std::string> word{lower(text::trim(cell))};
  if (word.front().empty()) return std::nullopt;
  // "正方向" holds no word of the other list, and "反向" none of this.
  const bool up = find_any(word, up_words).has_value() || word.front() == "正" || word.front() == "往";
  const bool down = find_any(word, down_words).has_value() || word.front() == "负" || word.front() == "負" ||
                    word.front() == "反" || word.front() == "回";
  if (up == down) return direction_by_end(word);
  return up ? Direction::up : Direction::down;
}

Head head_of(std::string_view raw) {
  std::string name = lower(text::trim(raw));
  for (const auto& [from, to] : {std::pair<std::string_view, std::string_view>{"（", "("},
                                 {"）", ")"},
                                 {"［", "["},
                                 {"］", "]"},
                                 {"\u2212", "-"},
                                 {"↑", " up "},
                                 {"↓", " down "},
                                 {"\u00A0", " "}})
    replace_all(name, from, to);
  Head head;
  NameAndUnit parts = part_unit(std::string(text::trim(name)));
  head.unit = parts.unit;
  const std::string_view plain = text::trim(parts.name);
  const std::vector<std::string> words = words_of(plain);
  head.role = role_of(words);
  if (std::ranges::count(plain, '|') > 1 && head.role == HeadRole::deviation) head.role = HeadRole::ignored;
  const bool corrected = find_any(words, correction_words).has_value();
  std::vector<std::string> ways = words;
  if (corrected)  // "vor Kompensation" and "avant correction" are before it, not forward
    std::erase_if(ways, [](const std::string& w) { return w == "vor" || w == "avant"; });
  const bool up = find_any(ways, up_words).has_value();
  const bool down = find_any(ways, down_words).has_value();
  if (up != down) head.direction = up ? Direction::up : Direction::down;
  if (!up && !down) head.direction = direction_by_end(words);
  if (!up && !down && !head.direction) head.direction = direction_by_sign(plain);
  std::vector<std::string> numbers;
  std::ranges::copy_if(words, std::back_inserter(numbers), [](const std::string& w) { return is_digit(w.front()); });
  if (numbers.size() == 1)
    if (const auto number = parse_count(numbers.front())) head.run = static_cast<std::size_t>(*number);
  const auto target = find_any(words, target_words);
  const auto measured = find_any(words, measured_words);
  const bool leading_minus = plain.size() > 1 && plain.front() == '-' && is_letter(plain[1]);
  head.sign_open = (corrected && head.role == HeadRole::unknown) || (leading_minus && head.role == HeadRole::deviation);
  if (target && measured && (plain.contains('-') || find_any(words, minus_words))) {  // a difference of the two
    const auto deviation = find_any(words, deviation_words);
    head.role = HeadRole::deviation;
    head.sign_open = *target < *measured && deviation && *deviation > *measured;  // "Soll-Ist-Abweichung" names both
    head.target_minus_actual = *target < *measured && !head.sign_open;
    head.direction.reset();
  }
  return head;
}

}  // namespace axiometry::formats::generic
