// SPDX-License-Identifier: Apache-2.0
// One test as its page works with it: what is kept, what is tried, and the numbers of what is tried.
import { computed, signal, type ReadonlySignal } from '@preact/signals';
import { type ApiError, as_error, query, send } from '../../api/client';
import type { Changes, Evaluated, Field, Options, Test } from '../../api/types';
import { decimal } from '../../settings';
import { keep_draft, kept_draft } from './draft_store';
import { as_stated, same_value, stated_text } from './field_value';
import { shared } from './shared';

export const same_changes = (a: Changes, b: Changes): boolean => {
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every((key) => a[key] === b[key]);
};
const same_options = (a: Options, b: Options): boolean =>
  a.trials === b.trials && a.seed === b.seed && a.coverage === b.coverage &&
  [...a.methods].sort().join() === [...b.methods].sort().join() && a.corrections.join() === b.corrections.join() &&
  JSON.stringify(a.temperatures ?? null) === JSON.stringify(b.temperatures ?? null);

const without = (changes: Changes, keys: readonly string[]): Changes =>
  Object.fromEntries(Object.entries(changes).filter(([key]) => !keys.includes(key)));

/** What the server writes of numbers as text follows the user's decimal mark. */
export const test_path = (id: number | string, rest = '', more: Record<string, string | number | null> = {}): string =>
  `/api/tests/${encodeURIComponent(id)}${rest}${query({ ...more, decimal: decimal.value })}`;

/** The field by which the method of record is chosen. */
export const method_field = 'uncertainty.method';
const sampling_pause_ms = 500;   // so that not every letter that is typed starts a simulation

export class TestState {
  readonly test = signal<Test>(undefined as never);
  readonly changes = signal<Changes>({});
  readonly options = signal<Options>(undefined as never);
  readonly title = signal('');
  readonly draft = signal<Evaluated | null>(null);
  /** By field: what the server says against the value. The numbers are those without it. */
  readonly faults = signal<Record<string, string>>({});
  /** Against the draft as a whole. */
  readonly failure = signal<ApiError | null>(null);
  readonly busy = signal<'no' | 'evaluating' | 'sampling'>('no');
  readonly editing = signal(false);
  /** A field that wants to be shown and focused. */
  readonly wanted_field = signal<string | null>(null);
  /** Index of the target that chart and table point at. */
  readonly target = signal<number | null>(null);
  /** What the file says, without any change. */
  readonly stated = signal<Record<string, unknown>>({});
  readonly restored = signal(false);

  readonly evaluated: ReadonlySignal<Evaluated> = computed(() => this.draft.value ?? this.test.value);
  /** Whether numbers may differ from the kept ones. */
  readonly edited = computed(() =>
    !same_changes(this.changes.value, this.test.value.changes) || !same_options(this.options.value, this.test.value.options));
  readonly dirty = computed(() => this.edited.value || this.title.value.trim() !== this.test.value.title);
  /** Whether the uncertainty of record comes from the Monte Carlo method: a draft without it would be judged by another. */
  readonly sampled_record = computed(() => {
    const stated = this.stated.value['uncertainty'] as Record<string, unknown> | undefined;
    const chosen = this.changes.value[method_field] ?? stated?.['method'] ?? '';
    return chosen === '' ? this.options.value.methods.includes('monte-carlo') : chosen === 'monte-carlo';
  });
  /** For comparison Monte Carlo takes seconds, so a draft is without it until it is asked for. */
  readonly lacks_sampling = computed(() =>
    this.draft.value !== null && this.options.value.methods.includes('monte-carlo') &&
    !this.draft.value.result.uncertainty?.monte_carlo);

  private last_changed: string | null = null;
  private abort: AbortController | null = null;
  private timer = 0;

  constructor(test: Test) {
    this.take(test);
    const kept = kept_draft(test.id);
    if (kept === null || test.version !== test.latest) return;
    if (kept.base_version !== test.version) return;
    this.changes.value = kept.changes;
    this.options.value = kept.options;
    this.title.value = kept.title;
    if (!this.dirty.value) return;
    this.restored.value = true;
    this.editing.value = true;
    this.plan_evaluation();
  }

  /** A kept version takes the place of what is shown; nothing is left to save. */
  take(test: Test): void {
    this.stop();
    this.test.value = test;
    this.changes.value = test.changes;
    this.options.value = test.options;
    this.title.value = test.title;
    this.draft.value = null;
    this.faults.value = {};
    this.failure.value = null;
    this.restored.value = false;
    this.stated.value = as_stated(test);
    if (Object.keys(test.changes).length > 0) void this.ask_what_the_file_says();
  }

  /** The same version again, perhaps in another language or with a document more. */
  refresh(test: Test): void {
    this.test.value = test;
    if (this.edited.value) this.plan_evaluation();
  }

  private async ask_what_the_file_says(): Promise<void> {
    const { id, options } = this.test.value;
    try {
      const bare = await send<Evaluated>('POST', test_path(id, '/evaluate'), { changes: {}, options: quick(options) });
      this.stated.value = as_stated(bare);
    } catch {
      // Then changes cannot be told from the file's values; everything else works.
    }
  }

  /** A field's value in the draft, as `--set` takes it. */
  text_of(field: Field): string {
    return this.changes.value[field.key] ?? stated_text(field, this.stated.value);
  }

  /** Puts a value; the file's own value is no change. */
  put(field: Field, text: string): void {
    const next = { ...this.changes.value };
    if (same_value(field, text, stated_text(field, this.stated.value))) delete next[field.key];
    else next[field.key] = text;
    this.last_changed = field.key;
    this.faults.value = without(this.faults.value, [field.key]);
    this.changes.value = next;
    this.changed();
  }

  rename(title: string): void {
    this.title.value = title;
    this.keep();
  }

  choose(options: Partial<Options>): void {
    this.options.value = { ...this.options.value, ...options };
    this.changed();
  }

  /** The whole draft at once: an older version taken up again, or edits moved onto a newer one. */
  replace(changes: Changes, options: Options): void {
    this.faults.value = {};
    this.changes.value = changes;
    this.options.value = options;
    this.changed();
  }

  discard(): void {
    keep_draft(this.test.value.id, null);
    this.take(this.test.value);
  }

  stop(): void {
    window.clearTimeout(this.timer);
    this.abort?.abort();
    this.busy.value = 'no';
  }

  private keep(): void {
    const { id, version } = this.test.value;
    const draft = { base_version: version, changes: this.changes.value, options: this.options.value, title: this.title.value };
    keep_draft(id, this.dirty.value ? draft : null);
  }

  private changed(): void {
    this.keep();
    this.plan_evaluation();
  }

  /** Changes made in one go are one request; a request that is overtaken is given up. */
  private plan_evaluation(): void {
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.evaluate(false), this.sampled_record.peek() && this.edited.peek() ? sampling_pause_ms : 0);
  }

  run_monte_carlo(): void {
    window.clearTimeout(this.timer);
    void this.evaluate(true);
  }

  /** What a field outside of the metadata holds and cannot be used: nothing is saved before it is mended. */
  blame(key: string, fault: string | null): void {
    this.faults.value = fault === null ? without(this.faults.value, [key]) : { ...this.faults.value, [key]: fault };
  }

  evaluate_again(): void {
    window.clearTimeout(this.timer);
    void this.evaluate(false);
  }

  private async evaluate(asked: boolean): Promise<void> {
    const sampling = asked || this.sampled_record.peek();
    this.stop();
    if (!this.edited.value) {
      this.draft.value = null;
      this.failure.value = null;
      return;
    }
    const abort = (this.abort = new AbortController());
    this.busy.value = sampling ? 'sampling' : 'evaluating';
    const faulty = Object.keys(this.faults.value);
    for (;;) {
      try {
        const body = {
          changes: without(this.changes.value, faulty),
          options: sampling ? this.options.value : quick(this.options.value),
        };
        const drafted = await send<Evaluated>('POST', test_path(this.test.value.id, '/evaluate'), body, abort.signal);
        this.draft.value = shared(this.evaluated.peek(), drafted);
        this.failure.value = null;
        break;
      } catch (error) {
        if (abort.signal.aborted) return;
        const failure = as_error(error);
        const key = failure.kind === 'bad_input' ? this.blamed(failure.message, faulty) : null;
        if (key === null) {
          this.failure.value = failure;
          break;
        }
        faulty.push(key);
        this.faults.value = { ...this.faults.value, [key]: failure.message };
      }
    }
    if (this.abort === abort) this.busy.value = 'no';
  }

  /** The changed field that a message names; else the one changed last. */
  private blamed(message: string, faulty: readonly string[]): string | null {
    const keys = Object.keys(this.changes.value).filter((key) => !faulty.includes(key));
    const named = keys.filter((key) => message.includes(key)).sort((a, b) => b.length - a.length)[0];
    if (named !== undefined) return named;
    return this.last_changed !== null && keys.includes(this.last_changed) && !same_changes(this.changes.value, this.test.value.changes)
      && same_options(this.options.value, this.test.value.options) ? this.last_changed : null;
  }

  edit(field: string | null = null): void {
    if (this.test.value.version !== this.test.value.latest) return;
    this.editing.value = true;
    this.wanted_field.value = field;
  }

  retry(): void {
    this.plan_evaluation();
  }
}

const quick = (options: Options): Options => ({
  ...options, methods: options.methods.filter((method) => method !== 'monte-carlo'),
});
