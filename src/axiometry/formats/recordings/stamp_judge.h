// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Which of the stamps of a stream are wrong: one digit that a disturbed cable changed must cost one line, not all
/// those behind it.
namespace axiometry::formats {

/// A line whose stamp (a time in s, or a counter) is judged.
struct StampedLine {
  double stamp = 0.0;
  double position = 0.0;
  double arrival_s = std::numeric_limits<double>::quiet_NaN();  ///< NaN where it is not known
  std::size_t line = 0;
  double told = 0.0;  ///< the stamp as the line has it
};

/// Stamps grow. Each line waits for those behind it, which decide:
///
/// - It is settled by the next line that does not run back behind it.
/// - When two lines that follow each other lie between the line settled before and the one that waits, that one had run
///   ahead: it is rejected.
/// - Lines that run back are rejected when the next one is in order again. When five of them follow each other, the
///   clock of the source was set, or the source began anew: they are taken, and their time goes on behind the line
///   before by as long as arrivals say that it took, or one step.
/// - A clock that was set ahead leaves a gap in the time; where arrivals are known that is told.
///
/// The result depends on the lines alone, so that a recording gives again what the live stream gave.
class StampJudge {
 public:
  enum class Kind {
    times,   ///< s; a stamp may be repeated
    counts,  ///< never repeated; nothing is known of how long a source was away
  };
  explicit StampJudge(Kind kind) : kind_(kind) {}

  /// The lines that this one settles, in order, until the next call.
  std::span<const StampedLine> push(StampedLine line);
  /// What waits is settled: lines are missing here, or there are no more. What ran back is rejected.
  std::span<const StampedLine> flush();

  /// What the stamp of the next line should be compared with; nullptr before the first.
  const StampedLine* base() const { return last_ ? &*last_ : waiting_ ? &*waiting_ : nullptr; }
  std::size_t rejected() const { return rejected_; }
  std::size_t rejected_in_a_row() const { return rejected_in_a_row_; }
  /// Sentences of what was rejected and of clocks that were set; empty when all was in order.
  std::vector<std::string> remarks() const;

 private:
  bool follows(const StampedLine& line, const StampedLine& before) const;
  void settle(const StampedLine& line);
  void reject(const StampedLine& line);
  void reject_doubtful();
  void doubt(const StampedLine& line);
  void take_doubtful(double shift);
  double shift_of_new_clock() const;

  Kind kind_;
  double shift_ = 0.0;  // shift of times since the clock was set
  std::optional<StampedLine> last_, waiting_;
  std::vector<StampedLine> doubtful_, settled_;
  std::size_t rejected_ = 0, rejected_in_a_row_ = 0, first_rejected_ = 0;
  std::size_t clocks_ = 0, first_clock_ = 0;  // set back
  std::size_t leaps_ = 0, first_leap_ = 0;    // set ahead
};

}  // namespace axiometry::formats
