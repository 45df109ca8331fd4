// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/capture_keeping.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <ranges>
#include <set>

#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/live/disk/stop_marks.h"
#include "axiometry/app/recordings/raw_log.h"
#include "axiometry/app/workbench/test_of_file.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/format.h"
#include "axiometry/model/simulated.h"

namespace axiometry::app {
namespace {

constexpr std::size_t largest_recording = std::size_t{1} << 30;

/// A file of the recording as it will be called in the archive, and where a table's end names it.
struct Part {
  std::string name;
  std::string bytes;
  std::string TableEnd::* noted_as = &TableEnd::raw;
};

/// "X 2026-11-22 093005"
std::string name_of(const CaptureOrder& order) {
  std::string when = order.started.substr(0, 19);
  std::ranges::replace(when, 'T', ' ');
  std::erase(when, ':');
  const std::string of = order.lengths  ? order.lengths->title
                         : order.motion ? order.motion->error.text()
                                        : order.walked.axis.name;
  return file_name_part(fmt::format("{}{}{}", of, of.empty() ? "" : " ", when));
}

Result<std::vector<Part>> recording_of(const HeldCapture& held) {
  const std::string raw = held.raw();
  std::error_code none;
  std::vector<Part> parts;
  if (!std::filesystem::exists(raw, none) || std::filesystem::file_size(raw, none) == 0) return parts;
  const std::string name = name_of(held.order()) + ".raw";
  AXIOMETRY_TRY(std::string bytes, file_bytes(raw, largest_recording));
  parts.push_back({name, std::move(bytes)});
  if (has_times(raw)) {  // else lost, which the test tells
    AXIOMETRY_TRY(std::string times, file_bytes(times_name(raw), largest_recording));
    parts.push_back({times_name(name), std::move(times), &TableEnd::times});
  }
  if (has_marks(raw)) {
    AXIOMETRY_TRY(std::string keys, file_bytes(marks_name(raw), largest_recording));
    parts.push_back({marks_name(name), std::move(keys), &TableEnd::keys});
  }
  return parts;
}

store::By by_of(const CaptureOrder& order) {
  if (order.lengths) return {order.actor, fmt::format("captured from {}: {}", order.source, order.lengths->title)};
  return {order.actor, fmt::format("captured from {} after plan {}", order.source, order.plan)};
}

Test to_be_kept(const CaptureOrder& order, Test test) {
  if (order.source != simulator_source().id) return test;
  test.metadata.machine.name = simulated_machine(test.metadata.machine.name);
  return test;
}

std::string test_name(const CaptureOrder& order) { return name_of(order) + ".json"; }

/// A test that was noted, where the store has it.
Result<std::optional<store::Id>> noted_test(const store::Store& store, const HeldCapture& held) {
  return store.read([&](const store::Transaction& archive) {
    return test_of_file(archive, {test_name(held.order()), held.noted_tests()});
  });
}

/// One that was noted may come to the store only now, though the program that sent it was killed: so receive() looks
/// again while nobody else writes.
Result<store::Id> keep_test(Workbench& workbench, HeldCapture& held, const Test& test) {
  static const formats::Format* const json = formats::find_format("json");
  const CaptureOrder& order = held.order();
  const std::string bytes = json->write(to_be_kept(order, test));
  AXIOMETRY_TRY_VOID(held.note_test(sha256(bytes)));
  const Upload upload{
      .name = test_name(order), .bytes = bytes, .plan = order.plan, .perhaps_kept_as = held.noted_tests()};
  AXIOMETRY_TRY(const Received received, workbench.receive({&upload, 1}, by_of(order)));
  return received.tests.front().id;
}

Result<void> attach(Workbench& workbench, store::Id test, const std::vector<Part>& parts, const store::By& by) {
  AXIOMETRY_TRY(const auto documents, workbench.archive().documents(test));
  for (const Part& part : parts) {
    if (std::ranges::find(documents, part.name, &store::DocumentRecord::name) != documents.end()) continue;
    AXIOMETRY_TRY_VOID(workbench.attach(test, {part.name, std::string(octets), part.bytes}, by));
  }
  return {};
}

Result<std::optional<store::Id>> kept(Workbench& workbench, const HeldCapture& held) {
  AXIOMETRY_TRY(const auto test, noted_test(workbench.archive(), held));
  if (!test) return test;
  AXIOMETRY_TRY(const auto parts, recording_of(held));
  AXIOMETRY_TRY_VOID(attach(workbench, *test, parts, by_of(held.order())));
  return test;
}

Result<std::optional<store::Id>> keep(Workbench& workbench, const CapturedEnd& end) {
  AXIOMETRY_TRY(const auto before, kept(workbench, end.held));
  if (before) return before;
  const store::By by = by_of(end.held.order());
  AXIOMETRY_TRY(const auto parts, recording_of(end.held));
  if (end.test) {
    AXIOMETRY_TRY(const store::Id id, keep_test(workbench, end.held, *end.test));
    AXIOMETRY_TRY_VOID(attach(workbench, id, parts, by));
    return std::optional(id);
  }
  for (const Part& part : parts)
    AXIOMETRY_TRY_VOID(workbench.archive().keep({sha256(part.bytes), part.name, "recording", part.bytes}, by));
  return std::optional<store::Id>();
}

Result<std::string> keep_length_plan(Workbench& workbench, const CaptureOrder& order, const std::string& plan) {
  const std::string name = name_of(order) + ".plan.json";
  return workbench.archive().keep({sha256(plan), name, "length-plan", plan}, by_of(order));
}

/// Where lengths or readings come from stands above them. Readings say themselves when and from where; here no colon
/// stands behind a word that might be a key of theirs.
std::string told_table(const CaptureOrder& order, const FoundTable& table, const TableEnd& end) {
  if (order.motion) return fmt::format("# raw recording has SHA-256 {}\n", end.raw) + table.table;
  return fmt::format("# captured on {} from {}: {}\n# raw recording: SHA-256 {}\n", order.started, order.source,
                     order.lengths->title, end.raw) +
         table.table;
}

Result<TableEnd> keep_table(Workbench& workbench, const HeldCapture& held,
                               const std::optional<FoundTable>& found) {
  const CaptureOrder& order = held.order();
  AXIOMETRY_TRY(const std::vector<Part> parts, recording_of(held));
  const store::By by = by_of(order);
  TableEnd end;
  for (const Part& part : parts) {
    AXIOMETRY_TRY(end.*part.noted_as,
                  workbench.archive().keep({sha256(part.bytes), part.name, "recording", part.bytes}, by));
  }
  if (!found) return end;
  end.found = found->found;
  end.notes = found->notes;
  const std::string table = told_table(order, *found, end), name = name_of(order) + ".csv";
  AXIOMETRY_TRY(end.table, workbench.archive().keep(
                               {sha256(table), name, order.motion ? "motion-readings" : "lengths", table}, by));
  return end;
}

/// Under which names the archive keeps notes of captures that came to tables, and of those that are listed no more.
struct NotedAs {
  const char *listed, *discarded;
};
constexpr NotedAs of_lengths{"length-capture", "discarded-length-capture"};
constexpr NotedAs of_motions{"motion-capture", "discarded-motion-capture"};
constexpr const NotedAs& noted_as(const CaptureOrder& order) { return order.motion ? of_motions : of_lengths; }

Result<void> keep_note(Workbench& workbench, const CaptureOrder& order, const char* format, const std::string& bytes,
                       const store::By& by) {
  const std::string name = name_of(order) + ".capture.json";
  AXIOMETRY_TRY_VOID(workbench.archive().keep({sha256(bytes), name, format, bytes}, by));
  return {};
}

Result<std::vector<EndedCapture>> captures_noted_as(const store::Transaction& archive, const char* format,
                                                    bool listed) {
  std::vector<EndedCapture> captures;
  AXIOMETRY_TRY(const std::vector<std::string> hashes, archive.contents(format));
  for (const std::string& hash : hashes) {
    const auto content = archive.content(hash);
    // `store verify` tells it. Without a discard that cannot be read nothing may be listed: it could be any.
    if (!content && content.error().kind == ErrorKind::damaged && listed) continue;
    if (!content) return std::unexpected(content.error());
    if (auto capture = ended_capture_from(content->bytes)) captures.push_back(*std::move(capture));
  }
  return captures;
}

/// What was discarded is not listed, whichever of the notes came first; of one capture that came to two ends, since the
/// program was killed between them, the last.
Result<ArchivedCaptures> captures_of(const store::Store& store) {
  return store.read([](const store::Transaction& archive) -> Result<ArchivedCaptures> {
    ArchivedCaptures captures;
    for (const NotedAs& names : {of_lengths, of_motions}) {
      AXIOMETRY_TRY(std::vector<EndedCapture> listed, captures_noted_as(archive, names.listed, true));
      AXIOMETRY_TRY(std::vector<EndedCapture> discarded, captures_noted_as(archive, names.discarded, false));
      std::ranges::move(listed, std::back_inserter(captures.listed));
      std::ranges::move(discarded, std::back_inserter(captures.discarded));
    }
    std::set<std::string> seen;
    for (const EndedCapture& capture : captures.discarded) seen.insert(identity_of(capture.order));
    std::vector<EndedCapture> last;
    for (EndedCapture& capture : std::views::reverse(captures.listed))
      if (seen.insert(identity_of(capture.order)).second) last.push_back(std::move(capture));
    captures.listed.assign(std::make_move_iterator(last.rbegin()), std::make_move_iterator(last.rend()));
    std::ranges::stable_sort(captures.listed, {}, [](const EndedCapture& capture) { return capture.order.started; });
    return captures;
  });
}

}  // namespace

CaptureKeeping keeping_in(Workbench& workbench) {
  return {.keep = [&workbench](const CapturedEnd& end) { return keep(workbench, end); },
          .kept = [&workbench](const HeldCapture& held) { return kept(workbench, held); },
          .evaluate = [&workbench](const CaptureOrder& order, const Test& test) -> Result<Outcome> {
            Draft draft;
            const Test whole = to_be_kept(order, test);
            auto outcome = workbench.evaluate(whole, draft);
            if (outcome) return outcome;
            draft.options.gum = false;  // for which something is missing
            return workbench.evaluate(whole, draft);
          },
          .keep_plan = [&workbench](const CaptureOrder& order,
                                    const std::string& plan) { return keep_length_plan(workbench, order, plan); },
          .bytes = [&workbench](const std::string& sha256) -> Result<std::string> {
            AXIOMETRY_TRY(store::Content content, workbench.archive().content(sha256));
            return std::move(content.bytes);
          },
          .keep_table =
              [&workbench](const HeldCapture& held, const std::optional<FoundTable>& found) {
                return keep_table(workbench, held, found);
              },
          .keep_capture =
              [&workbench](const EndedCapture& capture) {
                return keep_note(workbench, capture.order, noted_as(capture.order).listed, text_of(capture),
                                 by_of(capture.order));
              },
          .discard_capture =
              [&workbench](const EndedCapture& capture, const std::string& actor) {
                return keep_note(workbench, capture.order, noted_as(capture.order).discarded, discard_text_of(capture),
                                 {actor, "discarded: " + by_of(capture.order).reason});
              },
          .captures = [&workbench] { return captures_of(workbench.archive()); }};
}

Result<std::string> captures_folder(const store::Info& store) {
  if (store.kind == "sqlite") return store.location + ".captures";
  const auto environment = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  const std::string state = environment("XDG_STATE_HOME"), home = environment("HOME");
  if (state.empty() && home.empty()) return fail("found no home folder for captures, expected XDG_STATE_HOME or HOME");
  const std::filesystem::path base =
      state.empty() ? std::filesystem::path(home) / ".local" / "state" : std::filesystem::path(state);
  return (base / "axiometry" / fmt::format("captures-{}", sha256(store.location).substr(0, 16))).string();
}

Result<Plan> captured_plan(const store::Store& store, const store::PlanRecord& record, Plan plan) {
  if (!record.axis) return plan;
  AXIOMETRY_TRY(const auto axis, store.get<store::AxisRecord>(*record.axis));
  AXIOMETRY_TRY(const auto machine, store.get<store::MachineRecord>(axis.value.machine));
  const auto name = [&](Plan& part) {
    part.machine = machine.value.name;
    part.axis.name = axis.value.name;
  };
  name(plan);
  std::ranges::for_each(plan.further, name);
  return plan;
}

}  // namespace axiometry::app
