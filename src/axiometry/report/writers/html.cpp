// SPDX-License-Identifier: Apache-2.0
// One self-contained page: style and figures inline, no script, nothing loaded from elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <type_traits>

#include "axiometry/report/documents/compose.h"
#include "axiometry/report/drawing/html_text.h"
#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/writer.h"
#include "axiometry/report/writers/html_style.h"

namespace axiometry::report {

namespace html {
namespace {

constexpr std::size_t rows_kept_together = 30;  // in print, where they fit on a page

std::string_view tone_class(Tone tone) {
  switch (tone) {
    case Tone::normal: return "";
    case Tone::quiet: return "quiet";
    case Tone::good: return "good";
    case Tone::caution: return "caution";
    case Tone::bad: return "bad";
  }
  return "";
}

/// ` class="a b"`, or nothing when no class is left.
std::string class_attribute(std::initializer_list<std::string_view> classes) {
  std::string names;
  for (std::string_view name : classes)
    if (!name.empty()) names += fmt::format("{}{}", names.empty() ? "" : " ", name);
  return names.empty() ? "" : fmt::format(" class=\"{}\"", names);
}

void append(std::string& out, const std::vector<Fact>& facts, std::string_view list_class) {
  out += fmt::format("<dl class=\"{}\">\n", list_class);
  for (const Fact& fact : facts)
    out += fmt::format("<div><dt>{}</dt><dd{}>{}</dd></div>\n", rich(fact.name),
                       class_attribute({tone_class(fact.value.tone)}), rich(fact.value.text));
  out += "</dl>\n";
}

void append(std::string& out, const Paragraph& paragraph) {
  out += fmt::format("<p{}>{}</p>\n", class_attribute({tone_class(paragraph.tone)}), rich(paragraph.text));
}

void append(std::string& out, const Notice& notice) {
  out += fmt::format("<div{} role=\"note\">\n<p class=\"lead\">{}</p>\n",
                     class_attribute({"notice", tone_class(notice.tone)}), rich(notice.heading));
  if (notice.lines.size() == 1) {
    out += fmt::format("<p>{}</p>\n", rich(notice.lines.front()));
  } else if (!notice.lines.empty()) {
    out += "<ul>\n";
    for (const RichText& line : notice.lines) out += fmt::format("<li>{}</li>\n", rich(line));
    out += "</ul>\n";
  }
  out += "</div>\n";
}

void append(std::string& out, const Facts& facts) {
  out += "<div class=\"facts\">\n";
  if (!facts.title.empty()) out += fmt::format("<h3>{}</h3>\n", escaped(facts.title));
  append(out, facts.facts, "list");
  out += "</div>\n";
}

std::string_view align_class(const Column& column) {
  if (column.align == Align::decimal) return "number";
  return column.align == Align::centre ? "centre" : "";
}

/// Columns and their heads, the group heads above them.
void append_head(std::string& out, const Table& table) {
  out += "<thead>\n";
  if (!table.groups.empty()) {
    out += "<tr>";
    for (const ColumnGroup& group : table.groups) {
      const bool empty = group.head.empty();
      out += fmt::format("<{0} colspan=\"{1}\"{2}{3}>{4}</{0}>", empty ? "td" : "th", group.columns,
                         empty ? "" : " scope=\"colgroup\"", class_attribute({"group", empty ? "" : "ruled"}),
                         rich(group.head));
    }
    out += "</tr>\n";
  }
  out += "<tr>";
  for (const Column& column : table.columns)
    out += fmt::format("<th scope=\"col\"{}>{}</th>",
                       class_attribute({align_class(column), column.opens_group ? "opens" : ""}), rich(column.head));
  out += "</tr>\n</thead>\n";
}

/// What a number lacks behind its last digit to end where the longest of its column ends; shown as
/// invisible text, which aligns in every font.
std::string pad_attribute(const TableCell& cell, std::size_t longest) {
  const std::string text = plain_text(cell.text);
  const std::size_t missing = is_number(text) ? longest - fraction_length(text) : 0;
  if (missing == 0) return "";
  const bool lacks_mark = fraction_length(text) == 0;
  return fmt::format(" data-pad=\"{}{}\"", lacks_mark ? "." : "", std::string(missing - (lacks_mark ? 1 : 0), '0'));
}

void append_rows(std::string& out, const Table& table) {
  std::vector<std::size_t> longest;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    longest.push_back(table.columns[c].align == Align::decimal ? longest_fraction(table, c) : 0);
  out += "<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const Column& column = table.columns[c];
      const std::string_view tag = column.names_row ? "th" : "td";
      out += fmt::format("<{0}{1}{2}{3}>{4}</{0}>", tag, column.names_row ? " scope=\"row\"" : "",
                         class_attribute({align_class(column), tone_class(row[c].tone),
                                          column.takes_space ? "long" : "", column.opens_group ? "opens" : ""}),
                         column.align == Align::decimal ? pad_attribute(row[c], longest[c]) : "", rich(row[c].text));
    }
    out += "</tr>\n";
  }
  out += "</tbody>\n";
}

/// Characters side by side in the widest row, by which print chooses the size of dense tables.
std::size_t characters_across(const Table& table) {
  std::size_t all = 0;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t widest = length(plain_text(table.columns[c].head));
    for (const auto& row : table.rows) widest = std::max(widest, length(plain_text(row[c].text)));
    all += widest + (table.columns[c].opens_group ? 2 : 1);
  }
  return all;
}

/// A table without a caption of its own is named after its section, for those who listen.
void append(std::string& out, const Table& table, std::string_view section_title) {
  const std::string name = escaped(table.caption.empty() ? section_title : plain_text(table.caption));
  const std::string_view whole = table.rows.size() <= rows_kept_together ? " whole" : "";
  out += fmt::format("<div class=\"scroll{}\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n", whole, name);
  out += table.dense ? fmt::format("<table class=\"dense\" style=\"--chars:{}\">\n", characters_across(table))
                     : "<table>\n";
  out += table.caption.empty() ? fmt::format("<caption class=\"unseen\">{}</caption>\n", name)
                               : fmt::format("<caption>{}</caption>\n", rich(table.caption));
  append_head(out, table);
  append_rows(out, table);
  out += "</table>\n</div>\n";
  if (table.notes.empty()) return;
  out += "<div class=\"notes\">\n";
  for (const RichText& note : table.notes) out += fmt::format("<p>{}</p>\n", rich(note));
  out += "</div>\n";
}

void append(std::string& out, const Figure& figure) {
  out += fmt::format(
      "<figure>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n{1}\n</div>\n"
      "<figcaption>{0}</figcaption>\n</figure>\n",
      escaped(figure.title), to_svg(figure));
}

void append(std::string& out, const Block& block, std::string_view section_title) {
  if (const auto* table = std::get_if<Table>(&block)) return append(out, *table, section_title);
  std::visit(
      [&]<typename T>(const T& other) {
        if constexpr (!std::is_same_v<T, Table>) append(out, other);
      },
      block);
}

void append(std::string& out, const Section& section, const std::string& label) {
  out += fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 id=\"{0}-title\">{1}", section.id,
                     escaped(section.title));
  if (section.shows_results && !label.empty()) out += fmt::format(" <span class=\"label\">{}</span>", escaped(label));
  out += "</h2>\n";
  bool in_columns = false;
  for (std::size_t b = 0; b < section.blocks.size(); ++b) {
    const bool facts = std::holds_alternative<Facts>(section.blocks[b]);
    const bool more = b + 1 < section.blocks.size() && std::holds_alternative<Facts>(section.blocks[b + 1]);
    if (facts && !in_columns && more) {
      out += "<div class=\"columns\">\n";
      in_columns = true;
    }
    append(out, section.blocks[b], section.title);
    if (in_columns && !more) {
      out += "</div>\n";
      in_columns = false;
    }
  }
  out += "</section>\n";
}

/// Running heads and page numbers, for browsers that print them.
std::string page_rules(const Document& document, const Options& options) {
  // "Page 1 of 3", of which the browser counts the numbers
  const std::string words = translated("Page 0 of 0", options);
  const std::size_t first = words.find('0'), last = words.rfind('0');
  const std::string counted = fmt::format("{} counter(page) {} counter(pages)", css_string(words.substr(0, first)),
                                          css_string(words.substr(first + 1, last - first - 1)));
  return fmt::format(
      "@page{{size:A4;margin:19mm 15mm 17mm;font:7.5pt Arial,\"Liberation Sans\",sans-serif;color:#5d6670;"
      "@top-left{{content:{}}}@top-right{{content:{}}}@bottom-left{{content:{}}}"
      "@bottom-right{{content:{}}}}}\n"
      "@page :first{{@top-left{{content:none}}@top-right{{content:none}}}}\n",
      css_string(document.running_head), css_string(document.running_number), css_string(document.running_status),
      counted);
}

std::string page(const Document& document, const Options& options) {
  std::string out;
  out.reserve(1 << 17);
  out += fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n",
      language::tag(options.language));
  out += fmt::format("<meta name=\"generator\" content=\"{}\">\n<title>{} – {}</title>\n<style>",
                     escaped(document.generator), escaped(document.running_head), escaped(document.title));
  out += html_style;
  out += page_rules(document, options);
  out += "</style>\n</head>\n<body>\n<div class=\"sheet\">\n<header>\n";
  out += fmt::format("<p class=\"kicker\">{} · {}</p>\n<h1>{}</h1>\n", escaped(document.kind),
                     escaped(document.edition), escaped(document.title));
  append(out, document.identity, "identity");
  for (const Notice& notice : document.status) append(out, notice);
  out += "</header>\n<main>\n";
  for (const Section& section : document.sections) append(out, section, document.label);
  out += fmt::format("</main>\n<footer>{}</footer>\n</div>\n</body>\n</html>\n", escaped(document.generator));
  return out;
}

Result<std::string> write(const Subject& subject, const Options& options) {
  return page(translated(compose(subject, options), options), options);
}

Result<std::string> set(const Document& document, const Options& options) {
  return page(translated(document, options), options);
}

}  // namespace
}  // namespace html

extern const Writer html_writer;
const Writer html_writer = {"html", "Web page, self-contained, prints on A4", &html::write, &html::set};

}  // namespace axiometry::report
