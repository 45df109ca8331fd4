// SPDX-License-Identifier: Apache-2.0
// The common rules come first, so that those of a page, equally strong, win over them.
import './styles/tokens.css';
import './styles/base.css';
import './styles/shell.css';
import { render } from 'preact';
import { App } from './app';

render(<App />, document.getElementById('app') as HTMLElement);
