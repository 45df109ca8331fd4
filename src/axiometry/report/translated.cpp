// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/translated.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace axiometry::report {
namespace {

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

/// The runs of a style of their own where the translation has them.
RichText set_again(const language::TextPieces& pieces, const std::vector<RichText>& in_style, const Options& options) {
  RichText all;
  for (const language::TextPiece& piece : pieces)
    if (const auto* words = std::get_if<std::string>(&piece)) {
      all.push_back({.text = *words});
    } else {
      const RichText& given = in_style.at(std::get<language::TextArgument>(piece).number);
      const RichText runs = words_translated(given, options);
      all.insert(all.end(), runs.begin(), runs.end());
    }
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

TextWithArguments with_arguments(const RichText& given) {
  const RichText text = without_empty(given);
  if (text.empty()) return {};
  const bool user_wrote = std::ranges::any_of(text, &TextRun::verbatim);
  if (std::string words = in_words(text);
      !user_wrote && (shares_one_style(text) || same(without_empty(prose(words)), text)))
    return {{std::move(words)}, {}};
  TextWithArguments all;
  const TextRun* before = nullptr;
  for (const TextRun& run : text) {
    const bool after_plain = before != nullptr && is_plain(*before);
    if (is_plain(run)) {
      if (!after_plain) all.pieces.emplace_back(std::string());
      std::get<std::string>(all.pieces.back()) += run.text;
    } else {
      const bool continues = before != nullptr && !after_plain && !run.verbatim && !before->verbatim;
      if (!continues) {
        all.pieces.emplace_back(language::TextArgument{all.arguments.size()});
        all.arguments.emplace_back();
      }
      all.arguments.back().push_back(run);
    }
    before = &run;
  }
  return all;
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
  const auto [pieces, arguments] = with_arguments(text);
  if (!arguments.empty())
    return set_again(language::translated(pieces, options.language, options.numbers), arguments, options);
  const std::string& english = std::get<std::string>(pieces.front());
  const std::string words = translated(english, options);
  return words == english ? given : prose(words);
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
