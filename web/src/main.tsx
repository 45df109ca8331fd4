// SPDX-License-Identifier: Apache-2.0
// The common rules come first, so that those of a page, equally strong, win over them.
import './styles/tokens.css';
import './styles/base.css';
import './styles/shell.css';
import { render } from 'preact';
import { App } from './app';
import { language_known } from './i18n/texts';
import { load_all_pages } from './lazy_page';

void language_known().then(() => render(<App />, document.getElementById('app') as HTMLElement));
// When what is shown has come, and the browser has nothing to do.
window.addEventListener('load', () => setTimeout(() => void load_all_pages(), 500));
