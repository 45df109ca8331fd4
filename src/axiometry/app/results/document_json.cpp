// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/document_json.h"

#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "axiometry/report/drawing/dark_page.h"
#include "axiometry/report/drawing/svg.h"

namespace axiometry::app {
namespace {

using json::Value;
using report::RichText;

std::string_view tone_word(report::Tone tone) {
  switch (tone) {
    case report::Tone::quiet: return "quiet";
    case report::Tone::good: return "good";
    case report::Tone::caution: return "caution";
    case report::Tone::bad: return "bad";
    case report::Tone::normal: break;
  }
  return "normal";
}

std::string_view align_word(report::Align align) {
  switch (align) {
    case report::Align::centre: return "centre";
    case report::Align::decimal: return "decimal";
    case report::Align::start: break;
  }
  return "start";
}

/// The bar over a letter becomes U+0304, as everywhere in plain text.
Value run_to_json(const report::TextRun& run) {
  Value object = Value::object();
  object.add("text", report::plain_text({run}));
  if (run.italic) object.add("italic", true);
  if (run.bold) object.add("bold", true);
  if (run.script == report::Script::sub) object.add("script", "sub");
  if (run.script == report::Script::super) object.add("script", "super");
  return object;
}

template <typename Range, typename ToJson>
Value list_of(const Range& range, ToJson to_json) {
  Value list = Value::array();
  for (const auto& one : range) list.push(to_json(one));
  return list;
}

Value text_to_json(const RichText& text) { return list_of(text, run_to_json); }

Value cell_to_json(const report::TableCell& cell) {
  Value object = Value::object();
  object.add("text", text_to_json(cell.text));
  object.add("tone", tone_word(cell.tone));
  return object;
}

Value notice_to_json(const report::Notice& notice) {
  Value object = Value::object();
  object.add("tone", tone_word(notice.tone));
  object.add("heading", text_to_json(notice.heading));
  object.add("lines", list_of(notice.lines, text_to_json));
  return object;
}

struct BlockToJson {
  bool dark = false;

  static Value of_kind(std::string_view kind) {
    Value object = Value::object();
    object.add("kind", kind);
    return object;
  }

  Value operator()(const report::Paragraph& paragraph) const {
    Value object = of_kind("paragraph");
    object.add("tone", tone_word(paragraph.tone));
    object.add("text", text_to_json(paragraph.text));
    return object;
  }

  Value operator()(const report::Notice& notice) const {
    Value object = of_kind("notice");
    object.add("notice", notice_to_json(notice));
    return object;
  }

  Value operator()(const report::Facts& facts) const {
    Value object = of_kind("facts");
    object.add("title", facts.title);
    object.add("facts", list_of(facts.facts, [](const report::Fact& fact) {
                 Value one = Value::object();
                 one.add("name", text_to_json(fact.name));
                 one.add("value", cell_to_json(fact.value));
                 return one;
               }));
    return object;
  }

  Value operator()(const report::Table& table) const {
    Value object = of_kind("table");
    object.add("caption", text_to_json(table.caption));
    object.add("groups", list_of(table.groups, [](const report::ColumnGroup& group) {
                 Value one = Value::object();
                 one.add("head", text_to_json(group.head));
                 one.add("columns", group.columns);
                 return one;
               }));
    object.add("columns", list_of(table.columns, [](const report::Column& column) {
                 Value one = Value::object();
                 one.add("head", text_to_json(column.head));
                 one.add("align", align_word(column.align));
                 one.add("names_row", column.names_row);
                 one.add("takes_space", column.takes_space);
                 return one;
               }));
    object.add("rows", list_of(table.rows, [](const auto& row) { return list_of(row, cell_to_json); }));
    object.add("notes", list_of(table.notes, text_to_json));
    return object;
  }

  Value operator()(const report::Figure& figure) const {
    Value object = of_kind("figure");
    object.add("title", figure.title);
    object.add("description", figure.description);
    object.add("svg", report::to_svg(dark ? report::for_dark_page(figure) : figure));
    return object;
  }
};

}  // namespace

json::Value document_to_json(const report::Document& document, bool dark) {
  Value object = Value::object();
  object.add("kind", document.kind);
  object.add("title", document.title);
  object.add("edition", document.edition);
  object.add("status", list_of(document.status, notice_to_json));
  object.add("sections", list_of(document.sections, [dark](const report::Section& section) {
               Value one = Value::object();
               one.add("id", section.id);
               one.add("title", section.title);
               one.add("blocks", list_of(section.blocks, [dark](const report::Block& block) {
                         return std::visit(BlockToJson{dark}, block);
                       }));
               return one;
             }));
  return object;
}

}  // namespace axiometry::app
