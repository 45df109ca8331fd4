// SPDX-License-Identifier: Apache-2.0
// The edges of the working volume: which of them lie behind it, and along which the axes are named. Pure.
import { between, dot, type Extent, type Place, type Projection } from './projection';

export interface BoxEdge {
  key: string;
  axis: 0 | 1 | 2;            // along which it runs, from its lower end
  from: Place;
  to: Place;
  behind: boolean;            // both faces that meet in it look away
  named: boolean;             // the axis is named here: at the outline, where there is room
}

interface Found extends BoxEdge { at_outline: boolean }

export function box_edges({ low, high }: Extent, view: Projection): BoxEdge[] {
  const edges: Found[] = [];
  for (const axis of [0, 1, 2] as const) {
    const others = ([0, 1, 2] as const).filter((k) => k !== axis);
    for (const ends of [[0, 0], [0, 1], [1, 0], [1, 1]] as const) {
      const from = [...low] as [number, number, number];
      others.forEach((k, i) => { if (ends[i]) from[k] = high[k]; });
      const to = [...from] as [number, number, number];
      to[axis] = high[axis];
      const faces_viewer = others.map((k, i) => dot(unit(k, ends[i] ? 1 : -1), view.out) > 1e-9);
      edges.push({
        key: `edge-${axis}-${ends.join('')}`, axis, from, to, named: false,
        behind: !faces_viewer[0] && !faces_viewer[1], at_outline: faces_viewer[0] !== faces_viewer[1],
      });
    }
  }
  for (const axis of [0, 1, 2] as const) {
    const chosen = best(edges.filter((edge) => edge.axis === axis), view);
    if (chosen) chosen.named = true;
  }
  return edges.map(({ at_outline: _, ...edge }) => edge);
}

const unit = (axis: number, sign: number): Place => [axis === 0 ? sign : 0, axis === 1 ? sign : 0, axis === 2 ? sign : 0];

/** X and Y are named below the volume, Z at its left; along an axis that one looks along no edge is at the outline. */
function best(edges: Found[], view: Projection): Found | null {
  const outline = edges.filter(({ at_outline }) => at_outline);
  const middle = (edge: Found) => view.flat(between(edge.from, edge.to, 0.5));
  const rank = (edge: Found) => (edge.axis === 2 ? -middle(edge)[0] : middle(edge)[1]);
  return (outline.length > 0 ? outline : edges).reduce<Found | null>((chosen, edge) => (chosen === null || rank(edge) > rank(chosen) ? edge : chosen), null);
}
