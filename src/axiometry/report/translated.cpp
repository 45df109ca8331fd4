// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/translated.h"

#include <algorithm>

#include "axiometry/base/utf8.h"

namespace axiometry::report {
namespace {

constexpr char32_t first_private = 0xE000;
constexpr std::size_t private_length = 3;  // bytes in UTF-8
constexpr std::size_t most_in_style = 0x1000;

std::string private_character(std::size_t k) {
  const auto code = static_cast<unsigned>(first_private + k);
  return {static_cast<char>(0xE0 | (code >> 12)), static_cast<char>(0x80 | ((code >> 6) & 0x3F)),
          static_cast<char>(0x80 | (code & 0x3F))};
}

bool same_style(const TextRun& a, const TextRun& b) {
  return a.italic == b.italic && a.bold == b.bold && a.bar == b.bar && a.script == b.script && a.verbatim == b.verbatim;
}

bool is_plain(const TextRun& run) { return same_style(run, TextRun{}); }

bool same(const RichText& a, const RichText& b) {
  return std::ranges::equal(a, b,
                            [](const TextRun& x, const TextRun& y) { return same_style(x, y) && x.text == y.text; });
}

RichText without_empty(const RichText& text) {
  RichText kept;
  std::ranges::copy_if(text, std::back_inserter(kept), [](const TextRun& run) { return !run.text.empty(); });
  return kept;
}

/// "U_EVE", "x̄_i": as symbol() takes it. Only where prose() makes the same runs of it.
std::string in_words(const RichText& text) {
  std::string all;
  bool low = false;
  for (const TextRun& run : text) {
    if (run.script == Script::sub && !low) all += '_';
    low = run.script == Script::sub;
    all += run.text;
    if (run.bar) all += "\u0304";
  }
  return all;
}

bool shares_one_style(const RichText& text) {
  return std::ranges::all_of(text, [&](const TextRun& run) { return same_style(run, text.front()); });
}

/// Words in bold or italics within a text; symbols and the user's words are left.
RichText words_translated(RichText runs, const Options& options) {
  for (TextRun& run : runs)
    if (!run.verbatim && run.script == Script::normal && !run.bar) run.text = translated(run.text, options);
  return runs;
}

/// The runs of a style of their own in the places of their private-use characters.
RichText set_again(std::string_view text, const std::vector<RichText>& in_style, const Options& options) {
  RichText all;
  std::size_t done = 0;
  const auto add_plain = [&](std::size_t end) {
    if (end > done) all.push_back({.text = std::string(text.substr(done, end - done))});
  };
  for (std::size_t at = 0; at < text.size();) {
    const Character character = character_at(text, at);
    const bool stands_for_runs =
        character.valid() && character.code >= first_private && character.code < first_private + in_style.size();
    if (stands_for_runs) {
      add_plain(at);
      const RichText runs =
          words_translated(in_style[static_cast<std::size_t>(character.code - first_private)], options);
      all.insert(all.end(), runs.begin(), runs.end());
      done = at + private_length;
    }
    at += character.length;
  }
  add_plain(text.size());
  return all;
}

void translate(RichText& text, const Options& options) { text = translated(text, options); }
void translate(std::string& text, const Options& options) { text = translated(text, options); }
void translate(TableCell& cell, const Options& options) { translate(cell.text, options); }
void translate(Paragraph& paragraph, const Options& options) { translate(paragraph.text, options); }

void translate(std::vector<RichText>& texts, const Options& options) {
  for (RichText& text : texts) translate(text, options);
}

void translate(Notice& notice, const Options& options) {
  translate(notice.heading, options);
  translate(notice.lines, options);
}

void translate(std::vector<Fact>& facts, const Options& options) {
  for (Fact& fact : facts) {
    translate(fact.name, options);
    translate(fact.value, options);
  }
}

void translate(Facts& facts, const Options& options) {
  translate(facts.title, options);
  translate(facts.facts, options);
}

void translate(Table& table, const Options& options) {
  translate(table.caption, options);
  for (ColumnGroup& group : table.groups) translate(group.head, options);
  for (Column& column : table.columns) translate(column.head, options);
  for (auto& row : table.rows)
    for (TableCell& cell : row) translate(cell, options);
  translate(table.notes, options);
}

void translate(Figure& figure, const Options& options) {
  translate(figure.title, options);
  translate(figure.description, options);
}

}  // namespace

Figure with_words_translated(Figure figure, const Options& options) {
  translate(figure, options);
  return figure;
}

FlatText flattened(const RichText& given) {
  const RichText text = without_empty(given);
  if (text.empty()) return {};
  const bool user_wrote = std::ranges::any_of(text, &TextRun::verbatim);
  if (std::string words = in_words(text);
      !user_wrote && (shares_one_style(text) || same(without_empty(prose(words)), text)))
    return {std::move(words), {}};
  FlatText flat;
  bool continues = false;
  for (const TextRun& run : text) {
    if (is_plain(run)) {
      flat.text += run.text;
      continues = false;
      continue;
    }
    continues = continues && !run.verbatim && !flat.in_style.back().back().verbatim;
    if (!continues) {
      if (flat.in_style.size() == most_in_style) return {plain_text(text), {}};
      flat.text += private_character(flat.in_style.size());
      flat.in_style.emplace_back();
    }
    flat.in_style.back().push_back(run);
    continues = true;
  }
  return flat;
}

std::string_view colon(const Options& options) {
  return options.language == language::Language::french ? "\u00A0: " : ": ";
}

std::string_view semicolon(const Options& options) {
  return options.language == language::Language::french ? "\u00A0; " : "; ";
}

std::string translated(std::string_view text, const Options& options) {
  return language::translated(text, options.language, options.numbers);
}

RichText translated(const RichText& given, const Options& options) {
  if (options.language == language::Language::english) return given;
  const RichText text = without_empty(given);
  if (text.empty()) return given;
  if (shares_one_style(text)) {
    if (text.front().verbatim) return given;
    TextRun run = text.front();
    run.text = translated(plain_text(text), options);
    return run.bar || run.script != Script::normal ? given : RichText{run};
  }
  const FlatText flat = flattened(text);
  if (!flat.in_style.empty()) return set_again(translated(flat.text, options), flat.in_style, options);
  const std::string words = translated(flat.text, options);
  return words == flat.text ? given : prose(words);
}

Document translated(Document document, const Options& options) {
  if (options.language == language::Language::english) return document;
  for (std::string* text :
       {&document.kind, &document.title, &document.edition, &document.label, &document.running_status})
    translate(*text, options);
  translate(document.identity, options);
  for (Notice& notice : document.status) translate(notice, options);
  for (Section& section : document.sections) {
    translate(section.title, options);
    for (Block& block : section.blocks) std::visit([&](auto& part) { translate(part, options); }, block);
  }
  return document;
}

}  // namespace axiometry::report
