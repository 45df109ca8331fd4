// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/table/import_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

// In the order of the enumerations.
constexpr std::string_view encoding_words[] = {"auto", "utf-8", "utf-16", "gbk", "windows-1252", "latin-1"};
constexpr std::string_view delimiter_words[] = {"comma", "semicolon", "tab", "blanks"};
constexpr std::string_view layout_words[] = {"long", "wide", "transposed"};
constexpr std::string_view role_words[] = {"ignore",    "target", "deviation", "position",
                                           "direction", "run",    "time",      "label"};
constexpr std::string_view direction_rule_words[] = {"column", "names", "motion", "visits", "run-parity", "up", "down"};
constexpr std::string_view run_rule_words[] = {"column", "names", "repetition"};
constexpr std::string_view direction_names[] = {"up", "down"};
constexpr std::string_view mark_words[] = {"point", "comma"};

constexpr double most_lines = 1e6;
constexpr double most_runs = 1e4;

/// One member of the profile or of a column: how it is described, written and read.
template <typename Owner>
struct Member {
  std::string_view name;
  std::string_view description;
  Value (*schema)();
  Value (*get)(const Owner&);
  Result<void> (*put)(Owner&, const Value&);
};

Value object(std::initializer_list<std::pair<std::string_view, Value>> members) {
  Value result = Value::object();
  for (const auto& [name, value] : members) result.add(name, value);
  return result;
}

std::unexpected<Error> wrong(const Value& value, std::string_view expected) {
  const std::string found = value.is(Kind::text)     ? text::quoted(value.text())
                            : value.is(Kind::number) ? fmt::format("{}", value.number())
                                                     : std::string(json::kind_name(value.kind()));
  return fail(fmt::format("found {}, expected {}", found, expected), value.at());
}

template <typename Enum, std::size_t n>
Result<Enum> one_of(const std::string_view (&words)[n], const Value& value) {
  if (value.is(Kind::text))
    for (std::size_t k = 0; k < n; ++k)
      if (words[k] == value.text()) return static_cast<Enum>(k);
  return wrong(value, fmt::format("one of {}", fmt::join(words, ", ")));
}

Result<std::size_t> count_from(const Value& value, double least, double most) {
  if (value.is(Kind::number) && value.number() >= least && value.number() <= most &&
      value.number() == static_cast<double>(static_cast<std::size_t>(value.number())))
    return static_cast<std::size_t>(value.number());
  return wrong(value, fmt::format("a whole number from {} to {}", least, most));
}

Result<std::string> text_from(const Value& value) {
  if (value.is(Kind::text)) return value.text();
  return wrong(value, "a string");
}

Result<std::vector<std::string>> texts_from(const Value& value) {
  if (!value.is(Kind::array)) return wrong(value, "an array of strings");
  std::vector<std::string> texts;
  for (const Value& item : value.items()) {
    AXIOMETRY_TRY(texts.emplace_back(), text_from(item));
  }
  return texts;
}

/// Each cell of a column is compared with all of them.
Result<std::vector<std::string>> words_from(const Value& value) {
  constexpr std::size_t most = 50;
  AXIOMETRY_TRY(auto words, texts_from(value));
  if (words.size() > most) return wrong(value, fmt::format("at most {} words", most));
  return words;
}

Result<const Unit*> unit_from(const Value& value) {
  if (value.is(Kind::text))
    if (const Unit* unit = find_unit(value.text())) return unit;
  return wrong(value, fmt::format("one of {}", unit_names()));
}

template <std::size_t n>
Value choice(const std::string_view (&words)[n], bool or_null = false) {
  Value list = Value::array();
  for (std::string_view word : words) list.push(word);
  if (or_null) list.push(Value());
  return object({{"enum", std::move(list)}});
}

Value unit_choice() {
  Value names = Value::array();
  for (const Unit& unit : units()) names.push(unit.name);
  names.push(Value());
  return object({{"enum", std::move(names)}});
}

Value string_schema() { return object({{"type", "string"}}); }
Value strings_schema() { return object({{"type", "array"}, {"items", string_schema()}}); }

Value count_schema(double least, double most) {
  return object({{"type", "integer"}, {"minimum", least}, {"maximum", most}});
}

Value json_of(const Unit* unit) { return unit == nullptr ? Value() : Value(unit->name); }

Value json_of(const std::vector<std::string>& texts) {
  Value list = Value::array();
  for (const std::string& t : texts) list.push(t);
  return list;
}

/// Puts what `read` makes of the value into `target`.
template <typename T>
Result<void> put_into(T& target, auto read) {
  AXIOMETRY_TRY(target, read);
  return {};
}

const Member<ImportColumn> column_members[] = {
    {"role", "What stands in the column.", [] { return choice(role_words); },
     [](const ImportColumn& c) { return Value(word_of(c.role)); },
     [](ImportColumn& c, const Value& v) { return put_into(c.role, one_of<ImportRole>(role_words, v)); }},
    {"name", "Its name in the header, which is then looked for in the file; left out: not compared.", string_schema,
     [](const ImportColumn& c) { return c.name.empty() ? Value() : Value(c.name); },
     [](ImportColumn& c, const Value& v) { return put_into(c.name, text_from(v)); }},
    {"unit", "Unit of its readings, where it is not reading_unit.", unit_choice,
     [](const ImportColumn& c) { return json_of(c.unit); },
     [](ImportColumn& c, const Value& v) { return put_into(c.unit, unit_from(v)); }},
    {"direction", "Direction of approach of all its readings.", [] { return choice(direction_names, true); },
     [](const ImportColumn& c) {
       return c.direction ? Value(direction_names[static_cast<std::size_t>(*c.direction)]) : Value();
     },
     [](ImportColumn& c, const Value& v) { return put_into(c.direction, one_of<Direction>(direction_names, v)); }},
    {"run", "Run of all its readings, counted from 1.", [] { return count_schema(1, most_runs); },
     [](const ImportColumn& c) { return c.run ? Value(*c.run) : Value(); },
     [](ImportColumn& c, const Value& v) { return put_into(c.run, count_from(v, 1, most_runs)); }},
};

/// Takes the members of an object; null leaves what there is. Fails on unknown names.
template <typename Owner, std::size_t n>
Result<void> take_members(Owner& owner, const Value& value, const Member<Owner> (&members)[n], std::string_view what) {
  if (!value.is(Kind::object)) return wrong(value, fmt::format("an object, {}", what));
  for (const auto& [name, item] : value.members()) {
    if (name == "$schema" || name == "format") continue;
    const auto member = std::ranges::find(members, std::string_view(name), &Member<Owner>::name);
    if (member == std::end(members)) {
      std::vector<std::string_view> names;
      for (const auto& m : members) names.push_back(m.name);
      const auto near = text::nearest(name, names);
      return fail(fmt::format("found the unknown member {} in {}, expected {}", text::quoted(name), what,
                              near ? fmt::format("perhaps {}", text::quoted(*near))
                                   : fmt::format("one of {}", fmt::join(names, ", "))),
                  item.at());
    }
    if (item.is(Kind::null)) continue;
    if (auto put = member->put(owner, item); !put)
      return fail(fmt::format("{} for {}", put.error().message, name), put.error().at);
  }
  return {};
}

template <typename Owner, std::size_t n>
void add_members(Value& target, const Owner& owner, const Member<Owner> (&members)[n], bool with_null) {
  for (const auto& member : members) {
    Value value = member.get(owner);
    if (with_null || !value.is(Kind::null)) target.add(member.name, std::move(value));
  }
}

template <typename Owner, std::size_t n>
Value members_schema(const Member<Owner> (&members)[n]) {
  Value properties = Value::object();
  for (const auto& member : members) {
    Value schema = member.schema();
    schema.add("description", member.description);
    properties.add(member.name, std::move(schema));
  }
  return properties;
}

Value columns_schema() {
  return object({{"type", "array"},
                 {"minItems", 1},
                 {"items", object({{"type", "object"},
                                   {"properties", members_schema(column_members)},
                                   {"required", Value::array({"role"})},
                                   {"additionalProperties", false}})}});
}

Value columns_to_json(const ImportProfile& profile) {
  Value list = Value::array();
  for (const ImportColumn& column : profile.columns)
    add_members(list.push(Value::object()), column, column_members, false);
  return list;
}

Result<void> take_columns(ImportProfile& profile, const Value& value) {
  if (!value.is(Kind::array)) return wrong(value, "an array of objects");
  profile.columns.clear();
  for (const Value& item : value.items())
    AXIOMETRY_TRY_VOID(take_members(profile.columns.emplace_back(), item, column_members, "a column"));
  return {};
}

using P = ImportProfile;

const Member<P> profile_members[] = {
    {"encoding", "Encoding of the text; auto finds it out.", [] { return choice(encoding_words); },
     [](const P& p) { return Value(word_of(p.encoding)); },
     [](P& p, const Value& v) { return put_into(p.encoding, one_of<TextEncoding>(encoding_words, v)); }},
    {"delimiter", "What stands between the columns.", [] { return choice(delimiter_words); },
     [](const P& p) { return Value(word_of(p.delimiter)); },
     [](P& p, const Value& v) { return put_into(p.delimiter, one_of<Delimiter>(delimiter_words, v)); }},
    {"decimal_mark", "Decimal mark of the numbers. With comma as delimiter too, every number has a comma of its own.",
     [] { return choice(mark_words); }, [](const P& p) { return Value(p.decimal_mark == ',' ? "comma" : "point"); },
     [](P& p, const Value& v) -> Result<void> {
       AXIOMETRY_TRY(const bool comma, one_of<bool>(mark_words, v));
       p.decimal_mark = comma ? ',' : '.';
       return {};
     }},
    {"comment", "Lines that begin with it are passed over; empty: none are.", string_schema,
     [](const P& p) { return Value(p.comment); },
     [](P& p, const Value& v) { return put_into(p.comment, text_from(v)); }},
    {"skip_lines", "Lines to pass over before anything is looked at.", [] { return count_schema(0, most_lines); },
     [](const P& p) { return Value(p.skip_lines); },
     [](P& p, const Value& v) { return put_into(p.skip_lines, count_from(v, 0, most_lines)); }},
    {"header_lines",
     "Lines of the header: 0 without one, 2 when a line of units follows the names. Where columns have names here, the "
     "header is the first line that holds them; else the first line that is no comment.",
     [] { return count_schema(0, 10); }, [](const P& p) { return Value(p.header_lines); },
     [](P& p, const Value& v) { return put_into(p.header_lines, count_from(v, 0, 10)); }},
    {"end", "A line that begins with it ends the table; empty: the file does.", string_schema,
     [](const P& p) { return Value(p.end); }, [](P& p, const Value& v) { return put_into(p.end, text_from(v)); }},
    {"layout",
     "long: one reading per row; wide: one column per run, one row per target; transposed: one row per run, the "
     "targets across in the header.",
     [] { return choice(layout_words); }, [](const P& p) { return Value(word_of(p.layout)); },
     [](P& p, const Value& v) { return put_into(p.layout, one_of<TableLayout>(layout_words, v)); }},
    {"columns", "From left to right. In a transposed table the last one stands for all that follow.", columns_schema,
     columns_to_json, take_columns},
    {"target_unit", "Unit of the targets.", unit_choice, [](const P& p) { return json_of(p.target_unit); },
     [](P& p, const Value& v) { return put_into(p.target_unit, unit_from(v)); }},
    {"reading_unit", "Unit of the readings.", unit_choice, [](const P& p) { return json_of(p.reading_unit); },
     [](P& p, const Value& v) { return put_into(p.reading_unit, unit_from(v)); }},
    {"direction",
     "Where the direction of approach comes from: a column; names of columns or labels of rows; motion, the step from "
     "the target before; visits to a target (transposed: rows) in turn; run-parity, runs counted one way each; or all "
     "approaches are up, or down.",
     [] { return choice(direction_rule_words, true); },
     [](const P& p) { return p.direction ? Value(word_of(*p.direction)) : Value(); },
     [](P& p, const Value& v) { return put_into(p.direction, one_of<DirectionRule>(direction_rule_words, v)); }},
    {"first_direction", "Direction of the first run or visit, for run-parity and visits.",
     [] { return choice(direction_names); },
     [](const P& p) { return Value(direction_names[static_cast<std::size_t>(p.first_direction)]); },
     [](P& p, const Value& v) { return put_into(p.first_direction, one_of<Direction>(direction_names, v)); }},
    {"up_words", "Words for up in the column of directions, beside the usual ones.", strings_schema,
     [](const P& p) { return json_of(p.up_words); },
     [](P& p, const Value& v) { return put_into(p.up_words, words_from(v)); }},
    {"down_words", "Words for down in the column of directions, beside the usual ones.", strings_schema,
     [](const P& p) { return json_of(p.down_words); },
     [](P& p, const Value& v) { return put_into(p.down_words, words_from(v)); }},
    {"runs",
     "Where the number of the run comes from: a column or label, names of columns, or the repetition of targets.",
     [] { return choice(run_rule_words); }, [](const P& p) { return Value(word_of(p.runs)); },
     [](P& p, const Value& v) { return put_into(p.runs, one_of<RunRule>(run_rule_words, v)); }},
    {"first_run", "Number of the first run in its column.", [] { return count_schema(0, 1); },
     [](const P& p) { return Value(p.first_run); },
     [](P& p, const Value& v) { return put_into(p.first_run, count_from(v, 0, 1)); }},
    {"sign", "1: readings are as they stand; -1: their sign is the other one (target minus actual).",
     [] {
       return object({{"enum", Value::array({1, -1})}});
     },
     [](const P& p) { return Value(p.sign); },
     [](P& p, const Value& v) -> Result<void> {
       if (!v.is(Kind::number) || (v.number() != 1.0 && v.number() != -1.0)) return wrong(v, "1 or -1");
       p.sign = v.number();
       return {};
     }},
};

std::size_t count_of(const ImportProfile& profile, ImportRole role) {
  return static_cast<std::size_t>(std::ranges::count(profile.columns, role, &ImportColumn::role));
}

Result<void> check_table(const ImportProfile& profile) {
  const bool transposed = profile.layout == TableLayout::transposed;
  for (const ImportRole role : {ImportRole::target, ImportRole::direction, ImportRole::run, ImportRole::time})
    if (const std::size_t n = count_of(profile, role); n > 1)
      return fail(fmt::format("found {} columns of the role {}, expected one", n, word_of(role)));
  const std::size_t deviations = count_of(profile, ImportRole::deviation);
  const std::size_t positions = count_of(profile, ImportRole::position);
  if (deviations > 0 && positions > 0)
    return fail("found columns of deviations and of positions, expected one of the two; the others are to be ignored");
  if (deviations + positions == 0) return fail("found no column of deviations or positions, expected one");
  if (!transposed && count_of(profile, ImportRole::target) == 0)
    return fail("found no column of the role target, expected one");
  if (!transposed && count_of(profile, ImportRole::label) > 0)
    return fail("found a column of the role label, expected it in a transposed table only");
  if (!transposed) return {};
  const ImportRole last = profile.columns.back().role;
  if ((last != ImportRole::deviation && last != ImportRole::position) || deviations + positions > 1)
    return fail("found a transposed table whose readings are not its last column, expected one that stands for all");
  if (count_of(profile, ImportRole::target) > 0 || profile.header_lines == 0)
    return fail("found a transposed table without its targets in the header, expected them there");
  return {};
}

}  // namespace

std::string_view word_of(TextEncoding encoding) { return encoding_words[static_cast<std::size_t>(encoding)]; }
std::string_view word_of(Delimiter delimiter) { return delimiter_words[static_cast<std::size_t>(delimiter)]; }
std::string_view word_of(TableLayout layout) { return layout_words[static_cast<std::size_t>(layout)]; }
std::string_view word_of(ImportRole role) { return role_words[static_cast<std::size_t>(role)]; }
std::string_view word_of(DirectionRule rule) { return direction_rule_words[static_cast<std::size_t>(rule)]; }
std::string_view word_of(RunRule rule) { return run_rule_words[static_cast<std::size_t>(rule)]; }

json::Value profile_to_json(const ImportProfile& profile) {
  Value root = object({{"format", profile_format_name}});
  add_members(root, profile, profile_members, true);
  return root;
}

std::string write_profile(const ImportProfile& profile) { return json::dump(profile_to_json(profile)) + "\n"; }

Result<ImportProfile> read_profile(std::string_view bytes) {
  AXIOMETRY_TRY(const std::string_view text, readable_text(bytes));
  AXIOMETRY_TRY(const Value root, json::parse(text));
  const Value* format = root.is(Kind::object) ? root.find("format") : nullptr;
  if (format == nullptr || !format->is(Kind::text) || format->text() != profile_format_name)
    return fail(fmt::format("found no \"format\": \"{}\", expected an import profile", profile_format_name),
                format != nullptr ? format->at() : root.at());
  ImportProfile profile;
  AXIOMETRY_TRY_VOID(take_members(profile, root, profile_members, "the profile"));
  const Value* columns = root.find("columns");
  AXIOMETRY_TRY_VOID(placed(check_table(profile), columns != nullptr ? columns->at() : root.at()));
  return profile;
}

std::string profile_schema() {
  Value properties = object({{"$schema", object({{"type", "string"}, {"description", "For editors; ignored."}})},
                             {"format", object({{"const", profile_format_name}})}});
  const Value members = members_schema(profile_members);
  for (const auto& [name, value] : members.members()) properties.add(name, value);
  const Value schema = object({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                               {"$id", "urn:axiometry:schema:axiometry-import-profile:1"},
                               {"title", "Axiometry import profile"},
                               {"description", "How a table of numbers in a file of an unknown layout is to be read."},
                               {"type", "object"},
                               {"properties", std::move(properties)},
                               {"required", Value::array({"format", "columns"})},
                               {"additionalProperties", false}});
  return json::dump(schema) + "\n";
}

}  // namespace axiometry::formats
