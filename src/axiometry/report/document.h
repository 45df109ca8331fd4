// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/report/drawing/figure.h"

/// A report as a list of blocks, described once (compose.h) and set by every writer of documents.
/// Texts are UTF-8 as the user gave them; escaping is the writer's business.
namespace axiometry::report {

/// Text in several styles, as in the labels of figures.
using RichText = std::vector<TextRun>;

/// "x" upright, in one style.
RichText plain(std::string_view text);
RichText strong(std::string_view text);
RichText italic(std::string_view text);

/// What the user wrote: names, remarks, serial numbers, dates. It is never translated.
RichText verbatim(std::string_view text);

/// A symbol as it is typeset: "A↑" with an italic letter, "B̄" with a bar, "x̄_i↑" and "U_M,DEVICE" with an
/// index behind the underscore. An index of letters that count or name a coordinate (hijkmnxyz) is
/// italic, others are upright as arrows are.
RichText symbol(std::string_view text);

/// Running text in which words such as U_EVE are typeset as symbols.
RichText prose(std::string_view text);

/// A message as a sentence: prose() with a capital letter and a full stop.
RichText sentence(std::string_view message);

/// The parts one after the other.
RichText joined(std::initializer_list<RichText> parts);

/// The text without its styles; the bar becomes U+0304.
std::string plain_text(const RichText& text);

/// What a text means to its reader; writers choose the colour. Never the only sign of it.
enum class Tone { normal, quiet, good, caution, bad };

struct TableCell {
  RichText text;
  Tone tone = Tone::normal;
};

enum class Align {
  start,
  centre,
  decimal,  ///< numbers stand under each other at the decimal mark; other texts at the end
};

struct Column {
  RichText head;
  Align align = Align::start;
  bool names_row = false;    ///< the cell is the head of its row
  bool takes_space = false;  ///< running text: wraps, and takes what the others leave
  bool opens_group = false;  ///< a little more room before it
};

/// A head above several columns.
struct ColumnGroup {
  RichText head;  ///< may be empty
  std::size_t columns = 1;
};

struct Table {
  RichText caption;                 ///< may be empty where the section's title says it all
  std::vector<ColumnGroup> groups;  ///< empty, or covering all columns
  std::vector<Column> columns;
  std::vector<std::vector<TableCell>> rows;  ///< as many cells as columns
  std::vector<RichText> notes;               ///< notes below the table
  bool dense = false;                        ///< many columns or rows of numbers: set small
};

struct Fact {
  RichText name;
  TableCell value;
};

/// Names and values, one pair per line.
struct Facts {
  std::string title;  ///< may be empty
  std::vector<Fact> facts;
};

struct Paragraph {
  RichText text;
  Tone tone = Tone::normal;
};

/// What must not be overlooked.
struct Notice {
  Tone tone = Tone::normal;
  RichText heading;
  std::vector<RichText> lines;
};

using Block = std::variant<Paragraph, Notice, Facts, Table, Figure>;

struct Section {
  std::string id;  ///< ASCII, unique, for links: "parameters"
  std::string title;
  bool shows_results = false;  ///< the document's label stands beside the title
  std::vector<Block> blocks;
};

/// "Axiometry 0.1.0", which every document has at its foot.
std::string program_text();

struct Document {
  std::string kind = "Test report";  ///< what stands above the title, with the edition
  std::string title;
  std::string edition;         ///< "ISO 230-2:2014", or "Formulas of …" where the test departs from it
  std::vector<Fact> identity;  ///< axis, machine, date, … below the title
  std::vector<Notice> status;  ///< the label; whether the result may be called one of the standard; the verdict
  std::string label;           ///< Assessment::label; empty in the ordinary case
  std::string running_head;    ///< axis and machine, on every page
  std::string running_number;  ///< report number, on every page; may be empty
  std::string running_status;  ///< the status in a few words, on every page
  std::string date;            ///< date of the test, as given; may be empty
  std::string generator = program_text();
  std::vector<Section> sections;
};

/// Words that must stand wherever the results do: as the label, and first of what the document says of itself. Nothing
/// where they are empty.
void put_label(Document& document, std::string label);

/// How many characters a number has from its decimal mark on: 2 for "9.6" and "−4,1", 0 for "14".
/// Nothing when the text is no number, such as "not applicable".
std::size_t fraction_length(std::string_view number);
bool is_number(std::string_view text);

/// The largest fraction_length() among the numbers of a column.
std::size_t longest_fraction(const Table& table, std::size_t column);

}  // namespace axiometry::report
