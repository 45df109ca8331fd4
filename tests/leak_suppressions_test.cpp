// SPDX-License-Identifier: Apache-2.0

/// Read by the leak sanitizer. Fontconfig keeps its caches until the process ends; nothing of ours is
/// excused.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the name is the sanitizer's
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
