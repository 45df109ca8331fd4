// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from 'preact/hooks';

/** True as soon as the element has come near the window once: what is far away need not be asked for. */
export function use_seen(ref: { current: Element | null }): boolean {
  const [seen, set_seen] = useState(false);
  useEffect(() => {
    if (seen || ref.current === null) return;
    const watch = new IntersectionObserver((entries) => { if (entries.some((entry) => entry.isIntersecting)) set_seen(true); }, { rootMargin: '300px' });
    watch.observe(ref.current);
    return () => watch.disconnect();
  }, [seen]);
  return seen;
}
