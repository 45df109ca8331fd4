// SPDX-License-Identifier: Apache-2.0
// The API's shapes, described for others in apps/server/openapi.json. Values of parameters and deviations are in the
// axis' native unit ("um" or "arcsec"), positions in mm or °. Times are RFC 3339 in UTC. What does not exist is null.

export type Parameter =
  | 'A' | 'A_up' | 'A_down' | 'E' | 'E_up' | 'E_down' | 'M' | 'R' | 'R_up' | 'R_down' | 'B' | 'B_mean';
export type Verdict = 'conforms' | 'does not conform' | 'undecided';
/** How an uncertainty was found; "annex-a", … where it is chosen by `uncertainty.method`. */
export type Method = 'annex_a' | 'gum' | 'monte_carlo';
/** Who stated a limit, the one that gives way to all others first: the test's own file, entered for this test, … */
export type LimitSource = 'axis' | 'table' | 'test' | 'entered' | 'user';
export type ErrorKind =
  | 'bad_input' | 'not_found' | 'conflict' | 'read_only' | 'full' | 'unavailable' | 'damaged' | 'refused';

/** Every answer with a status of 400 or more. */
export interface Failure {
  error: { kind: ErrorKind; message: string; file: string | null; line: number | null; column: number | null };
}

// GET /api/health
export interface Health {
  status: 'ok';
  program: { name: string; version: string };
  store: { kind: 'sqlite' | 'postgresql'; location: string; schema: number; writable: boolean; why_not: string | null;
           counts: { machines: number; axes: number; instruments: number; plans: number; tests: number; documents: number; content_bytes: number } };
  limits: { upload_bytes: number };
  token: boolean;                          // whether one is asked for; who has not shown it is told the status alone
}
// POST /api/login {token} → 204 and a cookie, or 401; POST /api/logout → 204. Without the token all else answers 401.

// GET /api/vocabulary: what there is to choose from. Titles and descriptions in the language of the request.
export interface Vocabulary {
  parameters: { key: Parameter; symbol: string; title: string; clause: string }[];
  fields: Field[];
  formats: { id: string; title: string; extensions: string; manual: string; writes: boolean }[];
  writers: { extension: string; title: string }[];
  dialects: { id: string; title: string; extension: string; axes: string; has_loops: boolean; manual: string }[];
  corrections: { id: string; title: string }[];
  cycles: { id: string; title: string }[];
  rules: { id: string; title: string }[];
}
export interface Field {
  key: string; group: string; title: string;
  type: 'text' | 'number' | 'boolean' | 'choice' | 'numbers' | 'records';
  unit_linear: string; unit_rotary: string; clause: string;
  minimum: number | null; maximum: number | null; choices: string[];
  columns: { key: string; title: string; type: 'text' | 'number'; unit: string }[];
  description: string; wanted: boolean;
}

// A result as `axiometry evaluate --json` writes it (docs/results.md), with the members a page needs most.
export interface Result {
  standard: string;
  axis: { name: string; kind: 'linear' | 'rotary' };
  unit: 'um' | 'arcsec';
  conforming: boolean;
  label?: string;
  parameters: Record<Parameter, number | null>;
  uncertainty: {
    record?: UncertaintyOfRecord;                      // what stands with the results and decides; all else is for comparison
    inputs?: ResolvedInput[];                          // what was stated, and what counts of it
    annex_a?: Record<Parameter, number | null> | null;
    gum?: Record<Parameter, { value: number; u: number; U: number; k: number; nu_eff: number | null } | null> | null;
    monte_carlo?: Record<Parameter, MonteCarloOutput | null> | null;
    annex_a_budget?: AnnexABudget | null;
    gum_budget?: GumBudget | null;
    monte_carlo_run?: MonteCarloRun | null;
  };
  positions: PositionResult[];
  tolerances?: Judgement[];
  findings: Finding[];
  claims?: Claim[];                        // absent: `conforming` alone
  information?: { smaller_repeatability?: { value: number; unit: string; text: string } | null };
  metadata: Record<string, unknown>;
  source: { file: string; sha256: string | null; format: string; [key: string]: unknown };
  program: { name: string; version: string };
  [key: string]: unknown;
}
/** Of the method of record, whose U is null where it states an interval alone; in µm or ″. */
export interface UncertaintyOfRecord {
  method: Method | null; chosen: boolean;
  parameters: Record<Parameter, { u: number; U: number | null; low: number; high: number } | null>;
}
/** A statement about the uncertainty: which methods take it, and where it comes from; words in the reader's language. */
export interface ResolvedInput {
  key: string; symbol: string; title?: string; value: number | string; unit: string;
  origin: string; origin_title?: string; use: 'all' | 'annex-a' | 'gum-and-monte-carlo' | 'none'; use_title?: string;
}
export interface MonteCarloOutput {
  value: number; mean: number; u: number; bias: number; low?: number; high?: number; refusal?: string;
  symmetric: [number, number]; shortest: [number, number];   // of one hypothesis about the noise; low to high holds for all
  stable: boolean; histogram: { lower: number; width: number; counts: number[] };
}
export interface MonteCarloRun {
  trials: number; seed: number | string; stable: boolean; coverage: number; notes: string[];
  hypotheses?: { key: string; title: string; refuted: boolean }[];
  contributions: { key: string; title: string; u: Record<Parameter, number | null> }[];
}
export interface AnnexABudget {
  contributors: { key: string; symbol: string; title: string; formula: string; U: number | null;
                  inputs: { symbol: string; value: number; unit: string }[] }[];
  notes: string[]; runs: number; coverage_factor: number;
}
export interface GumBudget {
  sources: { key: string; symbol: string; title: string; source: string; distribution: string | null; u: number; unit: string; note: string }[];
  contributions: { key: string; u: Record<Parameter, number | null> }[];
  notes: string[]; [key: string]: unknown;
}
export interface PositionResult {
  target: number; n_up: number; n_down: number;
  mean_up: number | null; mean_down: number | null; mean: number | null; reversal: number | null;
  s_up: number | null; s_down: number | null; R_up: number | null; R_down: number | null; R: number | null;
}
/** As app/wire.cpp spells them: see docs/results.md, "tolerances". */
export interface Judgement { parameter: Parameter; limit: number; verdict: string; [key: string]: unknown }
/** What a result may be called, and what it lacks where it may not. */
export interface Claim { key: 'computed' | 'tested' | 'reported'; title: string; holds: boolean; missing: string[] }
export interface Finding { clause: string; severity: 'departure' | 'missing' | 'note'; message: string }

/** Deviations as they were read; rows are targets, columns runs; null where there is none. */
export interface Readings {
  targets: number[];
  up: (number | null)[][];
  down: (number | null)[][];
  as_measured: { up: (number | null)[][]; down: (number | null)[][] } | null;  // before corrections, where there were any
}

export interface Evaluated {
  result: Result;
  readings: Readings;
  verdict: Verdict | null;                 // of all tolerances together
  shown: Shown[];
  from_archive?: FromArchive;              // what it took from the archive beside the test itself
  milliseconds: number;                    // the evaluation took
}

/** A parameter as people read it, with the uncertainty of record, and what it was held against. */
export interface Shown {
  parameter: Parameter; value: string; U: string; interval: string; unit: string;
  low: number | null; high: number | null; method: Method | null;
  limit: number | null; source: LimitSource | null; replaced: ReplacedLimit[] | null;
  verdict: Verdict | null;
  withheld: string | null;                 // why nothing is decided, although there is a value
}
/** A limit of the same parameter that another one has taken the place of. */
export interface ReplacedLimit { limit: number; source: LimitSource }

/** Inputs of instruments that neither the file nor the changes state, calibrations that held on the day of the test, and
 *  the limits of the axis, each of which holds where nothing else limits its parameter (the source "axis"). They are
 *  kept with a version as they were on its day. */
export interface FromArchive {
  instruments: { instrument: number; version: number; name: string; inputs: Changes }[];
  calibrations: Calibration[];
  axis: { axis: number; version: number; limits: Limit[] } | null;
}

/** Of a component of the test equipment, by its place in the list from 1. */
export interface Calibration {
  component: number; instrument: number; version: number;
  certificate: string; calibrated_on: string; calibration_due: string;
}

/** How a test is evaluated, beside its metadata. */
export interface Options {
  methods: ('gum' | 'monte-carlo')[];      // Annex A is always there
  trials: number | null;                   // null: until two digits are stable
  seed: number;
  coverage: number;                        // 0.95
  corrections: string[];                   // "nde", "air=ciddor", …: as --correct
}

/** Over what the file says: key and text as `--set` takes them; "" takes the value away. A list of records (equipment,
 *  sensors) has a record per line, "cell | cell", and takes the place of the file's. */
export type Changes = Record<string, string>;

/** How a table of any layout is read: docs/howto/import-any-file.md. What is not decided is null. */
export interface ImportProfile {
  format: string; delimiter: 'comma' | 'semicolon' | 'tab' | 'blanks'; decimal_mark: 'point' | 'comma';
  layout: 'long' | 'wide' | 'transposed'; columns: ImportColumn[];
  target_unit: string | null; reading_unit: string | null;
  direction: 'column' | 'names' | 'motion' | 'visits' | 'run-parity' | 'up' | 'down' | null;
  first_direction: 'up' | 'down'; up_words: string[]; down_words: string[];
  runs: 'column' | 'names' | 'repetition'; first_run: number; sign: 1 | -1;
  [key: string]: unknown;
}
export interface ImportColumn {
  role: 'ignore' | 'target' | 'deviation' | 'position' | 'direction' | 'run' | 'time' | 'label';
  name?: string; unit?: string; direction?: 'up' | 'down'; run?: number;
}
/** The first rows of a table, what is known of its columns (guessed, or as it was said), and what only a person knows. */
export interface AskedTable {
  profile: ImportProfile; questions: { key: string; text: string }[]; names: string[]; rows: string[][];
}

// POST /api/preview (the file's bytes; X-File-Name: percent-encoded name; or multipart/form-data with the file and a
// part "profile", the JSON of an ImportProfile): nothing is kept.
export interface Preview {
  file: { name: string; size: number; sha256: string };
  format: { id: string; title: string } | null;
  refused: Failure['error'] | null;        // then tests is empty
  tests: { name: string; axis: string; kind: 'linear' | 'rotary'; machine: string; measured_on: string;
           targets: number; runs: number; readings: number; first: number; last: number; unit: string;
           evaluated: Evaluated | null }[];   // evaluated: of the first eight
  same_content: number[];                  // ids of tests with these very bytes
  table: AskedTable | null;                // of a refused table, and of one read after a guess or a profile
}

// POST /api/tests[?plan=ID] (bytes with X-File-Name, or multipart/form-data with one or more files: all are kept, or
// when one is refused none; with a part "profile" beside a single file it is read by that ever after) → 201
export interface Received extends Evaluated {
  id: number; version: number;             // of the first test in the file
  tests: { id: number; version: number; title: string; same_content: number[] }[];  // whose file had these very bytes
  same_content?: number[];                 // tests that had these very bytes before
}
// POST /api/evaluations?draft={"changes":…,"options":…}&test=NAME (bytes as above) → Evaluated: nothing is kept
// Requests with ?decimal=comma|point: numbers in `shown` and in reports; else as the language of the request has them.

// GET /api/tests?text=&machine=&axis=&instrument=&from=&to=&verdict=&withdrawn=&order=&descending=&offset=&limit=
export interface TestPage { tests: TestRow[]; total: number }
export interface TestRow {
  id: number; version: number; title: string; file_name: string;
  machine: { id: number; name: string } | null; axis: { id: number; name: string; kind: string } | null;
  unit: 'um' | 'arcsec'; measured_on: string; received_at: string;
  conforming: boolean; withdrawn: boolean; verdict: Verdict | null; label: string;
  figures: FigureOfTest[];
}
/** With the uncertainty of record: U is null where its method states the interval alone. */
export interface FigureOfTest {
  parameter: Parameter; value: number; U: number | null; low: number | null; high: number | null; method: Method | null;
  limit: number | null; verdict: Verdict | null;
}

export interface Change { at: string; actor: string; reason: string }

// GET /api/tests/{id}[?version=]
export interface Test extends Evaluated {
  id: number; version: number; latest: number; title: string;
  file: { name: string; sha256: string; size: number; format: string; name_in_file: string; profile: ImportProfile | null };
  received: Change; versions: (Change & { version: number })[]; withdrawn: boolean;
  machine: { id: number; name: string } | null; axis: { id: number; name: string; kind: string; limits: Limit[] } | null;
  instruments: { id: number; name: string; calibration_due: string }[];
  plan: number | null;
  changes: Changes; options: Options;
  documents: Document[];
}
export interface Limit { parameter: Parameter; value: number }
export interface Document {
  id: number; test: number; version: number; kind: 'report' | 'attachment'; name: string; media_type: string;
  language: string; sha256: string; size: number; change: Change;
}

// POST /api/tests/{id}/evaluate {changes, options} → Evaluated: a draft, nothing is kept
export interface Draft { changes: Changes; options: Options }
// POST /api/tests/{id}/versions → 201 Test; 409 when base_version is no longer the latest
export interface Revision extends Draft { base_version: number; title: string; reason: string; plan?: number | null }
// POST /api/tests/{id}/withdraw {reason}, /api/tests/{id}/reinstate {reason} → Test
// GET  /api/tests/{id}/raw → the bytes as they came
// GET  /api/tests/{id}/report.{html|pdf|svg|png|csv|json|…}?version=&language=de&decimal=comma&unit=mm&download=1
// GET  /api/tests/{id}/figures?version= → {figures: {id, title}[]};  /api/tests/{id}/figures/{id}.svg?version=&theme=dark
// POST /api/tests/{id}/reports {extension, language, decimal, unit} → 201 Document (issued: kept as it is for good)
// POST /api/tests/{id}/attachments (bytes, X-File-Name, Content-Type) → 201 Document
// GET  /api/documents/{id} → its bytes

// GET /api/machines → {machines: Machine[]}; POST; GET /api/machines/{id}; PUT with base_version and reason;
// GET /api/machines/{id}/versions. The same for /api/axes, /api/instruments.
export interface Entity { id: number; version: number; change: Change }
export interface Machine extends Entity {
  name: string; manufacturer: string; type: string; serial_number: string; controller: string; location: string; notes: string;
  axes: Axis[];                            // in answers only
  tests: number; latest_test: { id: number; measured_on: string; verdict: Verdict | null } | null;  // in answers only
}
export interface Axis extends Entity { machine: number; name: string; kind: 'linear' | 'rotary'; limits: Limit[]; notes: string }
export interface Instrument extends Entity {
  role: string; manufacturer: string; type: string; serial_number: string; certificate: string;
  calibrated_on: string; calibration_due: string; inputs: Changes; notes: string;
}
export type Edit<T extends Entity> = Omit<T, 'id' | 'version' | 'change' | 'axes' | 'tests' | 'latest_test'> & { base_version?: number; reason?: string };

// GET /api/axes/{id}/trend?parameters=A,E,R,B&limit=500
export interface Trend {
  axis: Axis; machine: { id: number; name: string }; unit: 'um' | 'arcsec';
  points: { test: number; version: number; title: string; measured_on: string; received_at: string; conforming: boolean;
            verdict?: Verdict | null;      // of all limits together, also of parameters that the test does not have
            label: string; figures: FigureOfTest[] }[];
}

// A plan's file may stand in place of a request: {plan: {…} or the text of the file}.
// POST /api/plans/draft → PlanDraft, nothing is kept; POST /api/plans {title, axis, request} → 201 Plan
export interface PlanRequest {
  axis: string; kind: 'linear' | 'rotary'; from: number; to: number;
  positions: number[] | null;              // null: chosen by the planner
  targets: number | null;                  // how many, null: what the standard asks for
  cycle: 'standard' | 'step' | 'pilgrim' | 'unidirectional' | 'user-defined'; runs: number | null;
  feed: number | null; dwell_s: number | null; overrun: number | null; seed: number | null;  // null: as the planner chooses
  further: Record<string, string>;         // more of `axiometry plan`, by the names of its flags
}
export interface PlanDraft {
  plan: unknown;                           // plan JSON as `axiometry plan --json` writes it
  targets: number[]; duration_s: number; findings: Finding[]; conforming: boolean; figure_svg: string;
  request?: PlanRequest | null;            // with the seed that was drawn: keep or draft this one to get the same plan
  parts?: PlanPart[];                      // the plan itself and its further ones, as ?part=1, 2, … counts them
}
export interface PlanPart {
  part: number; title: string; cycle: string; runs: number; readings: number; targets: number[]; duration_s: number;
  figure_svg: string;
}
export interface Plan extends PlanDraft, Entity { title: string; axis: number | null; request: PlanRequest | null }
// GET /api/plans → {plans: {id, version, title, axis, change}[]}; GET /api/plans/{id} → Plan
// GET /api/plans/{id}/sheet.{html|pdf}?language=; GET /api/plans/{id}/program?dialect=linuxcnc&unrolled=1&…(ProgramOptions)
// POST /api/plans/draft/program {request, dialect, options} and /api/plans/draft/sheet.{extension} {request}: of a draft
// Of programs: dialect, part (1), download=1 for a file, and options by their names in nc/dialect.h: unit=inch,
// unrolled, trigger_m_code, number, decimals, block_numbers=0, stop_at_start. GET /api/plans/{id}/plan.json; GET /api/plans/{id}/versions
// PUT /api/plans/{id} {base_version, title, axis, request, reason}

// GET /api/sources → {sources: Source[]}: what a capture may listen to; named when the server is started
export interface Source { id: string; title: string; kind: 'simulator' | 'tcp' | 'serial';
  presets?: { id: string; title: string; sign: string }[]; speeds?: number[] }  // of the simulator
// POST /api/captures {plan, source, layout, options} → 201 Capture; POST /api/captures/{id}/stop → Capture
// GET /api/captures → {captures: Capture[]}; GET /api/captures/{id}?after=REVISION: at once; readings after that revision
export interface Capture {
  id: number; plan: number; source: Source; started: string; revision: number;
  state: 'waiting' | 'running' | 'complete' | 'stopped' | 'failed' | 'interrupted';  // interrupted: may be resumed
  approaches: number;                      // of the plan
  due: { target: number; run: number; direction: 'up' | 'down'; position?: number } | null;  // i and j from 1; P_i
  now: { position: number; at_rest: boolean } | null;
  anew?: boolean;                          // readings are all there are: forget those of before
  readings: { target: number; run: number; direction: 'up' | 'down'; deviation: number; spread: number; samples: number; remarks: string[];
              position?: number }[];       // i and j from 1; P_i; spread in the unit of the deviation
  events: { kind: string; message: string; time_s: number }[];
  notices: string[];
  so_far: Evaluated | null;                // as soon as a test can be made of it
  test: number | null;                     // kept as this test when it has ended with readings
  error: string | null;
  part?: number; unit?: 'um' | 'arcsec'; kind?: 'linear' | 'rotary';
  targets?: number[];                      // P_i of the plan (or its part) that is captured
}
// POST /api/captures {plan, source, layout, options}: layout '' recognises it. Options are texts by the names of the
// flags of `axiometry capture`: part, wavelength, counts-per-wavelength, rate, datum, zero, reverse, give-up, …; of the
// source "simulator": speed (1, 10 or 60), preset (simulation faults), seed.
// POST /api/captures {resume: ID}: goes on with one that is "interrupted"; POST /api/captures/{ID}/stop keeps what it has.

// GET /api/audit?subject=&before=&limit= → {entries: AuditEntry[]}
export interface AuditEntry { id: number; change: Change; action: string; subject: string; detail: Record<string, unknown>; sha256: string }
