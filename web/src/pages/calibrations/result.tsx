// SPDX-License-Identifier: Apache-2.0
// What a calibration has found. The 21 errors are shown in one place, ErrorTable, in a small way: what shows the whole
// result of an identification may stand there instead, given `result`.
import type { KeptCalibration, CalibrationFigure, TrackingEvaluation } from '../../api/types';
import { DataTable } from '../../components/table';
import { fixed } from '../../numbers';
import { TrackingFindings } from '../tracking/findings';
import { Results } from '../tracking/results';
import '../tracking.css';
import { figure_text } from './figures';
import { t } from './texts';

interface Estimate { value: number | null; u: number | null }
interface Node extends Estimate { position: number }

/** The parts of the result of `axiometry volumetric identify` that are shown here (docs/results.md). */
interface Identified {
  errors: Record<string, readonly Node[] | Estimate>;
  findings: readonly { id: string; severity: 'serious' | 'note'; message: string }[];
}

export function CalibrationResult({ calibration }: { calibration: KeptCalibration }) {
  if (calibration.kind === 'lines') {
    return (
      <section class="panel">
        <header><h2>{t('lines')}</h2></header>
        <Results evaluation={calibration.result as unknown as TrackingEvaluation} />
      </section>
    );
  }
  const result = calibration.result as unknown as Identified;
  return (
    <>
      <VolumePanel figures={calibration.figures} />
      <section class="panel">
        <header><h2>{t('findings')}</h2></header>
        <TrackingFindings findings={[...result.findings]} />
      </section>
      <section class="panel">
        <header><h2>{t('errors')}</h2></header>
        <ErrorTable errors={result.errors} />
      </section>
    </>
  );
}

const volume = [['volume_largest', 'largest'], ['volume_percent_95', 'percent_95'], ['volume_mean', 'mean']] as const;
const counted = [['chi2_per_dof', 'chi2'], ['rank', 'rank'], ['unseen_errors', 'unseen'], ['readings', 'readings']] as const;

/** With each tool the size of the error over the volume, and how well the lengths tell it. */
function VolumePanel({ figures }: { figures: readonly CalibrationFigure[] }) {
  const tools = [...new Set(figures.map((one) => one.of).filter((of) => of !== ''))];
  const figure = (parameter: string, of: string) => figures.find((one) => one.parameter === parameter && one.of === of);
  const unknowns = figure('unknowns', '');
  return (
    <section class="panel calibration-volume">
      <header><h2>{t('volume')}</h2><span class="quiet small">{t('volume_how')}</span></header>
      {tools.length > 0 && (
        <DataTable<string> caption={t('volume')} rows={tools} row_key={(tool) => tool} columns={[
          { key: 'tool', head: t('tool'), row_head: true, cell: (tool) => tool },
          ...volume.map(([parameter, head]) => ({ key: parameter, head: `${t(head)} / µm`, number: true, cell: (tool: string) => fixed(figure(parameter, tool)?.value, 1) })),
          { key: 'u', head: `${t('u')} (${t('largest')}) / µm`, number: true, cell: (tool) => fixed(figure('volume_largest', tool)?.u, 1) },
        ]} />
      )}
      <dl class="fact-grid">
        {counted.map(([parameter, label]) => {
          const found = figure(parameter, '');
          return found && (
            <div key={parameter}>
              <dt>{t(label)}</dt>
              <dd>{figure_text(parameter, found.unit, found.value)}{parameter === 'rank' && unknowns ? ` / ${unknowns.value}` : ''}{parameter === 'unseen_errors' ? ' / 21' : ''}</dd>
            </div>
          );
        })}
      </dl>
    </section>
  );
}

/** The largest amount of each curve with the uncertainty at that place; squareness with its sign. */
function ErrorTable({ errors }: { errors: Identified['errors'] }) {
  const rows = Object.entries(errors).map(([name, told]) => ({ name, ...shown(told), unit: unit_of(name) }));
  return (
    <DataTable caption={t('errors')} rows={rows} row_key={({ name }) => name} columns={[
      { key: 'name', head: t('error'), row_head: true, cell: ({ name }) => name },
      { key: 'value', head: t('largest'), number: true, cell: ({ value }) => (value === null ? <span class="quiet">{t('not_told')}</span> : fixed(value, 2)) },
      { key: 'u', head: t('u'), number: true, cell: ({ u }) => fixed(u, 2) },
      { key: 'unit', head: t('unit'), cell: ({ unit }) => unit },
    ]} />
  );
}

function shown(told: readonly Node[] | Estimate): Estimate {
  if (!Array.isArray(told)) return told as Estimate;
  return (told as readonly Node[]).reduce<Estimate>((most, node) => (Math.abs(node.value ?? 0) > Math.abs(most.value ?? -1) || most.value === null ? node : most), { value: null, u: null });
}

/** "EXY" is a displacement, "EAY" a rotation, "C0Y" a squareness. */
const unit_of = (name: string): string => (/^E[XYZ][XYZ]$/.test(name) ? 'µm' : 'µrad');
