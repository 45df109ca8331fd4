// SPDX-License-Identifier: Apache-2.0
//
// Reports of many kinds in German: nothing in them stays English but what the user wrote.
#include "axiometry/report/translated.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "axiometry/language/words.h"
#include "axiometry/model/fields.h"
#include "axiometry/report/conformity_text.h"
#include "axiometry/report/documents/compose.h"
#include "axiometry/report/documents/plan_sheet.h"
#include "axiometry/report/drawing/picture.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/standards/readings/reading_correction.h"
#include "tests/support/document_parts.h"
#include "tests/support/made_up_monte_carlo.h"
#include "tests/support/report_subject.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing_support::made_up_monte_carlo;
using testing_support::make_series;
using testing_support::Reported;
using testing_support::reported;
using testing_support::reported_table2;
using testing_support::reported_without_metadata;
using testing_support::tolerance;
namespace table2 = testing_support::table2;

constexpr auto german = language::Language::german;
const Options in_german{.numbers = {.decimal_mark = ','}, .language = german};

/// As a phrase book sees it, with its arguments by number: "Uncertainty of {0}".
std::string told(const language::TextPieces& text) {
  std::string all;
  for (const language::TextPiece& piece : text)
    if (const auto* words = std::get_if<std::string>(&piece))
      all += *words;
    else
      all += fmt::format("{{{}}}", std::get<language::TextArgument>(piece).number);
  return all;
}

using Texts = std::set<language::TextPieces>;

void collect(Texts& all, const std::string& text) { all.insert({text}); }

void collect(Texts& all, const RichText& text) {
  if (!text.empty() && !std::ranges::all_of(text, &TextRun::verbatim)) all.insert(with_arguments(text).pieces);
}

void collect(Texts& all, const Table& table) {
  collect(all, table.caption);
  for (const ColumnGroup& group : table.groups) collect(all, group.head);
  for (const Column& column : table.columns) collect(all, column.head);
  for (const auto& row : table.rows)
    for (const TableCell& cell : row) collect(all, cell.text);
  for (const RichText& note : table.notes) collect(all, note);
}

void collect(Texts& all, const std::vector<Fact>& facts) {
  for (const Fact& fact : facts) {
    collect(all, fact.name);
    collect(all, fact.value.text);
  }
}

void collect(Texts& all, const Notice& notice) {
  collect(all, notice.heading);
  for (const RichText& line : notice.lines) collect(all, line);
}

void collect(Texts& all, const Block& block) {
  if (const auto* paragraph = std::get_if<Paragraph>(&block)) collect(all, paragraph->text);
  if (const auto* notice = std::get_if<Notice>(&block)) collect(all, *notice);
  if (const auto* table = std::get_if<Table>(&block)) collect(all, *table);
  if (const auto* facts = std::get_if<Facts>(&block)) {
    collect(all, facts->title);
    collect(all, facts->facts);
  }
  if (const auto* figure = std::get_if<Figure>(&block)) {
    collect(all, figure->title);
    collect(all, figure->description);
  }
}

/// Every text of a composed English document that a reader of German must not meet.
Texts texts_of(const Document& document) {
  Texts all = {{document.kind}, {document.title}, {document.edition}, {document.label}, {document.running_status}};
  collect(all, document.identity);
  for (const Notice& notice : document.status) collect(all, notice);
  for (const Section& section : document.sections) {
    collect(all, section.title);
    for (const Block& block : section.blocks) collect(all, block);
  }
  return all;
}

std::vector<std::string> unknown(const Document& document) {
  std::vector<std::string> all;
  for (const language::TextPieces& text : texts_of(document))
    if (!language::is_known(text, german)) all.push_back(told(text));
  return all;
}

std::set<std::string> labels_of(const Figure& figure) {
  std::set<std::string> all;
  for (const Operation& operation : figure.operations)
    if (const auto* text = std::get_if<Text>(&operation)) all.insert(told(with_arguments(text->runs).pieces));
  return all;
}

/// Labels with words that a German figure shares with the English one.
std::vector<std::string> english_labels(const Document& in_english, const Document& document) {
  const auto labels = [](const Document& d) {
    std::set<std::string> all;
    for (const Section& section : d.sections)
      for (const Block& block : section.blocks)
        if (const auto* figure = std::get_if<Figure>(&block)) all.merge(labels_of(*figure));
    return all;
  };
  const std::set<std::string> there = labels(document);
  std::vector<std::string> all;
  for (const std::string& label : labels(in_english)) {
    const bool same_in_german = label.starts_with("Position") || label.starts_with("GUM");
    if (there.contains(label) && !language::has_no_words(label) && !same_in_german) all.push_back(label);
  }
  return all;
}

using Compose = std::function<Document(const Options&)>;

void expect_german(const Compose& compose) {
  const Document english = compose({});
  EXPECT_THAT(unknown(english), IsEmpty());
  EXPECT_THAT(english_labels(english, compose(in_german)), IsEmpty());
}

void expect_german(const Reported& reported) {
  expect_german([&](const Options& options) { return compose(reported.subject(), options); });
}

Reported with_methods(Reported reported, bool gum, bool monte_carlo) {
  if (gum) reported.assessment.gum = iso230_2::gum(reported.test, reported.assessment.evaluation).value();
  if (monte_carlo) {
    reported.assessment.monte_carlo = made_up_monte_carlo(reported.assessment.evaluation);
    reported.assessment.monte_carlo->notes.clear();
  }
  return reported;
}

Reported judged(Reported reported, uncertainty::DecisionRule::Kind kind) {
  uncertainty::DecisionRule rule;
  rule.kind = kind;
  rule.guard_band = 1.5;
  reported.judge({tolerance("A", 10), tolerance("E", 5), tolerance("R_up", 1), tolerance("M", 100)}, rule);
  return reported;
}

TEST(GermanReport, OfTable2IsComplete) { expect_german(reported_table2()); }

TEST(GermanReport, WithoutMetadataIsComplete) { expect_german(reported_without_metadata()); }

TEST(GermanReport, WithEveryMethodOfUncertaintyIsComplete) {
  expect_german(with_methods(reported_table2(), true, false));
  expect_german(with_methods(reported_table2(), false, true));
  expect_german(with_methods(reported_table2(), true, true));
}

TEST(GermanReport, WithTolerancesIsCompleteByEveryRule) {
  using Kind = uncertainty::DecisionRule::Kind;
  for (const Kind kind : {Kind::simple, Kind::iso_14253_1, Kind::guard_band})
    for (const bool methods : {false, true}) {
      expect_german(judged(with_methods(reported_table2(), methods, methods), kind));
      expect_german(judged(reported_without_metadata(), kind));
    }
}

Reported rotary() {
  axiometry::Test test = table2::complete_test();
  std::vector<double> targets;
  for (int k = 0; k < 9; ++k) targets.push_back(40.0 * k);
  const std::vector<testing_support::RunDeviations> runs(5, testing_support::RunDeviations(9, 1.5));
  test.series = make_series(targets, runs, runs);
  test.metadata.axis = {};
  test.metadata.axis.name = "C";
  test.metadata.axis.kind = AxisKind::rotary;
  test.metadata.uncertainty.device_calibration = Deviation::native(1);
  return reported(std::move(test));
}

TEST(GermanReport, OfARotaryAxisIsComplete) {
  expect_german(rotary());
  expect_german(with_methods(rotary(), true, false));
}

TEST(GermanReport, OfOneDirectionIsComplete) {
  expect_german(reported({{}, make_series(table2::targets, table2::up, {}), {}}));
  expect_german(reported({{}, make_series(table2::targets, {}, table2::down), {}}));
}

TEST(GermanReport, OfOneApproachIsComplete) {
  axiometry::Test test = table2::complete_test();
  test.series = make_series(table2::targets, {table2::up[0]}, {table2::down[0]});
  expect_german(reported(std::move(test)));
}

TEST(GermanReport, OfManyRunsIsComplete) {
  std::vector<testing_support::RunDeviations> runs;
  for (int k = 0; k < 30; ++k) runs.push_back(table2::up[static_cast<std::size_t>(k) % 5]);
  expect_german(reported({{}, make_series(table2::targets, runs, runs), {}}));
}

TEST(GermanReport, OfEveryCycleIsComplete) {
  for (const TestCycle cycle :
       {TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional, TestCycle::user_defined}) {
    axiometry::Test test = table2::complete_test();
    test.metadata.conditions.cycle = cycle;
    expect_german(with_methods(reported(std::move(test)), false, true));
  }
}

TEST(GermanReport, OfCorrectedReadingsIsComplete) {
  axiometry::Test test = table2::complete_test();
  test.metadata.nde.applied = false;
  test.metadata.instrument.refractive_index = 1.000271;
  test.metadata.instrument.dead_path = Length::mm(120);
  test.metadata.instrument.gain = 1.01;
  test.metadata.instrument.sign_reversed = true;
  for (const AirEquation equation : {AirEquation::ciddor, AirEquation::edlen}) {
    const auto corrected =
        correct_readings(test, {.air = equation, .dead_path = true, .expansion = true, .drift = true});
    ASSERT_TRUE(corrected) << corrected.error().to_string();
    expect_german(reported(*corrected));
  }
  expect_german(reported(correct_readings(test, {.sign = true, .gain = true}).value()));
}

TEST(GermanReport, OfADiagonalIsComplete) {
  axiometry::Test test = table2::complete_test();
  test.metadata.axis.line_origin_mm = {0, 0, 0};
  test.metadata.axis.line_direction = {1, 1, 0};
  expect_german(reported(test));
  test.metadata.axis.name.clear();
  test.metadata.tracking.station_position = Position::native(900);
  test.metadata.tracking.station_uncertainty_mm = {0.1, 0.2};
  expect_german(with_methods(reported(test), true, false));
}

TEST(GermanReport, OfATestThatDepartsInManyWaysIsComplete) {
  axiometry::Test test = table2::complete_test();
  std::vector<double> targets;
  for (int k = 0; k < 5; ++k) targets.push_back(500.0 * k);
  auto up = std::vector<testing_support::RunDeviations>(4, testing_support::RunDeviations(5, 1.0));
  for (std::size_t j = 0; j < up.size(); ++j)
    for (std::size_t i = 0; i < 5; ++i) up[j][i] = static_cast<double>(j) + 0.1 * static_cast<double>(i);
  auto down = up;
  down[1][2] = std::numeric_limits<double>::quiet_NaN();
  down.pop_back();
  test.series = make_series(targets, up, down);
  test.metadata.axis.travel_begin = Position::native(0);
  test.metadata.axis.travel_end = Position::native(2000);
  test.metadata.axis.compensation_points = {0, 500, 1000};
  test.metadata.nde.applied = false;
  test.metadata.equipment = {{"", "", "", ""}, {"optics", "", "T", ""}};
  expect_german(reported(test));
  test.metadata.nde.applied.reset();
  test.metadata.environment.sensors = {{"", "", {}, {}}, {"machine", "", Temperature::celsius(24), {}}};
  test.metadata.uncertainty = {};
  expect_german(reported(test));
  test.metadata.nde.applied = true;
  expect_german(reported(test));
}

iso230_2::PlanRequest plan_request(double from, double to, AxisKind kind = AxisKind::linear) {
  iso230_2::PlanRequest request;
  request.axis.name = "X";
  request.axis.kind = kind;
  request.axis.travel_begin = Position::native(from);
  request.axis.travel_end = Position::native(to);
  request.machine = "Mill";
  request.seed = 7;
  return request;
}

void expect_german_sheet(const Plan& plan) {
  const auto findings = iso230_2::plan_findings(plan);
  const Duration duration = iso230_2::estimated_duration(plan);
  expect_german([&](const Options& options) { return plan_sheet({plan, findings, duration, duration}, options); });
}

TEST(GermanPlanSheet, IsComplete) {
  for (const auto& request : {plan_request(0, 800), plan_request(0, 5000), plan_request(0, 360, AxisKind::rotary),
                              plan_request(-720, 720, AxisKind::rotary)}) {
    const auto plan = iso230_2::make_plan(request);
    ASSERT_TRUE(plan) << plan.error().to_string();
    expect_german_sheet(*plan);
  }
  for (const TestCycle cycle : {TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional}) {
    auto request = plan_request(0, 800);
    request.cycle = cycle;
    request.dwell = Duration::s(0);
    request.warm_up_runs = 0;
    expect_german_sheet(iso230_2::make_plan(request).value());
  }
  auto periodic = plan_request(0, 800);
  periodic.axis.expected_period = Position::native(10);
  periodic.periodic.emplace();
  expect_german_sheet(iso230_2::make_plan(periodic).value());
}

TEST(GermanMetadata, HasATitleAndADescriptionForEveryField) {
  for (const Field& field : metadata_fields()) {
    EXPECT_TRUE(language::is_known(field.title, german)) << field.title;
    EXPECT_TRUE(language::is_known(field.description, german)) << field.description;
    for (const RecordColumn& column : field.columns)
      EXPECT_TRUE(language::is_known(column.title, german)) << column.title;
  }
}

/// What a user may write that reads like the program's own words.
Reported like_the_programs_words() {
  axiometry::Test test = table2::complete_test();
  test.metadata.axis.name = "Value";
  test.metadata.machine.name = "Reversal error";
  test.metadata.machine.serial_number = "3.5 to 4.5";
  test.metadata.conditions.inspector = "Test report";
  test.metadata.conditions.comment = "found 4 runs, expected 5";
  test.metadata.conditions.report_number = "Findings";
  test.metadata.equipment = {{"machine", "Missing", "Note", ""}};
  test.provenance.file = "Figures";
  return reported(std::move(test));
}

TEST(GermanReport, KeepsWhatTheUserWrote) {
  Reported report = like_the_programs_words();
  report.options = in_german;
  const std::string html = report.written("html");
  for (const char* word :
       {"Reversal error", "3.5 to 4.5", "Test report", "found 4 runs, expected 5", "Bericht Findings", "Missing",
        "Note", "Figures", "Value (Linearachse)", "Achse Value · Reversal error", "Position Value / ",
        "Wiederholpräzision, Achse Value", "machine ohne Hersteller und Seriennummer"})
    EXPECT_THAT(html, HasSubstr(word));
  for (const char* word : {"3,5 bis", "3,5 to", "Achse Wert", "Umkehrspanne ·", "Bericht Feststellungen"})
    EXPECT_THAT(html, Not(HasSubstr(word)));
}

TEST(GermanReport, TellsWhereLimitsComeFrom) {
  using enum iso230_2::ToleranceSource;
  for (const auto source : {axis, table, test, entered, user}) {
    const std::string words = fmt::format("Limits: A, R from the {}.", source_title(source));
    EXPECT_TRUE(language::is_known(words, german)) << words;
  }
  EXPECT_TRUE(language::is_known("Limits: A, R from the limits of the axis as of 2026-11-26.", german));
}

TEST(GermanReport, TellsEquipmentThatWasOutOfCalibration) {
  axiometry::Test test = table2::complete_test();
  test.metadata.conditions.date = "2014-05-15";
  test.metadata.equipment = {{"Laser", "M", "", "9", "C", "2012-01-01", "2013-01-01"},
                             {"", "M", "T", "8", "C", "2015-01-01", ""}};
  Reported report = reported(std::move(test));
  report.options = in_german;
  const std::string html = report.written("html");
  for (const char* words : {"Prüfung am 2014-05-15, an dem die Kalibrierung ihrer Messmittel nicht galt",
                            "Laser (2012-01-01 – 2013-01-01); T (2015-01-01 – …)",
                            "Messmittel nicht vollständig bezeichnet: Laser ohne Typ"})
    EXPECT_THAT(html, HasSubstr(words));
  EXPECT_THAT(html, Not(HasSubstr("Found ")));
}

TEST(GermanReport, IsMarkedAsGerman) {
  Reported report = reported_table2();
  report.options = in_german;
  const std::string html = report.written("html");
  EXPECT_THAT(html, HasSubstr("<html lang=\"de\">"));
  EXPECT_THAT(html, HasSubstr("\"Seite \" counter(page) \" von \" counter(pages)"));
  EXPECT_THAT(html, HasSubstr("Prüfbericht · ISO 230-2:2014"));
  EXPECT_THAT(reported_table2().written("html"), HasSubstr("<html lang=\"en\">"));
}

TEST(GermanPicture, HasGermanTitles) {
  Reported report = reported_table2();
  report.options = in_german;
  EXPECT_THAT(report.written("svg"), HasSubstr("Bild 3b."));
  EXPECT_THAT(report.written("svg"), HasSubstr("Geprüft in Übereinstimmung mit ISO 230-2:2014"));
}

TEST(GermanPlanSheet, SaysItsLabelInTheFootToo) {
  auto request = plan_request(0, 800);
  request.cycle = TestCycle::pilgrim;
  const Plan plan = iso230_2::make_plan(request).value();
  const Duration duration = iso230_2::estimated_duration(plan);
  const auto findings = iso230_2::plan_findings(plan);
  const Document sheet = translated(plan_sheet({plan, findings, duration, duration}, in_german), in_german);
  EXPECT_EQ(sheet.running_status,
            "Prüfplan · Begriffe von ISO 230-2:2014 · Pilgerschrittzyklus, nicht für die Abnahme");
}

TEST(GermanCsv, IsTheEnglishOne) {
  Reported report = reported_table2();
  const std::string english = report.written("csv");
  report.options.language = german;
  EXPECT_EQ(report.written("csv"), english);
}

TEST(Translated, KeepsSymbolsInTheirStyleAndMovesThem) {
  const RichText text = translated(joined({plain("Uncertainty of "), symbol("A↑")}), in_german);
  EXPECT_EQ(plain_text(text), "Unsicherheit von A↑");
  ASSERT_EQ(text.size(), 3u);
  EXPECT_TRUE(text[1].italic);
  const RichText note = translated(sentence("U_MISALIGNMENT grows as 1/L and is not negligible under 300 mm: 2.5 µm at "
                                            "L = 100 mm"),
                                   in_german);
  EXPECT_THAT(plain_text(note), HasSubstr("2,5\u00a0µm bei L = 100\u00a0mm."));
  const auto low = std::ranges::find(note, Script::sub, &TextRun::script);
  ASSERT_NE(low, note.end());
  EXPECT_EQ(low->text, "MISALIGNMENT");
}

TEST(Translated, TakesNoCharacterOfTheUserForARunInItsStyle) {
  for (const char* character : {"\uE000", "\xFF\x80\x80", "\x1f", "\xFF"}) {
    const std::string quoted = fmt::format("'{}'", character);
    const RichText text = translated(joined({plain("Uncertainty of "), symbol("A↑"), plain("; " + quoted)}), in_german);
    EXPECT_EQ(plain_text(text), "Unsicherheit von A↑; " + quoted);
    EXPECT_EQ(std::ranges::count(text, true, &TextRun::italic), 1);
    EXPECT_EQ(plain_text(translated(joined({verbatim(character), plain(": Reversal error")}), in_german)),
              std::string(character) + ": Umkehrspanne");
  }
}

TEST(Translated, MovesRunsInTheirStyleByTheirNumbers) {
  const RichText text = translated(joined({plain("from "), symbol("B̄"), plain(" to "), symbol("x_i")}), in_german);
  EXPECT_EQ(plain_text(text), plain_text(joined({plain("von "), symbol("B̄"), plain(" bis "), symbol("x_i")})));
  EXPECT_EQ(std::ranges::count(text, Script::sub, &TextRun::script), 1);
}

TEST(Translated, ChangesNothingInEnglish) {
  const Reported report = reported_table2();
  const Document document = compose(report.subject(), {});
  EXPECT_EQ(texts_of(translated(document, {})), texts_of(document));
}

}  // namespace
}  // namespace axiometry::report
