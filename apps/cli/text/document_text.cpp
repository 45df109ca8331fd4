// SPDX-License-Identifier: Apache-2.0
#include "cli/text/document_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/translated.h"
#include "cli/text/flags_of_words.h"

namespace axiometry::cli {
namespace {

using report::Tone;

std::string text_of(const report::RichText& text) { return report::printable(report::plain_text(text)); }

std::string toned(const std::string& s, Tone tone, const Terminal& terminal) {
  switch (tone) {
    case Tone::quiet: return terminal.faint(s);
    case Tone::good: return terminal.green(s);
    case Tone::caution: return terminal.yellow(s);
    case Tone::bad: return terminal.red(s);
    case Tone::normal: break;
  }
  return s;
}

class TableText {
 public:
  TableText(const report::Table& table, const Terminal& terminal) : table_(table), terminal_(terminal) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      std::size_t width = display_width(text_of(table.columns[c].head));
      for (const auto& row : table.rows) width = std::max(width, display_width(cell(row, c)));
      widths_.push_back(width);
    }
    // The head of a group may be wider than its columns: the last of them gets the rest.
    std::size_t column = 0;
    for (const auto& group : table.groups) {
      const std::size_t missing = display_width(text_of(group.head)), have = width_of(column, group.columns);
      column += group.columns;
      if (missing > have) widths_[column - 1] += missing - have;
    }
  }

  std::string text() const {
    std::string s;
    if (!table_.caption.empty()) s += wrapped(text_of(table_.caption), terminal_.width(), 0) + "\n";
    if (!table_.groups.empty()) s += group_heads();
    std::string heads;
    for (std::size_t c = 0; c < widths_.size(); ++c) heads += gap(c) + placed(text_of(table_.columns[c].head), c);
    s += terminal_.faint(trimmed(heads)) + "\n";
    for (const auto& row : table_.rows) {
      std::string line;
      for (std::size_t c = 0; c < widths_.size(); ++c) line += gap(c) + placed(cell(row, c), c, row[c].tone);
      s += trimmed(line) + "\n";
    }
    for (const auto& note : table_.notes) s += terminal_.faint(wrapped(text_of(note), terminal_.width(), 0)) + "\n";
    return s;
  }

 private:
  static std::string trimmed(std::string s) {
    s.erase(s.find_last_not_of(' ') + 1);
    return s;
  }

  /// With blanks behind, so that decimal marks stand under each other.
  std::string cell(const std::vector<report::TableCell>& row, std::size_t c) const {
    std::string s = text_of(row[c].text);
    if (table_.columns[c].align != report::Align::decimal || !report::is_number(s)) return s;
    return s + std::string(report::longest_fraction(table_, c) - report::fraction_length(s), ' ');
  }

  std::string gap(std::size_t c) const { return c == 0 ? "" : table_.columns[c].opens_group ? "    " : "  "; }

  std::size_t width_of(std::size_t first, std::size_t count) const {
    std::size_t width = 0;
    for (std::size_t c = first; c < first + count; ++c) width += widths_[c] + (c > first ? gap(c).size() : 0);
    return width;
  }

  std::string placed(const std::string& s, std::size_t c, Tone tone = Tone::normal) const {
    const std::string whole =
        table_.columns[c].align == report::Align::decimal ? right(s, widths_[c]) : left(s, widths_[c]);
    return toned(whole, tone, terminal_);
  }

  std::string group_heads() const {
    std::string line;
    std::size_t column = 0;
    for (const auto& group : table_.groups) {
      line += gap(column) + left(text_of(group.head), width_of(column, group.columns));
      column += group.columns;
    }
    return terminal_.faint(trimmed(line)) + "\n";
  }

  const report::Table& table_;
  const Terminal& terminal_;
  std::vector<std::size_t> widths_;
};

struct BlockText {
  const Terminal& terminal;

  std::string operator()(const report::Paragraph& p) const {
    return toned(wrapped(text_of(p.text), terminal.width(), 0), p.tone, terminal) + "\n";
  }
  std::string operator()(const report::Notice& n) const {
    std::string s = toned(wrapped(text_of(n.heading), terminal.width(), 0), n.tone, terminal) + "\n";
    for (const auto& line : n.lines) s += "  " + wrapped(text_of(line), terminal.width(), 2) + "\n";
    return s;
  }
  std::string operator()(const report::Facts& f) const { return facts(f.facts); }
  std::string operator()(const report::Table& t) const { return TableText(t, terminal).text(); }
  std::string operator()(const report::Figure&) const { return {}; }

  std::string facts(const std::vector<report::Fact>& list) const {
    std::size_t width = 0;
    for (const auto& f : list) width = std::max(width, display_width(text_of(f.name)));
    std::string s;
    for (const auto& f : list) s += left(text_of(f.name), width) + "  " + text_of(f.value.text) + "\n";
    return s;
  }
};

/// Behind sentences of the composed document that speak of what flags give, these: looked up before it is translated.
void put_flags(report::RichText& said, const report::RichText& composed) {
  const std::string flags = flags_of_words(report::plain_text(composed));
  if (!flags.empty()) said = report::joined({said, report::verbatim(" (" + flags + ")")});
}

void put_flags(report::Block& said, const report::Block& composed) {
  if (auto* paragraph = std::get_if<report::Paragraph>(&said))
    put_flags(paragraph->text, std::get<report::Paragraph>(composed).text);
  if (auto* notice = std::get_if<report::Notice>(&said))
    for (std::size_t i = 0; i < notice->lines.size(); ++i)
      put_flags(notice->lines[i], std::get<report::Notice>(composed).lines[i]);
}

/// The document in the reader's language, block for block as it was composed.
report::Document in_reader_language(const report::Document& composed, const report::Options& options) {
  report::Document document = report::translated(composed, options);
  for (std::size_t s = 0; s < document.sections.size(); ++s)
    for (std::size_t b = 0; b < document.sections[s].blocks.size(); ++b)
      put_flags(document.sections[s].blocks[b], composed.sections[s].blocks[b]);
  return document;
}

}  // namespace

std::string document_text(const report::Document& composed, const report::Options& options, const Terminal& terminal) {
  const report::Document document = in_reader_language(composed, options);
  const BlockText blocks{terminal};
  std::string s = terminal.bold(report::printable(document.title)) + "\n";
  if (!document.edition.empty())
    s += terminal.faint(wrapped(report::printable(document.edition), terminal.width(), 0)) + "\n";
  s += blocks.facts(document.identity);
  for (const auto& section : document.sections)
    for (const auto& block : section.blocks)
      if (const std::string text = std::visit(blocks, block); !text.empty()) s += "\n" + text;
  for (const auto& notice : document.status) s += "\n" + blocks(notice);
  return s;
}

}  // namespace axiometry::cli
