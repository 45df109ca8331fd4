// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from 'preact/hooks';

/** The value once it has stayed for a while: what is typed is asked for when somebody has finished typing. */
export function use_settled<T>(value: T, pause_ms = 400): T {
  const [settled, set_settled] = useState(value);
  useEffect(() => {
    const timer = window.setTimeout(() => set_settled(value), pause_ms);
    return () => window.clearTimeout(timer);
  }, [value, pause_ms]);
  return settled;
}
